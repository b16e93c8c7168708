"""What is computed from the frame at a table: its word for the digest, what came of its last stroke."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any, Generic, TypeVar

from game.scenes.shared.tables.moments import Moments, moments_of

F = TypeVar("F")  # frames
P = TypeVar("P")  # what came of a stroke


def hashed(said: object) -> str:
    """A short hash of what a frame says: equal frames, equal words."""
    return hashlib.blake2b(repr(said).encode(), digest_size=8).hexdigest()


class Outcome(Generic[F, P]):
    """What is computed from a frame and kept while that holds; no part of the state.

    said: what a frame says, without the frames before it.
    """

    def __init__(self, said: Callable[[F], object]) -> None:
        self._said = said
        self._word_of: F | None = None
        self._word = ""
        self._played_of: Any = None
        self._played: P | None = None
        self._moments_of: Any = None
        self._moments: Moments | None = None

    def word(self, frame: F) -> str:
        """A hash of what a frame says."""
        if self._word_of is not frame:
            self._word_of, self._word = frame, hashed(self._said(frame))
        return self._word

    def word_of(self, frame: F) -> str:
        """The same of any frame; nothing is kept."""
        return hashed(self._said(frame))

    def played(self, frame: F) -> P | None:
        """What comes, or came, of a frame's last stroke; None before the first. ValueError if it fails."""
        struck: Any = frame
        if self._played_of is not struck.last:
            self._played = struck.outcome() if struck.last is not None else None
            self._played_of = struck.last
        return self._played

    def moments(self, frame: F, cue: int) -> Moments | None:
        """What of a frame's last stroke is worth a second look; None before the first. cue: row of the ball
        that was struck.
        """
        struck: Any = frame
        if self._moments_of is not struck.last:
            played: Any = self.played(frame)
            self._moments = moments_of(played.trajectory, cue) if played is not None else None
            self._moments_of = struck.last
        return self._moments
