"""Bodies in a box as a level makes them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.physics.effects import EffectSet
from game.physics.kernels import elementary, linear
from game.physics.spacetime.motion import Grip, Laws
from game.physics.spacetime.shapes import KINDS
from game.physics.spacetime.tree import inside
from game.physics.spacetime.world import Answer, TimedBody, TimedState, TimedWorld
from game.scenes.spacetime.level import BodyEntry, SpaceTimeContent
from game.scenes.spacetime.parameters import SpaceTimeParameters
from game.stage import Part

HALF = (3.2, 2.4)  # m, half the box


class Pair(NamedTuple):
    """What is known of the two bodies looked at: by the budget, and exactly (m)."""

    first: int
    second: int
    answer: Answer
    exact: float

    @property
    def error(self) -> float:
        """m."""
        return abs(self.answer.estimate - self.exact)


class SpaceTimeModel(Part):
    """The world, and what of its last steps is told."""

    def __init__(
        self, content: SpaceTimeContent, parameters: SpaceTimeParameters, active: EffectSet, seed: int
    ):
        self.content, self.parameters, self.active = content, parameters, active
        bodies = [_body_of(entry) for entry in content.bodies] or _scattered(
            int(parameters.count), seed, content
        )
        self.world = TimedWorld(bodies, HALF, self._laws())
        self.tests = self.due = self.untested = self.bounces = 0
        self.doubt = 0.0

    def _laws(self) -> Laws:
        chosen = self.parameters
        return Laws(chosen.bound, chosen.gravity, chosen.restitution, *HALF)

    def change_laws(self) -> None:
        """Take over the parameters; every pair may touch at once."""
        self.world.set_laws(self._laws())

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.world.forget_times()

    def advance(self, dt: float, held: int, hand: tuple[float, float]) -> None:
        """One step; ``held``: the body in the hand, or -1."""
        world = self.world
        world.bounces = self.bounces
        world.step(dt, int(self.parameters.budget), Grip(held, *hand, self.parameters.grip), self.active)
        self.tests, self.due, self.untested = world.tests, world.due, world.untested
        self.bounces, self.doubt = world.bounces, world.doubt

    def chosen(self) -> tuple[int, int]:
        """The two bodies looked at, different ones where there are two."""
        last = self.world.count - 1
        i = min(int(self.parameters.first) - 1, last)
        j = min(int(self.parameters.second) - 1, last)
        j = j if j != i else (i + 1) % (last + 1)
        return min(i, j), max(i, j)

    def pair(self) -> Pair:
        """Their distance, by the budget and exactly."""
        i, j = self.chosen()
        answer, _ = self.world.ask(i, j, int(self.parameters.budget))
        return Pair(i, j, answer, self.world.exact(i, j))

    def body_at(self, place: tuple[float, float]) -> int:
        """The body that holds a place, or -1."""
        for i in range(self.world.count):
            if inside(self.world.outline(i), place):
                return i
        return -1

    def entries(self) -> tuple[BodyEntry, ...]:
        """The bodies as they are, for a level."""
        fields = self.world.fields.T.tolist()
        return tuple(
            BodyEntry(
                kind=body.kind, variant=body.variant, size=body.size, place=(x, y),  # type: ignore[arg-type]
                angle=math.remainder(angle, math.tau), velocity=(vx, vy), spin=spin, push=body.push,
            )
            for body, (x, y, angle, vx, vy, spin) in zip(self.world.bodies, fields, strict=True)
        )  # fmt: skip

    def state(self) -> TimedState:
        """All that later steps depend on."""
        return self.world.state()

    def restore(self, state: TimedState) -> None:
        """Take over a copy of a state."""
        self.world.restore(state)


def _body_of(entry: BodyEntry) -> TimedBody:
    return TimedBody(
        entry.kind,
        entry.variant,
        entry.size,
        entry.place,
        entry.angle,
        entry.velocity,
        entry.spin,
        entry.push,
    )


def _scattered(count: int, seed: int, content: SpaceTimeContent) -> list[TimedBody]:
    """Bodies by chance in the cells of a grid, clear of each other."""
    chance = np.random.default_rng(seed)
    columns = math.ceil(math.sqrt(count * HALF[0] / HALF[1]))
    rows = math.ceil(count / columns)
    cell = (2.0 * HALF[0] / columns, 2.0 * HALF[1] / rows)
    found = []
    for k in range(count):
        column, row = k % columns, k // columns
        size = content.scale * min(0.5 * min(cell) * 0.9, 0.55) * linear.uniform(chance, 0.75, 1.0)
        heading = linear.uniform(chance, 0.0, math.tau)
        speed = content.speed * linear.uniform(chance, 0.4, 1.0)
        found.append(TimedBody(
            KINDS[k % len(KINDS)], int(chance.integers(0, 4)), float(size),
            ((column + 0.5) * cell[0] - HALF[0], (row + 0.5) * cell[1] - HALF[1]),
            float(linear.uniform(chance, 0.0, math.tau)),
            (float(speed * elementary.cos(heading)), float(speed * elementary.sin(heading))),
            float(linear.uniform(chance, -2.0, 2.0) * content.speed),
        ))  # fmt: skip
    return found
