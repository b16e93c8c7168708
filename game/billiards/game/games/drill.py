"""Drills and trick shots: one set-up, one stroke, a goal; then the same again, or the next."""

from __future__ import annotations

import msgspec

from game.billiards.game.goals import Goal, missed, stars_of
from game.billiards.game.rules import Call, Game, Hand, ShotSummary, Verdict


class Drill(Game, frozen=True, kw_only=True, tag="drill"):
    """A drill, or a trick shot. After every stroke the set-up is to be put back (`Verdict.reset`).

    goal: for the first star; more: what the second and the third want besides. set_up: the numbered balls.
    attempts, made, streak: strokes, those that met the goal, and how many of the last did. best: most stars.
    tries: strokes of a set, 0 for no end; needed: how many of them must meet the goal.
    """

    players: tuple[str, ...] = ("Player",)
    fouls_in_row: tuple[int, ...] = (0,)
    won: tuple[int, ...] = (0,)
    in_hand: Hand = ""
    goal: Goal = Goal()
    more: tuple[Goal, ...] = ()
    set_up: tuple[int, ...] = ()
    attempts: int = 0
    made: int = 0
    streak: int = 0
    best: int = 0
    tries: int = 0
    needed: int = 0

    @property
    def final(self) -> bool:
        """True in a set of so many tries: what is counted is not taken back."""
        return self.tries > 0

    @property
    def set_over(self) -> bool:
        """True if all tries of a set have been made."""
        return 0 < self.tries <= self.attempts

    @property
    def from_behind(self) -> bool:
        """False: nothing is forbidden."""
        return False

    def stars(self, shot: ShotSummary) -> int:
        """Stars of a stroke: none if the goal is missed, one more for each further goal, in their order."""
        return stars_of((self.goal, *self.more), shot)

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke. `scored` of the verdict: what went down, if the goal is met."""
        self.check_playable()
        stars = self.stars(shot)
        after = msgspec.structs.replace(
            self,
            attempts=self.attempts + 1,
            made=self.made + (stars > 0),
            streak=self.streak + 1 if stars else 0,
            best=max(self.best, stars),
            on_table=self.set_up or self.on_table,
        )
        result: tuple[str, ...] = ()
        if after.set_over:
            after = msgspec.structs.replace(after, winner=0)
            met = "met" if after.made >= self.needed else "not met"
            result = (f"{after.made} of {self.tries}: {self.needed} were needed, {met}.",)
        if not stars:
            return Verdict(after, words=(*result, *missed(self.goal, shot)), reset=True)
        words = [*result, f"{'★' * stars}{'☆' * (1 + len(self.more) - stars)}"]
        if stars <= len(self.more):
            words += [f"For another star: {text}" for text in missed(self.more[stars - 1], shot)]
        return Verdict(after, (), shot.balls_down, tuple(words), reset=True)

    def next_rack(self) -> Verdict:
        """The set-up put back, the counts kept; after a set they begin again."""
        if not self.set_over:
            return Verdict(self, reset=True)
        fresh = msgspec.structs.replace(self, attempts=0, made=0, streak=0, winner=None)
        return Verdict(fresh, reset=True)
