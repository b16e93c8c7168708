"""The time within which a program that was told to end has ended, whatever it is at.

A signal's handler in Python waits for the main thread, which may be in a compiler for half a minute. What it
raises may be dropped there. At its exit the interpreter waits for threads that compute. So another thread is
woken by the signal itself, and ends the process where it stands. Files are written whole or not at all, so
that nothing is lost but what was not yet written.
"""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
import threading
from collections.abc import Collection, Iterator
from contextlib import contextmanager

from game.app.window.children import end_children

GRACE_S = 1.5  # for threads that tidy up
STOPPED_LINE = "carom: stopped"
_said = threading.Event()


@contextmanager
def deadline(signals: Collection[signal.Signals], to_the_end: bool) -> Iterator[None]:
    """While this goes on, each of these signals ends the process after `GRACE_S`, with 128 + its number.

    Without ``to_the_end`` a process that leaves this in time lives on; with it, it must have ended by then.
    To be called in the main thread.
    """
    _said.clear()
    woken, wakes = socket.socketpair()
    wakes.setblocking(False)
    left = threading.Event()
    threading.Thread(target=_watch, args=(woken, signals, left), name="deadline", daemon=True).start()
    before = signal.set_wakeup_fd(wakes.fileno(), warn_on_full_buffer=False)
    try:
        yield
    finally:
        if not to_the_end:
            signal.set_wakeup_fd(before)
            left.set()
            wakes.close()  # the thread reads the end of it


def say_stopped(line: str = STOPPED_LINE) -> None:
    """Say on standard error that the program was stopped; what ends the process later then says nothing."""
    _said.set()
    print(line, file=sys.stderr)


def _watch(woken: socket.socket, signals: Collection[int], left: threading.Event) -> None:
    """Wait for a signal, then for the end."""
    with contextlib.suppress(OSError), woken:
        while heard := woken.recv(1):
            if heard[0] in signals:
                if not left.wait(GRACE_S):
                    _end(128 + heard[0])
                return


def _end(status: int) -> None:
    """End the process where it stands, and its children: no lock is waited for, nothing is flushed."""
    end_children()
    if not _said.is_set():
        with contextlib.suppress(OSError):
            os.write(2, f"{STOPPED_LINE}\n".encode())
    os._exit(status)
