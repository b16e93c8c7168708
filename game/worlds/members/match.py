"""A match that is led along a curve, or held by a hand: where it is, and how it burns."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

from game.arrays import Point
from game.physics.animation.keyframes import Keyframes
from game.physics.kernels import elementary
from game.stage import Part

FLARE_S = 0.35  # s in which what flares up is weaker by e


class Way(NamedTuple):
    """curve: of the head (m, m) and of the angle of the wood (rad) over s since it was taken up. In the same
    s: struck, when it flares up; out, when it is shaken out; ends, when it is put away.
    """

    curve: Keyframes
    struck: float
    out: float
    ends: float


class LedMatch(Part):
    """began: s at which it was taken up, or -1; held: where the hand has its head (m), or None.

    long: m, of its wood. rest: its head (m, m) and the angle of its wood (rad) before; tilt: rad, in the
    hand. flares: how much brighter it is as it is struck, over its later flame.
    """

    long: ClassVar[float]
    rest: ClassVar[tuple[float, float, float]]
    tilt: ClassVar[float]
    flares: ClassVar[float]

    def __init__(self) -> None:
        self.began = -1.0
        self.held: Point | None = None

    def way(self) -> Way:
        """How it is led."""
        raise NotImplementedError

    def is_away(self, time: float) -> bool:
        """Whether it is not taken up yet, or put away again."""
        return self.began < 0.0 or time - self.began > self.way().ends

    def lit(self, time: float) -> bool:
        """Whether it burns."""
        if self.held is not None:
            return True
        way = self.way()
        return self.began >= 0.0 and way.struck <= time - self.began < way.out

    def strength(self, time: float) -> float:
        """Of its flame: 1, and more as it is struck; 0 while it does not burn."""
        if self.held is not None or not self.lit(time):
            return float(self.held is not None)
        since = time - self.began - self.way().struck
        return 1.0 + self.flares * elementary.exp(-since / FLARE_S)

    def pose(self, time: float) -> tuple[float, float, float]:
        """Its head (m, m) and the angle of its wood (rad)."""
        if self.held is not None:
            return *self.held, self.tilt
        if self.began < 0.0:
            return self.rest
        way = self.way()
        x, y, turn = way.curve.sample(min(max(time - self.began, 0.0), way.ends)).tolist()
        return x, y, turn

    def place(self, time: float) -> tuple[Point, Point]:
        """Its head and the end of its wood, m."""
        x, y, turn = self.pose(time)
        return (x, y), (x + self.long * elementary.cos(turn), y + self.long * elementary.sin(turn))
