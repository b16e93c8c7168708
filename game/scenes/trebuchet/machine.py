"""The machine: arm, hinged counterweight and sling, cocked by a winch, let go by a trigger."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.physics.solids import Disc, Material, Polygon, box
from game.physics.solids.arrays.layout import LENGTH
from game.worlds.members.solids import Solids, energy
from game.worlds.world import Member

PIVOT, LONG, SHORT, HANG, LOW = 4.0, 5.6, 1.4, 1.1, 0.45  # m: axle, arms, hinge to weight, cocked tip
BEAM, BEAM_MASS, LINK_MASS, PARTS = 0.3, 300.0, 1.0, 6  # m; kg of the arm, of a joint of the sling's parts
STONE, FILLING = 2500.0, 2000.0  # kg/m³ of the stone, of the box of earth
BRAKE = 0.25  # of the greatest torque of the counterweight; put on once the stone is away
WINCH, NEARLY, FARTHEST = 3.0, 0.02, math.radians(160.0)  # m/s of rope; rad from cocked; rad it can pull
MOST_STONES = 20
NEAR, LEAST = 0.9, 1e-5  # share of the time to the release that is stepped at once; s, at least
COCKED, THROWING, LOOSE, WINDING = "cocked", "throwing", "loose", "winding"


class Shot(NamedTuple):
    """Where and how fast a stone of a mass (kg) left; J from the weight, in the stone, gained by both."""

    x: float
    y: float
    vx: float
    vy: float
    mass: float
    drop: float
    gain: float
    kept: float


def stone_radius(mass: float) -> float:
    """Of a ball of stone, m."""
    return elementary.cbrt(0.75 * mass / (math.pi * STONE))


class Machine(Member):
    """Turns about an axle at (0, PIVOT). stones: bodies of all, the last one is in the sling or was.

    phase: COCKED to WINDING; shot: of the last stone; began: J of the weight, J of all when it began.
    """

    def __init__(self, solids: Solids, parameters: Any, anchor: int):
        self.solids, self.world, self.parameters, self.anchor = solids, solids.world, parameters, anchor
        self.phase, self.stones, self.bodies, self.began = COCKED, list[int](), list[int](), (0.0, 0.0)
        self.shot: Shot | None = None
        self.flight, self.turns = math.inf, 0.0  # rad, angle of the stone's flight; rad/s at which it changes
        self.start = math.pi + elementary.asin((PIVOT - LOW) / LONG)
        self.tip: Point = (LONG * elementary.cos(self.start), LOW)
        self.cock()

    def cock(self) -> None:
        """Stand there cocked, a stone in the sling."""
        world, chosen = self.world, self.parameters
        held = [self.stones.pop()] if self.phase == COCKED and self.stones else []
        for body in [*self.bodies, *held]:
            world.remove_body(body)
        self.phase, y = COCKED, 0.5 * BEAM
        wood = Material(BEAM_MASS / (BEAM * (0.8 * LONG + SHORT)), mask=0)
        beam = Polygon([(-SHORT, -y), (LONG, -0.6 * y), (LONG, 0.6 * y), (-SHORT, y)], 0.0, wood)
        self.arm = world.add_body(beam, (0.0, PIVOT), self.start, restless=True)
        self.axle = world.add_joint("pin", self.anchor, self.arm, (0.0, PIVOT), most=0.0)
        x, y = self.end_of_arm(-SHORT)
        mass = chosen.counterweight
        self.side = elementary.cbrt(mass / FILLING)  # as deep as wide
        weight = box(self.side, self.side, material=Material(mass / (self.side * self.side), mask=0))
        self.weight = world.add_body(weight, (x, y - HANG), restless=True)
        self.hinge = world.add_joint("pin", self.arm, self.weight, (x, y), most=0.0)
        self.rope = world.add_joint("rope", self.anchor, self.arm, self.tip, length=0.0)
        self.links = self._lay_sling(stone_radius(chosen.stone))
        self.bodies = [self.arm, self.weight, *self.links]

    def _lay_sling(self, radius: float) -> list[int]:
        """Bodies of a rope from the arm's tip to a new stone; its last joint is what lets go."""
        below, mass = LOW - radius, self.parameters.stone
        length = max(self.parameters.sling, abs(below) + 0.05)
        end = (self.tip[0] + math.sqrt(length * length - below * below), radius)
        ball = Disc(radius, material=Material(mass / (math.pi * radius * radius), 0.4, 0.1))
        self.stones.append(self.world.add_body(ball, end))
        self.peg = self.world.add_joint("weld", self.anchor, self.stones[-1], end)  # or it would roll
        links = self.solids.hang_rope((self.arm, self.stones[-1]), self.tip, end, PARTS, LINK_MASS)
        self.hook = links.joints[-1]
        return links.bodies

    def change(self, name: str) -> None:
        if self.phase == COCKED and name in ("counterweight", "stone", "sling"):
            self.cock()

    def pull_trigger(self) -> str:
        """Let the arm go; why not, or ""."""
        if self.phase != COCKED:
            return "It is not cocked."
        for joint in (self.rope, self.peg):
            self.world.remove_joint(joint)
        self.flight, self.turns = math.inf, 0.0
        self.phase, self.began = THROWING, (self.weight_energy(), self.energy())
        return ""

    def wind(self) -> str:
        """Begin to pull the arm down by its winch; why not, or ""."""
        if self.phase in (COCKED, WINDING) or len(self.stones) >= MOST_STONES:
            return "There are no more stones." if self.phase in (LOOSE, THROWING) else "It is cocked."
        if self.phase == THROWING:
            self._let_go()
        if self.turned() > FARTHEST:  # it leans the wrong way: men carry it back
            self.cock()
        else:
            at, self.phase = self.end_of_arm(LONG), WINDING
            far = elementary.dist(at, self.tip)
            self.rope = self.world.add_joint("rope", self.anchor, self.arm, self.tip, at, length=far)
        return ""

    def part_of(self, most: float) -> float:
        """s that may be stepped at once of ``most``: all, or nearly up to the release if that is sooner.

        Flight turns by three degrees in a step: without this, a shot would depend on when it is fired.
        """
        left = (
            (math.radians(self.parameters.release) - self.flight) / self.turns if self.turns < 0.0 else most
        )
        return most if self.phase != THROWING or left >= most else min(max(NEAR * left, LEAST), most)

    def step(self, dt: float) -> None:
        """After the solids: let go at the angle, wind on."""
        if self.phase == THROWING:
            body, rows = self.stones[-1], self.world.bodies
            (x, y), (vx, vy) = rows.positions[body].tolist(), rows.velocities[body].tolist()
            before = self.flight
            self.flight = elementary.atan2(vy, vx) if y > PIVOT and vx > 0.0 else math.inf
            self.turns = (self.flight - before) / dt if before < math.inf else 0.0
            if self.flight <= math.radians(self.parameters.release):
                mass, gravity = 1.0 / float(rows.inverse_masses[body]), -self.world.settings.gravity[1]
                gain = 0.5 * mass * (vx * vx + vy * vy) + mass * gravity * (y - stone_radius(mass))
                kept = self.energy() - self.began[1]
                self.shot = Shot(x, y, vx, vy, mass, self.began[0] - self.weight_energy(), gain, kept)
                self._let_go()
        elif self.phase == WINDING:
            own = self.world.joints.parameters[self.rope]
            own[LENGTH] = max(float(own[LENGTH]) - WINCH * dt, 0.0)
            if self.turned() < NEARLY:
                self.cock()

    def _let_go(self) -> None:
        """The hook slips: the stone is free, the brake is on."""
        self.world.remove_joint(self.hook)
        torque = BRAKE * self.parameters.counterweight * -self.world.settings.gravity[1] * SHORT
        self.world.drive(self.axle, 0.0, torque)
        self.world.drive(self.hinge, 0.0, 0.1 * torque)
        self.phase = LOOSE

    def free(self) -> list[int]:
        """Stones that no sling holds."""
        return self.stones[: len(self.stones) - (self.phase in (COCKED, THROWING))]

    def weight_energy(self) -> float:
        """J of the counterweight's height."""
        gravity, rows = -self.world.settings.gravity[1], self.world.bodies
        return gravity * float(rows.positions[self.weight, 1] / rows.inverse_masses[self.weight])

    def energy(self) -> float:
        """J of motion and height of the machine and its last stone."""
        return energy(self.world, np.array([*self.bodies, self.stones[-1]]))

    def turned(self) -> float:
        """rad that the arm has turned from where it is cocked."""
        return self.start - float(self.world.bodies.angles[self.arm])

    def end_of_arm(self, far: float) -> Point:
        """A point of the beam so far (m) from the axle towards the sling."""
        angle = float(self.world.bodies.angles[self.arm])
        return far * elementary.cos(angle), PIVOT + far * elementary.sin(angle)
