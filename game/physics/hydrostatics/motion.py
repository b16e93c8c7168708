"""Heave, sway and roll of one body in a tank, by hydrostatics (Archimedes; Froude 1861).

The level stays flat; it answers to what is displaced. Water that has to move along is an added mass, a
declared choice: that of an ellipse as wide as the wetted part, half of it while the body is at the surface
(Lamb 1932, art. 71; von Karman 1929). As more water is taken along, momentum is shared; water that is left
behind keeps its own. Waves take away a share of critical damping, eddies a drag by the square of speed.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.hydrostatics.bodies import Floater
from game.physics.hydrostatics.cut import cut, ends, level_over
from game.physics.kernels import elementary
from game.settings import Number, Option

ADDED = ("none", "ellipse")
X, Y, TURN, VX, VY, SPIN, LEVEL, SWAY, HEAVE, ROLL = range(10)
PINNED, PIN_X, PIN_Y, AT_X, AT_Y = range(5)  # columns of a hinge: whether, in the body's frame, where, m


class FloatingSettings(NamedTuple):
    """What water does beside its lift."""

    gravity: Annotated[float, Number(0.0, 100.0, help="downwards", unit="m/s²")] = 9.81
    added: Annotated[int, Option(ADDED, help="mass of the water that moves along")] = 1
    drag: Annotated[float, Number(0.0, 5.0, help="coefficient, by the square of speed")] = 1.2
    waves: Annotated[float, Number(0.0, 2.0, help="share of critical damping that waves take")] = 0.08


class FloatingState(NamedTuple):
    """pose (10,): place m, angle rad, velocity m/s, spin rad/s, level m, added masses kg, kg, kg m²; hinge
    (5,).
    """

    pose: Floats
    hinge: Floats


class Tank(NamedTuple):
    """Width m, water in it m², density kg/m³."""

    width: float
    water: float
    density: float


@kernel
def added_masses(found, extent, density):
    """Added mass of sway, heave, roll (kg, kg, kg m²) of what was ``cut``; extent: the body's height, m."""
    left, right, low, top = found[6], found[7], found[8], found[9]
    if not left < right:
        return 0.0, 0.0, 0.0
    half, deep = 0.5 * (right - left), min(-low, 0.5 * extent)
    share = 0.5 + 0.5 * min(1.0, max(0.0, -top) / half)  # of the ellipse's
    unit = share * math.pi * density
    unequal = half * half - deep * deep
    return unit * deep * deep, unit * half * half, 0.125 * unit * unequal * unequal


@kernel
def share_momentum(pose, column, inertia, added, before):
    """Water that is newly taken along was at rest; what is left behind keeps its speed."""
    if added > before:
        pose[column] *= (inertia + before) / (inertia + added)


@kernel
def hold_in_tank(pose, corners, width, mass, inertia):
    """The floor stops the lowest corner, without rebound or friction; walls stop the whole."""
    c, s = elementary.cos(pose[TURN]), elementary.sin(pose[TURN])
    low, _, left, right = ends(corners, c, s)
    if pose[Y] + low < 0.0:
        pose[Y] = -low
        for i in range(corners.shape[0]):
            arm = c * corners[i, 0] - s * corners[i, 1]
            height = s * corners[i, 0] + c * corners[i, 1]
            down = pose[VY] + pose[SPIN] * arm
            if height < low + 1e-6 * (right - left) and down < 0.0:
                impulse = -down / (1.0 / mass + arm * arm / inertia)
                pose[VY] += impulse / mass
                pose[SPIN] += impulse * arm / inertia
    if pose[X] + left < 0.0:
        pose[X], pose[VX] = -left, max(pose[VX], 0.0)
    elif pose[X] + right > width:
        pose[X], pose[VX] = width - right, min(pose[VX], 0.0)


@kernel
def swing(pose, body, hinge, found, settings, pull, dt):
    """Turn about a hinge."""
    mass, inertia, density, gravity = body
    c, s = elementary.cos(pose[TURN]), elementary.sin(pose[TURN])
    arm_x = c * hinge[PIN_X] - s * hinge[PIN_Y]  # of the hinge, from the centre of mass
    arm_y = s * hinge[PIN_X] + c * hinge[PIN_Y]
    whole = inertia + mass * (arm_x * arm_x + arm_y * arm_y)
    torque = gravity * (mass * arm_x + density * (found[1] - arm_x * found[0]))
    torque += pull[2] - arm_x * pull[1] + arm_y * pull[0]
    if settings.added == 1:
        long = 0.5 * (found[7] - found[6]) if found[7] > found[6] else 0.0
        whole += density * math.pi * long * long * (arm_x * arm_x + 0.125 * long * long)
    held = 2.0 * settings.waves * math.sqrt(abs(density * gravity * found[0]) * whole)
    held += 0.25 * density * settings.drag * found[0] * abs(pose[SPIN])
    pose[SPIN] = (pose[SPIN] + dt * torque / whole) / (1.0 + dt * held / whole)
    pose[TURN] += dt * pose[SPIN]
    c, s = elementary.cos(pose[TURN]), elementary.sin(pose[TURN])
    arm_x = c * hinge[PIN_X] - s * hinge[PIN_Y]
    arm_y = s * hinge[PIN_X] + c * hinge[PIN_Y]
    pose[X], pose[Y] = hinge[AT_X] - arm_x, hinge[AT_Y] - arm_y
    pose[VX], pose[VY] = pose[SPIN] * arm_y, -pose[SPIN] * arm_x


@kernel
def step_floating(pose, corners, body, tank, hinge, settings, pull, dt):
    """One step of dt (s); body: mass kg, inertia kg m²; pull: a force N and a torque N m of a hand."""
    mass, inertia = body
    density, gravity = tank.density, settings.gravity
    c, s = elementary.cos(pose[TURN]), elementary.sin(pose[TURN])
    pose[LEVEL] = level_over(corners, c, s, pose[Y], tank.width, tank.water)
    found = cut(corners, c, s, pose[LEVEL] - pose[Y])
    if hinge[PINNED] > 0.0:
        swing(pose, (mass, inertia, density, gravity), hinge, found, settings, pull, dt)
        return
    sway, heave, roll = 0.0, 0.0, 0.0
    if settings.added == 1:
        sway, heave, roll = added_masses(found, found[9] - found[8], density)
        share_momentum(pose, VX, mass, sway, pose[SWAY])
        share_momentum(pose, VY, mass, heave, pose[HEAVE])
        share_momentum(pose, SPIN, inertia, roll, pose[ROLL])
    pose[SWAY], pose[HEAVE], pose[ROLL] = sway, heave, roll
    wide = max(found[7] - found[6], 0.0) if found[0] > 0.0 else 0.0
    deep = min(-found[8], found[9] - found[8]) if found[0] > 0.0 else 0.0
    eddies = 0.5 * density * settings.drag
    width = max(found[3], 0.0)
    stiff = found[5] - found[4] * found[4] / width if width > 0.0 else 0.0
    for column, inert, force, square, spring in (
        (VX, mass + sway, pull[0], eddies * deep, 0.0),
        (VY, mass + heave, pull[1] + gravity * (density * found[0] - mass), eddies * wide, width),
        (SPIN, inertia + roll, pull[2] + gravity * density * found[1],
         eddies * 0.03125 * wide * wide * wide * wide, stiff),
    ):  # fmt: skip
        free = pose[column] + dt * force / inert
        held = 2.0 * settings.waves * math.sqrt(max(density * gravity * spring * inert, 0.0))
        held += square * abs(free)
        pose[column] = free / (1.0 + dt * held / inert)
    for k in range(3):
        pose[k] += dt * pose[VX + k]
    hold_in_tank(pose, corners, tank.width, mass + heave, inertia + roll)


class FloatingBody:
    """A body in a tank, its centre at a place (m) over the floor's left end, at an angle (rad)."""

    def __init__(
        self,
        floater: Floater,
        tank: Tank,
        place: tuple[float, float],
        angle: float = 0.0,
        *,
        settings: FloatingSettings | None = None,
        hinge: tuple[float, float] | None = None,
    ):
        """hinge: a point of the outline's own frame (m) that stays where it is. ValueError for nonsense."""
        for name, value in zip(("width", "water", "density"), tank, strict=True):
            if not (0.0 < value < math.inf or (name == "water" and value == 0.0)):
                raise ValueError(f"tank.{name} = {value!r}: expected a number above 0")
        if not all(map(math.isfinite, (*place, angle))):
            raise ValueError(f"place, angle = {place!r}, {angle!r}: expected finite numbers")
        self.floater, self.tank = floater, tank
        self.settings = settings or FloatingSettings()
        self.pose: Floats = np.zeros(10)
        self.pose[[X, Y, TURN]] = (*place, angle)
        self.hinge: Floats = np.zeros(5)
        self.pull: Floats = np.zeros(3)
        if hinge is not None:
            own = np.array(hinge) - floater.centre
            self.hinge[:] = 1.0, *own, *self.placed(own[None])[0]
        self.pose[LEVEL] = self.find_level()

    def find_level(self) -> float:
        """The level (m) for the pose as it is."""
        c, s = elementary.cos(self.pose[TURN]), elementary.sin(self.pose[TURN])
        tank = self.tank
        return float(level_over(self.floater.corners, c, s, float(self.pose[Y]), tank.width, tank.water))

    def placed(self, own: Floats) -> Floats:
        """Points (n, 2) m about the centre of mass, in the tank."""
        c, s = float(elementary.cos(self.pose[TURN])), float(elementary.sin(self.pose[TURN]))
        turned = np.stack([c * own[:, 0] - s * own[:, 1], s * own[:, 0] + c * own[:, 1]], axis=1)
        return np.asarray(turned + self.pose[[X, Y]])

    def corners(self) -> Floats:
        """(n, 2) m in the tank."""
        return self.placed(self.floater.corners)

    def put(self, place: tuple[float, float], angle: float) -> None:
        """Let it be there, at rest."""
        self.pose[:] = 0.0
        self.pose[[X, Y, TURN]] = (*place, angle)
        self.pose[LEVEL] = self.find_level()

    def step(self, dt: float, parts: int = 1) -> None:
        """Go on by dt (s), in so many parts."""
        body = (self.floater.mass, self.floater.inertia)
        for _ in range(parts):
            step_floating(
                self.pose, self.floater.corners, body, self.tank, self.hinge, self.settings, self.pull,
                dt / parts,
            )  # fmt: skip

    def draft(self) -> float:
        """m, of the lowest point below the level."""
        return float(self.find_level() - self.corners()[:, 1].min())

    def displaced(self) -> float:
        """m²."""
        c, s = elementary.cos(self.pose[TURN]), elementary.sin(self.pose[TURN])
        level = self.find_level()
        return float(cut(self.floater.corners, c, s, level - float(self.pose[Y]))[0])

    def energy(self) -> float:
        """J/m of motion, and of the height of body and water over the floor."""
        c, s = elementary.cos(self.pose[TURN]), elementary.sin(self.pose[TURN])
        level, pose, tank = self.find_level(), self.pose, self.tank
        area, _, deep, *_ = map(float, cut(self.floater.corners, c, s, level - float(pose[Y])))
        moving = (
            (self.floater.mass + pose[SWAY]) * pose[VX] * pose[VX]
            + (self.floater.mass + pose[HEAVE]) * pose[VY] * pose[VY]
            + (self.floater.inertia + pose[ROLL]) * pose[SPIN] * pose[SPIN]
        )
        water = tank.density * (0.5 * tank.width * level * level - deep - area * level)
        return float(0.5 * moving + self.settings.gravity * (self.floater.mass * pose[Y] + water))

    def state(self) -> FloatingState:
        """All that later steps depend on."""
        return FloatingState(self.pose, self.hinge)

    def restore(self, state: FloatingState) -> None:
        """Take over a copy of a state."""
        self.pose[:], self.hinge[:] = state.pose, state.hinge
