"""A dask scheduler and its workers as processes of this machine, and a wire to the scheduler that can be cut."""

import contextlib
import json
import os
import select
import socket
import subprocess
import sys
import threading
import time

from conftest import BUILD

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(BUILD / "python")}


class LoopbackFarm:
    """One scheduler; workers of one thread each, without nannies, so that one that is killed stays dead."""

    def __init__(self, folder):
        self.file, self.workers = folder / "scheduler.json", []
        self.scheduler = start("scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", self.file, "--no-dashboard")
        wait_for(self.file.exists)
        self.address = json.loads(self.file.read_text())["address"]

    def add_workers(self, count):
        """Start workers; they register when they are up."""
        self.workers += [start("worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard") for _ in range(count)]

    def close(self):
        """End all processes."""
        for process in [*self.workers, self.scheduler]:
            process.kill()
            process.wait()


def start(kind, *words):
    """A process of dask.distributed."""
    command = [sys.executable, "-m", f"distributed.cli.dask_{kind}", *map(str, words)]
    return subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def wait_for(condition, seconds=60):
    """Wait until it holds."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.01)


class Wire:
    """Hands bytes on between its own port and an address; `cut` breaks what is connected, and new connections work again."""

    def __init__(self, address):
        host, port = address.removeprefix("tcp://").split(":")
        self.target, self.ends = (host, int(port)), []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"tcp://127.0.0.1:{self.listener.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                pair = (self.listener.accept()[0], socket.create_connection(self.target))
                self.ends += pair
                threading.Thread(target=self._hand_on, args=pair, daemon=True).start()

    def _hand_on(self, near, far):
        with contextlib.suppress(OSError, ValueError):
            while True:
                for end in select.select([near, far], [], [])[0]:
                    data = end.recv(1 << 16)
                    if not data:
                        raise OSError
                    (far if end is near else near).sendall(data)
        near.close(), far.close()

    def cut(self):
        """Break every connection; returns how many there were."""
        ends, self.ends = self.ends, []
        for end in ends:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
        return len(ends) // 2

    def close(self):
        """No more connections."""
        self.listener.close()
        self.cut()
