"""What a world has heard in the last moments: impacts of solids, and whatever else its members add."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.solids import SolidWorld
from game.stage import Sound, Steady
from game.worlds.world import Member

HEARD_TIME, HEARD_KIND, HEARD_SPEED, HEARD_X = range(4)  # columns: s, number of the kind, m/s, m
HEARD_WIDTH = 4
REMEMBERED_S = 0.4  # s that an impact stays among those heard: more than the longest gap that is heard


ROOM = Steady("room", 0.05)  # the tone of a place where nothing happens
WIND_SPEED = 12.0  # m/s, of a wind that roars
LOUDEST = 0.5  # level of what goes on, at its reference and above


def fire(power: float, reference: float, pan: float = 0.0) -> Steady:
    """Flames of so much power, as loud as can be at ``reference`` (same unit) and above."""
    return Steady("flame", LOUDEST * math.sqrt(min(max(power, 0.0) / reference, 1.0)), pan=pan)


def wind(speed: float, pan: float = 0.0) -> Steady:
    """Wind of a speed m/s, louder and brighter as it is faster."""
    share = min(abs(speed) / WIND_SPEED, 1.0)
    return Steady("wind", LOUDEST * share, share, pan)


def rows_of(time: float, kind: int, speeds: Floats, places: Floats) -> Floats:
    """Sounds (k, HEARD_WIDTH) of one kind at a time (s), of speeds m/s and at x m, (k,) each."""
    found = np.empty((len(speeds), HEARD_WIDTH))
    found[:, HEARD_TIME], found[:, HEARD_KIND] = time, kind
    found[:, HEARD_SPEED], found[:, HEARD_X] = speeds, places
    return found


def is_due(every: float, time: float, dt: float) -> bool:
    """Whether a grain of what goes on is to be heard in a step of dt (s) that ends at a time: one in each
    ``every`` s.
    """
    return int(time / every) != int((time - dt) / every)


class Heard(Member):
    """``rows`` (k, HEARD_WIDTH), those of the last moments, at most ``most`` of them."""

    kept = ("rows",)

    def __init__(self, most: int = 24, seconds: float = REMEMBERED_S):
        self.most, self.seconds = most, seconds
        self.rows: Floats = np.zeros((0, HEARD_WIDTH))

    def remember(self, added: Floats, began: float) -> None:
        """Take sounds (k, HEARD_WIDTH) of a step that began at a time (s), in order; forget old ones."""
        self.forget(began)
        if len(added):
            added = added[np.lexsort((added[:, HEARD_X], added[:, HEARD_TIME]))]
            self.append(added)

    def append(self, added: Any) -> None:
        """More sounds (k, HEARD_WIDTH)."""
        self.rows = np.concatenate([self.rows, added])[-self.most :]

    def add(self, time: float, kind: int, speed: float, x: float) -> None:
        """One more sound."""
        self.append([(time, float(kind), speed, x)])

    def forget(self, now: float) -> None:
        """Leave out what is over."""
        if len(self.rows):
            self.rows = self.rows[self.rows[:, HEARD_TIME] > now - self.seconds]

    def sounds(self, names: Mapping[int, str], half: float, middle: float = 0.0) -> list[Sound]:
        """By the names of kinds; ``half`` m beside the middle is all on one side."""
        return sounds_of(self.rows, names, half, middle)


def sounds_of(rows: Floats, names: Mapping[int, str], half: float, middle: float = 0.0) -> list[Sound]:
    """Rows (k, HEARD_WIDTH) as sounds, see `Heard.sounds`."""
    return [
        Sound(time, names[int(kind)], speed, max(-1.0, min(1.0, (x - middle) / half)))
        for time, kind, speed, x in rows.tolist()
    ]


class Impacts(NamedTuple):
    """Contacts that began in a step: place x, y m, impulse N s, speed of approach m/s, s after the step's
    beginning (k, 5); the two bodies and the kinds of both shapes, (k, 2) each.
    """

    rows: Floats
    bodies: Longs
    shapes: Longs

    def heard(self, began: float, kinds: Any, speeds: Floats) -> Floats:
        """As sounds (k, HEARD_WIDTH) of these kinds and speeds (k,)."""
        kinds = np.asarray(kinds, dtype=np.float64)
        return np.stack([began + self.rows[:, 4], kinds, speeds, self.rows[:, 0]], axis=1)

    def take(self, which: Any) -> Impacts:
        """Only those (numbers or flags)."""
        return Impacts(self.rows[which], self.bodies[which], self.shapes[which])

    def by_impulse(self, reference: float, most: float) -> Floats:
        """Speeds (k,) m/s, a heavy one as a light one (of ``reference`` kg) that is faster."""
        fast = self.rows[:, 3]
        return np.asarray(fast * np.clip(self.rows[:, 2] / (reference * fast), 0.3, most))


NONE = Impacts(np.zeros((0, 5)), np.zeros((0, 2), np.int64), np.zeros((0, 2), np.int64))


def impacts(world: SolidWorld, least: float) -> Impacts:
    """Of the last step, those that were faster than ``least`` m/s: what leans and slides is silent."""
    shapes, places = world.contacts_begun()
    of: Any = world.shapes
    if not len(places):
        return NONE
    loud = np.flatnonzero(places[:, 3] > least)
    return Impacts(places[loud], of.bodies[shapes[loud]], of.kinds[shapes[loud]])
