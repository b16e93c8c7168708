"""Ten-ball: the lowest ball is hit first, ball and pocket are called, and the called 10 wins (WPA 9)."""

from __future__ import annotations

from typing import ClassVar

import msgspec

from game.billiards.game.games.rotation import PLAY, Rotation
from game.billiards.game.rules import Call, Foul, Option, ShotSummary, Verdict

TEN = 10
TEN_BALLS = tuple(range(1, 11))

# named as after a push-out, so that the same player decides both alike
PASS_BACK = Option("pass back", "Let the player who potted it play again.")


class TenBall(Rotation, frozen=True, kw_only=True, tag="ten-ball"):
    """A rack of ten-ball."""

    winning: ClassVar[int] = TEN

    on_table: tuple[int, ...] = TEN_BALLS

    def needs_call(self) -> bool:
        """9.5: every stroke that is to pot a ball is called, but the break."""
        return not (self.opening or self.over or self.options)

    def _as_called(self, shot: ShotSummary, call: Call) -> bool:
        """True if the called ball went into the called pocket (9.5)."""
        fallen = shot.pocketing(call.ball) if call.ball is not None else None
        return fallen is not None and fallen.pocket == call.pocket and not (call.safety or call.push_out)

    def _put_back(self, shot: ShotSummary, call: Call, fouls: tuple[Foul, ...]) -> tuple[int, ...]:
        """9.9: the 10 that left the table, or went down with a foul, at a push-out, at the break (9.3), or
        otherwise than called.
        """
        wins = call.ball == TEN and self._as_called(shot, call) and not fouls and not self.opening
        return (TEN,) if TEN in shot.off_table or (TEN in shot.balls_down and not wins) else ()

    def _go_on(self, after: Rotation, shot: ShotSummary, call: Call, words: list[str]) -> Verdict:
        """9.8: who pots the called ball plays on. 9.3: so does who pots any at the break."""
        if (self.opening and shot.pocketed) or (not self.opening and self._as_called(shot, call)):
            scored = tuple(ball for ball in shot.balls_down if ball != TEN)
            return Verdict(after, (), scored, (*words, f"{self.shooter} plays on."))
        after = msgspec.structs.replace(after, turn=self.other)
        if not shot.pocketed:
            lead = f"{self.shooter} played safe." if call.safety else "Nothing went down."
            return Verdict(after, (), (), (*words, lead, f"{after.shooter} plays."))
        # 9.6 after a safety, 9.7 otherwise
        lead = "A ball went down with a safety." if call.safety else self._why_not(shot, call)
        asked = msgspec.structs.replace(after, options=(PLAY, PASS_BACK), push_out_next=False)
        return Verdict(asked, (), (), (*words, lead, f"{asked.shooter} chooses who plays."))

    def _why_not(self, shot: ShotSummary, call: Call) -> str:
        """Why what went down does not count (9.7)."""
        if call.ball is None or call.pocket is None:
            return "No ball and pocket were called."
        if shot.pocketing(call.ball) is None:
            return f"The {call.ball} did not go down as called."
        return f"The {call.ball} went into another pocket."
