"""A cloth that hangs from two hooks, is blown about, takes heat, burns through, tears and falls."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.physics.cloth import layout
from game.physics.cloth.charring import (
    STEAM_KG,
    TOTALS,
    Flame,
    GasAt,
    conduct,
    heat_in,
    meet_and_burn,
    pour_on,
)
from game.physics.cloth.effects import ATTACHMENTS, CLOTH, TEARING, WIND
from game.physics.cloth.fabric import Fabric
from game.physics.cloth.hanging import Hanging
from game.physics.cloth.holding import burn_through, find_reach, name_pieces, take_ash, tear_out, tie, weigh
from game.physics.cloth.layout import make_ties
from game.physics.cloth.sheet import Breeze, Motion, blow_on, move_sheet
from game.physics.heat.effects import CONDUCTION
from game.physics.heat.nodes import WATER_HEAT
from game.physics.kernels import elementwise

LEAST_MESHES, MOST_MESHES = 4, 400
STABLE = 0.45  # of the share of a patch's heat that may flow in a substep, over 1/4 being the limit
LEAST_LEFT = 0.14  # of its mass: a mesh with less holds nothing
NOBODY = -1
WAVES = 4  # in which a cloth that is wider than its hooks are apart lies at first
FASTEST, LEAST_KNOWN = 0.2, 4  # m/s: faster is no front, but what was heated all at once; patches to count
NO_FLAME = Flame(0.0, 0.0, 1.0, 293.15, 0.0, 0.0)


class ClothState(NamedTuple):
    """nodes, patches: see `layout`; whole (ny, nx); totals (TOTALS,), ash (4,): see `charring`, `holding`;
    others (9,): s, which hooks hold (2,), row and column of the node in the hand, where that goes (3,), how
    many threads have parted by being stretched.
    """

    nodes: Floats
    patches: Floats
    whole: Floats
    totals: Floats
    ash: Floats
    others: Floats


class Cloth:
    """meshes: across; as many down as the height asks. ValueError, naming the argument, for nonsense.

    In `step` it meets the gas before it: cells (gy, gx, 4) K and kg/m³ of vapour, oxygen, soot, which
    are changed, and how fast that is.
    """

    def __init__(self, meshes: int = 80, made_of: Fabric | None = None, hanging: Hanging | None = None):
        if (
            isinstance(meshes, bool)
            or not isinstance(meshes, int)
            or not LEAST_MESHES <= meshes <= MOST_MESHES
        ):
            raise ValueError(f"meshes = {meshes!r}: expected a whole number, {LEAST_MESHES} to {MOST_MESHES}")
        self.made_of, self.hanging = made_of or Fabric(), hanging or Hanging()
        self.spacing = self.hanging.width / meshes
        down = max(1, round(self.hanging.height / self.spacing))
        self.nodes: Floats = np.zeros((layout.NODE_ROWS, down + 1, meshes + 1))
        self.patches: Floats = np.zeros((layout.PATCH_ROWS, layout.PER * down, layout.PER * meshes))
        self.ties = make_ties(down, meshes)
        self.totals: Floats = np.zeros(TOTALS)
        self.ash: Floats = np.zeros(4)
        self.others: Floats = np.zeros(9)
        self.others[1:3], self.others[3:5] = 1.0, NOBODY
        self.names: Longs = np.zeros((down, meshes), dtype=np.int64)
        self._stack: Longs = np.zeros((down * meshes, 2), dtype=np.int64)
        self._hook: Floats = np.ones(2)
        self.pieces = 1
        self.size = self.spacing / layout.PER
        self.poured = 0.0
        self._lay()
        self._renew()

    def _lay(self) -> None:
        """Flat between the hooks, in slight waves as the span is less than the width; cold, nothing
        written.
        """
        rows, columns = self.nodes.shape[1:]
        share = np.arange(columns) / (columns - 1)
        x = self.hanging.span * (share - 0.5)
        down = self.spacing * np.arange(rows)
        slack = max(self.hanging.width / max(self.hanging.span, 1e-9) - 1.0, 0.0)
        turns = 2.0 * math.pi * WAVES * share
        deep = (
            2.0 * math.sqrt(slack) * self.hanging.span / (2.0 * math.pi * WAVES)
        )  # so that its way is as long
        self.nodes[layout.X], self.nodes[layout.Y] = x[None, :], self.hanging.top - down[:, None]
        self.nodes[layout.Z] = deep * elementwise.sin(turns)[None, :] * np.ones((rows, 1))
        self.nodes[layout.Z, 0, 0] = self.nodes[layout.Z, 0, -1] = 0.0
        self.patches[layout.HOT], self.patches[layout.FUEL] = self.made_of.ambient, self.made_of.dry
        self.patches[layout.BEGAN] = layout.NOT_YET

    # -- what holds ---------------------------------------------------------------------------------

    @property
    def whole(self) -> Floats:
        """(ny, nx) 1 where a mesh still holds."""
        return self.ties.whole

    @property
    def time(self) -> float:
        """s since it was hung up."""
        return float(self.others[0])

    @property
    def hooked(self) -> Floats:
        """(2,) 1 where an upper corner hangs on its hook."""
        return self.others[1:3]

    def _renew(self) -> None:
        """Threads, pieces and ways to the hooks, as meshes were lost."""
        tie(self.nodes, self.ties, self.hooked)
        if ATTACHMENTS in self.hanging.effects:
            find_reach(self.nodes, self.ties, self.hooked, self.spacing)
        self.pieces = int(name_pieces(self.whole, self.names, self._stack))
        self._weigh()

    def _weigh(self) -> None:
        weigh(self.nodes, self.patches, self.whole, self.spacing * self.spacing, self.made_of.dry)
        for k in range(2):
            if self.hooked[k] > 0.0:
                self.nodes[layout.INVERSE, 0, (self.nodes.shape[2] - 1) * k] = 0.0
        if self.held is not None:
            self.nodes[layout.INVERSE, self.held[0], self.held[1]] = 0.0

    def hanging_pieces(self) -> set[int]:
        """Names of the pieces that hang on a hook."""
        found = set()
        for k in range(2):
            if self.hooked[k] > 0.0:
                found.add(int(self.names[0, (self.whole.shape[1] - 1) * k]))
        return found - {NOBODY}

    def loose(self) -> NDArray[np.bool_]:
        """(rows, columns) of meshes: which still hold together, but on no hook."""
        return (self.whole > 0.0) & ~np.isin(self.names, sorted(self.hanging_pieces()))

    def fallen(self) -> int:
        """Meshes that still hold together, but on no hook."""
        return int(np.count_nonzero(self.loose()))

    def holes(self) -> float:
        """m² of the cloth that is not there any more."""
        return float(np.count_nonzero(self.whole <= 0.0)) * self.spacing * self.spacing

    # -- what a hand does ---------------------------------------------------------------------------

    def write(self, share: ArrayLike) -> None:
        """Saltpetre over the whole cloth (rows, columns of patches), 0 to 1. ValueError."""
        given = np.asarray(share, dtype=np.float64)
        if given.shape != self.patches.shape[1:] or not np.all((given >= 0.0) & (given <= 1.0)):
            raise ValueError(f"share: expected {self.patches.shape[1:]} numbers from 0 to 1")
        self.patches[layout.SALT] = given

    def _nearest(self, point: tuple[float, float], reach: float) -> tuple[int, int] | None:
        """Row and column of the node nearest to a place (m) of the picture; None: none is within reach."""
        right, up = self.nodes[layout.X] - point[0], self.nodes[layout.Y] - point[1]
        away = np.where(self.nodes[layout.THERE] > 0.0, right * right + up * up, np.inf)
        row, column = divmod(int(np.argmin(away)), away.shape[1])
        return (row, column) if away[row, column] <= reach * reach else None

    def point_on(self, point: tuple[float, float], reach: float = 0.1) -> tuple[float, float] | None:
        """Where on the cloth, m from its upper left corner, a place (m) of the picture is; None: beside."""
        nearest = self._nearest(point, reach)
        if nearest is None:
            return None
        row, column = nearest
        right = self.spacing * column + point[0] - float(self.nodes[layout.X, row, column])
        down = self.spacing * row + float(self.nodes[layout.Y, row, column]) - point[1]
        return right, down

    def dab(self, on: tuple[float, float], radius: float, value: float = 1.0) -> None:
        """Write (1) or wash out (0) with a round brush at a point of the cloth, m from its upper left corner;
        its edge is soft. ValueError.
        """
        if not all(map(math.isfinite, on)) or not 0.0 < radius < math.inf:
            raise ValueError(f"on = {on!r}, radius = {radius!r}: expected a place, and above 0 m")
        rows, columns = self.patches.shape[1:]
        right = (np.arange(columns) + 0.5) * self.size - on[0]
        down = (np.arange(rows) + 0.5) * self.size - on[1]
        away = np.sqrt((right * right)[None, :] + (down * down)[:, None])
        share = np.clip(0.5 + (radius - away) / (2.0 * self.size), 0.0, 1.0)
        salt = self.patches[layout.SALT]
        salt[:] = np.maximum(salt, share) if value > 0.5 else np.minimum(salt, 1.0 - share)

    def pour(self, point: tuple[float, float], radius: float, most: float) -> float:
        """Water, up to ``most`` kg/m² in the middle of a place (m); kg that it took. ValueError."""
        if not all(map(math.isfinite, point)) or not 0.0 < radius < math.inf or not 0.0 <= most <= 1e3:
            raise ValueError(
                f"point, radius, most = {point!r}, {radius!r}, {most!r}: expected a place, m, kg/m²"
            )
        jet = (float(point[0]), float(point[1]), float(radius), float(most), self.size * self.size)
        poured = float(pour_on(self.patches, self.whole, self.nodes, jet, self.made_of.laws()))
        self.poured += poured
        return poured

    @property
    def held(self) -> tuple[int, int] | None:
        """Row and column of the node in the hand."""
        return (int(self.others[3]), int(self.others[4])) if self.others[3] >= 0.0 else None

    def grab(self, point: tuple[float, float], reach: float = 0.15) -> bool:
        """Take hold of the node nearest to a place (m), if there is one within reach that no hook holds."""
        self.release()
        nearest = self._nearest(point, reach)
        if nearest is None or self.nodes[layout.INVERSE][nearest] <= 0.0:
            return False
        row, column = nearest
        self.others[3:5] = nearest
        self.others[5:8] = self.nodes[layout.X : layout.Z + 1, row, column]
        self.nodes[layout.INVERSE, row, column] = 0.0
        return True

    def drag(self, point: tuple[float, float]) -> None:
        """Lead what is held to a place (m) of the picture, as deep as it is."""
        self.others[5:7] = point

    def release(self) -> None:
        """Let go."""
        if self.held is not None:
            self.others[3:5] = NOBODY
            self._weigh()

    # -- a step -------------------------------------------------------------------------------------

    def step(
        self, dt: float, cells: Floats, speeds: Floats, gas: GasAt, wind: tuple[Floats, Floats, Breeze],
        flame: Flame = NO_FLAME,
    ) -> bool:  # fmt: skip
        """Take heat and burn, be blown, move, tear, for dt (s); whether meshes were lost. wind: u, v of the
        gas on faces, and its `Breeze`. ValueError for a bad dt.
        """
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        self.heat(dt, cells, speeds, gas, flame)
        self.move(dt, wind)
        lost = self._lose()
        self.others[0] += dt
        return lost

    def heat(self, dt: float, cells: Floats, speeds: Floats, gas: GasAt, flame: Flame = NO_FLAME) -> None:
        """Only heat and fire, for dt (s)."""
        laws, kinds = self.made_of.laws(), self.made_of.kinds()
        if CONDUCTION in self.made_of.effects:
            share = 4.0 * self.made_of.diffusivity * dt / (self.size * self.size)
            substeps = max(1, math.ceil(share / STABLE))
            for _ in range(substeps):
                conduct(self.patches, self.whole, laws, (dt / substeps, self.size), self.totals)
        clock = (float(dt), self.time, self.size)
        parts = (self.patches, self.whole, self.nodes)
        meet_and_burn(parts, (cells, speeds, gas), (laws, kinds), flame, clock, self.totals)

    def move(self, dt: float, wind: tuple[Floats, Floats, Breeze] | None = None) -> None:
        """Only the motion, for dt (s)."""
        chosen = self.hanging
        self._weigh()
        if wind is not None and WIND in chosen.effects:
            u, v, breeze = wind
            blow_on(self.nodes, u, v, breeze, self.spacing * self.spacing, float(dt))
        h = dt / chosen.substeps
        motion = Motion(
            CLOTH.mask(chosen.effects), chosen.substeps, h, float(chosen.gravity), self.spacing,
            chosen.shear / (h * h), chosen.folds / (h * h), float(chosen.floor), float(chosen.calm),
        )  # fmt: skip
        move_sheet(self.nodes, self.ties, motion, self.others[3:5].astype(np.int64), self.others[5:8])

    def _lose(self) -> bool:
        """Meshes that are burnt through or torn out."""
        dry, lost = self.made_of.dry, 0
        lost += int(burn_through(self.patches, self.whole, dry, LEAST_LEFT))
        if TEARING in self.hanging.effects:
            limits = (float(self.hanging.strength), self.spacing, dry)
            torn = int(tear_out(self.nodes, self.ties, self.patches, limits))
            self.others[8] += torn
            lost += torn
        if lost:
            numbers = (self.made_of.capacity, WATER_HEAT, self.made_of.ambient, self.size * self.size)
            take_ash(self.patches, self.whole, numbers, self.ash)
            self._renew()
            held = self.held
            if held is not None and self.nodes[layout.THERE, held[0], held[1]] <= 0.0:
                self.release()
        return lost > 0

    def settle(self, seconds: float = 1.5, calm: float = 6.0) -> None:
        """Hang still: move without air for so long, with more friction; then it is at rest."""
        chosen = self.hanging
        self.hanging = replace(chosen, calm=calm)
        for _ in range(max(1, round(60.0 * seconds))):
            self.move(1.0 / 60.0)
        self.hanging = chosen
        self.nodes[layout.VX : layout.VZ + 1] = 0.0

    # -- what there is ------------------------------------------------------------------------------

    def warmth(self) -> float:
        """J above the surroundings in what still hangs or lies."""
        return float(heat_in(self.patches, self.made_of.laws(), self.size))

    def mass(self) -> float:
        """kg of fuel and char that is there."""
        return float(np.sum(self.patches[layout.FUEL : layout.FUEL + 2])) * self.size * self.size

    def water(self) -> float:
        """kg of water in it."""
        return float(np.sum(self.patches[layout.FUEL + 2])) * self.size * self.size

    def steam(self) -> float:
        """kg of water that went as steam."""
        return float(self.totals[STEAM_KG])

    def front(self, since: float) -> float:
        """m/s at which the front goes along what is written, the median over patches that it came to in the
        last seconds ``since``: one over the gradient of the times at which it came. nan: it came to too few.
        """
        began, salt = self.patches[layout.BEGAN], self.patches[layout.SALT]
        new = (began > self.time - since) & (salt > 0.9)
        new[[0, -1], :], new[:, [0, -1]] = False, False
        rows, columns = np.nonzero(new)
        left, right = began[rows, columns - 1], began[rows, columns + 1]
        above, below = began[rows - 1, columns], began[rows + 1, columns]
        known = (left >= 0.0) & (right >= 0.0) & (above >= 0.0) & (below >= 0.0)
        if np.count_nonzero(known) < LEAST_KNOWN:
            return math.nan
        across, along = (right - left)[known], (below - above)[known]
        slow = np.sqrt(across * across + along * along) / (2.0 * self.size)
        slow = slow[slow * FASTEST > 1.0]
        return float(1.0 / np.median(slow)) if len(slow) >= LEAST_KNOWN else math.nan

    def state(self) -> ClothState:
        """All that later steps depend on, not copied."""
        return ClothState(self.nodes, self.patches, self.whole, self.totals, self.ash, self.others)

    def restore(self, state: ClothState) -> None:
        """Take over a copy of a state of a cloth of as many meshes."""
        for mine, given in zip(self.state(), state, strict=True):
            mine[:] = given
        self._renew()
