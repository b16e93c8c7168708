"""Free practice: one player, nothing is forbidden, what goes down stays down."""

from __future__ import annotations

from typing import Literal

import msgspec

from game.billiards.game.rules import CUE_BALL, Call, Foul, Game, Hand, ShotSummary, Verdict, remaining

Place = tuple[int, float, float]
RACKS = {"eight-ball": tuple(range(1, 16)), "nine-ball": tuple(range(1, 10)), "": ()}


class Practice(Game, frozen=True, kw_only=True, tag="practice"):
    """Practice. rack: what is racked when the table is empty; "": nothing, the game is then over.

    set_up: ball, x, y m of a position of one's own, which is set up again instead; hand: where the cue ball
    may then be put. strokes, potted, run: all strokes, all balls, and balls since the last stroke that potted
    none.
    """

    players: tuple[str, ...] = ("Player",)
    on_table: tuple[int, ...] = RACKS["eight-ball"]
    in_hand: Hand = "behind the line"
    opening: bool = True
    fouls_in_row: tuple[int, ...] = (0,)
    won: tuple[int, ...] = (0,)
    rack: Literal["eight-ball", "nine-ball", ""] = "eight-ball"
    strokes: int = 0
    potted: int = 0
    run: int = 0
    set_up: tuple[Place, ...] = ()
    hand: Hand = ""

    @property
    def from_behind(self) -> bool:
        """False: nothing is forbidden."""
        return False

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke: a cue ball that went down is in hand."""
        self.check_playable()
        down = shot.balls_down
        fouls = (Foul("scratch", "The cue ball went down; put it anywhere."),) if shot.cue_pocketed else ()
        if CUE_BALL in shot.off_table:
            fouls = (Foul("off the table", "The cue ball left the table; put it anywhere."),)
        left = tuple(sorted({*remaining(self, shot), *shot.numbered_off}))
        after = msgspec.structs.replace(
            self,
            on_table=left,
            in_hand="anywhere" if fouls else "",
            opening=False,
            strokes=self.strokes + 1,
            potted=self.potted + len(down),
            run=self.run + len(down) if down and not fouls else 0,
        )
        words = [foul.words for foul in fouls]
        words += [f"The {ball} left the table and is put back." for ball in shot.numbered_off]
        if left:
            return Verdict(after, fouls, down, tuple(words), shot.numbered_off)
        if self.rack:
            return self._racked(after, fouls, down, (*words, "The table is empty: racked again."))
        after = msgspec.structs.replace(after, winner=0, won=(self.won[0] + 1,))
        return Verdict(after, fouls, down, (*words, "The table is empty."))

    def _racked(
        self, state: Practice, fouls: tuple[Foul, ...], down: tuple[int, ...], words: tuple[str, ...]
    ) -> Verdict:
        """All balls back in the rack; the counts go on."""
        racked = msgspec.structs.replace(
            state,
            on_table=RACKS[self.rack or "eight-ball"],
            in_hand="behind the line",
            opening=True,
            winner=None,
        )
        return Verdict(racked, fouls, down, words, rack=True)

    def next_rack(self) -> Verdict:
        """The position of one's own set up again, if there is one; else all balls racked."""
        if not self.set_up:
            return self._racked(self, (), (), ("Racked again.",))
        numbers = tuple(sorted(ball for ball, _, _ in self.set_up if ball != CUE_BALL))
        here = len(numbers) < len(self.set_up)
        again = msgspec.structs.replace(
            self, on_table=numbers, in_hand=self.hand if here else self.hand or "anywhere", opening=False,
            winner=None,
        )  # fmt: skip
        return Verdict(again, words=("Set up again.",), places=self.set_up)
