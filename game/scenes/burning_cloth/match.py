"""A match that is led along a curve: struck on its box, held to each letter, shaken out."""

from __future__ import annotations

import numpy as np

from game.physics.animation.keyframes import Keyframes
from game.physics.cloth import Flame
from game.physics.kernels import elementary
from game.scenes.burning_cloth.tables import BOX, BOX_HIGH, ROOM, TABLE
from game.stage import Part

Point = tuple[float, float]
LONG = 0.13  # m
REST = (1.3, TABLE + 0.012, 3.1)  # where its head lies on the table, m, m, rad; the wood lies from there on
STRIKE_FROM, STRIKE_TO = (BOX[1] + 0.012, TABLE + BOX_HIGH + 0.004), (BOX[0], TABLE + BOX_HIGH + 0.006)
TILT = -0.75  # rad: which way its wood lies while it is held
LIFT, STRIKE, NEAR, TOUCH, ON, HOME = 0.7, 0.28, 1.5, 2.3, 0.75, 1.3  # s of the parts of its way
SLOW = 0.3  # s in which it is set on the box
FLARE = 0.35  # s
RADIUS, HOT, EXCHANGE = 0.03, 1450.0, 150.0  # m, K, W/(m² K) of its flame
WATT = 90.0  # of the part of its flame that only warms the gas
ABOVE = 0.02  # m: its flame is over its head
LAST_S = 60.0


class Match(Part):
    """began: s at which it was taken up, or -1; feet (n, 2) m: what it was to be held to then; held: where
    the hand has it.
    """

    def __init__(self) -> None:
        self.began = -1.0
        self.feet: list[Point] = []
        self.held: Point | None = None
        self._curve: Keyframes | None = None
        self._drawn_for: tuple[Point, ...] = ()
        self._ends = 0.0

    def take_up(self, time: float, feet: list[Point]) -> None:
        """Take it up, strike it, and lead it to these places (m), unless it is on its way."""
        if self.began < 0.0 or time - self.began > self.lasts():
            self.began, self.feet = time, [(float(x), float(y)) for x, y in feet]

    def _keys(self) -> Keyframes:
        """The curve of C01 for these places; laid again when they are others."""
        if self._curve is not None and self._drawn_for == tuple(self.feet):
            return self._curve
        times, keys = [0.0], [REST]
        now = LIFT
        keys.append((*STRIKE_FROM, 2.6))
        times.append(now)
        keys.append((STRIKE_FROM[0] - 0.012, STRIKE_FROM[1], 2.5))
        times.append(now := now + SLOW)
        keys.append((*STRIKE_TO, 2.3))
        times.append(now := now + STRIKE)
        keys.append((STRIKE_TO[0] - 0.1, STRIKE_TO[1] + 0.12, 0.6))
        times.append(now := now + 0.5)
        way = NEAR
        for x, y in self.feet:
            keys.append((x, y - ABOVE, TILT))
            times.append(now := now + way)
            keys.append((x + 0.004, y - ABOVE + 0.006, TILT - 0.04))
            times.append(now := now + TOUCH)
            way = ON
        self._out = now + 0.45 * HOME
        keys.append((STRIKE_TO[0] + 0.1, TABLE + 0.3, -0.2))
        times.append(now := now + 0.6 * HOME)
        keys.append((REST[0], REST[1], 0.05))
        times.append(now := now + HOME)
        self._ends = now
        self._drawn_for = tuple(self.feet)
        self._curve = Keyframes(times, np.array(keys), "centripetal", geometry=(0, 1))
        return self._curve

    def lasts(self) -> float:
        """s of its way."""
        self._keys()
        return self._ends

    def struck(self) -> float:
        """s after it was taken up at which it flares up."""
        return LIFT + SLOW + 0.6 * STRIKE

    def lit(self, time: float) -> bool:
        """Whether it burns."""
        if self.held is not None:
            return True
        self._keys()
        return self.began >= 0.0 and self.struck() <= time - self.began < self._out

    def strength(self, time: float) -> float:
        """Of its flame: it flares up as it is struck."""
        if not self.lit(time):
            return 0.0
        if self.held is not None:
            return 1.0
        since = time - self.began - self.struck()
        return 1.0 + 0.8 * elementary.exp(-since / FLARE)

    def flame(self, time: float) -> Flame:
        """What it does to the cloth."""
        strong = self.strength(time)
        if strong <= 0.0:
            return Flame(0.0, 0.0, RADIUS, ROOM, 0.0, 0.0)
        (x, y), _ = self.place(time)
        return Flame(x, y + ABOVE, RADIUS, HOT, EXCHANGE, min(strong, 1.0))

    def place(self, time: float) -> tuple[Point, Point]:
        """Its head and the end of its wood, m."""
        if self.held is not None:
            x, y, turn = *self.held, TILT
        elif self.began < 0.0:
            x, y, turn = REST
        else:
            x, y, turn = self._keys().sample(min(max(time - self.began, 0.0), self._ends)).tolist()
        return (x, y), (x + LONG * elementary.cos(turn), y + LONG * elementary.sin(turn))

    def used(self, time: float) -> bool:
        """Whether it is burnt down."""
        return self.began >= 0.0 and time - self.began >= self.struck()
