"""Drills and trick shots: one set-up, one stroke, a goal; then the same again, or the next."""

from __future__ import annotations

import msgspec

from game.billiards.game.goals import Goal, missed
from game.billiards.game.rules import Call, Game, Hand, ShotSummary, Verdict


class Drill(Game, frozen=True, kw_only=True, tag="drill"):
    """A drill, or a trick shot. After every stroke the set-up is to be put back (`Verdict.reset`).

    goal: for the first star; more: what the second and the third want besides. set_up: the numbered balls.
    attempts, made, streak: strokes, those that met the goal, and how many of the last did. best: most stars.
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

    def stars(self, shot: ShotSummary) -> int:
        """Stars of a stroke: none if the goal is missed, one more for each further goal, in their order."""
        stars = 0
        for goal in (self.goal, *self.more):
            if missed(goal, shot):
                break
            stars += 1
        return stars

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
        if not stars:
            return Verdict(after, words=missed(self.goal, shot), reset=True)
        words = [f"{'★' * stars}{'☆' * (1 + len(self.more) - stars)}"]
        if stars <= len(self.more):
            words += [f"For another star: {text}" for text in missed(self.more[stars - 1], shot)]
        return Verdict(after, (), shot.balls_down, tuple(words), reset=True)

    def next_rack(self) -> Verdict:
        """The set-up put back, the counts kept."""
        return Verdict(self, reset=True)
