"""What burnish's commands in Python share: errors on one line, exit codes, signals that end a run as Ctrl-C does."""

from __future__ import annotations

import argparse
import signal
import sys

FAILED, USAGE, PARTIAL, SIGNAL_BASE = 1, 2, 3, 128


class Parser(argparse.ArgumentParser):
    """argparse, with burnish's one line for errors."""

    def error(self, message):
        """End with wrong usage."""
        sys.exit(fail("E_USAGE", f"{message}; see {self.prog} --help", USAGE))


def fail(name, message, code):
    """Say on one line why the run ends; returns the exit code."""
    print(f"burnish: error: {name} {' '.join(str(message).split())}", file=sys.stderr)
    return code


def catch_signals():
    """Let SIGINT and SIGTERM raise KeyboardInterrupt(number), also where the shell had them ignored."""
    def stop(number, _):
        raise KeyboardInterrupt(number)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
