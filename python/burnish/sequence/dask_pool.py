"""Tasks on the workers of a dask.distributed scheduler.

A worker that dies loses its task to another, which dask sees to (`distributed.scheduler.allowed-failures` times, then the task is `Lost`).
When the connection to the scheduler breaks, the client forgets its tasks and connects anew; they come back as `Dropped`. A task whose old
run goes on meanwhile does no harm: outputs are renamed into place whole, and have the same bits.
"""

from __future__ import annotations

import contextlib
import queue
import secrets
import time
from typing import TYPE_CHECKING, Any

from ..errors import Error, LostConnection
from .pools import Dropped, Lost
from .tasks import forget, run_task

if TYPE_CHECKING:
    from .._core import Progress
    from .pools import Ended
    from .tasks import Task


class DaskPool:
    """Runs tasks on the workers that a client's scheduler has."""

    def __init__(self, client: Any) -> None:
        self.client = client
        self.workers = max(1, sum(client.nthreads().values()))
        self.ended: queue.Queue[Any] = queue.Queue()
        self.tasks: dict[Any, Task] = {}  # by future
        self.shares: dict[int, float] = {}

    def start(self, task: Task) -> None:
        """Send a task off."""
        key = f"burnish-{task['frames'][0]}-{task['frames'][-1]}-{secrets.token_hex(4)}"
        future = self.client.submit(run_task, task, pure=False, key=key)
        self.tasks[future] = task
        future.add_done_callback(self.ended.put)

    def wait(self, progress: Progress) -> list[Ended]:
        """Whatever ended within a moment. Raises LostConnection when there is no scheduler any more."""
        self._expect_connection()
        try:
            future = self.ended.get(timeout=0.1)
        except queue.Empty:
            return []
        task = self.tasks.pop(future, None)
        return [] if task is None else [(task, self._result(future))]

    def stop(self, run: str) -> None:
        """Forget what is not done, and let workers forget what they kept for the run."""
        unfinished = list(self.tasks)
        self.tasks.clear()
        if self.client.status == "running":
            with contextlib.suppress(OSError):
                self.client.cancel(unfinished)
                self.client.run(forget, run, on_error="ignore")

    def _result(self, future: Any) -> Any:
        """The outcomes of a task, or why there are none."""
        from dask.distributed import CancelledError, KilledWorker

        try:
            return future.result()
        except KilledWorker as error:
            return Lost(f"{error.last_worker.address if error.last_worker else 'its worker'} died with it, and so did others before")
        except CancelledError:
            return Dropped()
        except Exception as error:
            is_of_the_wire = isinstance(error, OSError) and not isinstance(error, Error)
            return Dropped() if is_of_the_wire else error

    def _expect_connection(self) -> None:
        """Wait while the client connects anew."""
        while self.client.status == "connecting":
            time.sleep(0.05)
        if self.client.status != "running":
            raise LostConnection("the scheduler is gone; start it again, connect a new client, and the same call goes on where this one stopped")
