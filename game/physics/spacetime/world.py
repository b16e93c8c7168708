"""Bodies in a box whose collisions are detected by space-time bounds and circle trees, within a budget."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.constraints.effects import CONTACTS
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary, elementwise, linear
from game.physics.spacetime import motion
from game.physics.spacetime import refine as r
from game.physics.spacetime.effects import SPACE_TIME, TIMED
from game.physics.spacetime.exact import exact_distance
from game.physics.spacetime.motion import (
    Grip,
    Laws,
    bounce_walls,
    due_pairs,
    move,
    place,
    renew_times,
    respond,
)
from game.physics.spacetime.refine import refine
from game.physics.spacetime.shapes import area_and_centre, second_moment
from game.physics.spacetime.tree import plant, tree_of

MOST_BODIES = 48
DENSITY = 1.0  # kg/m²
NEAR_STEPS = 8.0  # a pair's distance is wanted as far as it closes in so many steps


class TimedBody(NamedTuple):
    """A body: kind and variant of its outline, size (m to its farthest corner), place, angle, velocity, rate
    of turning, and what it is accelerated by (m/s²)."""

    kind: str
    variant: int
    size: float
    place: tuple[float, float]
    angle: float = 0.0
    velocity: tuple[float, float] = (0.0, 0.0)
    spin: float = 0.0
    push: tuple[float, float] = (0.0, 0.0)


class TimedState(NamedTuple):
    """fields: (6, n); times: (n, n) s, next possible contact of i < j; now: (1,) s."""

    fields: Floats
    times: Floats
    now: Floats


class Answer(NamedTuple):
    """What is known of two bodies' distance, m; level: reached, -1 if they were not compared at all."""

    lower: float
    upper: float
    level: int
    tests: int
    estimate: float


class TimedWorld:
    """All bodies, the next possible times of contact, and what the last step cost."""

    def __init__(self, bodies: list[TimedBody], half: tuple[float, float], laws: Laws):
        """half: m, half the box. ValueError for no bodies, too many, or nonsense."""
        if not 1 <= len(bodies) <= MOST_BODIES:
            raise ValueError(f"bodies: expected 1 to {MOST_BODIES}, not {len(bodies)}")
        for i, body in enumerate(bodies):
            numbers = (body.size, *body.place, body.angle, *body.velocity, body.spin, *body.push)
            if not all(map(math.isfinite, numbers)) or body.size <= 0.0:
                raise ValueError(f"bodies[{i}]: expected finite numbers, and a size above 0")
        self.bodies, self.laws = bodies, laws._replace(half_x=half[0], half_y=half[1])
        trees = [tree_of(body.kind, body.variant) for body in bodies]
        self.forest = plant(trees, [body.size for body in bodies])
        outlines = [tree.outline * body.size for tree, body in zip(trees, bodies, strict=True)]
        counts = [len(outline) for outline in outlines]
        self.outlines: Floats = np.concatenate(outlines)
        self.spans: Longs = np.stack([np.cumsum([0, *counts[:-1]]), counts], axis=1).astype(np.int64)
        self.makes: Floats = np.array([
            (DENSITY * area_and_centre(outline)[0], DENSITY * second_moment(outline), body.size, *body.push)
            for outline, body in zip(outlines, bodies, strict=True)
        ])  # fmt: skip
        self.fields: Floats = np.array(
            [(*body.place, body.angle, *body.velocity, body.spin) for body in bodies]
        ).T.copy()
        n = len(bodies)
        self.poses, self.now = np.zeros((n, 4)), 0.0
        self.times: Floats = np.zeros((n, n))
        self.kicked = np.zeros(n, dtype=np.bool_)
        self.pairs: Longs = np.zeros((max(n * (n - 1) // 2, 1), 2), dtype=np.int64)
        self.answers: Floats = np.zeros((len(self.pairs), r.ANSWERS))
        self.left: Longs = np.zeros((2, r.CAPACITY, 4), dtype=np.int64)
        self.gaps: Floats = np.zeros((2, r.CAPACITY))
        self.tests = self.due = self.untested = self.bounces = 0
        self.doubt = 0.0
        assert self.fields.shape == (motion.FIELDS, n)
        self.place_all()

    @property
    def count(self) -> int:
        """Bodies."""
        return len(self.bodies)

    def place_all(self) -> None:
        """Poses from places and angles."""
        for i in range(self.count):
            place(self.fields, self.poses, i)

    def forget_times(self) -> None:
        """Every pair may touch at once: laws have changed, or a body was put elsewhere."""
        self.times[:] = self.now

    def set_laws(self, laws: Laws) -> None:
        """Obey other laws from now on. ValueError unless they are finite and at least 0."""
        for name, value in zip(laws._fields[:1] + laws._fields[2:], (laws[0], *laws[2:]), strict=True):
            if not 0.0 <= value < math.inf:
                raise ValueError(f"{name} = {value!r}: expected a finite number, at least 0")
        self.laws = laws._replace(half_x=self.laws.half_x, half_y=self.laws.half_y)
        self.forget_times()

    # -- a step ---------------------------------------------------------------------------------------

    def step(self, dt: float, budget: int, grip: Grip, effects: EffectSet) -> None:
        """Go on by dt (s) with at most ``budget`` tests. ValueError for nonsense."""
        if not 0.0 < dt < math.inf or budget < 0:
            raise ValueError(
                f"dt, budget = {dt!r}, {budget!r}: expected dt above 0 s, and a budget from 0 on"
            )
        bits = TIMED.mask(effects)
        laws = self.laws if bits & TIMED.bit(GRAVITY) else self.laws._replace(gravity=0.0)
        self.kicked[:] = False
        move(self.fields, self.makes, self.poses, laws, grip, dt)
        self.now += dt
        if not bits & TIMED.bit(SPACE_TIME):
            self.forget_times()
        self.due = due_pairs(self.times, self.now, self.pairs)
        pairs, answers = self.pairs[: self.due], self.answers[: self.due]
        self.tests, _ = refine(
            self.forest, self.poses, pairs, self.reach_of(pairs, dt), budget, self.left, self.gaps, answers
        )
        known = answers[:, r.LEVEL] != r.UNTESTED
        self.untested = self.due - int(np.count_nonzero(known))
        self.doubt = float(
            np.max(
                (answers[:, r.UPPER] - answers[:, r.LOWER])[known & (answers[:, r.LOWER] <= 0.0)], initial=0.0
            )
        )
        if bits & TIMED.bit(CONTACTS):
            self.bounces += respond(self.fields, self.makes, pairs, answers, laws, self.kicked)
        bounce_walls(self.fields, self.makes, self.poses, self.outlines, self.spans, laws, self.kicked)
        renew_times(
            self.fields, self.makes, pairs, answers, self.times, self.kicked, self.laws.bound, self.now
        )

    def reach_of(self, pairs: Longs, dt: float) -> Floats:
        """How far off (m) a pair may be for its distance to matter: what it closes in some steps."""
        speed = (
            elementwise.hypot(self.fields[3], self.fields[4])
            + np.abs(self.fields[5]) * self.makes[:, motion.SIZE]
        )
        ahead = NEAR_STEPS * dt
        return np.asarray((speed[pairs[:, 0]] + speed[pairs[:, 1]] + self.laws.bound * ahead) * ahead)

    # -- what is there --------------------------------------------------------------------------------

    def ask(self, i: int, j: int, budget: int) -> tuple[Answer, Longs]:
        """The distance of two bodies as far as a budget of tests goes, and the pairs of nodes left."""
        answers, left, gaps = np.zeros((1, r.ANSWERS)), np.zeros_like(self.left), np.zeros_like(self.gaps)
        pairs, reach = np.array([[i, j]]), np.full(1, 1e300)
        tests, count = refine(self.forest, self.poses, pairs, reach, budget, left, gaps, answers)
        found = Answer(
            float(answers[0, r.LOWER]),
            float(answers[0, r.UPPER]),
            int(answers[0, r.LEVEL]),
            int(tests),
            float(answers[0, r.ESTIMATE]),
        )
        return found, left[0, :count]

    def near_nodes(self, budget: int, dt: float) -> tuple[Longs, Longs]:
        """Pairs (k, 2) whose time has come, and the nodes (m, 4) left of them after a budget of tests."""
        pairs = np.zeros_like(self.pairs)
        count = due_pairs(self.times, self.now + dt, pairs)
        pairs = pairs[:count]
        left, gaps, answers = np.zeros_like(self.left), np.zeros_like(self.gaps), np.zeros((count, r.ANSWERS))
        _, kept = refine(
            self.forest, self.poses, pairs, self.reach_of(pairs, dt), budget, left, gaps, answers
        )
        return pairs, left[0, :kept]

    def exact(self, i: int, j: int) -> float:
        """The distance of two bodies, m, by all their edges."""
        return float(exact_distance(self.outlines, self.spans, i, j, self.poses))

    def outline(self, i: int) -> Floats:
        """Corners (k, 2) of a body where it is, m."""
        first, count = self.spans[i].tolist()
        x, y, c, s = self.poses[i].tolist()
        return np.asarray(
            linear.product(self.outlines[first : first + count], np.array(((c, s), (-s, c))))
            + np.array((x, y))
        )

    def queue(self) -> list[tuple[float, int, int]]:
        """The queue: (s from now, i, j), soonest first."""
        n = self.count
        queue = [(float(self.times[i, j]) - self.now, i, j) for i in range(n) for j in range(i + 1, n)]
        return sorted(queue)

    def missed(self) -> int:
        """Pairs whose outlines meet although their next possible time of contact is still to come."""
        found = 0
        for ahead, i, j in self.queue():
            far = elementary.hypot(
                *(self.fields[motion.X : motion.Y + 1, i] - self.fields[motion.X : motion.Y + 1, j]).tolist()
            )
            if ahead > 0.0 and far < self.makes[i, motion.SIZE] + self.makes[j, motion.SIZE]:
                found += self.exact(i, j) == 0.0
        return found

    def check(self) -> None:
        """AssertionError unless numbers are finite, every tree covers its body and no pair was missed."""
        assert np.isfinite(self.fields).all(), "a place or a velocity is no number"
        for body in self.bodies:
            tree_of(body.kind, body.variant).check()
        assert self.missed() == 0, "two outlines meet before the time at which they may"

    def state(self) -> TimedState:
        """All that later steps depend on."""
        return TimedState(self.fields, self.times, np.array([self.now]))

    def restore(self, state: TimedState) -> None:
        """Take over a copy of a state."""
        self.fields, self.times = state.fields.copy(), state.times.copy()
        self.now = float(state.now[0])
        self.place_all()
