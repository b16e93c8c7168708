"""Ctrl+C, and the system's wish that the program end (SIGTERM): both leave whole files or none.

Either raises an exception in the main thread. One that is raised while a compiler calls back into Python
never comes out of it: ctypes reports and drops it. So it is raised again until it is dealt with. What cannot
be interrupted at all ends with the process (see deadline.py).
"""

from __future__ import annotations

import contextlib
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from game.app.window.children import end_children
from game.app.window.deadline import deadline

STOPPED, ENDED = 128 + signal.SIGINT, 128 + signal.SIGTERM  # exit status
PATIENCE_S = 0.2  # after which an exception that has got lost is raised again


class Ended(KeyboardInterrupt):
    """The system asks the program to end."""


@contextmanager
def ends_tidily(to_the_end: bool = False) -> Iterator[None]:
    """While this goes on SIGINT raises KeyboardInterrupt and SIGTERM raises Ended in the main thread.

    A process that has not left this `deadline.GRACE_S` later is ended. With ``to_the_end`` so is one that has
    left this and still lives: an interpreter that waits for its threads. After a signal the processes that
    were started (see children.py) are ended too. A signal that somebody else listens to, or that is ignored,
    is left to them.
    """
    usual: dict[signal.Signals, Any] = {
        signal.SIGINT: signal.default_int_handler,
        signal.SIGTERM: signal.SIG_DFL,
    }
    insistence = _Insistence()
    mine = [number for number, handler in usual.items() if signal.getsignal(number) is handler]
    try:
        for number in mine:
            signal.signal(number, insistence.hear)
    except ValueError:  # not the main thread
        mine = []
    try:
        with contextlib.ExitStack() as stack:
            if mine:
                stack.enter_context(deadline(mine, to_the_end))
                stack.enter_context(insistence.goes_on())
            yield
    finally:
        if insistence.heard:
            end_children()
        for number in mine:
            signal.signal(number, usual[number])


def status_of(why: KeyboardInterrupt) -> int:
    """The exit status of a program that was stopped."""
    return ENDED if isinstance(why, Ended) else STOPPED


class _Insistence:
    """Raises an exception for a signal, and again if it was swallowed on its way."""

    def __init__(self) -> None:
        self._raised: KeyboardInterrupt | None = None
        self.heard = False

    @contextmanager
    def goes_on(self) -> Iterator[None]:
        """While this goes on, the alarm clock is taken, and nothing is reported of what was swallowed."""
        report = sys.unraisablehook
        sys.unraisablehook = _without_interrupts(report)
        clock = getattr(signal, "SIGALRM", None)  # Windows has none, and nothing is raised again there
        before = signal.signal(clock, self._insist) if clock is not None else None
        try:
            yield
        finally:
            self._raised = None  # an alarm that rings right now sets no other one
            if clock is not None:
                signal.setitimer(signal.ITIMER_REAL, 0.0)
                signal.signal(clock, before)
            sys.unraisablehook = report

    def hear(self, number: int, frame: Any) -> None:
        """What a signal does."""
        self.heard = True
        self._raise(Ended() if number == signal.SIGTERM else KeyboardInterrupt())

    def _insist(self, number: int, frame: Any) -> None:
        """What the alarm clock does: a thread that is tidying up is not disturbed."""
        if self._raised is None:
            return
        if self._is_being_dealt_with():
            signal.setitimer(signal.ITIMER_REAL, PATIENCE_S)
        else:
            self._raise(type(self._raised)())

    def _raise(self, error: KeyboardInterrupt) -> None:
        self._raised = error
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_REAL, PATIENCE_S)
        raise error

    def _is_being_dealt_with(self) -> bool:
        """True within a ``finally`` or ``except`` that it has come to."""
        error = sys.exc_info()[1]
        while error is not None and error is not self._raised:
            error = error.__context__
        return error is not None


def _without_interrupts(report: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """The hook for exceptions that no caller can catch, but for interruptions."""

    def tell(unraisable: Any) -> None:
        if not issubclass(unraisable.exc_type, KeyboardInterrupt):
            report(unraisable)

    return tell
