"""A wind tunnel: gas that flows past one outline, and the force on it, measured in two ways at every step."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.gas import ADVECTIONS, GAS, Gas, GasSettings, GasState
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementwise
from game.physics.tunnel import balance, wall_force
from game.physics.tunnel.effects import TUNNEL
from game.physics.tunnel.outlines import PlacedOutline, TunnelOutline
from game.physics.tunnel.sticking import faces_near, stick

WALLS = ("slip", "open", "no-slip")
PROFILES = ("even", "parabolic")
MARGIN = 4.0  # cells from the outline's reach to the box whose momentum is booked
ROUNDING = 1e-6  # cells: so that the box is as far from the outline below as above
MOST_CELLS = 1 << 20
RANGES = {
    "cells": (2.0, 400.0), "width": (0.1, 1e3), "height": (0.1, 1e3), "wind": (0.0, 1e3),
    "reynolds": (0.1, 1e5), "courant": (0.05, 20.0), "tolerance": (0.0, 1.0), "nudge": (0.0, 1.0),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class TunnelSettings:
    """What a tunnel is. ValueError, naming the field, for nonsense.

    cells: of the grid, for a metre; width, height, at: m, of the tunnel, and where the outline's middle is
    (None: as far from the inflow as from a side, or three tenths of the width). wind: m/s, the mean over the
    inflow. reynolds: wind times chord over viscosity. walls: below and above, gas slips along them, sticks
    to them, or they are "open". profile: the wind is the same at all heights, or that of a channel (wind
    is then its mean, the middle has 1.5 of it). courant: cells that the wind moves in a step. nudge: share of
    the wind that blows across at the start, so that a wake need not wait for rounding to begin to swing.
    """

    cells: float = 12.0
    width: float = 12.0
    height: float = 6.0
    at: tuple[float, float] | None = None
    wind: float = 1.0
    reynolds: float = 100.0
    walls: str = "slip"
    profile: str = "even"
    courant: float = 0.8
    turns: int = 6
    tolerance: float = 1e-4
    advection: str = "time-centred"
    nudge: float = 0.05
    effects: EffectSet = TUNNEL.known

    def __post_init__(self) -> None:
        for name, (low, high) in RANGES.items():
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")
        for name, known in (("walls", WALLS), ("profile", PROFILES), ("advection", ADVECTIONS)):
            if getattr(self, name) not in known:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected one of {', '.join(known)}")
        if self.cells * self.cells * self.width * self.height > MOST_CELLS:
            raise ValueError(f"cells = {self.cells:g}: expected at most {MOST_CELLS} cells in all")

    @property
    def place(self) -> tuple[float, float]:
        """m, where the outline's middle is."""
        return self.at if self.at is not None else (0.3 * self.width, 0.5 * self.height)

    @property
    def pace(self) -> float:
        """m/s by which steps and coefficients are made: the wind, or 1 where none blows."""
        return self.wind if self.wind > 0.0 else 1.0


class Forces(NamedTuple):
    """Coefficients of drag, lift and moment (nose up), by pressure, by friction, and by the momentum book."""

    pressure: tuple[float, float, float]
    friction: tuple[float, float, float]
    book: tuple[float, float, float]

    @property
    def wall(self) -> tuple[float, float, float]:
        """Pressure and friction together."""
        a, b = self.pressure, self.friction
        return a[0] + b[0], a[1] + b[1], a[2] + b[2]


class TunnelState(NamedTuple):
    """gas; corners (n, 2) m and numbers (4,) of the outline; pose (2,): angle of attack rad, s since it was
    turned; held (3,) and reading (9,): momentum in the box, coefficients.
    """

    gas: GasState
    corners: Floats
    numbers: Floats
    pose: Floats
    held: Floats
    reading: Floats


class Tunnel:
    """An outline held in the wind.

    ``gas``; ``outline``; ``attack`` rad, nose up; ``reading`` (9,): `Forces` in one row. Call `step`, `turn`,
    `change_outline`. ValueError, in one line, for an outline that does not fit in.
    """

    def __init__(self, outline: TunnelOutline, settings: TunnelSettings | None = None, attack: float = 0.0):
        self.settings = settings or TunnelSettings()
        chosen = self.settings
        h = 1.0 / chosen.cells
        self.grid = Grid(
            max(4, round(chosen.width * chosen.cells)), max(4, round(chosen.height * chosen.cells)), h
        )
        self.held: Floats = np.zeros(3)
        self.reading: Floats = np.zeros(9)
        self.pose: Floats = np.array([float(attack), 0.0])
        self._flow, self._after, self._sums = np.zeros(3), np.zeros(3), np.zeros(6)
        self._check_fit(outline)
        self.outline = outline
        self.gas = Gas(self.grid, self._borders(), self._gas_settings(), ("smoke",))
        self._place()
        self._begin()

    # -- what it is ---------------------------------------------------------------------------------

    def _borders(self) -> Borders:
        chosen = self.settings
        side = Border({"slip": "wall", "no-slip": "no-slip", "open": "open"}[chosen.walls])
        return Borders(Border("inflow", self._profile()), Border("open"), side, side)

    def _profile(self) -> Floats:
        """(ny, 2) m/s of what flows in."""
        tall = self.grid.ny * self.grid.cell
        y = (np.arange(self.grid.ny) + 0.5) * self.grid.cell
        shape = (
            6.0 * y * (tall - y) / (tall * tall) if self.settings.profile == "parabolic" else np.ones_like(y)
        )
        return np.stack([self.settings.wind * shape, np.zeros_like(y)], axis=1)

    @property
    def viscosity(self) -> float:
        """m²/s."""
        return self.settings.pace * self.outline.chord / self.settings.reynolds

    @property
    def step_length(self) -> float:
        """s."""
        return self.settings.courant * self.grid.cell / self.settings.pace

    @property
    def attack(self) -> float:
        """rad, how far the nose is raised."""
        return float(self.pose[0])

    @property
    def blockage(self) -> float:
        """Share of the tunnel's height that the outline covers."""
        return self.outline.width(self.attack) / (self.grid.ny * self.grid.cell)

    def _gas_settings(self) -> GasSettings:
        chosen = self.settings
        return GasSettings(
            effects=chosen.effects & GAS.known, advection=chosen.advection, turns=chosen.turns,
            tolerance=chosen.tolerance, viscosity=self.viscosity, gravity=(0.0, 0.0), slip=False,
        )  # fmt: skip

    def change_settings(self, settings: TunnelSettings) -> None:
        """Another wind, viscosity or step; ValueError if the grid or the place would be another."""
        fixed = ("cells", "width", "height", "at", "walls")
        if any(getattr(settings, name) != getattr(self.settings, name) for name in fixed):
            raise ValueError(f"settings: {', '.join(fixed)} cannot change in a tunnel that stands")
        self.settings = settings
        self.gas.settings = self._gas_settings()
        self.gas.set_borders(self._borders())

    # -- the outline in it --------------------------------------------------------------------------

    def _check_fit(self, outline: TunnelOutline) -> None:
        h, (x, y) = self.grid.cell, self.settings.place
        far = outline.reach + MARGIN * h
        box = (
            math.floor((x - far) / h + ROUNDING), math.ceil((x + far) / h - ROUNDING),
            math.floor((y - far) / h + ROUNDING), math.ceil((y + far) / h - ROUNDING),
        )  # fmt: skip
        if not (box[0] >= 2 and box[1] <= self.grid.nx - 2 and box[2] >= 2 and box[3] <= self.grid.ny - 2):
            raise ValueError(
                f"shape: it reaches {outline.reach:.3g} m from its middle, too near to the tunnel's walls"
            )
        self.box = np.array(box, dtype=np.int64)

    def change_outline(self, outline: TunnelOutline, attack: float = 0.0) -> None:
        """Another outline in the same flow. ValueError, and nothing changed, if it does not fit in."""
        self._check_fit(outline)
        self.outline = outline
        self.gas.settings = self._gas_settings()
        self.turn(attack)

    def turn(self, attack: float) -> None:
        """Another angle of attack, rad. ValueError for what is no number."""
        if not math.isfinite(attack):
            raise ValueError(f"attack = {attack!r}: expected a finite angle, rad")
        self.pose[:] = attack, 0.0
        self._place()
        self._hold(self.held)

    def _place(self) -> None:
        placed = PlacedOutline(self.outline.placed(self.attack, self.settings.place))
        self.placed = placed
        self._near = faces_near(placed, self.grid)
        self._wall = wall_force.wall_points(placed, self.grid)
        self.gas.set_solids(placed)
        self._fix_near()

    def _fix_near(self) -> None:
        """Viscosity, implicit within a step, takes the faces that stick as given too."""
        index, drag = self._near.faces, self.gas.solids.drag
        for component, free in enumerate((drag.free_u, drag.free_v)):
            chosen = index[index[:, 0] == component]
            free[chosen[:, 1], chosen[:, 2]] = 0.0

    def _begin(self) -> None:
        chosen = self.settings
        profile = self._profile()[:, 0]
        self.gas.u[:] = profile[:, None]
        x = np.arange(self.grid.nx) + 0.5
        wave = elementwise.sin(2.0 * math.pi * x / self.grid.nx)
        self.gas.v[1:-1] = chosen.nudge * chosen.wind * wave
        self._stick()
        self._hold(self.held)

    # -- a step -------------------------------------------------------------------------------------

    def step(self) -> None:
        """Go on by `step_length`, and measure. ValueError for numbers that are not finite."""
        dt = self.step_length
        self.gas.step(dt)
        self._stick()
        self._measure(dt)
        self.pose[1] += dt

    def _stick(self) -> None:
        near = self._near
        stick(self.gas.u, self.gas.v, near.faces, near.rows, near.room)

    def _hold(self, out: Floats) -> None:
        (x, y), h, faces = self.settings.place, self.grid.cell, self.gas.faces
        numbers = np.array([h, self.viscosity, -x, -y])
        balance.held(self.gas.u, self.gas.v, faces.ax, faces.ay, self.box, numbers, out)

    def _measure(self, dt: float) -> None:
        (x, y), h, state = self.settings.place, self.grid.cell, self.gas.state()
        drags = "viscosity" in self.settings.effects
        nu = self.viscosity if drags else 0.0
        balance.outflow(
            state.pressure, state.u, state.v, self.box, np.array([h, nu, -x, -y]), self._flow
        )  # fmt: skip
        self._hold(self._after)
        book = -self._flow - (self._after - self.held) / dt
        self.held[:] = self._after
        numbers = np.array([h, nu, 0.0, 0.0, x, y])
        wall_force.sum_wall(state.pressure, state.u, state.v, self._wall, numbers, self._sums)
        sums = self._sums
        chord, pace = self.outline.chord, self.settings.pace
        per = 1.0 / (0.5 * pace * pace * chord)
        self.reading[0:2], self.reading[2] = per * sums[0:2], -per / chord * sums[4]
        self.reading[3:5], self.reading[5] = per * sums[2:4], -per / chord * sums[5]
        self.reading[6:8], self.reading[8] = per * book[0:2], -per / chord * book[2]

    # -- what is there ------------------------------------------------------------------------------

    def forces(self) -> Forces:
        """What was measured in the last step."""
        row = self.reading.tolist()
        return Forces(tuple(row[0:3]), tuple(row[3:6]), tuple(row[6:9]))

    def state(self) -> TunnelState:
        """All that later steps depend on."""
        made = self.outline
        numbers = np.array([made.chord, made.area, float(made.mirrored), float(made.turned)])
        return TunnelState(self.gas.state(), made.corners, numbers, self.pose, self.held, self.reading)

    def restore(self, state: TunnelState) -> None:
        """Take over a copy of a state of a tunnel of the same grid."""
        chord, area, mirrored, turned = state.numbers.tolist()
        same = np.array_equal(state.corners, self.outline.corners) and chord == self.outline.chord
        if not same:
            outline = TunnelOutline(state.corners.copy(), chord, area, mirrored > 0.5, turned > 0.5)
            self._check_fit(outline)
            self.outline = outline
            self.gas.settings = self._gas_settings()
        turned_back = not same or state.pose[0] != self.pose[0]
        self.pose[:], self.held[:], self.reading[:] = state.pose, state.held, state.reading
        if turned_back:
            self._place()
        self.gas.restore(state.gas)
