"""Balls on tracks as a level makes them: stepped, changed by hand, measured by its gauges."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.solids.tracks import Curve, TrackState
from game.physics.solids.tracks import motion as m
from game.scenes.tracks.level import BallEntry, GaugeEntry, TrackContent
from game.scenes.tracks.parameters import COLOURS, TrackParameters
from game.worlds.members.tracks import REACH, Tracks
from game.worlds.world import Member, World

OWN_FRICTION, OWN_RESTITUTION, COLOUR_BITS = 256, 512, 255
OWN = {  # parameters of the card: column of the ball's row, and what marks it as the ball's own
    "own_mass": (m.MASS, 0), "own_friction": (m.FRICTION, OWN_FRICTION),
    "own_restitution": (m.BOUNCE, OWN_RESTITUTION),
}  # fmt: skip
TRAIL = 160  # places that are remembered of each ball
RIDERS = 50  # bits that a float holds, with some to spare
NOT_YET = 0.0
BEGIN_X, BEGIN_Y, BEGIN_VX, BEGIN_VY, BEGIN_SPIN, SEATED, ROLLING = range(7)  # of what a ball begins with
BEGIN_WIDTH = 7
BEYOND = 0.5  # of the view's width and height: a ball that flies so far beside it has left
LIVE = ("period", "speed", "high", "past")  # gauges that go on measuring
ALL = slice(None)


class TracksState(NamedTuple):
    """Tracks and balls as `Tracks` keeps them; what `Balls` and the gauges remember."""

    balls: TrackState
    points: Floats
    starts: Longs
    kinds: Floats
    tints: Longs
    energies: Floats
    gauges: Floats
    trail: Floats
    begun: Floats
    spent: Floats


class Balls(Member):
    """tints (n,): colour, and which of its numbers are its own; energies (n,): J, when it was let go; gauges
    (g, 3): value and two notes; trail (TRAIL, n, 2) m; begun (n, BEGIN_WIDTH): what each begins with again;
    spent (1,): J that were lost before the balls were let go as they are now.
    """

    kept = ("tints", "energies", "gauges", "trail", "begun", "spent")

    def __init__(self, gauges: int):
        self.tints: Longs = np.zeros(0, dtype=np.int64)
        self.energies: Floats = np.zeros(0)
        self.gauges: Floats = np.zeros((gauges, 3))
        self.trail: Floats = np.zeros((TRAIL, 0, 2))
        self.begun: Floats = np.zeros((0, BEGIN_WIDTH))
        self.spent: Floats = np.zeros(1)


class TracksWorld(World):
    """Balls and tracks. steps: since the beginning. held: ball in the hand, or -1; inspected: ball whose card
    is open, or -1.
    """

    state_type = TracksState
    content: TrackContent
    parameters: TrackParameters

    def __init__(self, content: TrackContent, parameters: TrackParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.tracks = Tracks(content.tracks, parameters, active, int(parameters.chords))
        self.balls = Balls(len(content.gauges))
        self.members = (self.tracks, self.balls)
        self.steps, self.held, self.inspected = 0, -1, -1
        for entry in content.balls:
            self.add(entry)
        for k, gauge in enumerate(content.gauges):
            if gauge.of >= len(content.balls):
                raise ValueError(
                    f"gauges: {gauge.name!r} is of ball {gauge.of}; there are {len(content.balls)}"
                )
            if gauge.measure == "arrives":
                start = self.rows[gauge.of, m.X]
                self.balls.gauges[k, 1] = math.copysign(1.0, gauge.level - start)

    @property
    def rows(self) -> Floats:
        """Of the balls, see `motion`."""
        return self.tracks.riders.balls.rows

    # -- changes --------------------------------------------------------------------------------------

    def add(self, entry: BallEntry) -> int:
        """A ball; its number. ValueError."""
        parameters, riders, balls = self.parameters, self.tracks.riders, self.balls
        ball = riders.add_ball(
            entry.position, entry.radius, entry.velocity, entry.spin, share=entry.share, mass=entry.mass,
            friction=parameters.friction if entry.friction is None else entry.friction,
            restitution=parameters.restitution if entry.restitution is None else entry.restitution,
        )  # fmt: skip
        own = OWN_FRICTION * (entry.friction is not None) + OWN_RESTITUTION * (entry.restitution is not None)
        balls.tints = np.append(balls.tints, COLOURS.index(entry.colour) + own)
        begun = (*entry.position, *entry.velocity, entry.spin, entry.seated, entry.rolling)
        balls.begun = np.vstack([balls.begun, begun])
        self._seat(ball)
        balls.energies = np.append(balls.energies, float(riders.energies()[ball].sum()))
        place = self.rows[ball, m.X : m.Y + 1]
        balls.trail = np.concatenate([balls.trail, np.broadcast_to(place, (TRAIL, 1, 2))], axis=1)
        return ball

    def _seat(self, ball: int) -> None:
        """Put a ball on the track where it begins, if it begins on one."""
        begun, row = self.balls.begun[ball], self.rows[ball]
        if begun[SEATED] and self.tracks.riders.put_down(ball, REACH) and begun[ROLLING]:
            row[m.SPIN] = -row[m.SPEED] / row[m.RADIUS]

    def _losses(self) -> Floats:
        """(n,) J that each ball has lost since it was let go."""
        return np.asarray(self.balls.energies - self.tracks.riders.energies().sum(axis=1))

    def lost(self) -> float:
        """J that friction and impacts have taken since the beginning."""
        return float(self.balls.spent[0]) + float(self._losses().sum())

    @contextmanager
    def changing(self, which: Any = ALL) -> Iterator[None]:
        """While something else than a step changes balls: what they have lost stays lost, and afterwards
        their speeds are compared with what their new energies allow.
        """
        self.balls.spent[0] += float(self._losses()[which].sum())
        yield
        self.balls.energies[which] = self.tracks.riders.energies().sum(axis=1)[which]

    def hold(self, ball: int, place: Point) -> None:
        """Put a ball somewhere, at rest and free."""
        with self.changing(ball):
            self.tracks.hold(ball, place)

    def put_down(self, ball: int, reach: float) -> None:
        """Onto a track within reach (m), if there is one."""
        with self.changing(ball):
            self.tracks.riders.put_down(ball, reach)

    def begin_here(self, ball: int) -> None:
        """A ball that was let go by hand begins there, whenever it comes back."""
        x, y = self.rows[ball, m.X : m.Y + 1].tolist()
        self.balls.begun[ball] = x, y, 0.0, 0.0, 0.0, self.tracks.rolling()[ball], False

    def remove(self, ball: int) -> None:
        """Take a ball away."""
        balls = self.balls
        balls.spent[0] += float(self._losses()[ball])
        self.tracks.riders.remove_ball(ball)
        self.inspected = -1  # numbers shift
        balls.begun = np.delete(balls.begun, ball, axis=0)
        balls.tints, balls.energies = np.delete(balls.tints, ball), np.delete(balls.energies, ball)
        balls.trail = np.delete(balls.trail, ball, axis=1)

    # -- what a ball has of its own -------------------------------------------------------------------

    def inspect(self, ball: int) -> None:
        """Open the card of a ball, or with -1 put it away."""
        self.inspected = ball
        if ball >= 0:
            self.show_own(ball)

    def show_own(self, ball: int) -> None:
        """Let the parameters of the card say what a ball has, as near as they can say it."""
        for name, (column, _) in OWN.items():
            ends, value = getattr(type(self.parameters), name), float(self.rows[ball, column])
            setattr(self.parameters, name, min(max(value, ends.minimum), ends.maximum))
        self.parameters.own_colour = COLOURS[int(self.balls.tints[ball]) & COLOUR_BITS]

    def give_own(self, ball: int, name: str) -> None:
        """Give a ball what the parameter of that name says is its own; a lighter one keeps its speed."""
        tints, value = self.balls.tints, self.parameters.values[name]
        if name == "own_colour":
            tints[ball] = (int(tints[ball]) & ~COLOUR_BITS) | COLOURS.index(value)
            return
        column, own = OWN[name]
        with self.changing(ball):
            self.rows[ball, column] = value
        tints[ball] |= own

    def lay(self, curves: list[Curve]) -> None:
        """Other tracks. ValueError for one that cannot be."""
        with self.changing():
            self.tracks.lay(curves)

    def change_parameter(self, name: str) -> None:
        with self.changing() if name == "gravity" else nullcontext():
            super().change_parameter(name)
        tints = self.balls.tints
        if name == "friction":
            self.rows[tints & OWN_FRICTION == 0, m.FRICTION] = self.parameters.friction
        elif name == "restitution":
            self.rows[tints & OWN_RESTITUTION == 0, m.BOUNCE] = self.parameters.restitution

    def change_effects(self, active: EffectSet) -> None:
        with self.changing():
            super().change_effects(active)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """One step; a ball that is held stays where it is."""
        balls, held = self.tracks.riders.balls, self.held
        kept = (balls.rows[held].copy(), balls.pieces[held].copy()) if 0 <= held < len(balls.rows) else None
        before, on = balls.rows[:, m.X : m.Y + 1].copy(), self.tracks.rolling()
        with self.tracks.watch.time("step"):
            self.tracks.riders.step(dt)
        if kept is not None:
            balls.rows[held], balls.pieces[held] = kept
        self.time += dt
        if self.parameters.again:
            self._bring_back()
        self.balls.trail[self.steps % TRAIL] = self.rows[:, m.X : m.Y + 1]
        self.steps += 1
        for k, gauge in enumerate(self.content.gauges):
            if gauge.measure == "past":
                self.balls.gauges[k, 0] = np.count_nonzero(self.rows[:, m.X] > gauge.level)
            elif gauge.measure == "rode":
                self._count_riders(self.balls.gauges[k], gauge.level)
            elif gauge.of < len(on):
                self._measure(self.balls.gauges[k], gauge, before[gauge.of], bool(on[gauge.of]), dt)
        return ""

    def _bring_back(self) -> None:
        """Let balls that have left the view for good begin again where they began, but for those on which a
        gauge goes on measuring.
        """
        view, rows = self.content.view, self.rows
        wide, tall = BEYOND * (view.right - view.left), BEYOND * (view.top - view.bottom)
        x, y = rows[:, m.X], rows[:, m.Y]
        out = (x < view.left - wide) | (x > view.right + wide) | (y < view.bottom - tall)
        out &= ~self.tracks.rolling()
        for gauge in self.content.gauges:
            if gauge.measure == "past":
                out[:] = False
            elif gauge.measure in LIVE and gauge.of < len(out):
                out[gauge.of] = False
        if 0 <= self.held < len(out):
            out[self.held] = False
        if not out.any():
            return
        with self.changing(out):
            for ball in np.flatnonzero(out).tolist():
                begun = self.balls.begun[ball]
                self.tracks.hold(ball, begun[BEGIN_X : BEGIN_Y + 1])
                rows[ball, m.VX : m.VY + 1] = begun[BEGIN_VX : BEGIN_VY + 1]
                rows[ball, m.SPIN] = begun[BEGIN_SPIN]
                self._seat(ball)
                self.balls.trail[:, ball] = rows[ball, m.X : m.Y + 1]

    def _measure(self, noted: Floats, gauge: GaugeEntry, before: Floats, on: bool, dt: float) -> None:
        row = self.rows[gauge.of]
        x, y = row[m.X : m.Y + 1].tolist()
        moved = x - float(before[0])
        crossing = self.time - dt * (x - gauge.level) / moved if moved != 0.0 else self.time
        if gauge.measure == "arrives" and noted[0] == NOT_YET and (x - gauge.level) * noted[1] >= 0.0:
            noted[0] = crossing
        elif gauge.measure == "period" and float(before[0]) > gauge.level >= x:
            noted[0] = crossing - noted[1] if noted[1] > 0.0 else 0.0
            noted[1] = crossing
        elif gauge.measure == "leaves" and noted[0] == NOT_YET and on:
            if not self.tracks.rolling()[gauge.of]:
                noted[0] = math.degrees(elementary.atan2(abs(x - gauge.about[0]), y - gauge.about[1]))
        elif gauge.measure == "speed":
            noted[0] = elementary.hypot(row[m.VX], row[m.VY])
        elif gauge.measure == "high":
            noted[0] = y

    def _count_riders(self, noted: Floats, level: float) -> None:
        """noted: how many, and the numbers of those that flew or came, as bits."""
        flown, come, rolling = int(noted[1]), int(noted[2]), self.tracks.rolling()
        for ball in range(min(len(self.rows), RIDERS)):
            if self.rows[ball, m.X] > level and not flown >> ball & 1:
                come |= 1 << ball
            elif not rolling[ball] and not come >> ball & 1:
                flown |= 1 << ball
        noted[:] = come.bit_count(), flown, come

    # -- what is there --------------------------------------------------------------------------------

    def exact_speed(self, ball: int) -> float:
        """m/s that the ball's energy allows at its height, if nothing ever slipped or struck."""
        row = self.rows[ball]
        _, turning, height = self.tracks.riders.energies()[ball].tolist()
        left = self.balls.energies[ball] - height
        if not self.tracks.rolling()[ball]:
            return math.sqrt(max(0.0, 2.0 * (left - turning) / row[m.MASS]))
        share = row[m.SHARE] if row[m.FRICTION] > 0.0 else 0.0
        return math.sqrt(max(0.0, 2.0 * left / (row[m.MASS] * (1.0 + share))))
