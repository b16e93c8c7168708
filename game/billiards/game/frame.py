"""A frame: game, table and balls together, and what a stroke or a choice makes of them.

All values are immutable: undo keeps the frame before, and plays on from it.
"""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.arrangement import (
    Arrangement,
    BallSet,
    Stroke,
    after_shot,
    is_free,
    racked,
    spotted,
)
from game.billiards.game.rules import CUE_BALL, Call, Game, ShotSummary, Verdict
from game.billiards.game.summary import summarize
from game.billiards.shot.shot import Physics
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate
from game.billiards.table.table import Table


class Frame(NamedTuple):
    """A game before a stroke: the rules' state, the balls, the table, its physics."""

    game: Game
    lie: Arrangement
    table: Table
    physics: Physics = Physics()

    def place_white(self, x: float, y: float) -> Frame:
        """The white ball put down at (x, y) m. ValueError if it is not in hand, or not allowed there."""
        hand = self.game.in_hand
        if not hand:
            raise ValueError("white ball: it is not in hand")
        if not is_free(self.lie, self.table, CUE_BALL, x, y, hand):
            raise ValueError(f"white ball: ({x:.3f}, {y:.3f}) m is not free, or not {hand}")
        return self._replace(lie=self.lie.with_ball(CUE_BALL, (x, y)))

    def play(self, stroke: Stroke, call: Call = Call()) -> Played:  # noqa: B008  (immutable)
        """Play a stroke and judge it. ValueError if it may not be played, or no white ball lies there."""
        self.game.check_playable()
        if self.lie.place_of(CUE_BALL) is None:
            raise ValueError("white ball: it must be put down first")
        trajectory = simulate(self.lie.shot(self.table, self.physics, stroke))
        summary = summarize(trajectory)
        verdict = self.game.judge(summary, call)
        return Played(trajectory, summary, verdict, self.follow(verdict, after_shot(self.lie, summary)))

    def choose(self, name: str, seed: int | None = None) -> Frame:
        """The frame after the player at turn has chosen an option. seed: of a new rack, if there is one."""
        return self.follow(self.game.choose(name), self.lie, seed)

    def next_rack(self, seed: int | None = None) -> Frame:
        """The next rack. ValueError if the game has none."""
        return self.follow(self.game.next_rack(), self.lie, seed)

    def follow(self, verdict: Verdict, lie: Arrangement, seed: int | None = None) -> Frame:
        """The frame that a verdict leads to, from the balls as they lie after the stroke."""
        if verdict.reset:
            lie = self.lie
        elif verdict.rack:
            lie = rack_for(verdict.game, self.table, self.lie.balls, seed)
        else:
            lie = spotted(lie, self.table, verdict.spot)
        return self._replace(game=verdict.game, lie=lie)


class Played(NamedTuple):
    """A stroke that has been played: its paths, its summary, the verdict, and the frame to go on with."""

    trajectory: Trajectory
    summary: ShotSummary
    verdict: Verdict
    frame: Frame


def rack_for(game: Game, table: Table, balls: BallSet | None = None, seed: int | None = None) -> Arrangement:
    """The balls racked for a game, those that it is played with."""
    full = racked(table, "nine-ball" if max(game.on_table, default=0) <= 9 else "eight-ball", balls, seed)
    return full.without(*(n for n in full.numbers if n != CUE_BALL and n not in game.on_table))


def new_frame(game: Game, table: Table | None = None, balls: BallSet | None = None,
              seed: int | None = None) -> Frame:  # fmt: skip
    """A game with its balls racked on a pool table. seed: see `arrangement.racked`."""
    table = Table.pool() if table is None else table
    return Frame(game, rack_for(game, table, balls, seed), table)
