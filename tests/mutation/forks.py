"""Work done in a fork of this process, so that nothing of it stays."""

from __future__ import annotations

import json
import os
import select
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import Any


class OutOfTime(BaseException):
    """A test took more processor time than it was given; no Exception, so that no program catches it."""


def in_fork(work: Callable[[], Any], limit_s: float) -> Any:
    """What a piece of work returns (as JSON keeps it), done in a fork; None: it came to no end, or broke.

    The fork leads a session of its own: what it has started ends with it.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        _work_and_leave(work, writing)
    os.close(writing)
    parts, ends = [], time.monotonic() + limit_s
    while (left := ends - time.monotonic()) > 0.0 and select.select([reading], [], [], left)[0]:
        part = os.read(reading, 1 << 16)
        if not part:
            break
        parts.append(part)
    os.close(reading)
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    os.waitpid(child, 0)
    try:
        return json.loads(b"".join(parts))
    except ValueError:
        return None


def _work_and_leave(work: Callable[[], Any], writing: int) -> None:
    try:
        os.setsid()
        silent = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(silent, stream)
        with os.fdopen(writing, "wb") as pipe:
            pipe.write(json.dumps(work()).encode())
    finally:
        os._exit(0)


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Raise OutOfTime in what runs within, once it has used so many seconds of processor time."""

    def stop(*_: object) -> None:
        raise OutOfTime(f"took more than {seconds:.1f} s of processor time")

    signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
