"""Processes that this one has started: when it is stopped by a signal none of them goes on alone."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

_started: list[subprocess.Popen[Any]] = []
_leaders: set[int] = set()  # process numbers of those that lead a group of their own


def start(command: Sequence[str], group: bool = False, **options: Any) -> subprocess.Popen[Any]:
    """Start a process that `end_children` ends, with all it has started if it has a ``group`` of its own.

    ``options`` go to `subprocess.Popen`; OSError as from there. A signal that comes meanwhile is heard
    afterwards: between the start and the note of it the process would be forgotten.
    """
    group = group and hasattr(os, "killpg")
    with _signals_wait():
        _started[:] = [one for one in _started if one.poll() is None]
        process = subprocess.Popen(command, process_group=0 if group else None, **options)
        _started.append(process)
        if group:
            _leaders.add(process.pid)
    return process


def end_children() -> None:
    """Ask all to end that still go on; none is waited for."""
    for process in _started:
        if process.returncode is None:
            with contextlib.suppress(OSError):
                if process.pid in _leaders:
                    os.killpg(process.pid, signal.SIGTERM)
                else:
                    process.terminate()
    _started.clear()
    _leaders.clear()


@contextmanager
def _signals_wait() -> Iterator[None]:
    """While this goes on Ctrl+C and SIGTERM wait; only the main thread is ever interrupted."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    heard: list[int] = []
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    mine = [number for number, handler in before.items() if callable(handler)]
    for number in mine:
        signal.signal(number, lambda which, frame: heard.append(which))
    try:
        yield
    finally:
        for number in mine:
            signal.signal(number, before[number])
        if heard:
            signal.raise_signal(heard[0])
