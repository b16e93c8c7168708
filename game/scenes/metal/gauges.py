"""The gauges of a level: what is measured of its balls, and what is exact."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from game.arrays import Floats
from game.physics.kernels import elementary
from game.physics.solids.tracks import DISC, motion
from game.physics.solids.tracks import descent as d
from game.scenes.metal.balls import NOT_YET, Table
from game.scenes.metal.level import GaugeEntry, MetalContent
from game.worlds.entries.tracks import TrackEntry

VALUE, NOTE, SECOND = range(3)  # columns of a gauge
GAUGE_WIDTH = 3
AT_ITS_START = 1e-6  # m
DESCENTS: dict[str, Callable[[float, float, float, float], float]] = {
    "line": d.line_time, "cycloid": d.cycloid_time, "arc": d.arc_time,
}  # fmt: skip
OF_A_BALL = ("speeds up", "arrives", "drop", "leaves", "rode", "rises", "speed")
OF_A_LOOP = ("drop", "leaves")


class Moment(NamedTuple):
    """A ball in a step: its row after it and before, what it was let go with (table, number), and the step's
    end, s.
    """

    row: Floats
    before: Floats
    rolls: bool
    rolled: bool
    own: Table
    ball: int
    time: float
    dt: float
    gravity: float

    def crossing(self, level: float) -> tuple[float, float] | None:
        """When (s) and how high (m) it passed x = level in this step, to the right or the left."""
        x0, x1 = float(self.before[motion.X]), float(self.row[motion.X])
        if x0 == x1 or not min(x0, x1) < level <= max(x0, x1):
            return None
        share = d.crossing_share(
            x0, x1, float(self.before[motion.VX]) * self.dt, float(self.row[motion.VX]) * self.dt, level
        )
        y = float(self.before[motion.Y]) + (level - x0) / (x1 - x0) * float(
            self.row[motion.Y] - self.before[motion.Y]
        )
        return self.time - (1.0 - share) * self.dt, y


def names_of(content: MetalContent) -> list[str]:
    """Names of the balls of a level: their own, or their numbers from 1 on."""
    return [one.name or f"ball {k + 1}" for k, one in enumerate(content.balls)]


def balls_of(content: MetalContent) -> list[int]:
    """The ball of each gauge, or -1. ValueError, naming the gauge, for one that there is not."""
    names, found = names_of(content), []
    for gauge in content.gauges:
        if gauge.measure not in OF_A_BALL:
            found.append(-1)
            continue
        if gauge.of not in names:
            raise ValueError(f"gauges: {gauge.name!r} is of {gauge.of!r}; there are {', '.join(names)}")
        if gauge.measure in OF_A_LOOP and not _is_loop(content, gauge.track):
            raise ValueError(f"gauges: {gauge.name!r} is of track {gauge.track}, which is no loop")
        found.append(names.index(gauge.of))
    return found


def _is_loop(content: MetalContent, number: int) -> bool:
    return number < len(content.tracks) and content.tracks[number].form == "loop"


def measure(gauge: GaugeEntry, noted: Floats, track: TrackEntry | None, now: Moment) -> None:
    """One step of one ball, into a gauge's numbers (3,)."""
    if gauge.measure == "speed":
        noted[VALUE] = elementary.hypot(float(now.row[motion.VX]), float(now.row[motion.VY]))
    elif now.own.freed[now.ball] == NOT_YET:
        return
    elif gauge.measure == "rises":
        noted[VALUE] = float(now.own.highest[now.ball] - now.own.y[now.ball])
    elif gauge.measure == "leaves" and track is not None:
        _note_leaving(noted, track, now)
    elif noted[VALUE] == NOT_YET:
        _note_crossing(gauge, noted, now)


def _note_leaving(noted: Floats, track: TrackEntry, now: Moment) -> None:
    """The angle at which the push of the loop became zero, between the step's beginning and its end."""
    if noted[VALUE] != NOT_YET or not now.rolled or now.rolls:
        return
    places = []
    for row in (now.before, now.row):
        x, y = float(row[motion.X]) - track.at[0], float(row[motion.Y]) - track.at[1] - track.size[0]
        if elementary.hypot(x, y) >= track.size[0]:
            return
        speed = elementary.square(float(row[motion.VX])) + elementary.square(float(row[motion.VY]))
        push = speed / (track.size[0] - float(row[motion.RADIUS])) - now.gravity * y / elementary.hypot(x, y)
        places.append((elementary.atan2(x, y), push))
    (angle, push), (after, pull) = places
    share = push / (push - pull) if push > 0.0 > pull else 1.0
    noted[VALUE] = abs(math.degrees(angle + share * (after - angle)))


def _note_crossing(gauge: GaugeEntry, noted: Floats, now: Moment) -> None:
    if gauge.measure == "rode" and now.rolled and not now.rolls:
        noted[NOTE] = 1.0
    passed = now.crossing(gauge.level)
    if passed is None:
        return
    time, y = passed
    took = time - float(now.own.freed[now.ball])
    if gauge.measure == "rode":
        noted[VALUE] = 0.0 if noted[NOTE] else 1.0
    elif gauge.measure == "arrives":
        noted[VALUE] = took
    elif gauge.measure == "speeds up" and took > 0.0:
        across, down = gauge.level - float(now.own.x[now.ball]), float(now.own.y[now.ball]) - y
        noted[VALUE] = 2.0 * elementary.hypot(across, down) / (took * took)
        noted[NOTE] = elementary.atan2(down, abs(across))


def exact_of(
    gauge: GaugeEntry, noted: Floats, track: TrackEntry | None, of: tuple[Table, int, Floats], gravity: float
) -> float:
    """What theory says of a gauge, for balls that roll without slip; NaN where it says nothing. of: all
    balls, the one that it measures and its row.
    """
    own, ball, row = of
    if gauge.measure == "speeds up" and noted[VALUE] != NOT_YET:
        return d.rolling_acceleration(float(noted[NOTE]), gravity, DISC)
    if track is None or gravity <= 0.0:
        return math.nan
    if gauge.measure == "leaves":
        drop = drop_of(track, own, ball, row)
        return math.degrees(d.leaving_angle(drop, track.size[0], float(row[motion.RADIUS]), DISC))
    if gauge.measure == "drop":
        return d.loop_drop(track.size[0], float(row[motion.RADIUS]), DISC)
    if gauge.measure == "arrives" and track.form in DESCENTS:
        start = (own.x[ball], own.y[ball]) if own.freed[ball] != NOT_YET else (row[motion.X], row[motion.Y])
        if elementary.dist(start, track.at) < AT_ITS_START:
            return DESCENTS[track.form](*track.size, gravity, DISC)
    return math.nan


def drop_of(track: TrackEntry, own: Table, ball: int, row: Floats) -> float:
    """How far (m) a ball's centre begins above its place at a loop's foot."""
    y = float(own.y[ball] if own.freed[ball] != NOT_YET else row[motion.Y])
    return y - track.at[1] - float(row[motion.RADIUS])
