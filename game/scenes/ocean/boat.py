"""The boat: a hull of sections, ballast in its keel, one sail on a mast; how water and wind move it.

It goes along x, on a course that a helmsman keeps; it drifts to no side and turns to none, and its picture
goes with it. Heel is above 0 to where the wind blows, pitch with the bow up.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.cloth.sail import BACK, FX, FY, FZ, LEAN, TURN, Sail, Wind
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary
from game.physics.waves.effects import ADDED_MASS
from game.physics.waves.sea import LEVEL, RISE, Sea
from game.physics.waves.sections import (
    AREA,
    HEAVE,
    PITCH,
    ROLL,
    STRIKE,
    SURGE,
    HullSettings,
    SectionHull,
    rounded_sections,
)
from game.worlds.world import Member

LENGTH, STATIONS = 7.2, 21
BEAM, DRAFT, FREE = 2.6, 0.5, 0.72  # m, of the hull as it was drawn
USUAL_BALLAST, BALLAST_Y, HULL_Y = 900.0, -1.05, 0.28  # kg; m from the drawn water line
MAST, KEEL = (
    2.1,
    0.9,
)  # m before the middle; m below the middle of mass, where the keel holds against the wind
CORNERS = np.array([(0.06, 1.3), (0.06, 5.6), (3.9, 8.7), (5.9, 1.55)])  # tack, throat, peak, clew
COLUMNS, ROWS = 15, 13  # of the sail
AIR, PLATE, OUT = 1.2, 1.25, 3.3  # kg/m³; coefficient of a plate; m of the cloth's middle from the mast
CENTRE = 4.5  # m up: of the sail
SMITH = 0.3  # m below the water line at which waves are felt
WETTED, SKIN = 15.0, 0.008  # m²; coefficient of what the hull drags
KEEL_DRAG, HULL_DAMP = 1100.0, 0.02  # N m s² of a keel that swings; share of critical, of the hull
BOOM, BOOM_DAMP, HAULED = 60.0, 25.0, 0.6  # kg m²; N m s; rad/s at which a sheet is hauled in
UP, PITCHED, HEEL, SPEED, RISING, PITCHING, ROLLING, SWUNG, SWINGING, SAILED = range(10)
# when heel and heave last came up through their middle (s), and how long it took since the time before
ROLL_AT, ROLL_S, HEAVE_AT, HEAVE_S = range(4)
LEAST_SWING = math.radians(0.15)  # of a heel, and m of a heave, that count as a swing
LEAST_HEAVE = 0.0005
ROLLS, PITCHES = 0.36, 0.25  # radii of gyration, of beam and length


def hull_ends() -> tuple[Floats, Floats]:
    """Stations (n,) m from amidships; half breadths, drafts, freeboards (n, 3) m there."""
    at = (2.0 * np.arange(STATIONS) + 1.0) / STATIONS - 1.0
    fore, aft = np.maximum(at, 0.0), np.maximum(-at, 0.0)
    half = 0.5 * BEAM * (1.0 - 0.97 * fore * fore * np.sqrt(fore)) * (1.0 - 0.24 * aft * aft)
    draft = DRAFT * (1.0 - 0.78 * aft * aft) * (1.0 - 0.3 * fore * fore * fore * fore)
    free = FREE + 0.55 * fore * fore + 0.12 * aft * aft
    return 0.5 * LENGTH * at, np.stack([half, draft, free], axis=1)


class Boat(Member):
    """``pose`` (10,) by UP to SAILED; ``breadths`` (n,) m at the water, a substep ago; ``beats`` (4,) s, 0
    while a period is not known.

    ``forces`` (6,): of the sail on the boat, N and N m about the middle of mass: drive, lift, side, heeling,
    pitching; last the righting moment of the water. ``struck``: N s of blows in the last step.
    """

    kept = ("pose", "breadths", "beats", "forces", "blows")

    def __init__(self, content: Any, parameters: Any, active: EffectSet, sea: Sea):
        self.parameters, self.active, self.sea = parameters, active, sea
        self.load()
        self.sail = Sail(CORNERS, COLUMNS, ROWS)
        self.pose: Floats = np.zeros(10)
        self.pose[UP], self.pose[HEEL] = self.rest.up + content.lifted, math.radians(content.heel)
        if content.heel:
            self.pose[UP] = self.hull.afloat(float(self.pose[HEEL])) + content.lifted
        self.pose[SWUNG] = 0.5
        self.sail.hoist(0.5)
        self.breadths: Floats = np.full(STATIONS, -1.0)
        self.beats: Floats = np.array((-1.0, 0.0, -1.0, 0.0))
        self.forces: Floats = np.zeros(6)
        self.blows: Floats = np.zeros(STATIONS)
        self.wind = np.zeros(3)
        self.time, self.held = 0.0, False

    def load(self) -> None:
        """Take the ballast in that is chosen now."""
        stations, self.ends = hull_ends()
        drawn = rounded_sections(self.ends)
        whole = SectionHull(drawn, stations, 1.0, (1.0, 1.0))
        bare = HullSettings().density * whole.volume(0.0) - USUAL_BALLAST
        self.middle_x = float(np.sum(whole.cuts[:, AREA] * stations) / np.sum(whole.cuts[:, AREA]))
        self.ballast = ballast = float(self.parameters.ballast)
        mass = bare + ballast
        self.middle_y = (bare * HULL_Y + ballast * BALLAST_Y) / mass
        low, high = BALLAST_Y - self.middle_y, HULL_Y - self.middle_y
        rolls = bare * (ROLLS * BEAM * ROLLS * BEAM + high * high) + ballast * low * low
        self.hull = SectionHull(
            drawn - np.array((0.0, self.middle_y)), stations - self.middle_x, mass,
            (mass * PITCHES * LENGTH * PITCHES * LENGTH, rolls), self._settings(),
        )  # fmt: skip
        self.rest = self.hull.at_rest()
        self.laws = self.hull.periods(self.gravity()) if self.gravity() else (math.inf, math.inf)

    def _settings(self) -> HullSettings:
        added = 1.0 if ADDED_MASS in self.active else 0.0
        return HullSettings(added=added, strikes=added, leaving=float(self.parameters.leaving))

    def gravity(self) -> float:
        return float(self.parameters.gravity) if GRAVITY in self.active else 0.0

    def change(self, name: str) -> None:
        if name == "ballast":
            before = self.middle_y
            self.load()
            self.pose[UP] += self.middle_y - before
        self.hull.settings = self._settings()

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.hull.settings = self._settings()
        self.laws = self.hull.periods(self.gravity()) if self.gravity() else (math.inf, math.inf)

    def state(self) -> tuple[Any, ...]:
        return (*super().state(), self.sail.nodes)

    def restore(self, fields: Any) -> None:
        super().restore(fields)
        if self.ballast != self.parameters.ballast:
            self.load()
        self.sail.nodes[...] = next(fields)

    # -- a step ---------------------------------------------------------------------------------------

    def go(self, wind: tuple[float, float], dt: float) -> float:
        """A step of dt (s) in a wind (m/s along x and z); rad/s at which the boom came to its sheet, or 0."""
        struck = self._set_sail(wind, dt)
        points = np.zeros((STATIONS, 2))
        points[:, 0] = self.hull.stations * elementary.cos(float(self.pose[PITCHED]))
        water = self.sea.at(points, SMITH)
        count = int(self.parameters.substeps)
        self.blows[:] = 0.0
        before = self.pose[[HEEL, UP]] - (0.0, self.rest.up)
        for _ in range(count):
            self._float(water, dt / count)
            water[:, LEVEL] += water[:, RISE] * (dt / count)
        self.time += dt
        self._beat(before, self.pose[[HEEL, UP]] - (0.0, self.rest.up), dt)
        return struck

    def _set_sail(self, wind: tuple[float, float], dt: float) -> float:
        """The wind on the sail, and the boom on its sheet."""
        pose, sail = self.pose, self.sail
        c, s = elementary.cos(float(pose[HEEL])), elementary.sin(float(pose[HEEL]))
        dry = min(max(0.5 + 0.5 * (c * CENTRE + float(pose[UP])), 0.0), 1.0)  # no wind blows under water
        air = dry * (wind[0] - float(pose[SPEED]) + CENTRE * float(pose[PITCHING]))
        across = dry * wind[1]
        rolled = dry * CENTRE * float(pose[ROLLING])
        local = Wind(air, across * s, across * c - rolled, 0.5 * AIR * PLATE)
        self.wind[:] = local[:3]
        angle, rate = float(pose[SWUNG]), float(pose[SWINGING])
        gravity = self.gravity() * c
        total = sail.step(angle, rate, local, gravity, dt, 2 * int(self.parameters.substeps))
        # the air holds a boom that swings: taken at the end of the step
        strong = elementary.length(air, across, rolled)
        held = BOOM_DAMP + AIR * PLATE * sail.area * strong * OUT * OUT
        rate += dt * (float(total[TURN]) - BOOM_DAMP * rate) / (BOOM + dt * held)
        most, hit = max(math.radians(self.parameters.sheet), abs(angle) - HAULED * dt), 0.0
        angle += dt * rate
        if abs(angle) > most:
            angle = math.copysign(most, angle)
            if rate * angle > 0.0:
                hit, rate = abs(rate), 0.0
        pose[SWUNG], pose[SWINGING] = angle, rate
        fx, fy, fz = (float(total[k]) for k in (FX, FY, FZ))
        side_force = fz * c + fy * s
        heeling = float(total[LEAN]) - fz * self.middle_y + side_force * KEEL * c
        pitching = float(total[BACK]) + (MAST - self.middle_x) * fy + self.middle_y * fx
        self.forces[:5] = fx, fy * c - fz * s, side_force, heeling, pitching
        return hit

    def _float(self, water: Floats, h: float) -> None:
        """A substep of the hull."""
        pose, hull, gravity = self.pose, self.hull, self.gravity()
        found = hull.push(
            (pose[UP], pose[PITCHED], pose[HEEL], pose[SPEED], pose[RISING], pose[PITCHING], pose[ROLLING]),
            water, self.breadths, gravity, h,
        )  # fmt: skip
        self.breadths[:] = hull.cuts[:, 3]
        self.blows += hull.cuts[:, STRIKE] * h
        drive, lift, _, heeling, pitching = self.forces[:5].tolist()
        mass = hull.mass + float(found[1, 0])
        if self.held:
            pose[[RISING, PITCHING, ROLLING]] *= 0.9
        else:
            pose[RISING] += h * (float(found[0, HEAVE]) - hull.mass * gravity + lift) / mass
        inertia = hull.inertia[0] + float(found[1, 1])
        pose[PITCHING] += (
            h * (float(found[0, PITCH]) + pitching - float(found[1, 3]) * pose[PITCHING]) / inertia
        )
        rolling = float(pose[ROLLING])
        stiff = abs(hull.mass * gravity * self.rest.metacentre * hull.inertia[1])
        damping = 2.0 * HULL_DAMP * math.sqrt(stiff) + KEEL_DRAG * abs(rolling)
        self.forces[5] = -float(found[0, ROLL])
        rolling += h * (float(found[0, ROLL]) + heeling) / hull.inertia[1]
        pose[ROLLING] = rolling / (1.0 + h * damping / hull.inertia[1])
        speed = float(pose[SPEED])
        hump = elementary.cube(speed * speed / (0.16 * max(gravity, 0.1) * LENGTH))
        wet = min(float(np.sum(hull.cuts[:, 0])) * hull.width / max(self.rest.volume, 1e-9), 2.0)
        drag = 0.5 * hull.settings.density * WETTED * SKIN * wet * abs(speed) * (1.0 + hump)
        speed += h * (drive + float(found[0, SURGE])) / hull.mass
        pose[SPEED] = speed / (1.0 + h * drag / hull.mass)
        pose[UP] += h * pose[RISING]
        pose[PITCHED] += h * pose[PITCHING]
        pose[HEEL] += h * pose[ROLLING]
        pose[SAILED] += h * pose[SPEED]

    def _beat(self, before: Floats, now: Floats, dt: float) -> None:
        """Times at which heel and heave come up through their middle."""
        least = (LEAST_SWING, LEAST_HEAVE)
        for k, (at, took) in enumerate(((ROLL_AT, ROLL_S), (HEAVE_AT, HEAVE_S))):
            one, other = float(before[k]), float(now[k])
            if one < 0.0 <= other and other - one > 0.05 * least[k]:
                when = self.time - dt * other / (other - one)
                if self.beats[at] >= 0.0:
                    self.beats[took] = when - self.beats[at]
                self.beats[at] = when

    # -- what a hand does -----------------------------------------------------------------------------

    def pull_over(self, heel: float) -> None:
        """Hold it at a heel (rad) and let go."""
        self.pose[HEEL], self.pose[ROLLING] = heel, 0.0
        self.pose[UP] = self.hull.afloat(heel) + float(self.sea.at(np.zeros((1, 2)))[0, LEVEL])
        self.breadths[:] = -1.0
        self.beats[:] = -1.0, 0.0, -1.0, 0.0

    def press_down(self, by: float) -> None:
        """Hold it so much lower (m) and let go."""
        self.pose[UP] -= by
        self.pose[RISING] = 0.0
        self.breadths[:] = -1.0
        self.beats[:] = -1.0, 0.0, -1.0, 0.0

    # -- what there is --------------------------------------------------------------------------------

    def heel(self) -> float:
        """°, from -180 to 180."""
        return math.degrees(math.remainder(float(self.pose[HEEL]), math.tau))

    def righting_arm(self) -> float:
        """m at this heel in still water; above 0: it rights itself."""
        heel = float(self.pose[HEEL])
        side = 1.0 if math.remainder(heel, math.tau) >= 0.0 else -1.0
        return side * self.hull.arm(heel)
