"""Drills of many strokes: a set-up that is to be cleared without a miss, again and again.

Line-up, circle and L-drill are of this kind: every stroke must pot a ball, in order or not, into one pocket
or any. The cue ball may have to stay off the cushions. The first stroke that does not ends the try, and the
balls are put back.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.billiards.game.rules import CUE_BALL, Call, Game, Hand, ShotSummary, Verdict, remaining

Place = tuple[int, float, float]
Count = Annotated[int, msgspec.Meta(ge=0)]


class RunDrill(Game, frozen=True, kw_only=True, tag="run-drill"):
    """A drill of many strokes.

    set_up: ball, x, y m of all, the cue ball among them, at the beginning of a try; hand: where the cue ball
    may then be put. ordered: the lowest ball is hit first and potted; pocket: its row, into which all must
    go, None for any; off_cushions: the cue ball touches no cushion. run: balls of this try so far; attempts,
    potted: tries that are over, and the balls of all of them; best: the most of a try. tries: of a set, 0
    for no end; needed: balls in it.
    """

    players: tuple[str, ...] = ("Player",)
    fouls_in_row: tuple[int, ...] = (0,)
    won: tuple[int, ...] = (0,)
    set_up: tuple[Place, ...] = ()
    hand: Hand = ""
    ordered: bool = False
    pocket: Annotated[int, msgspec.Meta(ge=0, le=5)] | None = None
    off_cushions: bool = False
    run: Count = 0
    attempts: Count = 0
    potted: Count = 0
    best: Count = 0
    tries: Count = 0
    needed: Count = 0

    @property
    def count(self) -> int:
        """Balls of a try."""
        return sum(1 for ball, _, _ in self.set_up if ball != CUE_BALL)

    @property
    def final(self) -> bool:
        """True in a set of so many tries."""
        return self.tries > 0

    @property
    def set_over(self) -> bool:
        """True if all tries of a set have been made."""
        return 0 < self.tries <= self.attempts

    @property
    def from_behind(self) -> bool:
        """False: nothing is forbidden."""
        return False

    def legal_first(self) -> tuple[int, ...]:
        """The lowest ball, if they are potted in order."""
        return self.on_table[:1] if self.ordered else self.on_table

    def targets(self) -> tuple[int, ...]:
        """What counts if it goes down."""
        return self.legal_first()

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke: the next ball, or the next try."""
        self.check_playable()
        why = self._why_over(shot)
        run = self.run + (0 if why else len(shot.balls_down))
        left = remaining(self, shot)
        if not why and left:
            after = msgspec.structs.replace(self, on_table=left, in_hand="", run=run)
            return Verdict(after, (), shot.balls_down, (f"{run} of {self.count}.",))
        return self._tried(run, why or "All of them.", () if why else shot.balls_down)

    def _why_over(self, shot: ShotSummary) -> str:
        """Why a stroke ends the try; empty if it does not."""
        if shot.cue_pocketed:
            return "The cue ball went down."
        lowest = self.on_table[0]
        if self.ordered and lowest not in shot.first:
            return f"The {lowest} was not hit first."
        if not shot.pocketed or (self.ordered and lowest not in shot.balls_down):
            return f"The {lowest} did not go down." if self.ordered else "Nothing went down."
        if self.pocket is not None and any(fallen.pocket != self.pocket for fallen in shot.pocketed):
            return "A ball went into another pocket."
        if self.off_cushions and any(kind == "cushion" for kind, _ in shot.cue_path):
            return "The cue ball touched a cushion."
        return ""

    def _tried(self, run: int, why: str, scored: tuple[int, ...]) -> Verdict:
        """The try is over with so many balls: the next one."""
        after = msgspec.structs.replace(
            self._begun(), attempts=self.attempts + 1, potted=self.potted + run, best=max(self.best, run)
        )
        words: tuple[str, ...] = (why, f"{run} of {self.count}.")
        if after.set_over:
            after = msgspec.structs.replace(after, winner=0)
            met = "met" if after.potted >= self.needed else "not met"
            total = self.tries * self.count
            words = (f"{after.potted} of {total} balls: {self.needed} were needed, {met}.", *words)
        return Verdict(after, (), scored, words, places=self.set_up)

    def _begun(self) -> RunDrill:
        """A try at its beginning."""
        numbers = tuple(sorted(ball for ball, _, _ in self.set_up if ball != CUE_BALL))
        return msgspec.structs.replace(self, on_table=numbers, in_hand=self.hand, run=0)

    def next_rack(self) -> Verdict:
        """The set-up put back; after a set the counts begin again."""
        fresh = self._begun()
        if self.set_over:
            fresh = msgspec.structs.replace(fresh, attempts=0, potted=0, best=0, winner=None)
        return Verdict(fresh, places=self.set_up)
