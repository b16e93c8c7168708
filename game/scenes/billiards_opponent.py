"""Who thinks for a computer player: a thread that is asked one question at a time.

What it finds comes back as decisions, which the stage lets in as events; the state never waits for it.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import NamedTuple

from game.billiards.arrangement import Stroke
from game.billiards.frame import Frame
from game.stage import Decision


class Thought(NamedTuple):
    """What a player has come to: decisions in order, and the strokes that were considered, the best first."""

    decisions: tuple[Decision, ...]
    considered: tuple[Stroke, ...] = ()


class Question(NamedTuple):
    """What is asked: the frame, the player's grade, a seed. key: equal for equal questions."""

    key: object
    frame: Frame
    grade: str
    seed: int


Think = Callable[[Question], Thought]


class Thinker:
    """Answers the newest question; answers to older ones are forgotten."""

    def __init__(self, think: Think) -> None:
        self._think = think
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

    def forget(self) -> None:
        """Nobody waits for an answer any more."""
        with self._lock:
            self._key, self._answer = None, None

    def _run(self, question: Question) -> None:
        try:
            thought = self._think(question)
        except Exception as error:  # a player that fails must not stop the game: it plays on simply
            self.failure = f"{type(error).__name__}: {error}"
            thought = Thought(())
        with self._lock:
            if self._key == question.key:
                self._answer = thought
