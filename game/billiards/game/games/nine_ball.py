"""Nine-ball: the lowest ball is hit first, and the player that pots the 9 wins (WPA 2)."""

from __future__ import annotations

from typing import ClassVar

import msgspec

from game.billiards.game.games.rotation import Rotation
from game.billiards.game.rules import Call, Foul, ShotSummary, Verdict

NINE = 9
NINE_BALLS = tuple(range(1, 10))


class NineBall(Rotation, frozen=True, kw_only=True, tag="nine-ball"):
    """A rack of nine-ball."""

    winning: ClassVar[int] = NINE

    on_table: tuple[int, ...] = NINE_BALLS

    def _put_back(self, shot: ShotSummary, call: Call, fouls: tuple[Foul, ...]) -> tuple[int, ...]:
        """2.7: the 9 that left the table, or went down with a foul or at a push-out."""
        down = NINE in shot.balls_down and (bool(fouls) or call.push_out)
        return (NINE,) if down or NINE in shot.off_table else ()

    def _go_on(self, after: Rotation, shot: ShotSummary, call: Call, words: list[str]) -> Verdict:
        """2.5: who pots any ball plays on."""
        if shot.pocketed:
            return Verdict(after, (), shot.balls_down, (*words, f"{self.shooter} plays on."))
        after = msgspec.structs.replace(after, turn=self.other)
        return Verdict(after, (), (), (*words, "Nothing went down.", f"{after.shooter} plays."))
