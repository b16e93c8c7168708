"""The system's wish that the program end (SIGTERM) is obeyed as Ctrl+C is: whole files or none are left."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

STOPPED, ENDED = 128 + signal.SIGINT, 128 + signal.SIGTERM  # exit status


class Ended(KeyboardInterrupt):
    """The system asks the program to end."""


@contextmanager
def ends_tidily() -> Iterator[None]:
    """While this goes on SIGTERM raises Ended in the main thread, unless somebody else listens to it."""
    try:
        listened = signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL
        if not listened:
            signal.signal(signal.SIGTERM, _end)
    except ValueError:  # not the main thread
        listened = True
    try:
        yield
    finally:
        if not listened:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)


def status_of(why: KeyboardInterrupt) -> int:
    """The exit status of a program that was stopped."""
    return ENDED if isinstance(why, Ended) else STOPPED


def _end(number: int, frame: Any) -> None:
    raise Ended
