"""Steps of many particles, beside numpy."""

from __future__ import annotations

from functools import partial

import numpy as np

from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, WIND
from game.physics.generations import CALM, Kind, StarSystem
from game.physics.generations import step as s
from game.physics.kernels import elementary, elementwise
from game.physics.particles import OBSTACLES, Discs, Emitter, ParticleSystem

SMALL_STEP = 1e-6  # s: the particles stay where they are, so that every repeat does the same work


def swarm(count: int, effects: EffectSet, method: str = "verlet", capacity: int = 0) -> ParticleSystem:
    """A fountain in its steady state, made at once: ages spread over the life."""
    system = ParticleSystem(
        capacity or count, solids=Discs([(0.2, 2.4)], [0.45]), effects=effects, method=method, life=1e9
    )
    rng = np.random.default_rng(1)
    age, angle = np.sort(rng.random(count))[::-1] * 1.8, (rng.random(count) - 0.5) * 0.5
    x, y = 9 * elementwise.sin(angle) * age, 9 * elementwise.cos(angle) * age - 4.905 * (age * age)
    y = np.maximum(y, 0.0)
    x = np.where(
        elementary.square(x - 0.2) + elementary.square(y - 2.4) < elementary.square(0.46), 5.0, x
    )  # none begins in the stone
    system.add(
        np.stack([x, y], 1),
        np.stack([9 * elementwise.sin(angle), 9 * elementwise.cos(angle) - 9.81 * age], 1),
    )
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


def burst_stars(count: int) -> StarSystem:
    """Stars in the air, none of which ends or comes down within the timing."""
    stars = StarSystem(
        [Kind("star", life_s=1e6, drag_per_m=0.022, burns=0.5, capacity=count)],
        air=CALM._replace(wind=5.0, shear=0.004),
    )
    rng = np.random.default_rng(2)
    state, pool = stars.state(), stars.state().fields
    pool[s.X], pool[s.Y] = rng.uniform(-100.0, 100.0, count), rng.uniform(60.0, 160.0, count)
    pool[s.VX], pool[s.VY] = rng.normal(0.0, 20.0, count), rng.normal(0.0, 20.0, count)
    pool[s.DIES], pool[s.BURNT] = 1e6, 0.5e-6
    state.counts[0] = count
    return stars


class NumpyStars:
    """The same split step in place with numpy: gravity, wind with shear, quadratic drag, burning."""

    def __init__(self, stars: StarSystem):
        fields = stars.stars("star")
        self.x, self.y, self.vx, self.vy = (fields[row].copy() for row in (s.X, s.Y, s.VX, s.VY))
        self.age = np.zeros_like(self.x)
        self.air, self.kind = stars.air, stars.kinds[0]

    def step(self, h: float) -> None:
        """One step; ends and falls are looked for, as the other does."""
        air, kick = self.air, -0.5 * h * self.air.gravity
        wind = air.wind * (1.0 + air.shear * np.clip(self.y + 0.5 * h * self.vy, 0.0, air.ceiling))
        ux, uy = self.vx - wind, self.vy + kick
        mass = np.maximum(1.0 - self.kind.burns / self.kind.life_s * (self.age + 0.5 * h), 1e-6)
        factor = mass / (mass + self.kind.drag_per_m * h * np.sqrt(ux * ux + uy * uy))
        vx, vy = wind + ux * factor, uy * factor + kick
        self.x += 0.5 * h * (self.vx + vx)
        self.y += 0.5 * h * (self.vy + vy)
        self.vx, self.vy = vx, vy
        self.age += h
        if (self.age >= self.kind.life_s).any() or (self.y <= 0.0).any():
            raise AssertionError("a star ended")


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
        "stars-60000", "Stars: gravity, wind, quadratic drag, burning, 60,000", "step",
        lambda: partial(burst_stars(60_000).step, SMALL_STEP),
        peers=(
            Peer("numpy, same forces", lambda: partial(NumpyStars(burst_stars(60_000)).step, SMALL_STEP)),
        ),
    ),
    Scenario(
        "fountain", "Fountain of 100,000 with births, drag, wind, stone and ground", "step",
        lambda: partial(live_fountain(100_000).step, 1.0 / 120.0),
    ),
)  # fmt: skip
