"""Work for a picture in a thread of its own: always for the newest question, what is older is given up."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, NamedTuple, TypeVar

T = TypeVar("T")


class Answer(NamedTuple, Generic[T]):
    """What came of a question. key: equal for equal questions."""

    key: object
    value: T


class Newest(Generic[T]):
    """Answers the newest question that it is asked. No part of any state."""

    def __init__(self, name: str) -> None:
        """name: of the thread."""
        self.failure = ""
        self._name = name
        self._lock = threading.Lock()
        self._wanted: tuple[object, Callable[[], T]] | None = None
        self._begun: object = None
        self._thread: threading.Thread | None = None
        self._latest: Answer[T] | None = None

    @property
    def latest(self) -> Answer[T] | None:
        """What was answered last, be it to an older question."""
        with self._lock:
            return self._latest

    def ask(self, key: object, work: Callable[[], T]) -> None:
        """Have a question answered; asking again for the same costs nothing."""
        with self._lock:
            if self._begun == key or (self._wanted is not None and self._wanted[0] == key):
                return
            self._wanted = (key, work)
            if self._thread is None:
                self._thread = threading.Thread(target=self._run, daemon=True, name=self._name)
                self._thread.start()

    def answer(self, key: object, work: Callable[[], T]) -> T:
        """The answer here and now."""
        found = self.latest
        if found is None or found.key != key:
            found = Answer(key, work())
            with self._lock:
                self._latest, self._begun = found, key
        return found.value

    def wait(self) -> None:
        """Until nothing is being worked on any more."""
        with self._lock:
            thread = self._thread
        if thread is not None:
            thread.join()

    def _run(self) -> None:
        while True:
            with self._lock:
                wanted, self._wanted = self._wanted, None
                if wanted is None:
                    self._thread = None
                    return
                self._begun = wanted[0]
            try:
                value = wanted[1]()
            except Exception as error:  # a picture that fails must not stop the game
                self.failure = f"{type(error).__name__}: {error}"
                continue
            with self._lock:
                self._latest = Answer(wanted[0], value)
