"""Logs and sticks: rigid pieces welded together, each with its own heat; they burn, shrink, break and fall.

A piece is so long and so thick, and a metre deep, as all is in the plane. It warms as a skin does; its fuel
is that of very light wood. What it has burnt it is thinner by; below a third of its fuel its welds give way.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.heat import BurningBodies, Fuel, NodesState
from game.physics.heat.nodes import FUEL
from game.physics.kernels import elementary, linear
from game.physics.solids import Capsule, Disc, Material, SolidSettings, SolidState, SolidWorld, box
from game.scenes.fireplace import tables
from game.scenes.fireplace.level import MOST_PIECES, FireplaceContent, WoodEntry
from game.scenes.fireplace.tables import BARS, UPRIGHTS
from game.stage import Part
from game.worlds.members.boxes import box_rows

DENSITY = 3.0  # kg/m³ of fuel: real wood has some 500, and takes an hour or two
HEAT = 1.6e7  # J/kg
SKIN = 130.0  # J/(m² K): what of a log is quickly warmed with its fuel; a stick has less
THIN = 0.04  # m: what is thinner warms as a whole
GRAIN = 40.0  # W/K along the wood, from piece to piece
OPEN, OPEN_STICK = 0.35, 0.8  # share of a piece's surface that sees the room, and meets the gas
WEAK, SPENT = 0.34, 0.24  # share of its fuel below which its welds break; no air comes to it through its ash
NEAR = 0.2  # m: so near to each other pieces warm each other by their glow
MOST_SEEN = 0.75  # of what a piece sees, other pieces and flames
FLAME = 1200.0  # K, as flames shine
STILL, STIRRED, CALM = (
    2.5,
    18.0,
    0.25,
)  # W/(m² K) in calm gas, more with the root of its speed beyond so many m/s
DEEP = 0.4  # m: the hearth is so thick, so that nothing is pushed through it
SHRINK = 0.05  # of its thickness, at a time


class WoodState(NamedTuple):
    """world; nodes; table (n, PIECE_WIDTH), see `tables`."""

    world: SolidState
    nodes: NodesState
    table: Floats


def fuel_of_wood(haste: float, effects) -> Fuel:
    """How logs burn, so many times as quickly as usual."""
    return Fuel(
        ignition=560.0, rate=0.06 * haste, heat=HEAT, kept=0.55, vapour=0.62, fuel_heat=1500.0, exchange=18.0,
        emissivity=0.9, ambient=tables.ROOM, effects=effects,
    )  # fmt: skip


class Wood(Part):
    """All pieces. table (n, PIECE_WIDTH); nodes: their heat, one each."""

    def __init__(self, content: FireplaceContent, haste: float, moisture: float, heat_effects, effects):
        self.world = SolidWorld(SolidSettings(effects=effects, substeps=6))
        self.moisture = moisture
        self.table: Floats = np.zeros((0, tables.PIECE_WIDTH))
        self.made_of = fuel_of_wood(haste, heat_effects)
        self.nodes = BurningBodies(1, made_of=self.made_of)
        self.woods = 0
        stone = Material(density=2000.0, friction=0.7)
        self.world.add_body(box(4.0, DEEP, 0.0, stone), (0.0, -0.5 * DEEP), kind="fixed")
        for x in BARS:
            self.world.add_body(Disc(tables.BAR, material=stone), (x, tables.GRATE), kind="fixed")
        for x in UPRIGHTS:
            self.world.add_body(Capsule((x, 0.0), (x, 0.27), tables.BAR, material=stone), kind="fixed")
        for entry in content.wood:
            self.add(entry)

    @property
    def count(self) -> int:
        """Pieces."""
        return len(self.table)

    # -- making -----------------------------------------------------------------------------------------

    def add(self, entry: WoodEntry) -> bool:
        """One more log or stick; False if there is no space for it."""
        if self.count + entry.pieces > MOST_PIECES:
            return False
        turn, half = math.radians(entry.turn), 0.5 * entry.length / entry.pieces
        rows, before = [], tables.NONE
        for k in range(entry.pieces):
            along = (2 * k + 1 - entry.pieces) * half
            at = (entry.at[0] + along * elementary.cos(turn), entry.at[1] + along * elementary.sin(turn))
            body = self._body(at, turn, half, 0.5 * entry.thick, (k == 0, k == entry.pieces - 1))
            joint = tables.NONE
            if before != tables.NONE:
                weld = (at[0] - half * elementary.cos(turn), at[1] - half * elementary.sin(turn))
                joint = float(self.world.add_joint("weld", int(before), body, weld))
            whole = DENSITY * 2.0 * half * entry.thick
            rows.append((body, self.woods, k, half, 0.5 * entry.thick, 1.0, whole, joint))
            before = float(body)
        self.table = np.concatenate([self.table, np.array(rows)])
        self.woods += 1
        self._grow(entry, np.array(rows))
        return True

    def _body(
        self, at: tuple[float, float], turn: float, half: float, thick: float, ends: tuple[bool, bool]
    ) -> int:
        """A piece: a box whose corners are rounded a little."""
        bark = Material(density=400.0, friction=0.75)
        rounding = 0.25 * min(thick, half)
        shape = box(2.0 * half, 2.0 * thick, rounding, bark)
        return self.world.add_body(shape, at, turn)

    def _grow(self, entry: WoodEntry, rows: Floats) -> None:
        """Space for the new pieces in the heat's arrays; those that are there keep what they have."""
        old, first = self.nodes, self.count - len(rows)
        links = [(i - 1, i) for i in range(self.count) if self.table[i, tables.JOINT] != tables.NONE]
        surface = 2.0 * (2.0 * rows[:, tables.HALF_LENGTH] + 2.0 * rows[:, tables.HALF_THICK])
        skin = SKIN * surface * np.minimum(1.0, 2.0 * rows[:, tables.HALF_THICK] / THIN)
        moist = entry.moisture + (self.moisture if entry.thick >= THIN else 0.0)
        fresh = BurningBodies(
            self.count,
            links,
            GRAIN * 2.0 * self.table[[b for _, b in links], tables.HALF_THICK] if links else 1.0,
            temperature=entry.kelvin,
            rest=np.concatenate([np.ones(first), skin]),
            fuel=np.concatenate([np.zeros(first), rows[:, tables.WHOLE]]),
            water=np.concatenate([np.zeros(first), moist * rows[:, tables.WHOLE]]),
            area=np.concatenate([np.ones(first), surface * (OPEN if entry.thick >= THIN else OPEN_STICK)]),
            made_of=self.made_of,
        )
        if first:
            fresh.nodes[:, :first] = old.nodes[:, :first]
            fresh.torn[: len(old.torn)] = old.torn
            fresh.totals[:] = old.totals
        self.nodes = fresh

    def change_haste(self, haste: float) -> None:
        """Burn so many times as quickly as usual."""
        self.made_of = fuel_of_wood(haste, self.made_of.effects)
        self.nodes.made_of = self.made_of

    def change_effects(self, heat_effects, effects) -> None:
        """Compute these from now on."""
        self.made_of = Fuel(**{
            name: getattr(self.made_of, name) for name in Fuel.__dataclass_fields__ if name != "effects"
        }, effects=heat_effects)  # fmt: skip
        self.nodes.made_of = self.made_of
        self.world.set(effects=effects)

    # -- where and how ------------------------------------------------------------------------------------

    def places(self) -> Floats:
        """(n, 2) m, middles of the pieces."""
        return self.world.bodies.positions[self.table[:, tables.BODY].astype(np.int64)]

    def share_left(self) -> Floats:
        """(n,) of its fuel that a piece still has."""
        return np.asarray(self.nodes.nodes[FUEL, : self.count] / self.table[:, tables.WHOLE])

    def is_log(self) -> NDArray[np.bool_]:
        """(n,) whether a piece is of a log, not of a stick."""
        return np.asarray(self.table[:, tables.HALF_THICK] >= 0.5 * THIN)

    def boxes(self, least: float) -> Floats:
        """(k, BOX_WIDTH) pieces of logs at least so thick (m), as solids of a gas. Sticks are none: in space
        the gas goes past them, before and behind.
        """
        half = self.table[:, tables.HALF_THICK] * self.table[:, tables.SCALE]
        kept = self.is_log() & (2.0 * half >= least)
        rows, bodies = self.world.bodies, self.table[kept, tables.BODY].astype(np.int64)
        halves = np.column_stack([self.table[kept, tables.HALF_LENGTH], half[kept]])
        return box_rows(rows.positions[bodies], rows.rotations[bodies], halves)

    # -- a step -------------------------------------------------------------------------------------------

    def meet(self, gas: Floats, oxygen: Floats, speed: Floats, flames: Floats) -> None:
        """What gas (K, share of fresh air, m/s) is at each piece; flames (n,): share of what it sees that
        they are.
        """
        self.nodes.meet_gas(gas, oxygen, STILL + STIRRED * np.sqrt(np.clip(speed - CALM, 0.0, 9.0)))
        places, hot = self.places(), self.nodes.temperature
        apart = places[:, None] - places[None]
        away = np.sqrt(apart[..., 0] * apart[..., 0] + apart[..., 1] * apart[..., 1])
        half = self.table[:, tables.HALF_THICK] * self.table[:, tables.SCALE]
        seen = np.where(
            (away > 0.0) & (away < NEAR), half[None] / (math.pi * np.maximum(away, half[None])), 0.0
        )
        most = np.maximum(MOST_SEEN - flames, 0.0)
        seen *= np.minimum(1.0, most / np.maximum(np.sum(seen, axis=1), 1e-9))[:, None]
        of_wood = np.sum(seen, axis=1)
        fourth = hot * hot * hot * hot
        around = (
            linear.product(seen, fourth)
            + flames * elementary.square(FLAME * FLAME)
            + (1.0 - of_wood - flames) * elementary.square(tables.ROOM * tables.ROOM)
        )
        self.nodes.meet_light(np.sqrt(np.sqrt(around)))

    def advance(self, dt: float) -> None:
        """Burn for dt (s), shrink, break, fall."""
        self.nodes.step(dt)
        left = self.share_left()
        wanted = np.sqrt(0.16 + 0.84 * np.clip(left, 0.0, 1.0))
        for i in np.flatnonzero(self.table[:, tables.SCALE] - wanted > SHRINK).tolist():
            self._shrink(i, float(wanted[i]))
        self._break(left)
        self.world.step(dt)

    def _break(self, left: Floats) -> None:
        """Welds of what is nearly burnt give way."""
        number = -1
        for i in np.flatnonzero(self.table[:, tables.JOINT] != tables.NONE).tolist():
            number += 1
            torn = min(left[i - 1], left[i]) < WEAK
            if torn and not self.nodes.torn[self._link_of(i)]:
                self.nodes.tear(self._link_of(i))
                self.world.remove_joint(int(self.table[i, tables.JOINT]))

    def _link_of(self, piece: int) -> int:
        """The thread of heat that ends at a piece."""
        return int(np.count_nonzero(self.table[: piece + 1, tables.JOINT] != tables.NONE)) - 1

    def _shrink(self, piece: int, scale: float) -> None:
        """A thinner body in the place of a piece's; what it is welded to it stays welded to."""
        row, world = self.table[piece], self.world
        old = int(row[tables.BODY])
        at, turn = world.bodies.positions[old].copy(), float(world.bodies.angles[old])
        velocity, spin = world.bodies.velocities[old].copy(), float(world.bodies.spins[old])
        held = [
            i
            for i in (piece, piece + 1)
            if i < self.count
            and self.table[i, tables.OF] == row[tables.OF]
            and self.table[i, tables.JOINT] != tables.NONE
            and not self.nodes.torn[self._link_of(i)]
        ]
        for i in held:
            world.remove_joint(int(self.table[i, tables.JOINT]))
        world.remove_body(old)
        row[tables.SCALE] = scale
        length = row[tables.HALF_LENGTH] * (1.0 if held else scale)
        body = self._body(
            (float(at[0]), float(at[1])), turn, length, row[tables.HALF_THICK] * scale, (False, False)
        )
        row[tables.BODY] = body
        world.set_velocity(body, velocity, spin)
        for i in held:
            a, b = int(self.table[i - 1, tables.BODY]), int(self.table[i, tables.BODY])
            weld = 0.5 * (world.bodies.positions[a] + world.bodies.positions[b])
            self.table[i, tables.JOINT] = world.add_joint("weld", a, b, weld)

    # -- memory -------------------------------------------------------------------------------------------

    def state(self) -> WoodState:
        """All that later steps depend on."""
        return WoodState(self.world.state(), self.nodes.state(), self.table)

    def restore(self, state: WoodState) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        if len(state.table) != self.count:
            self.table = state.table.copy()
            self._fit()
        self.table[:] = state.table
        self.nodes.restore(state.nodes)

    def _fit(self) -> None:
        """The heat's arrays as long as the table."""
        links = [(i - 1, i) for i in range(self.count) if self.table[i, tables.JOINT] != tables.NONE]
        thick = self.table[[b for _, b in links], tables.HALF_THICK] if links else 1.0
        self.nodes = BurningBodies(max(self.count, 1), links, GRAIN * 2.0 * thick, made_of=self.made_of)
