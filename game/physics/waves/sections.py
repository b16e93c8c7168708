"""A hull of cross sections among waves: lift by the volume under water, in heave, pitch and roll.

Each section is a polygon. What is under the water's line is cut out anew at each step (clipped polygon). So
large angles need nothing of their own, and the righting arm at any heel follows from the same cut. The water
pushes at right angles to its own surface (Froude 1861, Krylov 1896). The water that swings along with a
section is that of a half disc as wide as it is at the water (Lewis 1929). What is added as it goes in strikes
it (von Karman 1929). Waves that leave take energy, by a coefficient.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.waves.sea import LEVEL, LIFT, RISE, SLOPE_X, SLOPE_Z
from game.settings import Number

AREA, MIDDLE_Z, MIDDLE_Y, BREADTH, STRIKE = range(5)  # columns of a cut: m², m, m, m, N
HEAVE, PITCH, ROLL, SURGE = range(4)


class HullSettings(NamedTuple):
    """What water does besides lifting."""

    density: Annotated[float, Number(1.0, 2000.0, unit="kg/m³", help="of the water")] = 1025.0
    added: Annotated[float, Number(0.0, 2.0, help="water that swings along, of a half disc")] = 1.0
    leaving: Annotated[float, Number(0.0, 3.0, help="how strongly waves leave a hull that heaves")] = 0.5
    strikes: Annotated[float, Number(0.0, 3.0, help="of the blow as a section goes in")] = 1.0


@inner_kernel
def cut_section(points, turn, line):
    """Area, its middle (Z, Y) and breadth at the water of what of a section is below a line.

    points (p, 2): z, y m from the middle of mass; turn: cosine and sine of heel; line: level and slope.
    """
    c, s = turn
    level, slope = line
    area, mz, my = 0.0, 0.0, 0.0
    first_z, first_y, last_z, last_y, begun = 0.0, 0.0, 0.0, 0.0, False
    low, high = 1e30, -1e30
    count = points.shape[0]
    bz = points[count - 1, 0] * c + points[count - 1, 1] * s
    by = points[count - 1, 1] * c - points[count - 1, 0] * s
    db = by - level - slope * bz
    for k in range(count):
        az, ay, da = bz, by, db
        bz, by = points[k, 0] * c + points[k, 1] * s, points[k, 1] * c - points[k, 0] * s
        db = by - level - slope * bz
        for part in range(2):
            if part == 0:
                if (da < 0.0) == (db < 0.0):
                    continue
                share = da / (da - db)
                z, y = az + share * (bz - az), ay + share * (by - ay)
                low, high = min(low, z), max(high, z)
            else:
                if db >= 0.0:
                    continue
                z, y = bz, by
            if begun:
                cross = last_z * y - z * last_y
                area += cross
                mz += cross * (last_z + z)
                my += cross * (last_y + y)
            else:
                first_z, first_y, begun = z, y, True
            last_z, last_y = z, y
    if begun:
        cross = last_z * first_y - first_z * last_y
        area += cross
        mz += cross * (last_z + first_z)
        my += cross * (last_y + first_y)
    breadth = high - low if high > low else 0.0
    if abs(area) < 1e-12:
        return 0.0, 0.0, 0.0, breadth
    return 0.5 * abs(area), mz / (3.0 * area), my / (3.0 * area), breadth


@lean_kernel
def push_hull(form, pose, water, before, settings, pace, out):
    """Forces of the water on a hull, and how much water swings along.

    form: sections (n, p, 2), stations (n,) m from the middle of mass, width m of each. pose: height of the
    middle of mass m, pitch, heel rad, then velocities along, up m/s, pitching, rolling rad/s. water (n,
    5): `sea`. before (n,) m, breadths a step ago; below 0: none is known. pace: gravity m/s² and the step
    s. out: cuts (n, 5), AREA to STRIKE; found (2, 4):
    forces N, N m by HEAVE to SURGE; then added mass kg, kg m², how strongly it heaves kg/s, pitches kg m²/s.
    """
    sections, stations, width = form
    gravity, dt = pace
    cuts, found = out
    up, pitch, heel, along, rising, pitching, _ = pose
    c, s = elementary.cos(heel), elementary.sin(heel)
    tilt_c, tilt_s = elementary.cos(pitch), elementary.sin(pitch)
    for row in range(2):
        for k in range(4):
            found[row, k] = 0.0
    for j in range(sections.shape[0]):
        reach = stations[j] * tilt_c
        height = up + stations[j] * tilt_s
        slope_x, slope_z = water[j, SLOPE_X], water[j, SLOPE_Z]
        area, z, y, breadth = cut_section(sections[j], (c, s), (water[j, LEVEL] - height, slope_z))
        cuts[j, AREA], cuts[j, MIDDLE_Z], cuts[j, MIDDLE_Y], cuts[j, BREADTH] = area, z, y, breadth
        lift = settings.density * gravity * area * width
        swings = settings.added * settings.density * 0.125 * math.pi * breadth * breadth * width
        meets = rising + pitching * reach - water[j, RISE] - along * slope_x
        strike = 0.0
        if before[j] >= 0.0 and breadth > before[j] and meets < 0.0:
            had = settings.added * settings.density * 0.125 * math.pi * before[j] * before[j] * width
            strike = -settings.strikes * (swings - had) / dt * meets
        cuts[j, STRIKE] = strike
        leaves = settings.leaving * settings.density * breadth * width * math.sqrt(gravity * breadth)
        force = lift + strike + swings * water[j, LIFT] - leaves * meets
        found[0, HEAVE] += force
        found[0, PITCH] += force * reach + lift * slope_x * (y + stations[j] * tilt_s)
        found[0, ROLL] -= lift * (z + slope_z * y)
        found[0, SURGE] -= lift * slope_x
        found[1, 0] += swings
        found[1, 1] += swings * reach * reach
        found[1, 2] += leaves
        found[1, 3] += leaves * reach * reach


class Hydrostatics(NamedTuple):
    """Of a hull at rest: height of its middle of mass over the water m, volume m³, water plane m². Then
    height of the metacentre over the middle of mass m, and mass that swings along kg.
    """

    up: float
    volume: float
    plane: float
    metacentre: float
    added: float


class SectionHull:
    """Sections (n, p, 2) m against the clock, of equal width along x, at stations (n,) m from the middle of
    mass. mass kg, inertia of pitching and of rolling kg m². ValueError for nonsense.
    """

    def __init__(
        self, sections: Floats, stations: Floats, mass: float, inertia: tuple[float, float],
        settings: HullSettings | None = None,
    ):  # fmt: skip
        if sections.ndim != 3 or sections.shape[2] != 2 or len(stations) != len(sections):
            raise ValueError(f"sections {sections.shape}: expected (n, p, 2), with n stations")
        if not (0.0 < mass < math.inf and min(inertia) > 0.0):
            raise ValueError(f"mass, inertia = {mass}, {inertia}: expected above 0")
        self.sections, self.stations = np.ascontiguousarray(sections), np.ascontiguousarray(stations)
        self.width = float(stations[1] - stations[0]) if len(stations) > 1 else 1.0
        self.mass, self.inertia, self.settings = mass, inertia, settings or HullSettings()
        self.cuts: Floats = np.zeros((len(stations), 5))
        self.found: Floats = np.zeros((2, 4))
        self.still: Floats = np.zeros((len(stations), 5))
        self.unknown: Floats = np.full(len(stations), -1.0)

    def push(
        self, pose: tuple[float, ...], water: Floats, before: Floats, gravity: float, dt: float
    ) -> Floats:
        """Forces (2, 4), see `push_hull`; `cuts` are those of this pose."""
        push_hull(
            (self.sections, self.stations, self.width), pose, water, before, self.settings, (gravity, dt),
            (self.cuts, self.found),
        )  # fmt: skip
        return self.found

    def volume(self, up: float, heel: float = 0.0) -> float:
        """m³ under still water at a height of the middle of mass."""
        self.push((up, 0.0, heel, 0.0, 0.0, 0.0, 0.0), self.still, self.unknown, 1.0, 1.0)
        return float(np.sum(self.cuts[:, AREA])) * self.width

    def afloat(self, heel: float = 0.0) -> float:
        """Height (m) of the middle of mass over still water at which the hull floats, at a heel (rad).

        ValueError if it sinks.
        """
        reach = 2.0 * float(np.abs(self.sections).max())
        low, high, goal = -reach, reach, self.mass / self.settings.density
        if self.volume(low, heel) < goal:
            raise ValueError(f"mass = {self.mass:g} kg: a hull that sinks")
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.volume(middle, heel) > goal else (low, middle)
        return 0.5 * (low + high)

    def arm(self, heel: float) -> float:
        """Righting arm (m) at a heel (rad) in still water, level fore and aft; above 0 it rights itself."""
        self.volume(self.afloat(heel), heel)
        areas = self.cuts[:, AREA]
        return float(np.sum(areas * self.cuts[:, MIDDLE_Z]) / max(float(np.sum(areas)), 1e-12))

    def at_rest(self) -> Hydrostatics:
        """By closed forms for small angles: what water plane and volume say of periods."""
        up = self.afloat()
        volume = self.volume(up)
        areas, breadths = self.cuts[:, AREA], self.cuts[:, BREADTH]
        middle = float(np.sum(areas * self.cuts[:, MIDDLE_Y])) / float(np.sum(areas))
        plane = float(np.sum(breadths)) * self.width
        inertia = float(np.sum(breadths * breadths * breadths)) * self.width / 12.0
        return Hydrostatics(up, volume, plane, inertia / volume + middle, float(self.found[1, 0]))

    def periods(self, gravity: float = 9.81) -> tuple[float, float]:
        """s of heaving, slowed by waves that leave, and of rolling by a little (Bouguer 1746); inf: never."""
        rest = self.at_rest()
        stiff = self.settings.density * gravity * rest.plane
        upright = self.mass * gravity * rest.metacentre
        heave = math.inf
        if stiff > 0.0:
            mass = self.mass + rest.added
            self.push((rest.up, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), self.still, self.unknown, gravity, 1.0)
            slowed = float(self.found[1, 2]) / (2.0 * mass)
            rate = stiff / mass - slowed * slowed
            heave = math.tau / math.sqrt(rate) if rate > 0.0 else math.inf
        roll = math.tau * math.sqrt(self.inertia[1] / upright) if upright > 0.0 else math.inf
        return heave, roll


def box_sections(breadth: float, height: float, below: float, count: int = 1) -> Floats:
    """(count, 4, 2) rectangles whose lower edge is ``below`` m under the middle of mass."""
    half = 0.5 * breadth
    one = np.array([(-half, -below), (half, -below), (half, height - below), (-half, height - below)])
    return np.repeat(one[None], count, axis=0)


def rounded_sections(ends: Floats, points: int = 9) -> Floats:
    """(n, 2 points, 2) sections from keel to deck. ends (n, 3): half breadth, draft and freeboard m; z, y
    from the water line that it was drawn with.
    """
    share = np.arange(points) / (points - 1.0)
    full = 1.0 - (1.0 - share) * (1.0 - share)  # round below, upright sides
    half, draft, free = (ends[:, k, None] for k in range(3))
    y = -draft + (draft + free) * share * share
    right = np.stack([half * full, y], axis=2)
    left = right[:, ::-1] * np.array((-1.0, 1.0))
    return np.concatenate([right, left], axis=1)
