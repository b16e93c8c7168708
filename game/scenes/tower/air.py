"""The air about the tower on a coarse grid, and the dust in it (A08).

Floors are solids in it that move with their true velocity, at least as thick as a cell: what falls drives the
air out from under it, and draws it in behind. Pieces of floors, which are smaller than a cell, drag the air
along (quadratic drag). Dust is carried in flux form, so that its mass is kept but for what goes out at the
sides. It weighs on the air it is in. What the air does to floors is left out: beside them it weighs nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Point, Singles
from game.compiler.decorator import lean_kernel
from game.physics.effects import EffectSet, declare_effect
from game.physics.gas import Gas, GasSettings, GasState
from game.physics.gas.effects import ADVECTION, PRESSURE
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementary, elementwise
from game.physics.surfaces.surface import Sample, empty_sample
from game.scenes.tower.building import RUBBLE, SHARD, SLAB
from game.scenes.tower.frame import Frame
from game.scenes.tower.level import TowerContent
from game.worlds.members import boxes
from game.worlds.world import Member

AIR = declare_effect("air", "Air", "What falls drives the air out from under it, and the air carries dust.")


DENSITY = 1.2  # kg/m³, of air
DRAG = 1.2  # of a piece, by its breadth (a plate across: 2; an edge-on one: less)
PER_STOREY, MOST_ROWS = 3, 64  # cells in a storey; rows of cells
THICKER = 1.02  # cells: so thick is a floor at least, so that no air goes through it
BESIDE, ABOVE = 33.0, 8.0  # m of air beside the tower and above it
FADES = 6  # cells at the sides over which the picture of the dust fades
FULL = 0.35  # kg/m³ of dust that hides what is behind it
RISES = 0.35  # of a cell for each to the side: how steeply the light falls
DIMS = 1.6  # kg/m² of dust that leave 1/e of the light
LAMP_RISES = 22.0  # m above the ground at which the light of lamps there is a good half
LAMPS_AT = 24.0  # m from the middle to both sides
SLOWS = 0.3  # 1/s
QUICKEST = 50.0  # m/s: what is squeezed out of a gap far narrower than a cell would have no bound
SLOWEST = 0.1  # m/s: slower pieces take no air along
STILL = 0.03  # m/s: slower air, without dust, is not computed
# of a floor: middle m, direction of its length, half its length and thickness m, velocity m/s, spin rad/s,
# half its extent across and up m
FX, FY, FC, FS, FLONG, FTHICK, FVX, FVY, FSPIN, FWIDE, FTALL = range(11)
FLOOR_WIDTH = 11
AS_BOX = [FX, FY, FC, FS, FLONG, FTHICK, FWIDE, FTALL]  # columns of a floor as those of `boxes`


class AirState(NamedTuple):
    """gas; dust (1,): kg raised so far, for a metre of depth; floors (k, FLOOR_WIDTH) as the gas knows
    them.
    """

    gas: GasState
    dust: Floats
    floors: Floats


@lean_kernel
def weigh(density, u, v, gravity, force):
    """Write force (ny, nx, 2) m/s²: dust (ny, nx) kg/m³ weighs on the air that it makes heavier, and whirls
    die down: in space they fall apart, in the plane they would last.
    """
    for j in range(force.shape[0]):
        for i in range(force.shape[1]):
            force[j, i, 0] = -0.5 * SLOWS * (u[j, i] + u[j, i + 1])
            force[j, i, 1] = -gravity * density[j, i] / (DENSITY + density[j, i])
            force[j, i, 1] -= 0.5 * SLOWS * (v[j, i] + v[j + 1, i])


@lean_kernel
def drag_along(pieces, u, v, lower, cell, dt, force):
    """Add to force (ny, nx, 2) m/s² the drag of pieces (n, 5): place m, velocity m/s, breadth m.

    Each pulls the air of its cell towards its own velocity, by no more than that in a step.
    """
    ny, nx = force.shape[0], force.shape[1]
    for n in range(pieces.shape[0]):
        i, j = int((pieces[n, 0] - lower[0]) / cell), int((pieces[n, 1] - lower[1]) / cell)
        if pieces[n, 0] < lower[0] or pieces[n, 1] < lower[1] or i >= nx or j >= ny:
            continue
        dx = pieces[n, 2] - 0.5 * (u[j, i] + u[j, i + 1])
        dy = pieces[n, 3] - 0.5 * (v[j, i] + v[j + 1, i])
        rate = 0.5 * DRAG * pieces[n, 4] * elementary.hypot(dx, dy) / (cell * cell)
        rate = rate / (1.0 + rate * dt)
        force[j, i, 0] += rate * dx
        force[j, i, 1] += rate * dy


def solids_of(frame: Frame, least: float) -> Floats:
    """(k, FLOOR_WIDTH): bays of floors that are whole, as solids of the air, ``least`` m thick."""
    whole, bodies = frame.rows((SLAB,)), frame.world.bodies
    own = frame.parts.body[whole]
    long, thick = 0.5 * frame.parts.wide[whole], 0.5 * np.maximum(frame.parts.tall[whole], least)
    c, s = np.abs(bodies.rotations[own]).T
    return np.column_stack([
        bodies.positions[own], bodies.rotations[own], long, thick, bodies.velocities[own], bodies.spins[own],
        c * long + s * thick, s * long + c * thick,
    ])  # fmt: skip


def loose_of(frame: Frame) -> Floats:
    """(n, 5): place m, velocity m/s, breadth m of what is broken and moves."""
    loose, bodies = frame.rows((SHARD, RUBBLE)), frame.world.bodies
    own = frame.parts.body[loose]
    breadth = 0.5 * (frame.parts.wide[loose] + frame.parts.tall[loose])
    found = np.column_stack([bodies.positions[own], bodies.velocities[own], breadth])
    return np.ascontiguousarray(found[np.abs(found[:, 2:4]).max(axis=1, initial=0.0) > SLOWEST])


class Floors:
    """Floors (k, FLOOR_WIDTH) as solids of the gas."""

    def __init__(self) -> None:
        self.rows: Floats = np.zeros((0, FLOOR_WIDTH))

    def sample(self, points: Floats) -> Sample:
        """Of the nearest floor."""
        found = empty_sample(len(points))
        if len(self.rows):
            places = np.ascontiguousarray(points, dtype=np.float64)
            boxes.sample_boxes(places, np.ascontiguousarray(self.rows[:, AS_BOX]), found.distance, found.body)
            own = self.rows[found.body]
            found.velocity[:, 0] = own[:, FVX] - own[:, FSPIN] * (places[:, 1] - own[:, FY])
            found.velocity[:, 1] = own[:, FVY] + own[:, FSPIN] * (places[:, 0] - own[:, FX])
        return found


class TowerAir(Member):
    """Air and dust about a tower of a level. on: whether it is computed."""

    def __init__(self, content: TowerContent, active: EffectSet):
        self.content, self.on = content, AIR in active
        self.begin()

    def begin(self) -> None:
        """At rest, and without dust."""
        content = self.content
        tall = content.storeys * content.storey + ABOVE
        half = 0.5 * content.bays * content.bay + BESIDE
        cell = max(content.storey / PER_STOREY, tall / MOST_ROWS)
        nx, ny = 2 * round(half / cell), round(tall / cell)
        self.grid = Grid(nx, ny, cell, (-0.5 * nx * cell, 0.0))
        away = Border("open")
        settings = GasSettings(
            effects=ADVECTION | PRESSURE, advection="cubic", turns=4, tolerance=1e-3, conservative=("smoke",)
        )  # fmt: skip
        self.gas = Gas(self.grid, Borders(away, away, Border("wall"), away), settings, ("smoke",))
        self.floors = Floors()
        self.dust: Floats = np.zeros(1)
        self._veil = np.zeros((ny, nx, 2), np.float32)
        self._lower = np.array(self.grid.lower)
        from_side = np.minimum(np.arange(nx), np.arange(nx)[::-1]) / FADES
        self._edge = np.minimum(from_side, 1.0)  # the picture has no edge at the sides

    @property
    def density(self) -> Floats:
        """(ny, nx) kg/m³ of dust."""
        return self.gas.field("smoke")

    def thickness(self, true: float) -> float:
        """m, of a floor in the air."""
        return max(true, THICKER * self.grid.cell)

    def raise_dust(self, places: Floats, kilograms: float) -> None:
        """So much dust (for each metre of depth), in equal parts at those of the places (n, 2) m where there
        is air; none if there is none.
        """
        cell, (ny, nx) = self.grid.cell, self.grid.shape
        i = np.floor((places[:, 0] - self._lower[0]) / cell).astype(np.int64)
        j = np.floor((places[:, 1] - self._lower[1]) / cell).astype(np.int64)
        inside = (i >= 0) & (i < nx) & (j >= 0) & (j < ny)
        i, j = i[inside], j[inside]
        ax, ay = self.gas.faces.ax, self.gas.faces.ay
        free = np.maximum(np.maximum(ax[j, i], ax[j, i + 1]), np.maximum(ay[j, i], ay[j + 1, i])) > 0.0
        if free.any():
            np.add.at(self.density, (j[free], i[free]), kilograms / (np.count_nonzero(free) * cell * cell))
            self.dust[0] += kilograms

    def is_still(self) -> bool:
        """True if nothing moves in it, and no dust is there."""
        fastest = max(float(np.max(np.abs(self.gas.u))), float(np.max(np.abs(self.gas.v))))
        return fastest < STILL and float(np.max(self.density)) < 1e-6

    def advance(self, floors: Floats, pieces: Floats, gravity: float, dt: float) -> None:
        """Flow for dt (s) under gravity (m/s²) about floors (k, FLOOR_WIDTH) and pieces (n, 5), see
        `drag_along`.
        """
        if not np.array_equal(floors, self.floors.rows):
            self._take_floors(floors)
        weigh(self.density, self.gas.u, self.gas.v, gravity, self.gas.force)
        drag_along(pieces, self.gas.u, self.gas.v, self._lower, self.grid.cell, dt, self.gas.force)
        self.gas.step(dt)
        for speeds in (self.gas.u, self.gas.v):
            np.clip(speeds, -QUICKEST, QUICKEST, out=speeds)

    def _take_floors(self, floors: Floats) -> None:
        self.floors.rows = floors
        self.gas.set_solids(*((self.floors,) if len(floors) else ()))

    def in_the_air(self) -> float:
        """kg of dust for each metre of depth."""
        return self.gas.total("smoke")

    def fastest(self) -> float:
        """m/s, of the air in the middles of cells."""
        w = self.gas.velocity()
        return float(np.sqrt(np.max(w[..., 0] * w[..., 0] + w[..., 1] * w[..., 1])))

    def veil(self, lamps: float = 0.0) -> Singles:
        """(ny, nx, 2): how thick the dust is, 0 to 1, and how much light it scatters, 0 to 1; good until the
        next call.

        Light comes in from the right; from lamps at the ground comes more, ``lamps`` times as much there.
        """
        share = self.density / FULL
        self._veil[..., 0] = 0.94 * share / (1.0 + share) * self._edge
        light = self._lit()
        if lamps > 0.0:
            light = np.minimum(0.45 * light + lamps * self._lit_by_lamps(), 1.0)
        self._veil[..., 1] = self._veil[..., 0] * light
        return self._veil

    def _lit_by_lamps(self) -> Floats:
        """(ny, nx): what is left of light from lamps at both sides at the ground, by height and by the dust
        on its way: up beside the tower, then across.
        """
        cell, (ny, nx) = self.grid.cell, self.grid.shape
        x = self._lower[0] + (np.arange(nx) + 0.5) * cell
        passed = np.cumsum(self.density, axis=1) - 0.5 * self.density
        lamps = np.clip(np.searchsorted(x, (-LAMPS_AT, LAMPS_AT)), 0, nx - 1)
        up = np.cumsum(self.density[:, lamps], axis=0)
        nearer = (np.abs(passed[:, :, None] - passed[:, None, lamps]) + up[:, None, :]).min(axis=2)
        heights = (np.arange(ny) * cell / LAMP_RISES)[:, None]
        beyond = np.maximum(np.abs(x) - LAMPS_AT, 0.0) / LAMP_RISES
        far = elementwise.power(1.0 + heights * heights, 0.75) * (1.0 + beyond * beyond)
        return elementwise.exp(-nearer * cell / DIMS) / far

    def _lit(self) -> Floats:
        """(ny, nx): what is left of light that comes in from the right, behind the dust, a little from above.
        It has gone RISES of a cell down for each one to the left (Lambert's law).
        """
        depth, behind = np.zeros_like(self.density), np.zeros(self.grid.ny)
        for i in range(self.grid.nx - 1, -1, -1):
            above = np.concatenate([behind[1:], behind[-1:]])
            behind = (1.0 - RISES) * behind + RISES * above
            depth[:, i] = behind
            behind = behind + self.density[:, i]
        return elementwise.exp(-depth * self.grid.cell / DIMS)

    def box(self) -> tuple[Point, Point]:
        """Lower left and upper right corner, m."""
        (x, y), h = self.grid.lower, self.grid.cell
        return (x, y), (x + self.grid.nx * h, y + self.grid.ny * h)

    # -- as a member ----------------------------------------------------------------------------------

    def change_effects(self, active: EffectSet) -> None:
        if AIR in active and not self.on:
            self.begin()
        self.on = AIR in active

    def state(self) -> tuple[Any, ...]:
        return (AirState(self.gas.state(), self.dust, self.floors.rows),)

    def restore(self, fields: Iterator[Any]) -> None:
        state: AirState = next(fields)
        self._take_floors(state.floors.copy())
        self.gas.restore(state.gas)
        self.dust[:] = state.dust
