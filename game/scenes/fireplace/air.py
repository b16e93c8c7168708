"""The gas about the fire: hood and flue, what burns in it, what wood and match give it."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats, Point
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings
from game.physics.gas.densities import carry_densities
from game.physics.gas.effects import ADVECTION, BUOYANCY, EXPANSION
from game.physics.grid import Border, Borders, Grid
from game.physics.grid.obstacles import GridObstacles
from game.physics.kernels import elementary
from game.scenes.fireplace import tables as t
from game.scenes.fireplace.tables import HALF, ROOM, TALL
from game.worlds.members.boxes import Boxes, box_rows
from game.worlds.members.burning_air import FIELDS, FRESH, BurningAir, faded
from game.worlds.members.openings import Openings
from game.worlds.painting.glowing import GlowLook

OUTSIDE = np.array([0.0, 0.0, FRESH, 0.0])  # J/m³ of heat, kg/m³ of fuel, oxygen and soot in the room
LEAST_FRESH = 1e-6  # share of fresh air: where there is less nowhere, all cells are alike
SLOWS = 0.8  # 1/s at which whirls die down: in space they fall apart, in the plane they would last
VAPOUR = {
    "ignition": 580.0, "rate": 30.0, "oxygen": 1.3, "heat": 1.6e7, "capacity": 1212.0, "soot": 0.05,
    "soot_rate": 1.4, "glow": 1.5e-11, "soot_glow": 4e-7, "ambient": ROOM,
}  # fmt: skip
HEAD = 0.026  # m about the head of a match that its flame fills
MATCH_HOT = 1500.0  # K at most, of its flame
LOOK = GlowLook(680.0, 1450.0, 0.05, 1.0e-4, 1.6e-3, 0.85, 950.0)
USED = 14  # of the flows: oxygen
COLDEST = 250.0  # K to which wood can cool gas
QUICKEST = 60.0  # 1/s at which a cell grows or shrinks at most
PLATE = 0.017  # m, half the thickness of a plate of the damper
SIDES = 0.62  # m beside the middle: beyond, a draught takes the air along
MOVED = 0.25  # cells: by so much logs move before the gas looks at them again
WAYS = (True, True, False, True)  # sides (left, right, bottom, top) from which gas comes; below is the floor
SLIT = 0.5  # of a face: through what is narrower no gas goes, else it would be a jet without bound


class Air(BurningAir):
    """cells: across. ``logs``: solids of the gas beside hood and damper.

    Its flows, J/m: from the match (less what water took), and asked of gas that was too cold to give it.
    Then four each of heat (J/m), fuel, oxygen and soot (kg/m): see `out`, `lost` and `covered`. The last is
    the oxygen (kg/m) that coal has used.
    """

    vapour, flame_look, counts = VAPOUR, LOOK, 15

    def __init__(
        self, cells: int, cycles: int, damper: float, sealed: bool, active: EffectSet, gas_effects: EffectSet
    ):  # fmt: skip
        cell = 2.0 * HALF / cells
        kind = "wall" if sealed else "open"
        borders = Borders(Border(kind), Border(kind), Border("wall"), Border(kind))
        gas = Gas(
            Grid(cells, round(TALL / cell), cell, (-HALF, 0.0)), borders,
            GasSettings(
                effects=gas_effects.without(BUOYANCY), turns=cycles, ambient=ROOM, conservative=FIELDS[1:],
                carries_fields=False,
            ),
            FIELDS, {"oxygen": FRESH},
        )  # fmt: skip
        super().__init__(gas, faded(gas.grid.shape, 0.12), active, BUOYANCY in gas_effects)
        self.wind, self.damper = 0.0, -1.0
        self.logs, self._solids = Boxes(), Boxes()
        self._obstacles, self.openings = GridObstacles(gas.grid), Openings(gas.grid.shape, WAYS)
        x, _ = self.gas.grid.centres()
        self._rise = np.zeros(self.gas.grid.shape)  # K that wood and match have warmed cells by in this step
        self._outside = np.abs(x) > SIDES
        self.set_damper(damper)

    # -- what it is made of -----------------------------------------------------------------------------

    def set_damper(self, share: float) -> None:
        """Open so much of the flue, 0 to 1."""
        if share == self.damper:
            return
        self.damper = share
        self._take_solids()

    def set_logs(self, rows: Floats) -> None:
        """Flow about logs (k, BOX_WIDTH of `worlds.members.boxes`) from now on, if they have moved."""
        if self.logs.differ(rows, MOVED * self.cell):
            self.restore_logs(rows)

    def restore_logs(self, rows: Floats) -> None:
        """Logs as they are in a state whose gas is restored next."""
        self.logs.rows = rows
        self._take_solids()

    def _take_solids(self) -> None:
        """Sample hood, damper and logs; to the gas they are at rest. What they cover is booked."""
        before = self.contents()
        self._solids.rows = np.concatenate([_shell(self.damper), self.logs.rows])
        faces = self._obstacles.update(self._solids)
        self.openings.take(faces.ax, faces.ay, SLIT)
        self.gas.set_open_parts(faces.ax, faces.ay)
        self.covered[:] += before - self.contents()

    def plates(self) -> list[Floats]:
        """Corners (4, 2) m of the damper's two plates."""
        return [np.array(_plate(side, self.damper)) for side in (-1.0, 1.0)]

    # -- what comes in ------------------------------------------------------------------------------------

    def around(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """K (of the three hottest), share of fresh air and m/s of the gas, means over points (n, k, 2) m."""
        j, i = self.openings.nearest_to(*self.cells_at(points))
        cells = self.gas.scalars[j, i]
        along = 0.5 * (self.gas.u[j, i] + self.gas.u[j, i + 1])
        upward = 0.5 * (self.gas.v[j, i] + self.gas.v[j + 1, i])
        speed = np.sqrt(along * along + upward * upward)
        hottest = np.sort(cells[..., 0], axis=1)[:, -3:]
        fresh = np.sum(self._free(points) * self.fresh()[j, i], axis=1)
        return np.mean(hottest, axis=1), np.clip(fresh, 0.0, 1.0), np.mean(speed, axis=1)

    def _free(self, points: Floats) -> Floats:
        """(n, k) shares, 1 together, in which a piece meets gas at its points (n, k, 2) m: those that another
        lies on have none, unless all are so.
        """
        j, i = self.cells_at(points)
        free = (self.openings.nearest[j, i] == j * self.gas.grid.nx + i).astype(np.float64)
        free[np.sum(free, axis=1) == 0.0] = 1.0
        return np.asarray(free / np.sum(free, axis=1)[:, None])

    def take(self, points: Floats, joule: Floats, vapour: Floats, burnt: Floats) -> None:
        """Heat (n,) J/m and vapour (n,) kg/m into the cells at points (n, k, 2) m, where these are free.

        Coal that has ``burnt`` (n,) kg/m takes its oxygen from there, and gives its heat to the same cells.
        """
        j, i = self.openings.nearest_to(*self.cells_at(points))
        volume, share = self.cell * self.cell, self._free(points)
        burns = share * np.maximum(self.fresh()[j, i], LEAST_FRESH)
        burns /= np.sum(burns, axis=1)[:, None]
        parts = np.where(joule[:, None] > 0.0, burns, share)
        np.add.at(self._rise, (j, i), joule[:, None] * parts / (VAPOUR["capacity"] * volume))
        np.add.at(self.gas.scalars[..., 1], (j, i), vapour[:, None] * share / volume)
        oxygen, asked = self.gas.scalars[..., 2], np.zeros(self.gas.grid.shape)
        np.add.at(asked, (j, i), VAPOUR["oxygen"] * burnt[:, None] * burns / volume)
        used = np.minimum(asked, np.maximum(oxygen, 0.0))
        oxygen -= used
        self.flows[USED] += volume * float(np.sum(used))

    def heat_match(self, head: Point, power: float, dt: float) -> None:
        """The flame of a match of so many W/m at its head."""
        x, y = self.gas.grid.centres()
        near = elementary.square(x - head[0]) + elementary.square(y - head[1] - 0.012) < HEAD * HEAD
        near &= self.openings.open
        count = int(np.count_nonzero(near))
        if not count:
            return
        warm = self.gas.scalars[..., 0]
        rise = np.minimum(
            power * dt / (VAPOUR["capacity"] * (self.cell * self.cell) * count),
            np.maximum(MATCH_HOT - warm, 0.0),
        )
        self._rise[near] += rise[near]
        self.flows[0] += float(np.sum(rise[near])) * VAPOUR["capacity"] * (self.cell * self.cell)

    def pour(self, place: Point, reach: float) -> None:
        """Steam where water falls on a fire: it takes heat (J/m) of the gas around, and drives the air
        out.
        """
        near = self.near(place, reach)
        warm = self.gas.scalars[..., 0]
        cooler, before = np.where(near, 373.15 + 0.3 * (warm - 373.15), warm), self.heat()
        taken = np.where(near & (warm > 373.15), warm - cooler, 0.0)
        warm -= taken
        self.gas.scalars[..., 2][near] *= 0.4
        self.flows[0] -= before - self.heat()

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Burn, and flow."""
        gas, warm, volume = self.gas, self.gas.scalars[..., 0], self.cell * self.cell
        at_first, asked = warm.copy(), float(np.sum(self._rise))
        dense, before = gas.scalars.copy(), self.heat()
        dense[..., 0] = self._heats()
        np.maximum(self._rise, COLDEST - warm, out=self._rise)
        given = VAPOUR["capacity"] * volume * float(np.sum(self._rise))
        self.flows[1] += VAPOUR["capacity"] * volume * asked - given
        if self._expands():
            np.divide(self._rise, warm * dt, out=gas.expansion)
        else:
            gas.expansion[:] = 0.0
        warm += self._rise
        self._rise[:] = 0.0
        self.flames.step(gas.scalars, dt, gas.expansion)
        # by the cells themselves, not by the books of what burnt: else these could say what they like
        warmed = VAPOUR["capacity"] * volume * float(np.sum(warm - at_first))
        np.clip(gas.expansion, -QUICKEST, QUICKEST, out=gas.expansion)
        gas.force[:] = 0.0
        self.rise()
        self.slow(SLOWS, SLOWS)
        if self.wind != 0.0:
            along, _ = self.velocities()
            gas.force[self._outside, 0] += 3.0 * (self.wind - along[self._outside])
        # what is warmed holds that, until it expands
        dense[..., 0] += VAPOUR["capacity"] * (warm - at_first)
        dense[..., 1:] = gas.scalars[..., 1:]
        brought = self.contents()
        brought[0] = before + warmed
        out = self._carry(dense, dt)
        self.out[:] += out
        self.lost[:] += brought - out - self.contents()

    def _carry(self, dense: Floats, dt: float) -> Floats:
        """Let the gas flow, and what is in it, (ny, nx, 4): heat J/m³, fuel, oxygen and soot kg/m³.

        The velocity is the one that is left, which agrees with the expansion of this step. By fluxes the sums
        stay. Returns what left the box, J/m and kg/m (4,).
        """
        gas, out = self.gas, np.zeros(len(FIELDS))
        gas.step(dt)
        if ADVECTION in gas.settings.effects:
            out = carry_densities(gas, dense, OUTSIDE, dt)
        half = dense[..., 0] / VAPOUR["capacity"]
        gas.scalars[..., 0] = half + np.sqrt(half * half + ROOM * ROOM) if self._expands() else ROOM + half
        gas.scalars[..., 1:] = dense[..., 1:]
        return out

    def _expands(self) -> bool:
        return EXPANSION in self.flames.made_of.effects

    @property
    def of_match(self) -> float:
        """J/m that a match gave, less what water took."""
        return float(self.flows[0])

    @property
    def refused(self) -> float:
        """J/m (below 0) that wood took from gas which was too cold to give it."""
        return float(self.flows[1])

    @property
    def out(self) -> Floats:
        """(4,) J/m, kg/m that left the box with the gas."""
        return self.flows[2:6]

    @property
    def lost(self) -> Floats:
        """(4,) J/m, kg/m that the gas's way of carrying has lost: what was in its cells, or warmed them, less
        what left through the sides and what is in them then. In flux form it is rounding. Of what burnt and
        radiated it knows nothing.
        """
        return self.flows[6:10]

    @property
    def covered(self) -> Floats:
        """(4,) J/m, kg/m that was in gas where logs or damper came to lie, less what is where they lay.
        Fuel, oxygen and soot are pushed aside: of them it is rounding.
        """
        return self.flows[10:14]

    # -- what there is ------------------------------------------------------------------------------------

    def speeds(self) -> Floats:
        """(ny, nx) m/s."""
        along, upward = self.velocities()
        return np.asarray(np.sqrt(along * along + upward * upward))

    def fresh(self) -> Floats:
        """(ny, nx) oxygen of the gas, by mass, as a share of that of fresh air."""
        thin = self.gas.scalars[..., 0] / ROOM if self._expands() else 1.0
        return np.asarray(np.clip(self.gas.scalars[..., 2] * thin / FRESH, 0.0, 1.0))

    def draught(self) -> float:
        """m/s upwards above the fire, by which it is seen to puff."""
        j, i = self.gas.grid.cell_at(0.0, 0.6)
        return float(self.gas.v[j, i])

    def _heats(self) -> Floats:
        """(ny, nx) J/m³ above that of the room. Gas that has been warmed by C dT and has expanded by dT / T
        holds C (T² - Ta²) / 2 T of it, as d(h T) = C T dT; in a box where nothing expands it is C (T - Ta).
        """
        warm = self.gas.scalars[..., 0]
        share = 0.5 * (warm + ROOM) / warm if self._expands() else 1.0
        return np.asarray(VAPOUR["capacity"] * (warm - ROOM) * share)

    def contents(self) -> Floats:
        """(4,) J/m of heat above that of the room, kg/m of fuel, oxygen and soot."""
        return np.array(
            [self.heat(), *(np.sum(self.gas.scalars[..., 1:], axis=(0, 1)) * (self.cell * self.cell))]
        )

    def heat(self) -> float:
        """J/m in the gas above that of the room."""
        return float(np.sum(self._heats())) * (self.cell * self.cell)


def _plate_middle(share: float) -> float:
    """m beside the middle of the flue: of a plate that is as long as half of it and slides into the wall."""
    return t.HOOD_IN * (0.5 + share)


def _plate(side: float, share: float) -> list[Point]:
    """Corners of a plate of the damper."""
    middle, half, thick = side * _plate_middle(share), 0.5 * t.HOOD_IN, PLATE
    return [
        (middle - half, t.DAMPER_AT - thick), (middle + half, t.DAMPER_AT - thick),
        (middle + half, t.DAMPER_AT + thick), (middle - half, t.DAMPER_AT + thick),
    ]  # fmt: skip


def _shell(damper: float) -> Floats:
    """(6, BOX_WIDTH) hood, flue and the damper's plates, both sides; slanted walls end where others begin."""
    along, up = t.HOOD_IN - t.HOOD_OUT, t.THROAT - t.HOOD_FOOT
    long = elementary.length(along, up)
    c, s, half = along / long, up / long, 0.5 * t.WALL
    places, directions, halves = [], [], []
    for side in (-1.0, 1.0):
        slant = 0.5 * (t.HOOD_IN + t.HOOD_OUT) + half * s, 0.5 * (t.THROAT + t.HOOD_FOOT) - half * c
        flue = t.HOOD_IN + half, 0.5 * (t.THROAT + TALL + 0.2)
        places += [(side * slant[0], slant[1]), (side * flue[0], flue[1])]
        places.append((side * _plate_middle(damper), t.DAMPER_AT))
        directions += [(side * c, s), (0.0, 1.0), (1.0, 0.0)]
        halves += [(0.5 * long, half), (0.5 * (TALL + 0.2 - t.THROAT), half), (0.5 * t.HOOD_IN, PLATE)]
    return box_rows(np.array(places), np.array(directions), np.array(halves))
