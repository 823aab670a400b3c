"""The other end of `pools.Processes`: reads tasks from standard input, a line each, and tells of them on standard output."""

from __future__ import annotations

import json
import os
import signal
import sys
import time

from .tasks import run_task

BETWEEN_LINES_S = 0.2


def main() -> None:
    """Run tasks until there are none."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # also where the shell had it ignored
    with os.fdopen(os.dup(1), "w", encoding="utf-8") as out:
        os.dup2(2, 1)  # what libraries print must not mix with what is told

        def say(**told: object) -> None:
            out.write(json.dumps(told) + "\n")
            out.flush()

        for line in sys.stdin:
            try:
                say(outcomes=run_task(json.loads(line), _telling(say)))
            except Exception as error:
                say(code=getattr(error, "code", "E_INTERNAL"), message=str(error))
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # nothing is left to interrupt but Python's own end, which would complain


def _telling(say):
    """A progress callback that says so now and then."""
    last = time.monotonic()

    def tell(_, done):
        nonlocal last
        if time.monotonic() - last > BETWEEN_LINES_S:
            last = time.monotonic()
            say(done=done)

    return tell


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
