"""The cloth as the eye sees it: where its threads are, their light and colours."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.cloth import layout
from game.scenes.burning_cloth.model import BurningClothModel, BurningClothState
from game.scenes.burning_cloth.picture.sheet_painter import COLUMNS, PX, PY, paint_sheet, tint_sheet
from game.scenes.burning_cloth.picture.yard import SOURCES
from game.scenes.burning_cloth.tables import HALF, TALL
from game.ui.canvas.canvas import Canvas

EYE, FAR = 1.0, 6.0  # m: how high the eye is, and how far before the cloth
SUN = np.array((-0.42, 0.5, 0.76))  # where the light of the sky comes from
SKY_LIGHT = {True: (0.44, 0.47, 0.58), False: (1.0, 0.99, 0.95)}
FIRE = (1.25, 0.72, 0.34)  # of a cloth with fire before and behind it
COLD, HOTTEST = 293.0, 1200.0  # K, of the views of heat


class ClothPicture:
    """Paints the cloth of a model."""

    def __init__(self, model: BurningClothModel):
        self.model = model
        ny, nx = model.cloth.whole.shape
        self._vertices = np.zeros((2 * ny + 1, 2 * nx + 1, COLUMNS))
        random = np.random.default_rng(4)
        self._linen = (1.0 + 0.022 * random.standard_normal((2 * ny + 1, 2 * nx + 1))).astype(np.float64)

    def between(self, previous: BurningClothState | None, alpha: float) -> Floats:
        """(4, ny + 1, nx + 1) places m and which nodes are there; those beside one that is have a place
        too.
        """
        nodes = self.model.cloth.nodes
        found = np.concatenate([nodes[layout.X : layout.Z + 1], nodes[layout.THERE][None]])
        if previous is not None and previous.cloth.nodes.shape == nodes.shape:
            found[:3] -= (1.0 - alpha) * (
                nodes[layout.X : layout.Z + 1] - previous.cloth.nodes[layout.X : layout.Z + 1]
            )
        there = found[3] > 0.0
        if there.all():
            return found
        return _with_rim(found, there, self.model.cloth.spacing)

    def seen(self, nodes: Floats, rows: Any, columns: Any) -> Floats:
        """(n, 2) m: places of nodes as the eye sees them, in perspective."""
        near = 1.0 + nodes[2, rows, columns] / FAR
        return np.stack(
            [nodes[0, rows, columns] * near, EYE + (nodes[1, rows, columns] - EYE) * near], axis=-1
        )

    def draw(self, canvas: Canvas, nodes: Floats, dark: bool, light: NDArray[np.float32]) -> None:
        cloth, v = self.model.cloth, self._vertices
        near = 1.0 + nodes[2] / FAR
        seen = np.stack([nodes[0] * near, EYE + (nodes[1] - EYE) * near], axis=2)
        places = canvas.place_all(seen.reshape(-1, 2)).reshape(seen.shape)
        v[..., PX : PY + 1] = _doubled(places)
        patches = cloth.patches
        left = (patches[layout.FUEL] + patches[layout.CHAR]) / cloth.made_of.dry
        light_now = np.array((SKY_LIGHT[dark], FIRE))
        tint_sheet(
            patches,
            _lambert(nodes),
            self._fire_on(nodes, light),
            self._linen,
            light_now,
            cloth.made_of.dry,
            v,
        )
        if self.model.parameters.view in ("heat", "saltpetre"):
            v[..., 2:5] = self._measured()
        whole = cloth.whole > 0.0
        plain = (
            (left > 0.9)
            & (patches[layout.HOT] < 400.0)
            & (patches[layout.SALT] < 0.02)
            & (patches[layout.WATER] < 0.02)
        )
        plain = plain.reshape(*whole.shape[:1], layout.PER, whole.shape[1], layout.PER).all(axis=(1, 3))
        plain &= _all_around(plain)
        placed = nodes[3] > 0.0
        corners = placed[:-1, :-1] & placed[:-1, 1:] & placed[1:, :-1] & placed[1:, 1:]
        drawn = np.where(corners & (whole | _any_around(whole)), np.where(plain & whole, 1, 2), 0)
        pixels, clip = canvas.raster_target
        paint_sheet(pixels, clip, v, np.ascontiguousarray(drawn, dtype=np.int64))

    def _measured(self) -> Floats:
        """(2 ny + 1, 2 nx + 1, 3) 0 to 255: how hot the cloth is, or how much saltpetre is on it."""
        patches = self.model.cloth.patches
        if self.model.parameters.view == "heat":
            return _by_stops(_corners((patches[layout.HOT] - COLD) / (HOTTEST - COLD)))
        salt = _corners(patches[layout.SALT])[..., None]
        return np.asarray(np.array((60.0, 66.0, 74.0)) + salt * np.array((190.0, 130.0, -30.0)))

    def _fire_on(self, nodes: Floats, light: NDArray[np.float32]) -> Floats:
        """(ny + 1, nx + 1) firelight on the cloth, from the blocks about it."""
        rows, columns = SOURCES
        soft = light.copy()
        for _ in range(2):
            padded = np.pad(soft, 1, mode="edge")
            soft = 0.25 * (padded[1:-1, :-2] + padded[1:-1, 2:] + padded[:-2, 1:-1] + padded[2:, 1:-1])
            soft = 0.6 * soft + 0.4 * padded[1:-1, 1:-1]
        x = np.clip((nodes[0] + HALF) / (2.0 * HALF) * columns - 0.5, 0.0, columns - 1.001)
        y = np.clip(nodes[1] / TALL * rows - 0.5, 0.0, rows - 1.001)
        i, j = x.astype(int), y.astype(int)
        f, g = x - i, y - j
        low = soft[j, i] * (1.0 - f) + soft[j, i + 1] * f
        high = soft[j + 1, i] * (1.0 - f) + soft[j + 1, i + 1] * f
        return np.asarray(np.minimum(3.2 * (low * (1.0 - g) + high * g), 1.0))

    def draw_threads(self, canvas: Canvas, nodes: Floats) -> None:
        """Each mesh that holds, as its threads."""
        ties = self.model.cloth.ties
        rows, columns = np.nonzero(ties.across > 0.0)
        canvas.segments(
            self.seen(nodes, rows, columns), self.seen(nodes, rows, columns + 1), "chalk", 0.7, 0.45
        )
        rows, columns = np.nonzero(ties.along > 0.0)
        canvas.segments(
            self.seen(nodes, rows, columns), self.seen(nodes, rows + 1, columns), "chalk", 0.7, 0.45
        )


def _doubled(values: Floats) -> Floats:
    """(2 n - 1, 2 m - 1, ...) values at nodes (n, m, ...), and halfway between them."""
    rows, columns = values.shape[:2]
    found = np.empty((2 * rows - 1, 2 * columns - 1, *values.shape[2:]))
    found[::2, ::2] = values
    found[::2, 1::2] = 0.5 * (values[:, :-1] + values[:, 1:])
    found[1::2] = 0.5 * (found[:-2:2] + found[2::2])
    return found


def _corners(values: Floats) -> Floats:
    """(n + 1, m + 1) means at the corners of patches (n, m)."""
    padded = np.pad(values, 1, mode="edge")
    return np.asarray(0.25 * (padded[:-1, :-1] + padded[:-1, 1:] + padded[1:, :-1] + padded[1:, 1:]))


def _any_around(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether one of the eight about it is so."""
    padded = np.pad(mask, 1)
    rows = padded[:, :-2] | padded[:, 1:-1] | padded[:, 2:]
    return np.asarray(rows[:-2] | rows[1:-1] | rows[2:])


def _all_around(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether all about it are so."""
    padded = np.pad(mask, 1, constant_values=True)
    rows = padded[:, :-2] & padded[:, 1:-1] & padded[:, 2:]
    return np.asarray(rows[:-2] & rows[1:-1] & rows[2:])


def _lambert(nodes: Floats) -> Floats:
    """(ny + 1, nx + 1) light of the sky by the normal of the cloth, some of it from behind."""
    across = np.empty_like(nodes[:3])
    across[..., 1:-1] = nodes[:3, :, 2:] - nodes[:3, :, :-2]
    across[..., 0], across[..., -1] = nodes[:3, :, 1] - nodes[:3, :, 0], nodes[:3, :, -1] - nodes[:3, :, -2]
    upward = np.empty_like(across)
    upward[:, 1:-1] = nodes[:3, :-2] - nodes[:3, 2:]
    upward[:, 0], upward[:, -1] = nodes[:3, 0] - nodes[:3, 1], nodes[:3, -2] - nodes[:3, -1]
    x = across[1] * upward[2] - across[2] * upward[1]
    y = across[2] * upward[0] - across[0] * upward[2]
    z = across[0] * upward[1] - across[1] * upward[0]
    length = np.sqrt(x * x + y * y + z * z) + 1e-12
    turned = (x * SUN[0] + y * SUN[1] + z * SUN[2]) / length
    return np.asarray(0.34 + 0.82 * np.clip(np.abs(turned), 0.0, 1.0))


def _with_rim(nodes: Floats, there: NDArray[np.bool_], spacing: float) -> Floats:
    """Places for nodes that are gone beside those that are not: as these lie, carried on."""
    rows, columns = there.shape
    padded = np.pad(nodes, ((0, 0), (2, 2), (2, 2)))
    known = np.pad(there, 2)
    total, count = np.zeros((3, rows, columns)), np.zeros((rows, columns))
    for down, right in ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
        one = np.s_[2 + down : 2 + down + rows, 2 + right : 2 + right + columns]
        two = np.s_[2 + 2 * down : 2 + 2 * down + rows, 2 + 2 * right : 2 + 2 * right + columns]
        both = known[one] & known[two]
        total += np.where(both, 2.0 * padded[:3][(slice(None), *one)] - padded[:3][(slice(None), *two)], 0.0)
        count += both
    rim = ~there & (count > 0)
    found = nodes.copy()
    found[:3, rim] = total[:, rim] / count[rim]
    found[3] = there | rim
    return found


def _by_stops(values: Floats) -> Floats:
    """Colours (..., 3) from dark over red to yellow."""
    share = np.clip(values, 0.0, 1.0)
    places = (0.0, 0.25, 0.55, 0.8, 1.0)
    inks = np.array(
        ((28, 34, 44), (96, 72, 170), (214, 84, 30), (250, 160, 30), (255, 246, 160)), dtype=float
    )
    return np.stack([np.interp(share, places, inks[:, k]) for k in range(3)], axis=-1)
