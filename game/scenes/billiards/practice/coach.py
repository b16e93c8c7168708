"""The coach: what the last stroke was worth, why it missed and what it left; and the next one, if asked.

It is worked out in a thread of its own. Nothing of it belongs to the state but that it was asked before a
stroke (`Play.coached`), which the score then says.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from game.billiards.map.pool import Pot
from game.billiards.map.review import Review, best_pot, review
from game.scenes.billiards.beside import COACH
from game.scenes.billiards.play import AIMING, REPLAY, Play
from game.scenes.billiards.practice.hands import Hand, hand_of
from game.scenes.shared.newest import Newest


class Told(NamedTuple):
    """The review of a stroke, and the best pot of the position that it left, None for none.

    shooter: who played it; next_shooter: who is at turn after it; over: the game is.
    """

    review: Review
    left: Pot | None
    shooter: str
    next_shooter: str
    over: bool


class Coach:
    """What is known of the last stroke, and of the next."""

    def __init__(self, play: Play) -> None:
        self.play = play
        self.after: Newest[Told] = Newest("coach")
        self.ahead: Newest[Pot | None] = Newest("coach ahead")

    @property
    def hand(self) -> Hand:
        """The hand whose chances are told: that of map and cloud."""
        return hand_of(self.play)

    @property
    def active(self) -> bool:
        """True while the last stroke is to be told of."""
        play = self.play
        return (
            play.parameters.beside == COACH
            and play.phase in (AIMING, REPLAY)
            and play.model.frame.last is not None
        )

    @property
    def _key(self) -> object:
        frame = self.play.model.frame
        last = frame.last
        assert last is not None
        return last.frame.layout.places, last.stroke, frame.layout.places, frame.conditions, self.hand.noise

    def told(self) -> Told | None:
        """What there is to tell of the last stroke; asks for it."""
        if not self.active:
            return None
        self.after.ask(self._key, self._work())
        latest = self.after.latest
        return latest.value if latest is not None and latest.key == self._key else None

    def now(self) -> Told | None:
        """The same, worked out here and now."""
        return self.after.answer(self._key, self._work()) if self.active else None

    def _work(self) -> Callable[[], Told]:
        frame, noise = self.play.model.frame, self.hand.noise
        last = frame.last
        assert last is not None
        mine = last.stroke == self.play.done and self.play.meant is not None
        meant = self.play.meant if mine and self.play.meant is not None else last.stroke

        def work() -> Told:
            before = last.frame
            found = review(before, meant, last.stroke, last.call, noise)
            left = best_pot(frame, noise)
            return Told(found, left, before.game.shooter, frame.game.shooter, frame.game.over)

        return work

    # -- before the stroke, if asked ----------------------------------------------------------------

    @property
    def asked(self) -> bool:
        """True if the coach was asked about the stroke that is aimed."""
        play = self.play
        return play.parameters.beside == COACH and play.may_aim and play.advised == play.model.frame.strokes

    def advice(self) -> tuple[bool, Pot | None]:
        """Whether it is known what the surest pot is, and that pot, None if there is none."""
        frame, noise = self.play.model.frame, self.hand.noise
        key = (frame.layout.places, frame.conditions, noise)
        self.ahead.ask(key, lambda: best_pot(frame, noise))
        latest = self.ahead.latest
        known = latest is not None and latest.key == key
        return known, latest.value if known and latest is not None else None
