"""The rocket: it is led along a curve until it meets something; its flame, its smoke, its fire ball."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats, Point
from game.physics.animation.curves import CubicBezier
from game.physics.kernels import elementary, linear
from game.physics.solids import Material, Polygon
from game.physics.surfaces.key_frames import KeyFrames
from game.worlds.hands.hand import NOBODY
from game.worlds.members.dust import Dust, advance_dust
from game.worlds.members.solids import Solids
from game.worlds.world import Member

START, OVER = (112.0, 6.0), (78.0, 27.0)  # m: where it comes from, and over which point it bends
GOAL, DIVE = 1.2, 24.0  # m: the middle of the dam; how far before it the curve points down at it
LONG, THICK = 4.0, 0.9  # m
FLIGHT, SLOW_START = 3.2, 0.25  # s to the dam; share of its mean speed at which it begins
BEYOND = 1.25  # of the way to the dam, where it explodes if it has met nothing
SMOKE_RATE, FIRE_RATE = 150.0, 160.0  # puffs a second
SMOKE_S, FIRE_S = 4.5, 0.22  # s that they last
BALL_FIRE, BALL_SMOKE, BALL_S = 130, 110, 1.2  # puffs of an explosion; s that its fire lasts
BALL_SPEED, BALL_PUFF = 2.6, 0.15  # m/s, m for each kg^(1/3) of the charge
DRIFTS, RISES = 0.8, 1.3  # m/s of the air that takes smoke along
NONE: Floats = np.zeros(0)


def _drift(places: Floats) -> Floats:
    """m/s (n, 2) of the air: it is warm, and goes down the valley."""
    return np.tile((DRIFTS, RISES), (len(places), 1))


class Rocket(Member):
    """``flight`` (0,) or (1,) s since it was fired; ``smoke`` and ``fire``: dust that hangs, and that glows.

    Smoke and fire are puffs that the gas of the motor and of the explosion carries; they push nothing.
    """

    def __init__(self, solids: Solids, parameters: Any, seed: int):
        self.solids, self.parameters, self.seed = solids, parameters, seed
        self.smoke, self.fire = Dust(), Dust()
        self.body, self.since, self.shots, self.aim = NOBODY, 0.0, 0, 0.0
        self.time = 0.0

    def launch(self) -> str:
        """Fire it at where it is aimed now; why not, or ""."""
        if self.body != NOBODY:
            return "It is on its way."
        self.aim, self.since, self.shots = float(self.parameters.aim), 0.0, self.shots + 1
        x, y, angle = self.at(0.0)
        half, thick = 0.5 * LONG, 0.5 * THICK
        outline = [(-half, -thick), (0.5 * half, -thick), (half, 0.0), (0.5 * half, thick), (-half, thick)]
        shape = Polygon(outline, material=Material(1000.0, mask=0, category=0))
        self.body = self.solids.world.add_body(shape, (x, y), angle, kind="key-framed")
        return ""

    def at(self, since: float) -> tuple[float, float, float]:
        """Where it is (m) and its direction (rad) so long (s) after it was fired: a Bézier curve of C01."""
        share = since / FLIGHT
        u = min(SLOW_START * share + (1.0 - SLOW_START) * share * share, BEYOND)
        path = CubicBezier([START, OVER, (GOAL + DIVE, self.aim + 0.55 * DIVE), (GOAL, self.aim)])
        inside = min(u, 1.0)
        place, along = path.point([inside])[0], path.tangent([inside])[0]
        x, y = (place + (u - inside) * along).tolist()
        return x, y, elementary.atan2(float(along[1]), float(along[0]))

    def lead(self, dt: float) -> None:
        """Give the body the speed that its curve asks for in the next step of dt, s."""
        if self.body != NOBODY:
            KeyFrames(self.solids.world, self.body, self.at).lead(self.since, dt)
            self.since += dt

    def nose(self) -> Point:
        """m."""
        rows = self.solids.world.bodies
        c, s = rows.rotations[self.body].tolist()
        x, y = rows.positions[self.body].tolist()
        return x + 0.5 * LONG * c, y + 0.5 * LONG * s

    def is_spent(self) -> bool:
        """Whether it has flown past all that it could meet."""
        return self.since >= FLIGHT * BEYOND

    def driven_through(self, thick: float) -> Point:
        """Where its nose comes to (m), when it goes on through a wall so thick, m."""
        c, s = self.solids.world.bodies.rotations[self.body].tolist()
        far = thick / max(abs(c), 0.5)
        x, y = self.nose()
        return x + far * c, y + far * s

    def burst(self) -> None:
        """It is gone, in fire and smoke, which come out where it went in."""
        place, charge = np.array(self.nose()), float(self.parameters.charge)
        self.solids.world.remove_body(self.body)
        self.body = NOBODY
        random = self._chance()
        size = elementary.cbrt(charge)
        for dust, count, life, share, lift in (
            (self.fire, BALL_FIRE, BALL_S, 1.0, 3.0), (self.smoke, BALL_SMOKE, SMOKE_S, 0.8, 6.0),
        ):  # fmt: skip
            aim = linear.uniform(random, -1.0, 1.0, (count, 2))
            dust.add(
                place + 0.05 * size * aim,
                share * BALL_SPEED * size * aim + (0.0, lift),
                BALL_PUFF * size,
                life,
                random,
            )

    def _chance(self) -> np.random.Generator:
        return np.random.default_rng((self.seed, round(1e4 * self.time)))

    def step(self, dt: float) -> None:
        """After the solids: what its motor blows out."""
        self.time += dt
        if self.body != NOBODY:
            rows, random = self.solids.world.bodies, self._chance()
            velocity = rows.velocities[self.body]
            c, s = rows.rotations[self.body].tolist()
            tail = rows.positions[self.body] - 0.5 * LONG * np.array((c, s))
            for dust, rate, size, life, back in (
                (self.smoke, SMOKE_RATE, 0.45, SMOKE_S, 3.0), (self.fire, FIRE_RATE, 0.36, FIRE_S, 14.0),
            ):  # fmt: skip
                count = math.floor(rate * self.time) - math.floor(rate * (self.time - dt))
                places = tail - linear.uniform(random, 0.0, dt, (count, 1)) * velocity
                dust.add(places, np.tile(-back * np.array((c, s)), (count, 1)), size, life, random)
        self.smoke.rows = advance_dust(self.smoke.rows, dt, _drift)
        self.fire.rows = advance_dust(self.fire.rows, dt)

    @property
    def speed(self) -> float:
        """m/s; 0 where there is none."""
        if self.body == NOBODY:
            return 0.0
        return elementary.length(*self.solids.world.bodies.velocities[self.body].tolist())
