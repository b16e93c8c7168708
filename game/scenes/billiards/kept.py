"""What is computed from a round of the billiard table and kept while that holds; no part of the state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from game.scenes.billiards.play import word_of
from game.scenes.billiards.round import Played, Round, Struck, play
from game.scenes.billiards.sounds import sounds_of
from game.stage import Sound

if TYPE_CHECKING:
    from game.billiards.search.finding import FoundShot


class Kept:
    """Each thing is computed when it is asked for, and anew when the round is another.

    sight, hint: see billiards_sight. considered: by a computer player before its last stroke.
    """

    def __init__(self) -> None:
        self._word_of: Round | None = None
        self._word = ""
        self._played_of: Struck | None = None
        self._played: Played | None = None
        self._sounds_of: Struck | None = None
        self._sounds: tuple[Sound, ...] = ()
        self.sight: Any = None
        self.hint: Any = None
        self.considered: tuple[FoundShot, ...] = ()

    def word(self, round_: Round) -> str:
        """A hash of all that the round says."""
        if self._word_of is not round_:
            self._word_of, self._word = round_, word_of(round_)
        return self._word

    def played(self, round_: Round) -> Played | None:
        """What comes, or came, of the round's last stroke; None before the first."""
        if self._played_of is not round_.last:
            self._played = play(round_) if round_.last is not None else None
            self._played_of = round_.last
        return self._played

    def sounds(self, round_: Round) -> tuple[Sound, ...]:
        """What is to be heard of the round's last stroke."""
        last = round_.last
        if self._sounds_of is not last:
            played = self.played(round_)
            self._sounds = sounds_of(played.trajectory, last.stroke.cue_speed) if last and played else ()
            self._sounds_of = last
        return self._sounds
