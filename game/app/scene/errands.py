"""What may take longer than a frame: a thread does it, while the scene stands still and the window answers.

What is asked for meanwhile waits for its turn. So everything acts in the order in which it came and at the
step at which the scene stood, however long the thread took: nothing that comes out depends on the machine.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import NamedTuple

Act = Callable[[], object]


class _Errand(NamedTuple):
    """``work`` gives what the window is then to do. ``quick``: no thread is needed for it.

    ``inside``: it changes the scene itself.
    """

    work: Callable[[], Act | None]
    quick: bool = False
    kept: bool = False
    inside: bool = False
    name: str = ""


class Errands:
    """The errands of one scene, one after the other; only the window's thread may call this."""

    def __init__(self, in_background: bool) -> None:
        """``in_background``: False has everything done at once, for those who do not look on."""
        self.in_background = in_background
        self.seconds = 0.0  # that the scene has stood still
        self._waiting: deque[_Errand] = deque()  # the first one is under way
        self._thread: threading.Thread | None = None
        self._outcome: Act | Exception | None = None
        self._rests = False  # the thread waits for the window to have looked into the scene
        self._looking = False  # the window has seen that
        self._in_haste = False  # the thread is waited for, so it is not to rest
        self._go = threading.Event()

    @property
    def busy(self) -> bool:
        """Whether something is under way, so that the scene is to stand still."""
        return bool(self._waiting)

    def work(self, work: Callable[[], Act | None], kept: bool = False) -> None:
        """Let a thread do this, which must not change the scene, then the window what it gives, if anything.

        ``kept``: it is finished even if the scene is left before.
        """
        self._add(_Errand(work, kept=kept))

    def act(self, act: Act, name: str = "") -> None:
        """Do this at once, or when everything before it has been done.

        What waits under a ``name`` is given up for what is asked for right after it under the same one.
        """
        self._add(_Errand(lambda: act, quick=True, name=name))

    def work_inside(self, work: Callable[[], Act | None], name: str = "") -> None:
        """Let a thread do this to the scene itself, which no other thread may look at meanwhile; then as
        `work`.

        ``name``: as in `act`.
        """
        self._add(_Errand(work, inside=True, name=name))

    @property
    def inside(self) -> bool:
        """Whether a thread is at work in the scene itself."""
        return self._thread is not None and self._waiting[0].inside and not self._looking

    def rest(self) -> None:
        """Called by work inside: let the window show the scene once as it is, then go on."""
        if threading.current_thread() is not self._thread:
            return
        self._go.clear()
        if self._in_haste:
            return
        self._rests = True
        self._go.wait()
        self._rests = False

    def shown(self) -> None:
        """The window has drawn the scene: a thread that rests goes on."""
        if self._looking:
            self._looking = False
            self._go.set()

    def update(self, elapsed_s: float) -> None:
        """Let time pass, and go on as far as the thread has come."""
        self._looking = self._rests and not self._go.is_set()
        self.seconds = self.seconds + elapsed_s if self.busy else 0.0
        if self._thread is not None and not self._thread.is_alive():
            self._end()
            self._go_on()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the thread of what is under way; it rests no more."""
        if self._thread is not None:
            self._hurry(True)
            self._thread.join(seconds)
            self._hurry(False)

    def _hurry(self, in_haste: bool) -> None:
        self._in_haste, self._looking = in_haste, False
        if in_haste:
            self._go.set()

    def close(self) -> None:
        """The scene is left: what is to be kept is finished, with all that comes before it."""
        self._hurry(True)
        while self._waiting and not self._waiting[-1].kept:
            self._waiting.pop()
        while self._waiting:
            if self._thread is not None:
                self._end()
            self._go_on()
        self._thread = None

    def _add(self, errand: _Errand) -> None:
        if errand.name and len(self._waiting) > 1 and self._waiting[-1].name == errand.name:
            self._waiting.pop()
        self._waiting.append(errand)
        if self._thread is None:
            self._go_on()

    def _go_on(self) -> None:
        """Do what is first in the row, and the next, until a thread is to be waited for."""
        while self._waiting and self._thread is None:
            work = self._waiting[0].work
            if self.in_background and not self._waiting[0].quick:
                self._thread = threading.Thread(target=self._call, args=(work,), name="errand", daemon=True)
                self._thread.start()
            else:
                self._call(work)
                self._end()

    def _call(self, work: Callable[[], Act | None]) -> None:
        try:
            self._outcome = work()
        except Exception as error:  # raised again where the window waits for it
            self._outcome = error

    def _end(self) -> None:
        """Wait for the thread and do what its errand has given."""
        self.wait()
        outcome = self._outcome
        self._thread = self._outcome = None
        self._waiting.popleft()
        if isinstance(outcome, Exception):
            raise outcome
        if outcome is not None:
            outcome()
