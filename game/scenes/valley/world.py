"""The world of the valley: its bed, water, dam, rocket and timber; fronts by theory and by another model."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.grid.layout import Grid
from game.physics.kernels import elementary, elementwise, linear
from game.physics.liquid import LiquidState
from game.physics.solids import Chain, Disc, Material, SolidState
from game.physics.solids.arrays.state import SEGMENT
from game.physics.surfaces import SolidSurface
from game.physics.waves import DamBreak, ShallowSettings, ShallowState, ShallowWater, dam_break
from game.physics.waves.experiments import filmed_front
from game.scenes.valley.dam import Dam, thickness
from game.scenes.valley.parameters import ValleyContent, ValleyParameters
from game.scenes.valley.rocket import Rocket
from game.worlds.hands.hand import NOBODY
from game.worlds.hearing import Heard, impacts
from game.worlds.members.dust import Dust, Dusty, advance_dust
from game.worlds.members.solids import Solids, resist_rolling
from game.worlds.members.water import Mouths, Roar, Water
from game.worlds.world import Kept, Whole, World

BED = np.array([
    (-60.0, 60.0), (-48.0, 17.0), (-41.0, 9.0), (-33.0, 3.0), (-26.0, 0.0), (44.0, 0.0), (50.0, -2.2),
    (60.0, -4.0), (96.0, -4.8), (112.0, 6.0), (130.0, 20.0),
])  # fmt: skip
LEFT, RIGHT, LOW, TOP = -48.0, 80.0, -6.0, 18.0  # m, of the grid
RUNS_OUT = 79.0  # m, beyond which water leaves the picture for good
FLAT_FROM, FLAT_TO = -26.0, 44.0  # m, as far as theory's bed is even
THIN = 0.5  # cells: shallower water is no front, in either model
NEAR = 0.25  # m from something, at which the rocket is thought to strike it
BEHIND = 0.1  # m behind the dam, where it explodes
LOG, TIMBER, YARD = 0.7, Material(600.0, 0.5, 0.1), 24.0  # m radius of logs; of pine; m, where they lie
APART = 2.6  # m from one log to the next
FASTEST = 30.0  # m/s of water: half as fast again as the fastest front, 2 sqrt(g h)
ROLLS = 0.05  # rolling resistance of logs, as of wheels on soft ground
STONES, EARTH, BURST, SPLASH = range(4)  # sounds
LEAST_HEARD, USUAL, SPLASHING = 0.6, 1500.0, 2.0e4  # m/s; kg that sounds as it is; J/m of a usual splash
BURST_SOUND, SOUND_SPEED = 8.0, 343.0  # m/s as an impact; m/s
MOVED = 1.0  # m: a piece that is farther from its place than that is torn out
LOW_WATER, GAP = 2.5, 5.0  # m over the bed, in which water counts for the front; m of dry bed that end it
MIDDLE = 15.0  # m, of what is heard
MOST_PARTICLES = 60_000
DUSTY = Dusty(each=1500.0, most=10, quick=5.0, size=0.5, life=2.6)
TORN_DUST = Dusty(each=1.0, most=5, quick=7.0, size=0.8, life=4.0)  # of a piece that the blast tears off
DT = 1.0 / 60.0  # s, of a step


class ValleyState(NamedTuple):
    """pieces, homes, struck: see `Dam`; smoke, fire, dust (n, DUST_WIDTH); loud (3,), see `Roar`; flow, taps,
    drains: see `Mouths`; wet (n,): how high the bed's columns have been wet, m.
    """

    liquid: LiquidState
    loud: Floats
    taps: Floats
    drains: Floats
    flow: Floats
    solids: SolidState
    pieces: Longs
    homes: Floats
    struck: Floats
    smoke: Floats
    fire: Floats
    dust: Floats
    shallow: ShallowState
    heard: Floats
    wet: Floats


class ValleyWorld(World):
    """x from the dam's upper face and y from its foot, m. ``logs`` (n,) bodies; ``broke``: s, when it broke.

    shallow: the same water as a row of depths, whose dam is gone at once; columns: m, middles of cells.
    """

    state_type = ValleyState
    content: ValleyContent
    parameters: ValleyParameters

    def __init__(self, content: ValleyContent, parameters: ValleyParameters, active: EffectSet, seed: int):
        cell = (RIGHT - LEFT) / int(parameters.cells)
        grid = Grid(int(parameters.cells), round((TOP - LOW) / cell), cell, (LEFT, LOW))
        self.solids = Solids(parameters, active)
        self.anchor = self.solids.anchor()
        self.ground = self.solids.world.add_body(Chain(BED, material=Material(1.0, 0.7)), kind="fixed")
        self.dam = Dam(self.solids, content.block, seed)
        self.rocket = Rocket(self.solids, parameters, seed)
        self.logs = self._lay(content.logs)
        self.water = Water(grid, parameters, active, self.solids, most=MOST_PARTICLES)
        self.liquid, self.roar = self.water.liquid, Roar(self.water)
        self.water.limit = FASTEST
        self.mouths, self.heard, self.dust, self.seed = Mouths(self.water), Heard(60), Dust(), seed
        self.pours: Point | None = None
        self.water.meet(without=(self.anchor,), ground=self.ground)
        self.depth = float(parameters.level)
        places = self.liquid.lattice((LEFT, 0.0), (0.0, self.depth))  # a thin bed would let some lie below it
        self.liquid.add(places[places[:, 1] > bed_at(places[:, 0])])
        self.water.begin()
        self.columns: Floats = np.asarray(LEFT + (np.arange(grid.nx) + 0.5) * cell, dtype=np.float64)
        self.bed = bed_at(self.columns)
        self.wet = np.where(self.columns < 0.0, self.depth, self.bed)
        still = np.where(self.columns < 0.0, np.maximum(self.depth - self.bed, 0.0), 0.0)
        self.shallow = ShallowWater(
            still, self.bed, cell, ShallowSettings(gravity=float(parameters.gravity)),
            ("wall", "open", "wall", "wall"),
        )  # fmt: skip
        self.theory: DamBreak = dam_break(self.depth, 0.0, float(parameters.gravity))
        self.broke, self.fired, self.behind = math.nan, 0, self.area_behind()
        super().__init__(
            content, parameters, active, self.water, self.roar, self.mouths, self.solids, self.dam,
            Kept(self.rocket.smoke, "rows"), Kept(self.rocket.fire, "rows"), Kept(self.dust, "rows"),
            Whole(self.shallow), self.heard, Kept(self, "wet"),
        )  # fmt: skip

    def _lay(self, count: int) -> Longs:
        """Logs on the ground below the dam."""
        disc = Disc(LOG, material=TIMBER)
        return np.array(
            [self.solids.world.add_body(disc, (YARD + APART * k, LOG)) for k in range(count)], dtype=np.int64
        )

    def loose(self) -> Longs:
        """Bodies that a hand may take."""
        return np.concatenate([self.dam.free(), self.logs])

    def launch(self) -> str:
        """Fire the rocket; why not, or ""."""
        said = self.rocket.launch()
        self.fired += not said
        return said

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        if self.pours is not None:
            self.liquid.refresh()
            width = max(0.8, 2.0 * self.liquid.grid.cell)
            self.mouths.run(self.pours, (0.0, -self.parameters.poured / width), width, dt)
        self.rocket.lead(dt)
        self.water.step(dt)
        self.liquid.keep_only(self.liquid.places[:, 0] < RUNS_OUT)
        self.roar.step(dt)
        for log in self.logs.tolist():
            resist_rolling(self.solids.world, log, LOG, ROLLS, dt)
        self.solids.step(dt)
        if self.dam.broken:
            self.shallow.advance(dt)
        gone = self.solids.world.bodies.positions[self.dam.bodies, 0] > BED[-1, 0]
        for body in self.dam.bodies[gone].tolist():  # over the hills: no ground would stop it
            self.solids.world.set_kind(body, "fixed")
        self._listen(dt)
        met = self._met() if self.rocket.body != NOBODY else ""
        if met:
            self._explode(met)
        self.rocket.step(dt)
        self.dust.rows = advance_dust(self.dust.rows, dt)
        filled = self.depths() > 2.0 * self.liquid.grid.cell
        self.wet = np.maximum(self.wet, np.where(filled, self.bed + 0.3, self.wet))
        self.time += dt
        return ""

    def _met(self) -> str:
        """What the rocket's nose is at: "dam", "ground" for anything else, or ""."""
        nose, grid = self.rocket.nose(), self.liquid.grid
        solid = SolidSurface(self.solids.world, without=(self.anchor, self.rocket.body)).sample([nose])
        if float(solid.distance[0]) < NEAR:
            return "dam" if int(solid.body[0]) in self.dam.bodies else "ground"
        inside = grid.lower[0] < nose[0] < grid.upper[0] and grid.lower[1] < nose[1] < grid.upper[1]
        column, row = self.water.cells_of(np.array([nose]))[0].tolist()
        wet = inside and self.liquid.cells.rank[row, column] > 0
        return "ground" if wet or self.rocket.is_spent() else ""

    def _explode(self, what: str) -> None:
        chosen, nose = self.parameters, self.rocket.nose()
        at = self.rocket.driven_through(thickness(nose[1]) + BEHIND) if what == "dam" else nose
        self.rocket.burst()
        late = elementary.dist(nose, (MIDDLE, 0.0)) / SOUND_SPEED
        self.heard.add(self.time + late, BURST, BURST_SOUND, nose[0])
        if what == "dam" or self.dam.broken:
            first = not self.dam.broken
            self.dam.explode(at, float(chosen.charge), chosen.dam == "vanishes", self.depth_behind())
            self.water.stale = True
            self._crumble()
            self.broke = self.time if first else self.broke

    def _crumble(self) -> None:
        """What the blast tears off is dusty."""
        rows, free = self.solids.world.bodies, self.dam.free()
        speeds = elementwise.hypot(*rows.velocities[free].T)
        blows = np.column_stack([rows.positions[free], np.full(len(free), float(TORN_DUST.most)), speeds])
        self.dust.rise(blows, np.zeros(len(free), np.bool_), TORN_DUST, self._chance())

    def _chance(self) -> np.random.Generator:
        return np.random.default_rng((self.seed, 7, round(1e4 * self.time)))

    def _listen(self, dt: float) -> None:
        found = impacts(self.solids.world, 0.0)
        loud = found.take(found.rows[:, 3] > LEAST_HEARD)
        kinds = np.where((loud.shapes == SEGMENT).any(axis=1), EARTH, STONES)
        self.heard.remember(loud.heard(self.time, kinds, loud.by_impulse(USUAL, 3.0)), self.time)
        column, row = self.water.cells_of(loud.rows[:, :2]).T
        dry = self.liquid.cells.rank[row, column] <= 0
        self.dust.rise(loud.rows[dry], kinds[dry] == EARTH, DUSTY, self._chance())
        splash = self.roar.splash(SPLASHING)
        if splash > 0.0:
            self.heard.add(self.time, SPLASH, splash, self.water.blow.x)

    # -- what there is ------------------------------------------------------------------------------------

    def depths(self, below: float = math.inf) -> Floats:
        """(n,) m² of water in each column over its width: what all of it would be deep.

        below: m over the bed; what flies higher is left out.
        """
        grid, places = self.liquid.grid, self.liquid.places
        column = np.clip(((places[:, 0] - LEFT) / grid.cell).astype(np.int64), 0, grid.nx - 1)
        counts = np.bincount(column[places[:, 1] - self.bed[column] < below], minlength=grid.nx)
        return np.asarray(counts * (self.liquid.area / grid.cell))

    def front(self) -> float:
        """m from the dam's upper face, as far as the bed is wet with no gap of `GAP`; NaN before it broke."""
        return self._front_of(self.depths(LOW_WATER))

    def shallow_front(self) -> float:
        """The same of shallow water."""
        return self._front_of(self.shallow.depth[0])

    def _front_of(self, depths: Floats) -> float:
        if not self.dam.broken:
            return math.nan
        wet = self.columns[(depths > THIN * self.liquid.grid.cell) & (self.columns > -GAP)]
        gaps = np.flatnonzero(np.diff(wet) > GAP)
        last = float(wet[gaps[0]] if len(gaps) else wet[-1]) if len(wet) else 0.0
        return max(last + 0.5 * self.liquid.grid.cell, 0.0)

    @property
    def since(self) -> float:
        """s since the dam broke; NaN before."""
        return self.time - self.broke

    def ritter_front(self) -> float:
        """m; NaN before the dam broke, and beyond the even bed."""
        front = self.theory.bore * self.since
        return front if front <= FLAT_TO else math.nan

    def filmed_front(self) -> float:
        """m, of a column half as wide as this water is deep (Martin and Moyce); NaN where none was filmed.

        Such a short one falls behind: its back wall takes the push from it before water has come far.
        """
        return filmed_front(self.depth, self.since, self.theory.gravity) if self.dam.broken else math.nan

    def depth_behind(self) -> float:
        """m of water, in the mean of a few columns before the dam."""
        return float(self.depths()[self.columns < -8.0][-8:].mean())

    def push(self) -> float:
        """N for each metre of width, of the water on the whole wall: its pressure in the cells before it."""
        liquid = self.liquid
        pressure = liquid.pressure(DT / max(self.water.parts, 1))
        before = int(-LEFT / liquid.grid.cell + 1e-9) - 1
        return float(pressure[:, before].sum()) * liquid.grid.cell

    def flow(self) -> float:
        """m²/s that run past the dam's place: what is within a metre of it, times its speed."""
        near = np.abs(self.liquid.places[:, 0]) < 1.0
        return 0.5 * self.liquid.area * float(self.liquid.speeds[near, 0].sum())

    def ritter_flow(self) -> float:
        """The same by Ritter, 8/27 h sqrt(g h); NaN before, and after a wave is back from the lake's end."""
        speed = 0.5 * self.theory.bore
        return 8.0 / 27.0 * self.depth * speed if self.since < -2.0 * FLAT_FROM / speed else math.nan

    def area_behind(self) -> float:
        """m² of water on the dam's upper side."""
        return float(np.count_nonzero(self.liquid.places[:, 0] < 0.0)) * self.liquid.area


def bed_at(x: Floats) -> Floats:
    """Heights (n,) m of the valley's bed."""
    return np.asarray(linear.interpolated(x, BED[:, 0], BED[:, 1]))
