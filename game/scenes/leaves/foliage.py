"""Paints leaves: bent in the middle, seen from a little above, lit from one side and through."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.plates import law
from game.scenes.leaves import model
from game.scenes.leaves.basket import Basket
from game.scenes.leaves.model import NAMES
from game.scenes.leaves.species import SPECIES, half_of, outline_of
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.polygons import NO_EDGE, paint

BACKWARD = (0.26, 0.50)  # how far right and up a way into the picture is seen, beside its length
OF_DEPTH = (0.05, 0.15)  # m right and up of a leaf that lies one depth farther back
SUN = (0.42, 0.80, -0.43)  # towards the light, in x, y and into the picture
BELOW = 0.35  # the midrib lies that far below the middle, times sin q
OF_SHAPE = [model.KIND, model.YAW, model.FLIP]  # columns of what outlines come from
SHADOW = 14  # corners
NEARER, NEAR_M = 0.45, 0.4  # share of its depth that a leaf has in the basket; m before it where that begins
LARGER = 1.18  # leaves are drawn than their chords, as these are mean ones
FADES = 0.9  # m of height by which a shadow is weaker by e


class Cut(NamedTuple):
    """Outlines of leaves, cut at the middle of their chords: (p, 2) along the chord and into the picture, by
    half chords. The leaf (p,) and the half (p,) each corner belongs to. First corner of each half (2 n + 1,);
    ends of the midrib (n, 2, 2).
    """

    points: Floats
    leaves: NDArray[np.int64]
    starts: NDArray[np.int64]
    ribs: Floats


def cut_outlines(own: Floats) -> Cut:
    """Of leaves (n, 6) as `LeavesModel.own` has them."""
    parts: list[Floats] = []
    leaves: list[int] = []
    starts = [0]
    ribs = np.zeros((len(own), 2, 2))
    shapes = [outline_of(name) for name in NAMES]
    for i, row in enumerate(own):
        c, s = math.cos(row[model.YAW]), math.sin(row[model.YAW])
        flip = -1.0 if row[model.FLIP] > 0.5 else 1.0
        shape = shapes[int(row[model.KIND])] * (1.0, flip)
        turned = shape @ np.array(((c, s), (-s, c)))
        ribs[i] = np.array(((-1.35, 0.0), (0.92, 0.0))) @ np.array(((c, s), (-s, c)))
        for side in (-1.0, 1.0):
            half = half_of(turned, side)
            parts.append(half)
            leaves += [i] * len(half)
            starts.append(starts[-1] + len(half))
    points = np.concatenate(parts) if parts else np.zeros((0, 2))
    return Cut(points, np.array(leaves, dtype=np.int64), np.array(starts, dtype=np.int64), ribs)


def nearer(basket: Basket, rows: Floats, own: Floats) -> Floats:
    """What leaves are, with the depths (n, 6) at which they are seen: the basket is less deep than the
    lawn, and towards it they come into its plane.
    """
    near = 1.0 - np.minimum(basket.away(rows[law.X], rows[law.Y]) / NEAR_M, 1.0)
    seen = own.copy()
    seen[:, model.DEPTH] *= 1.0 - (1.0 - NEARER) * near * near * (3.0 - 2.0 * near)
    return seen


def shifts_of(own: Floats) -> Floats:
    """How far (n, 2) each leaf is seen to be shifted by its depth, m."""
    return own[:, model.DEPTH][:, None] * np.array(OF_DEPTH)


class Seen(NamedTuple):
    """Leaves as one picture has them: rows and own as `LeavesModel` has them, half chords (n,) m; corners
    (p, 2) m of the `Cut`; colours of the halves (2 n,) and of the ribs (n,).
    """

    rows: Floats
    own: Floats
    halves: Floats
    corners: Floats
    inks: NDArray[np.int64]
    veins: NDArray[np.int64]


class Foliage:
    """Keeps the outlines of the leaves there are."""

    def __init__(self) -> None:
        self._cut = cut_outlines(np.zeros((0, 6)))
        self._shapes: Floats = np.zeros((0, len(OF_SHAPE)))

    def seen(self, rows: Floats, own: Floats, halves: Floats, tint: tuple[float, float, float]) -> Seen:
        """Where all leaves are seen, and in what light: worked out once for a picture."""
        self._fit(own)
        return Seen(rows, own, halves, self._corners(rows, own, halves), *_shades(rows, own, tint))

    def _fit(self, own: Floats) -> None:
        """Cut anew where a shape has changed; how deep a leaf is seen to lie changes within a picture."""
        shapes = own[:, OF_SHAPE]
        if not np.array_equal(shapes, self._shapes):
            self._shapes, self._cut = shapes, cut_outlines(own)

    def shadows(self, canvas: Canvas, rows: Floats, own: Floats, halves: Floats) -> None:
        """Soft spots on the lawn, away from the light, weaker the higher a leaf is."""
        n = rows.shape[1]
        if not n:
            return
        height = np.maximum(rows[law.Y], 0.0)
        turn = np.linspace(0.0, math.tau, SHADOW, endpoint=False)
        wide = halves * (0.45 + 0.55 * np.abs(np.cos(rows[law.THETA]))) * (1.0 + 0.5 * height)
        middle = shifts_of(own) + np.stack([rows[law.X] - 0.45 * height, np.full(n, -0.012)], axis=1)
        spots = middle[:, None] + np.stack(
            [wide[:, None] * np.cos(turn), (0.36 * halves * (1.0 + 0.5 * height))[:, None] * np.sin(turn)],
            axis=2,
        )
        shares = 0.34 * np.exp(-height / FADES)
        starts = np.arange(0, SHADOW * n + 1, SHADOW)
        inks = np.full(n, 0x1C1408, dtype=np.int64)
        edges = np.full(n, NO_EDGE, dtype=np.int64)
        paint(
            canvas,
            np.ascontiguousarray(spots.reshape(-1, 2)),
            starts,
            inks,
            shares,
            edges,
            np.zeros((SHADOW, 2)),
        )

    def leaves(
        self, canvas: Canvas, seen: Seen, which: NDArray[np.bool_], basket: Basket | None = None
    ) -> None:
        """Those leaves, the farthest first; ``basket``: between whose walls they are seen."""
        rows, own, halves, places, inks, veins = seen
        order = np.flatnonzero(which)[np.argsort(-own[which, model.DEPTH], kind="stable")]
        if not len(order):
            return
        cut = self._cut
        if basket is not None:
            rows = rows.copy()
            rows[law.X] += self._pushed_in(places, basket)
            places = self._corners(rows, own, halves)
        halves_of = (2 * order[:, None] + np.array((0, 1))).ravel()
        pieces = [places[cut.starts[k] : cut.starts[k + 1]] for k in halves_of.tolist()]
        starts = np.concatenate([[0], np.cumsum([len(piece) for piece in pieces])])
        points = np.ascontiguousarray(np.concatenate(pieces))
        edges = np.full(len(halves_of), NO_EDGE, dtype=np.int64)
        most = int(np.max(np.diff(starts)))
        paint(canvas, points, starts, inks[halves_of], np.ones(len(halves_of)), edges, np.zeros((most, 2)))
        if canvas.pixels_per_unit > 90.0:
            self._ribs(canvas, rows, own, halves, veins, order)

    def _bent(
        self, rows: Floats, leaf: NDArray[np.int64], along: Floats, into: Floats, own: Floats, halves: Floats
    ) -> Floats:
        """Where points of leaves are seen: along their chord and into the picture, by half chords."""
        q, theta, half = rows[law.BEND, leaf], rows[law.THETA, leaf], halves[leaf]
        along, into = LARGER * along, LARGER * into
        x = along * np.cos(q) * half
        y = (np.abs(along) - BELOW) * np.sin(q) * half
        c, s = np.cos(theta), np.sin(theta)
        depth = into * half
        shift = shifts_of(own)[leaf]
        return np.stack(
            [
                rows[law.X, leaf] + c * x - s * y + BACKWARD[0] * depth,
                rows[law.Y, leaf] + s * x + c * y + BACKWARD[1] * depth,
            ],
            axis=1,
        ) + shift  # fmt: skip

    def _corners(self, rows: Floats, own: Floats, halves: Floats) -> Floats:
        cut = self._cut
        return self._bent(rows, cut.leaves, cut.points[:, 0], cut.points[:, 1], own, halves)

    def _pushed_in(self, places: Floats, basket: Basket) -> Floats:
        """How far (n,) m leaves are shifted so that none is seen through the walls of a basket: what is drawn
        of a leaf is wider than the chord that the walls stop, and some of it lies before the plane.
        """
        out = np.abs(places[:, 0] - basket.x) - basket.half_at(places[:, 1])
        shift = np.where(places[:, 0] < basket.x, 1.0, -1.0) * np.maximum(out, 0.0)
        firsts = self._cut.starts[:-1:2]
        inwards = np.maximum.reduceat(shift, firsts)
        back = np.minimum.reduceat(shift, firsts)
        return np.where((inwards > 0.0) & (back < 0.0), 0.5 * (inwards + back), inwards + back)

    def _ribs(
        self, canvas: Canvas, rows: Floats, own: Floats, halves: Floats, veins: NDArray[np.int64],
        order: NDArray[np.int64],
    ) -> None:  # fmt: skip
        ends = self._cut.ribs[order]
        fold = ends[:, 0] + (ends[:, 1] - ends[:, 0]) * (
            ends[:, 0, :1]
            / np.where(np.abs(ends[:, :1, 0] - ends[:, 1:, 0]) > 1e-9, ends[:, :1, 0] - ends[:, 1:, 0], 1.0)
        ).clip(0.0, 1.0)
        points = np.concatenate([ends[:, 0], fold, ends[:, 1]])
        bent = self._bent(rows, np.tile(order, 3), points[:, 0], points[:, 1], own, halves)
        a, m, b = bent.reshape(3, -1, 2)
        inks = veins[order].astype(np.uint32)
        canvas.segments(a, m, inks, 1.1, 0.75)
        canvas.segments(m, b, inks, 1.1, 0.75)


def _shades(
    rows: Floats, own: Floats, tint: tuple[float, float, float]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Colours of the halves (2 n,) and of the ribs (n,): upper or paler lower side, lit or shone through."""
    n = len(own)
    palette = np.array([SPECIES[name].colors for name in NAMES])
    pick = np.minimum((own[:, model.SHADE] * 4.0).astype(int), 3)
    ink = palette[own[:, model.KIND].astype(int), pick]
    base = np.stack([ink >> 16 & 255, ink >> 8 & 255, ink & 255], axis=1).astype(np.float64)
    found = np.zeros((n, 2, 3))
    for k, side in enumerate((-1.0, 1.0)):
        tilt = rows[law.THETA] + side * rows[law.BEND]
        nx, ny = -np.sin(tilt), np.cos(tilt)
        # which side is seen: the eye is before and above
        upper = nx * BACKWARD[0] + ny * BACKWARD[1] > 0.0
        facing = nx * SUN[0] + ny * SUN[1]
        lit = np.where(upper, facing, -facing)
        strength = 0.58 + 0.46 * np.maximum(lit, 0.0) + 0.26 * np.maximum(-lit, 0.0)
        color = np.where(upper[:, None], base, base + 0.30 * (np.array((226.0, 200.0, 150.0)) - base))
        # light that comes through is warmer
        warm = np.maximum(-lit, 0.0)[:, None] * np.array((0.16, 0.04, -0.10))
        found[:, k] = color * (strength[:, None] + warm) * np.array(tint)
    shown = np.clip(found, 0.0, 255.0).astype(np.int64)
    halves = (shown[..., 0] << 16 | shown[..., 1] << 8 | shown[..., 2]).reshape(-1)
    dark = np.clip(0.62 * base * np.array(tint), 0.0, 255.0).astype(np.int64)
    return halves, dark[:, 0] << 16 | dark[:, 1] << 8 | dark[:, 2]
