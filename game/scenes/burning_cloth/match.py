"""A match that is led along a curve: struck on its box, held to each letter, shaken out."""

from __future__ import annotations

import numpy as np

from game.arrays import Point
from game.physics.animation.keyframes import Keyframes
from game.physics.cloth import Flame
from game.scenes.burning_cloth.tables import BOX, BOX_HIGH, ROOM, TABLE
from game.worlds.members.match import LedMatch, Way

STRIKE_FROM, STRIKE_TO = (BOX[1] + 0.012, TABLE + BOX_HIGH + 0.004), (BOX[0], TABLE + BOX_HIGH + 0.006)
TILT = -0.75  # rad: which way its wood lies while it is held
LIFT, STRIKE, NEAR, TOUCH, ON, HOME = 0.7, 0.28, 1.5, 2.3, 0.75, 1.3  # s of the parts of its way
SLOW = 0.3  # s in which it is set on the box
RADIUS, HOT, EXCHANGE = 0.03, 1450.0, 150.0  # m, K, W/(m² K) of its flame
WATT = 90.0  # of the part of its flame that only warms the gas
ABOVE = 0.02  # m: its flame is over its head


class Match(LedMatch):
    """feet (n, 2) m: what it was to be held to when it was taken up."""

    long, rest, tilt, flares = 0.13, (1.3, TABLE + 0.012, 3.1), TILT, 0.8

    def __init__(self) -> None:
        super().__init__()
        self.feet: list[Point] = []
        self._way: Way | None = None
        self._laid_for: tuple[Point, ...] = ()

    def take_up(self, time: float, feet: list[Point]) -> None:
        """Take it up, strike it, and lead it to these places (m), unless it is on its way."""
        if self.is_away(time):
            self.began, self.feet = time, [(float(x), float(y)) for x, y in feet]

    def way(self) -> Way:
        """The curve of C01 for these places; laid again when they are others."""
        if self._way is not None and self._laid_for == tuple(self.feet):
            return self._way
        times, keys = [0.0], [self.rest]
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
        out = now + 0.45 * HOME
        keys.append((STRIKE_TO[0] + 0.1, TABLE + 0.3, -0.2))
        times.append(now := now + 0.6 * HOME)
        keys.append((*self.rest[:2], 0.05))
        times.append(now := now + HOME)
        self._laid_for = tuple(self.feet)
        curve = Keyframes(times, np.array(keys), "centripetal", geometry=(0, 1))
        self._way = Way(curve, LIFT + SLOW + 0.6 * STRIKE, out, now)
        return self._way

    def flame(self, time: float) -> Flame:
        """What it does to the cloth."""
        strong = self.strength(time)
        if strong <= 0.0:
            return Flame(0.0, 0.0, RADIUS, ROOM, 0.0, 0.0)
        (x, y), _ = self.place(time)
        return Flame(x, y + ABOVE, RADIUS, HOT, EXCHANGE, min(strong, 1.0))

    def used(self, time: float) -> bool:
        """Whether it is burnt down."""
        return self.began >= 0.0 and time - self.began >= self.way().struck
