"""The billiard table: rails, rounded jaws and pockets, as arrays.

Frame: x along the width, y along the length, z up; the origin is the lower left corner of the playing
surface. Lengths in metres. A ball meets a cushion when its centre is one radius from the cushion's line (the
nose), on the side of the normal. It meets a jaw as it would meet a disc. A pocket takes it when its centre,
and so its weight, has come over the edge of the hole.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary

BED_WIDTH = 1.27  # m; nine-foot bed, WPA equipment specification 1
BED_LENGTH = 2.54  # m
CUSHION_HEIGHT = 0.0362902  # m; nose above the cloth, 63.5 % of a ball's diameter (WPA 6: 62.5 to 64.5 %)
CUSHION_DEPTH = 0.045  # m; from the nose to the wood
RAIL_WIDTH = 0.119  # m; from the nose to the outer edge of the wood (WPA: 102 to 191 mm)

CORNER_RADIUS = 0.0585  # m; hole, and capture circle
CORNER_SET_OUT = 0.016  # m; the hole's centre lies so far outside both rails
CORNER_MOUTH = 0.117  # m; between the corners of the two noses (WPA 9: 114 to 117 mm)
CORNER_FACING = math.radians(142.0)  # angle between nose and facing (WPA 9: 142 +- 1 degrees)
CORNER_JAW_RADIUS = 0.02  # m; rounding between nose and facing

SIDE_RADIUS = 0.057  # m
SIDE_SET_OUT = 0.036  # m; outside its one rail
SIDE_MOUTH = 0.130  # m (WPA 9: 127 to 130 mm)
SIDE_FACING = math.radians(104.0)  # (WPA 9: 104 +- 1 degrees)
SIDE_JAW_RADIUS = 0.008  # m

CAROM_WIDTH = 1.42  # m, between the noses (UMB, World rules of carom billiard, article 11)
CAROM_LENGTH = 2.84  # m
CAROM_CUSHION_HEIGHT = 0.037  # m; nose above the cloth, 36 to 37 mm (article 11)

SNOOKER_WIDTH = 1.778  # m, between the noses (WPBSA, Rules of snooker, 1.1(a): 1778 mm +- 13 mm)
SNOOKER_LENGTH = 3.569  # m (1.1(a): 3569 mm +- 13 mm)
SNOOKER_CUSHION_HEIGHT = 1.4 * 0.02625  # m; 7 R / 5 (Mathavan, Jackson, Parkin 2010, measured at snooker)

POCKET_NAMES = ("lower left", "lower right", "middle left", "middle right", "upper left", "upper right")


class PocketCut(NamedTuple):
    """How the cushions are cut at a pocket, and its hole. mouth m: between the points in which the lines of
    noses and facings meet. facing rad: angle between nose and facing. jaw_radius m: of the rounding between
    them. radius m: of the hole and the circle of capture; set_out m: its centre lies so far outside the
    rails.
    """

    mouth: float
    facing: float
    jaw_radius: float
    radius: float
    set_out: float


# corner and side pockets
POOL_CUTS = (
    PocketCut(CORNER_MOUTH, CORNER_FACING, CORNER_JAW_RADIUS, CORNER_RADIUS, CORNER_SET_OUT),
    PocketCut(SIDE_MOUTH, SIDE_FACING, SIDE_JAW_RADIUS, SIDE_RADIUS, SIDE_SET_OUT),
)
# Openings of 4 1/4 and 4 3/4 inches, as a "tight" pool table's are from memory; the rest is as above
TIGHT_POOL_CUTS = (POOL_CUTS[0]._replace(mouth=0.10795), POOL_CUTS[1]._replace(mouth=0.12065))
# The WPBSA's templates (1.1(c)) are not published. The openings, 3 3/8 and 3 7/8 inches, are usual ones,
# from memory; the curves, and where the slate falls, are chosen so that a slow straight ball may brush the
# jaws and one that comes fast or aslant may not: tests/billiards/table/test_snooker_pockets.py measures by
# how much.
SNOOKER_CUTS = (
    PocketCut(0.0857, math.radians(137.0), 0.060, 0.0425, 0.025),
    PocketCut(0.0984, math.radians(100.0), 0.040, 0.0500, 0.050),
)
# An eighth of an inch less than those, at corners and sides.
TIGHT_SNOOKER_CUTS = tuple(cut._replace(mouth=cut.mouth - 0.003175) for cut in SNOOKER_CUTS)


class Table(NamedTuple):
    """A table's measures. Row order is part of the contract: events name elements by row.

    cushions (c, 6) m: from x, y, to x, y, unit normal x, y into the table. jaws (j, 3) m: centre x, y and
    radius. pockets (p, 3) m: centre x, y and radius of capture, in the order of POCKET_NAMES for `pool`.
    """

    width: float
    length: float
    cushion_height: float
    cushions: Floats
    jaws: Floats
    pockets: Floats

    @classmethod
    def pool(cls, tight: bool = False) -> Table:
        """Nine-foot pool table with six pockets, the cushions between them ending in rounded jaws.

        tight: the pockets' openings are smaller, their holes are not.
        """
        return _pocketed_table(
            BED_WIDTH, BED_LENGTH, CUSHION_HEIGHT, *(TIGHT_POOL_CUTS if tight else POOL_CUTS)
        )

    @classmethod
    def snooker(cls, tight: bool = False) -> Table:
        """Twelve-foot snooker table: six narrow pockets, the cushions curved into them; `tight` as `pool`."""
        cuts = TIGHT_SNOOKER_CUTS if tight else SNOOKER_CUTS
        return _pocketed_table(SNOOKER_WIDTH, SNOOKER_LENGTH, SNOOKER_CUSHION_HEIGHT, *cuts)

    @classmethod
    def carom(cls) -> Table:
        """Match table for carom billiards: four full rails, in the order left, right, lower, upper."""
        return cls.bare(CAROM_WIDTH, CAROM_LENGTH, CAROM_CUSHION_HEIGHT)

    @classmethod
    def bare(cls, width: float, length: float, cushion_height: float = CUSHION_HEIGHT) -> Table:
        """Four full rails without pockets. ValueError if a measure is not positive and finite."""
        return checked_table(
            width, length, cushion_height, _full_rails(width, length), np.empty((0, 3)), np.empty((0, 3))
        )

    @classmethod
    def open(cls, width: float = BED_WIDTH, length: float = BED_LENGTH) -> Table:
        """Cloth without an edge: no rails, no pockets; width and length say only what to draw."""
        nothing = np.empty((0, 3))
        return checked_table(width, length, 0.0, np.empty((0, 6)), nothing, nothing)


def checked_table(
    width: float, length: float, cushion_height: float, cushions: Floats, jaws: Floats, pockets: Floats
) -> Table:
    """Table from any array-likes, contiguous float64, frozen. ValueError names the field and the reason.

    Lengths m; cushions (c, 6), jaws (j, 3) and pockets (p, 3) as in `Table`.
    """
    for name, value in (("width", width), ("length", length)):
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"table {name}: must be positive and finite, got {value!r}")
    if not (math.isfinite(cushion_height) and cushion_height >= 0.0):
        raise ValueError(f"table cushion_height: must be finite and not negative, got {cushion_height!r}")
    rails = _rows("cushions", cushions, 6)
    for i, row in enumerate(rails):
        _check_cushion(i, row)
    discs = []
    for name, rows in (("jaws", jaws), ("pockets", pockets)):
        array = _rows(name, rows, 3)
        if array.size and float(array[:, 2].min()) <= 0.0:
            raise ValueError(f"table {name}[{int(array[:, 2].argmin())}]: radius must be positive")
        discs.append(array)
    return Table(float(width), float(length), float(cushion_height), rails, discs[0], discs[1])


def _rows(name: str, rows: Floats, columns: int) -> Floats:
    """A frozen (n, columns) float64 copy."""
    array = np.array(rows, dtype=np.float64, order="C")
    if array.size == 0:
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"table {name}: must have {columns} numbers a row, got shape {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"table {name}[{int(np.argwhere(~np.isfinite(array))[0, 0])}]: must be finite")
    array.setflags(write=False)
    return array


def _check_cushion(i: int, row: Floats) -> None:
    """A cushion has a length, and a unit normal at right angles to it."""
    x0, y0, x1, y1, normal_x, normal_y = (float(value) for value in row)
    dx, dy = x1 - x0, y1 - y0
    extent = math.sqrt(dx * dx + dy * dy)
    if extent == 0.0:
        raise ValueError(f"table cushions[{i}]: from and to are the same point")
    if abs(normal_x * normal_x + normal_y * normal_y - 1.0) > 1e-9:
        raise ValueError(f"table cushions[{i}]: normal must have length 1")
    if abs(dx * normal_x + dy * normal_y) > 1e-9 * extent:
        raise ValueError(f"table cushions[{i}]: normal must be at right angles to the cushion")


def _full_rails(width: float, length: float) -> Floats:
    """Left, right, lower and upper rail over the whole bed."""
    return np.array(
        [
            [0.0, 0.0, 0.0, length, 1.0, 0.0],
            [width, length, width, 0.0, -1.0, 0.0],
            [0.0, 0.0, width, 0.0, 0.0, 1.0],
            [0.0, length, width, length, 0.0, -1.0],
        ]
    )


def _cushion_end(
    tip: tuple[float, float], along: tuple[float, float], inward: tuple[float, float], cut: PocketCut
) -> tuple[tuple[float, float], list[float], list[float]]:
    """End of a nose at `tip`, where `along` is the unit vector from the nose towards the pocket.

    Nose and facing meet in `tip`; a disc tangent to both rounds them. Returns the point where the nose
    passes into the disc, the facing (a cushion row) and the disc (a jaw row).
    """
    turn = math.pi - cut.facing
    radius = cut.jaw_radius
    set_back = radius * elementary.tan(0.5 * turn)
    # the facing runs from the tip outwards, turned from the nose by `turn` away from the bed
    facing = tuple(
        elementary.cos(turn) * a - elementary.sin(turn) * b for a, b in zip(along, inward, strict=True)
    )
    normal = tuple(
        elementary.sin(turn) * a + elementary.cos(turn) * b for a, b in zip(along, inward, strict=True)
    )
    nose_end = (tip[0] - set_back * along[0], tip[1] - set_back * along[1])
    jaw = [nose_end[0] - radius * inward[0], nose_end[1] - radius * inward[1], radius]
    reach = CUSHION_DEPTH / elementary.sin(turn)
    start = [tip[k] + set_back * facing[k] for k in (0, 1)]
    end = [tip[k] + reach * facing[k] for k in (0, 1)]
    return nose_end, [*start, *end, *normal], jaw


def _mirror(rows: list[list[float]], axis: int, extent: float, vectors: bool) -> list[list[float]]:
    """Rows mirrored in the middle of the bed, in x (axis 0) or y (axis 1)."""
    mirrored = []
    for row in rows:
        image = list(row)
        image[axis] = extent - row[axis]
        if vectors:
            image[2 + axis] = extent - row[2 + axis]
            image[4 + axis] = -row[4 + axis]
        mirrored.append(image)
    return mirrored


def _pocketed_table(w: float, h: float, cushion_height: float, corner: PocketCut, side: PocketCut) -> Table:
    """One quarter built, the others its mirror images, so that the table is exactly symmetric. w, h m."""
    corner_tip = corner.mouth / math.sqrt(2.0)
    side_tip = 0.5 * (h - side.mouth)
    lower, lower_facing, lower_jaw = _cushion_end((corner_tip, 0.0), (-1.0, 0.0), (0.0, 1.0), corner)
    left, left_facing, left_jaw = _cushion_end((0.0, corner_tip), (0.0, -1.0), (1.0, 0.0), corner)
    middle, side_facing, side_jaw = _cushion_end((0.0, side_tip), (0.0, 1.0), (1.0, 0.0), side)
    noses = [[0.0, left[1], 0.0, middle[1], 1.0, 0.0]]
    noses += _mirror(noses, 0, w, True)
    noses += _mirror(noses, 1, h, True)
    ends = [[lower[0], 0.0, w - lower[0], 0.0, 0.0, 1.0]]
    ends += _mirror(ends, 1, h, True)
    facings = [lower_facing, left_facing, side_facing]
    facings += _mirror(facings, 0, w, True)
    facings += _mirror(facings, 1, h, True)
    jaws = [lower_jaw, left_jaw, side_jaw]
    jaws += _mirror(jaws, 0, w, False)
    jaws += _mirror(jaws, 1, h, False)
    low, high = -corner.set_out, h + corner.set_out
    pockets = [
        [-corner.set_out, low, corner.radius],
        [w + corner.set_out, low, corner.radius],
        [-side.set_out, 0.5 * h, side.radius],
        [w + side.set_out, 0.5 * h, side.radius],
        [-corner.set_out, high, corner.radius],
        [w + corner.set_out, high, corner.radius],
    ]
    return checked_table(
        w, h, cushion_height, np.array(noses + ends + facings), np.array(jaws), np.array(pockets)
    )
