"""The thinker for a computer player: a thread that is asked one question at a time.

What it finds comes back as decisions, which the stage lets in as events; the state never waits for it. Where
no time passes, the question is answered at once instead, with no thread and no limit of time: then the answer
depends on the question alone.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any, NamedTuple

from game.stage import Decision


class Thought(NamedTuple):
    """What a player has come to: decisions in order; what was considered, the best first; and that told in
    words, as of `tables.thoughts`.
    """

    decisions: tuple[Decision, ...]
    considered: tuple[Any, ...] = ()
    told: Any = None


class Question(NamedTuple):
    """What is asked: the frame, the player's grade, a seed. key: equal for equal questions.

    patient: it may take as long as it takes, on all processors.
    """

    key: object
    frame: Any
    grade: str
    seed: int
    patient: bool = False


Think = Callable[[Question], Thought]


class Thinker:
    """Answers the newest question; answers to older ones are forgotten."""

    def __init__(self, think: Think, *warm_ups: Callable[[], None]) -> None:
        """``warm_ups`` are done once, before the first question: they compile what thinking needs."""
        self._think = think
        self._warm_ups: tuple[Callable[[], None], ...] | None = warm_ups
        self._warmed = 0
        self._begun: float | None = None
        self._lock = threading.Lock()
        self._key: object = None
        self._thread: threading.Thread | None = None
        self._answer: Thought | None = None
        self.failure = ""

    @property
    def thinking(self) -> bool:
        """True while a question is open."""
        with self._lock:
            return self._key is not None and self._answer is None

    @property
    def warm(self) -> bool:
        """False while what thinking needs is still being compiled, or was never asked for."""
        return self._warm_ups is None

    @property
    def getting_ready(self) -> str:
        """How far getting ready has come, in words."""
        count = len(self._warm_ups or ())
        seconds = 0.0 if self._begun is None else time.monotonic() - self._begun
        part = min(self._warmed + 1, count)
        return f"gets ready: part {part} of {count}, {seconds:.0f} s" if count else "gets ready"

    def prepare(self) -> None:
        """Begin to compile what thinking needs, if that has not been done."""
        with self._lock:
            if self._warm_ups is not None and self._thread is None:
                self._thread = threading.Thread(target=self._make_ready, daemon=True, name="opponent")
                self._thread.start()

    def ask(self, question: Question) -> Thought | None:
        """The answer to a question, or None as long as there is none; asking again costs nothing."""
        with self._lock:
            if self._key == question.key:
                return self._answer
            if self._thread is not None and self._thread.is_alive():
                return None  # the question before is still being thought about
            self._key, self._answer = question.key, None
            self._thread = threading.Thread(target=self._run, args=(question,), daemon=True, name="opponent")
            self._thread.start()
        return None

    def answer(self, question: Question) -> Thought:
        """The answer to a question, thought about here and now."""
        return self._thought(question._replace(patient=True))

    def forget(self) -> None:
        """An answer is no longer waited for."""
        with self._lock:
            self._key, self._answer = None, None

    def _make_ready(self) -> None:
        self.failure = ""
        if self._warm_ups:
            self._begun = time.monotonic()
        for done, call in enumerate(self._warm_ups or ()):
            self._warmed = done
            try:
                call()
            except Exception as error:  # thinking itself will fail the same way, and is seen to there
                self.failure = f"{type(error).__name__}: {error}"
        self._warm_ups = None

    def _run(self, question: Question) -> None:
        self._make_ready()
        thought = self._thought(question)
        with self._lock:
            if self._key == question.key:
                self._answer = thought

    def _thought(self, question: Question) -> Thought:
        try:
            return self._think(question)
        except Exception as error:  # a player that fails must not stop the game: it plays on simply
            self.failure = f"{type(error).__name__}: {error}"
            return Thought(())
