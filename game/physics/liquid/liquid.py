"""A liquid of particles on a grid of cells (Harlow 1962; Zhu and Bridson 2005; Jiang et al. 2015).

A step: speeds pass from particles to faces; gravity; the pressure makes the flow free of divergence; speeds
pass back; particles move. With the same equation a second solve moves crowded particles apart (Kugelstadt,
Longva, Thürey and Bender 2021).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.grid.layout import Grid
from game.physics.grid.obstacles import GridObstacles
from game.physics.kernels import elementary
from game.physics.liquid import bodies, equation, faces, moving, projection, transfer
from game.physics.liquid.arrays import LEAST_OPEN, make_cells, make_particles, make_system, make_walls
from game.physics.liquid.effects import KEEP_VOLUME, LIQUID
from game.physics.liquid.settings import CARRIERS, SURFACES, LiquidSettings
from game.physics.liquid.surface import fill_room, find_surface, wet_cells
from game.physics.surfaces.surface import Surface

SIDES = ("left", "right", "bottom", "top")
MOST_PARTS = 1000  # of a step
SOLID_FAR = 3.0  # cells


class LiquidState(NamedTuple):
    """places, speeds (n, 2) m, m/s; affine (n, 4) m/s a cell; pressure, correction (ny, nx) of the last
    solves; account: (3,) particles put in, taken out, refused; clock: (2,) s, part steps; report: `Report`.
    """

    places: Floats
    speeds: Floats
    affine: Floats
    pressure: Floats
    correction: Floats
    account: Floats
    clock: Floats
    report: Floats


class Report(NamedTuple):
    """Of the last part step: wet cells, turns of both solvers, largest outflow left over, m/s."""

    wet: int = 0
    turns: int = 0
    turns_keeping: int = 0
    outflow: float = 0.0


class Liquid:
    """At most ``most`` particles on a grid. density kg/m³; spread: particles along the side of a cell."""

    def __init__(
        self,
        grid: Grid,
        settings: LiquidSettings | None = None,
        *,
        most: int = 20_000,
        spread: int = 2,
        density: float = 1000.0,
        effects: EffectSet = LIQUID.known,
        open_sides: tuple[str, ...] = (),
    ):
        """ValueError for nonsense; open_sides: through which liquid leaves for good."""
        if isinstance(most, bool) or not isinstance(most, int) or not 1 <= most <= 1 << 22:
            raise ValueError(f"most = {most!r}: expected a whole number of particles from 1")
        if spread not in (1, 2, 3, 4):
            raise ValueError(f"spread = {spread!r}: expected 1 to 4 particles along a cell")
        if not 0.0 < density < math.inf:
            raise ValueError(f"density = {density!r}: expected a number above 0, kg/m³")
        if not set(open_sides) <= set(SIDES):
            raise ValueError(f"open_sides = {open_sides!r}: expected some of {', '.join(SIDES)}")
        self.grid, self.settings, self.spread, self.density = (
            grid,
            settings or LiquidSettings(),
            spread,
            density,
        )
        self.effects, self.report = effects, Report()
        self.particles, self.cells = make_particles(most), make_cells(grid)
        self.cells.ends[:] = [side in open_sides for side in SIDES]
        self.system = make_system(grid.nx * grid.ny)
        self.obstacles = GridObstacles(grid)
        self.surfaces: tuple[Surface, ...] = ()
        self._grips, self._held = bodies.make_grips(grid.ny, grid.nx), list[bodies.Held]()
        self._scale = density * grid.cell * grid.cell
        self.account: Floats = np.zeros(3)
        self.clock: Floats = np.zeros(2)
        self._origin = (grid.lower[0], grid.lower[1], grid.cell)
        self.quarters: Floats = np.zeros((2 * grid.ny, 2 * grid.nx))
        self.walls = make_walls(grid, SOLID_FAR)
        self._take_walls()

    # -- particles ------------------------------------------------------------------------------------------

    @property
    def count(self) -> int:
        """How many particles there are."""
        return int(self.particles.alive[0])

    @property
    def places(self) -> Floats:
        """(n, 2) m, a view."""
        return self.particles.places[: self.count]

    @property
    def speeds(self) -> Floats:
        """(n, 2) m/s, a view."""
        return self.particles.speeds[: self.count]

    @property
    def area(self) -> float:
        """m² of liquid that a particle stands for."""
        return self.grid.cell * self.grid.cell / (self.spread * self.spread)

    def add(self, places: ArrayLike, speed: tuple[float, float] = (0.0, 0.0)) -> int:
        """Put in particles at places (n, 2) m with a speed (m/s), as far as there is room; how many.

        Those outside the grid or in a solid are left out. ValueError for what is no number.
        """
        at = np.asarray(places, dtype=np.float64).reshape(-1, 2)
        if not (np.isfinite(at).all() and all(map(math.isfinite, speed))):
            raise ValueError("places, speed: expected finite numbers")
        low, high = np.asarray(self.grid.lower), np.asarray(self.grid.upper)
        at = at[((at > low) & (at < high)).all(axis=1)]
        if len(self.surfaces) and len(at):
            at = at[self.solid_distance(at) > 0.0]
        fits = min(len(at), len(self.particles.places) - self.count)
        here = slice(self.count, self.count + fits)
        self.particles.places[here], self.particles.speeds[here] = at[:fits], speed
        self.particles.affine[here] = 0.0
        self.particles.alive[0] += fits
        self.account[0] += fits
        self.account[2] += len(at) - fits
        return fits

    def lattice(self, low: ArrayLike, high: ArrayLike) -> Floats:
        """Places (n, 2) m of particles that fill a box (corners m), a lattice on the grid's own cells."""
        pitch, corner = self.grid.cell / self.spread, np.asarray(self.grid.lower)
        first = np.ceil((np.asarray(low) - corner) / pitch - 0.5 - 1e-9)
        last = np.floor((np.asarray(high) - corner) / pitch - 0.5 + 1e-9)
        limits = np.array(self.grid.shape[::-1]) * self.spread - 1
        first, last = np.clip(first, 0, limits + 1), np.clip(last, -1, limits)
        columns = (np.arange(first[0], last[0] + 1) + 0.5) * pitch + corner[0]
        rows = (np.arange(first[1], last[1] + 1) + 0.5) * pitch + corner[1]
        x, y = np.meshgrid(columns, rows)
        return np.stack([x.ravel(), y.ravel()], axis=1)

    def keep_only(self, kept: np.ndarray) -> int:
        """Take out the particles for which kept (n,) is false; how many."""
        gone = self.count - int(np.count_nonzero(kept))
        if gone:
            for rows in (self.particles.places, self.particles.speeds, self.particles.affine):
                rows[: self.count - gone] = rows[: self.count][kept]
            self.particles.alive[0] -= gone
            self.account[1] += gone
        return gone

    # -- solids ---------------------------------------------------------------------------------------------

    def set_solids(self, *surfaces: Surface) -> None:
        """Sample these solids now; liquid in them is moved out of them.

        Bodies with an inverse mass are moved by the liquid: the pushes of a step take their own fall by
        gravity for granted, which the room of the bodies adds.
        """
        self.sample_solids(*surfaces)
        if surfaces and self.count:
            self._push_out()

    def sample_solids(self, *surfaces: Surface) -> None:
        """The same, and leave the liquid where it is."""
        self.surfaces = surfaces
        if surfaces:
            many = len(surfaces)
            self.obstacles.update(*[bodies.Numbered(one, k, many) for k, one in enumerate(surfaces)])
        else:
            self.obstacles.clear()
        found = self.obstacles
        self._held = bodies.hold_bodies(self._grips, surfaces, found.body_u, found.body_v, self._scale)
        self._take_walls()

    def solid_distance(self, places: Floats) -> Floats:
        """(n,) m from the nearest solid, below 0 in it."""
        found: Floats = np.full(len(places), np.inf)
        for surface in self.surfaces:
            np.minimum(found, surface.sample(places).distance, out=found)
        return found

    def _take_walls(self) -> None:
        found, walls = self.obstacles.faces, self.walls
        walls.ax[:], walls.ay[:], walls.u[:], walls.v[:] = found.ax, found.ay, found.u, found.v
        of_u, of_v = self._grips.of_u, self._grips.of_v
        edges = (
            (walls.ax[:, 0], walls.u[:, 0], of_u[:, 0]), (walls.ax[:, -1], walls.u[:, -1], of_u[:, -1]),
            (walls.ay[0], walls.v[0], of_v[0]), (walls.ay[-1], walls.v[-1], of_v[-1]),
        )  # fmt: skip
        for is_open, (part, speed, body) in zip(self.cells.ends, edges, strict=True):
            if not is_open:
                part[:], speed[:], body[:] = 0.0, 0.0, -1
        if self.surfaces:
            cells = 1.0 / self.grid.cell
            nodes, mid_x, mid_y, centres = self.obstacles.distances
            walls.distance[::2, ::2], walls.distance[1::2, ::2] = nodes * cells, mid_x * cells
            walls.distance[::2, 1::2], walls.distance[1::2, 1::2] = mid_y * cells, centres * cells
        else:
            walls.distance[:] = SOLID_FAR
        walls.present[0] = bool(self.surfaces)
        walls.ax[walls.ax < LEAST_OPEN], walls.ay[walls.ay < LEAST_OPEN] = 0.0, 0.0
        self.walls = walls._replace(
            closed_u=np.flatnonzero(walls.ax < LEAST_OPEN),
            closed_v=np.flatnonzero(walls.ay < LEAST_OPEN),
        )
        fill_room(self.cells, walls, self.quarters)

    def _push_out(self) -> None:
        """Particles in a solid go out as far as they were in, each a little to its own side."""
        places, edge = self.places, moving.NEAR * self.grid.cell
        low, high = np.asarray(self.grid.lower) + edge, np.asarray(self.grid.upper) - edge
        for surface in self.surfaces:
            found = surface.sample(places)
            inside = np.flatnonzero(found.distance < -moving.FAR * self.grid.cell)
            if len(inside):
                normal, deep = found.normal[inside], found.distance[inside]
                part = moving.GOLDEN * inside
                along = (part - np.floor(part) - 0.5) * (0.5 * self.grid.cell)
                out = -2.0 * deep[:, None] * normal
                out += along[:, None] * np.stack([-normal[:, 1], normal[:, 0]], axis=1)
                places[inside] = np.clip(places[inside] + out, low, high)

    # -- a step ---------------------------------------------------------------------------------------------

    def advance(self, duration: float) -> int:
        """Go on by a duration (s) in part steps in which no particle crosses more than ``courant`` cells.

        How many there were. ValueError for a duration that is none; RuntimeError beyond ``MOST_PARTS``.
        """
        if not 0.0 <= duration < math.inf:
            raise ValueError(f"duration = {duration!r}: expected a number from 0, s")
        left, made = duration, 0
        bodies.find_lift(self._grips, self._held, self._scale, self._pull(), duration)
        while left > 1e-12 * duration:
            speed = float(moving.fastest(self.particles)) + (abs(self._pull()) * left if self.count else 0.0)
            parts = max(1.0, math.ceil(left * speed / (self.settings.courant * self.grid.cell) - 1e-9))
            if not parts + made <= MOST_PARTS:
                raise RuntimeError(f"liquid: {speed:.4g} m/s asks for {parts:g} part steps in {left:g} s")
            self.step(left / parts, duration)
            left -= left / parts
            made += 1
        return made

    def _pull(self) -> float:
        return self.settings.gravity if GRAVITY in self.effects else 0.0

    def step(self, dt: float, whole: float = 0.0) -> None:
        """One part step of dt, s. whole: s, of the step in which bodies get it evenly; 0 is at once."""
        settings, cells, walls, origin = self.settings, self.cells, self.walls, self._origin
        pull, ghost = self._pull(), settings.surface == SURFACES.index("ghost")
        transfer.to_cells(self.particles, cells, walls, origin, 1.0 / (self.spread * self.spread))
        faces.pull(cells, -pull * dt)
        wet, regions, turns, after = int(find_surface(cells, walls)), 0, 0, 0.0
        if wet:
            regions, turns, after = self._find_pressure(wet, dt, whole)
            equation.take_slope(cells, walls, cells.q, 1.0, ghost)
        else:
            cells.q[:] = 0.0
        faces.close(cells, walls)
        faces.continue_speeds(cells)
        transfer.to_particles(
            self.particles, cells, origin, settings.carrier == CARRIERS.index("apic"), settings.flip
        )
        moved_apart = 0
        if wet and KEEP_VOLUME in self.effects and settings.keeping > 0.0:
            moved_apart = projection.find_shift(cells, self.system, self._grips, settings, wet, regions)
            equation.take_slope(cells, walls, cells.q_shift, self.grid.cell / dt, ghost)
        moving.advect(self.particles, cells, walls, origin, dt, 0.5 * pull * dt * dt)
        if cells.ends.any():
            self.account[1] += moving.drop_outside(self.particles, self.grid.lower, self.grid.upper)
        self.report = Report(wet, int(turns), int(moved_apart), float(after))
        self.clock += dt, 1.0

    def _find_pressure(self, wet: int, dt: float, whole: float) -> tuple[int, int, float]:
        """The pressure, with what it does to bodies, which meanwhile fall for dt, s, or are held up."""
        grips, held = self._grips, self._held
        if held:
            bodies.grip(grips, self.cells.rank, self.cells.phi, self.walls, self._origin)
            grips.gain[: len(held)] += dt * grips.lift[: len(held)]
            grips.gain[: len(held), 1] -= self._pull() * dt
        found = projection.find_pressure(self.cells, self.walls, self.system, grips, self.settings, wet)
        if held:
            mobility, sums = grips.mobility[: len(held)], grips.sums[: len(held)]
            grips.gain[: len(held)] += mobility * sums
            for one, centre, impulse in zip(held, grips.centre, self._scale * sums, strict=False):
                if impulse.any():
                    bodies.push(one, centre, impulse, whole)
        return int(found[0]), int(found[1]), float(found[2])

    # -- what there is --------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """s since the start."""
        return float(self.clock[0])

    def pressure(self, dt: float) -> Floats:
        """(ny, nx) Pa, of the last part step of dt, s."""
        return np.asarray(self.cells.q * (self.density * self.grid.cell / dt))

    def refresh(self) -> None:
        """Find fill and surface of the particles as they are now."""
        share = 1.0 / (self.spread * self.spread)
        transfer.to_cells(self.particles, self.cells, self.walls, self._origin, share)
        find_surface(self.cells, self.walls)

    def wet_area(self) -> float:
        """m² of liquid by the cells that it fills, as of the last part step. Crowded particles count less."""
        cells: float = wet_cells(self.cells, self.obstacles.faces.volume)
        return cells * self.grid.cell * self.grid.cell

    def energy(self) -> tuple[float, float]:
        """J/m of motion, and of height above the grid's lower side."""
        mass = self.density * self.area
        height = float((self.places[:, 1] - self.grid.lower[1]).sum())
        moving_part = 0.5 * mass * float(elementary.square(self.speeds).sum())
        return moving_part, mass * self._pull() * height

    def state(self) -> LiquidState:
        """All that later steps depend on, beside solids and settings."""
        n, p = self.count, self.particles
        report = np.array(self.report, dtype=np.float64)
        return LiquidState(
            p.places[:n], p.speeds[:n], p.affine[:n], self.cells.q, self.cells.q_shift, self.account,
            self.clock, report,
        )  # fmt: skip

    def restore(self, state: LiquidState) -> None:
        """Take over a copy of a state."""
        n, p = len(state.places), self.particles
        p.alive[0] = n
        p.places[:n], p.speeds[:n], p.affine[:n] = state.places, state.speeds, state.affine
        self.cells.q[:], self.cells.q_shift[:] = state.pressure, state.correction
        self.account[:], self.clock[:] = state.account, state.clock
        wet, turns, keeping, outflow = state.report.tolist()
        self.report = Report(int(wet), int(turns), int(keeping), outflow)
