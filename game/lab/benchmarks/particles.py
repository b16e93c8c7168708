"""Steps of many particles, beside numpy."""

from __future__ import annotations

from functools import partial

import numpy as np

from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, WIND
from game.physics.particles import OBSTACLES, Discs, Emitter, ParticleSystem

SMALL_STEP = 1e-6  # s: the particles stay where they are, so that every repeat does the same work


def swarm(count: int, effects: EffectSet, method: str = "verlet", capacity: int = 0) -> ParticleSystem:
    """A fountain in its steady state, made at once: ages spread over the life."""
    system = ParticleSystem(
        capacity or count, solids=Discs([(0.2, 2.4)], [0.45]), effects=effects, method=method, life=1e9
    )
    rng = np.random.default_rng(1)
    age, angle = np.sort(rng.random(count))[::-1] * 1.8, (rng.random(count) - 0.5) * 0.5
    x, y = 9 * np.sin(angle) * age, 9 * np.cos(angle) * age - 4.905 * age**2
    y = np.maximum(y, 0.0)
    x = np.where((x - 0.2) ** 2 + (y - 2.4) ** 2 < 0.46**2, 5.0, x)  # nobody begins in the stone
    system.add(np.stack([x, y], 1), np.stack([9 * np.sin(angle), 9 * np.cos(angle) - 9.81 * age], 1))
    return system


class NumpySwarm:
    """The same Verlet step in place with numpy."""

    def __init__(self, system: ParticleSystem):
        (self.x, self.y), (self.vx, self.vy) = system.positions.T.copy(), system.velocities.T.copy()
        self.room = np.empty_like(self.x)

    def step(self, h: float) -> None:
        """One step of gravity."""
        np.multiply(self.vx, h, out=self.room)
        self.x += self.room
        np.multiply(self.vy, h, out=self.room)
        self.y += self.room
        self.y -= 0.5 * 9.81 * h * h
        self.vy -= 9.81 * h


def live_fountain(count: int) -> ParticleSystem:
    """Births, deaths, drag, wind, stone and ground, in the steady state."""
    system = ParticleSystem(
        count + count // 10, emitters=[Emitter(rate=count / 2.4, spread=0.3)],
        solids=Discs([(0.2, 2.4)], [0.45]), effects=GRAVITY | DRAG | WIND | OBSTACLES | GROUND, life=2.4,
        floor_restitution=0.2,
    )  # fmt: skip
    for _ in range(300):
        system.step(1.0 / 120.0)
    return system


def _kernel(count: int) -> Call:
    return partial(swarm(count, EffectSet([GRAVITY])).step, SMALL_STEP)


def _numpy(count: int) -> Call:
    return partial(NumpySwarm(swarm(count, EffectSet([GRAVITY]))).step, SMALL_STEP)


SCENARIOS = (
    *(
        Scenario(
            f"particles-{count}", f"Verlet, gravity, {count:,} particles", "step", partial(_kernel, count),
            peers=(Peer("numpy in place", partial(_numpy, count)),),
        )
        for count in (10_000, 100_000, 1_000_000)
    ),
    Scenario(
        "fountain", "Fountain of 100,000 with births, drag, wind, stone and ground", "step",
        lambda: partial(live_fountain(100_000).step, 1.0 / 120.0),
    ),
)  # fmt: skip
