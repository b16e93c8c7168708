"""Settled heaps of discs beside pymunk, and free bodies in a batch beside numpy."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.broadphase import UniformGrid
from game.physics.rigid import METHODS
from game.physics.rigid.motion import advance
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.settings import material_tables, surroundings_of
from game.physics.spheres.spheres import SphereBodies

# -- discs at rest --------------------------------------------------------------------------------------

RADIUS, FRAME = 0.43, 1.0 / 60.0  # m, s
HEAPS = {1000: (40, 420), 5000: (100, 600)}  # columns, steps until they have settled
SETTINGS: dict[str, dict[str, Any]] = {
    "projection": {"correction": "projection", "iterations": 8, "passes": 3},
    "split impulses": {"correction": "split", "iterations": 10, "passes": 3},
}


def places_of(count: int, columns: int) -> Floats:
    """Where the discs begin (count, 2) m: rows, a little uneven."""
    random = np.random.default_rng(1)
    i = np.arange(count)
    shift = random.uniform(-0.05, 0.05, (count, 2))
    return np.stack((0.5 + i % columns, 0.5 + i // columns), axis=1) + shift


def heap(count: int, **settings: Any) -> CollidingSpheres:
    """Discs that fall together in a box."""
    columns, _ = HEAPS[count]
    rows = -(-count // columns)
    bodies = SphereBodies(
        places_of(count, columns), np.full(count, RADIUS), inertias=np.full(count, 0.5 * (RADIUS * RADIUS))
    )
    return CollidingSpheres(
        bodies,
        surroundings_of((0.0, 0.0, columns, 4.0 * rows)),
        material_tables(0.0, 0.5),
        UniformGrid((0.0, 0.0), (columns, rows + 2.0), 2.0 * RADIUS + 0.2),
        scheme="semi-implicit",
        **settings,
    )


def settled_heap(count: int, name: str) -> CollidingSpheres:
    """The same at rest, by one of the SETTINGS."""
    world = heap(count, **SETTINGS[name])
    for _ in range(HEAPS[count][1]):
        world.step(FRAME)
    return world


def pymunk_heap(count: int) -> tuple[Any, list[Any]]:
    """pymunk's space with the same discs at rest, and their bodies."""
    import pymunk

    columns, steps = HEAPS[count]
    space = pymunk.Space()
    space.gravity, space.iterations = (0, -9.81), 10
    high = 4.0 * count / columns
    for a, b in (((0, 0), (columns, 0)), ((0, 0), (0, high)), ((columns, 0), (columns, high))):
        wall = pymunk.Segment(space.static_body, a, b, 0.0)
        wall.friction = 0.5
        space.add(wall)
    bodies = []
    for place in places_of(count, columns).tolist():
        body = pymunk.Body(1.0, 0.5 * (RADIUS * RADIUS))
        body.position = tuple(place)
        disc = pymunk.Circle(body, RADIUS)
        disc.friction = 0.5
        space.add(body, disc)
        bodies.append(body)
    for _ in range(steps):
        space.step(FRAME)
    return space, bodies


def _settled(count: int) -> Call:
    return partial(settled_heap(count, "projection").step, FRAME)


def _pymunk(count: int) -> Call:
    return partial(pymunk_heap(count)[0].step, FRAME)


# -- free bodies ----------------------------------------------------------------------------------------

BODIES, STEPS, DT = 1_000, 10, 1.0 / 60.0
MOMENTS = np.array((1.0, 2.0, 3.0))


def batch(count: int = BODIES) -> tuple[Floats, Floats, Floats]:
    """States (n, 13), constants (n, 7), loads (n, 6) of bodies that all turn differently."""
    generator = np.random.default_rng(12)
    states = np.zeros((count, 13))
    q = generator.standard_normal((count, 4))
    states[:, 3:7] = q / np.sqrt((q * q).sum(axis=1, keepdims=True))
    states[:, 7:] = generator.standard_normal((count, 6))
    constants = np.tile(np.concatenate(((1.0,), MOMENTS, 1.0 / MOMENTS)), (count, 1))
    return states, constants, np.zeros((count, 6))


class NumpyBodies:
    """Explicit Euler of x, q, P, L, all bodies at a time, as one writes it with numpy."""

    def __init__(self, states: Floats) -> None:
        self.start = states.copy()
        self.states = states.copy()

    def step(self, dt: float) -> None:
        """One step of all bodies."""
        q, momentum, angular = self.states[:, 3:7], self.states[:, 7:10], self.states[:, 10:]
        w, u = q[:, :1], q[:, 1:]
        t = 2.0 * np.cross(-u, angular)
        body = (angular + w * t + np.cross(-u, t)) / MOMENTS
        t = 2.0 * np.cross(u, body)
        spin = body + w * t + np.cross(u, t)
        self.states[:, :3] += dt * momentum
        change = np.concatenate(
            (-(spin * u).sum(axis=1, keepdims=True), w * spin + np.cross(spin, u)), axis=1
        )
        q = q + 0.5 * dt * change
        self.states[:, 3:7] = q / np.sqrt((q * q).sum(axis=1, keepdims=True))

    def run(self) -> None:
        """STEPS steps from the start."""
        self.states[:] = self.start
        for _ in range(STEPS):
            self.step(DT)


def runner(method: str) -> tuple[Call, Floats]:
    """A call that makes STEPS steps of all bodies from the start, and their states."""
    states, constants, loads = batch()
    start, number = states.copy(), METHODS.index(method)

    def run() -> None:
        states[:] = start
        advance(number, states, constants, loads, (0.0, 1.0), 1, 1, DT, STEPS)

    return run, states


def _free_bodies(method: str) -> Call:
    return runner(method)[0]


SCENARIOS = (
    *(
        Scenario(
            f"discs-{count}", f"{count:,} settled discs, projection", "step", partial(_settled, count),
            peers=(Peer("pymunk step", partial(_pymunk, count)),),
        )
        for count in HEAPS
    ),
    *(
        Scenario(
            f"body-{method}", f"Free body, {title}, in a batch of 1,000", "step",
            partial(_free_bodies, method), BODIES * STEPS,
            (Peer("numpy, whole arrays", lambda: NumpyBodies(batch()[0]).run),)
            if method == "explicit-euler" else (),
        )
        for method, title in (
            ("explicit-euler", "explicit Euler"), ("splitting", "splitting"), ("rk4", "Runge-Kutta 4")
        )
    ),
)  # fmt: skip
