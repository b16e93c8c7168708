"""How the burning cloth is drawn: the yard in its light, the cloth, embers, flames, smoke, ashes, match."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.physics.cloth.layout import CHAR, FUEL, HOT, PER, SALT, THERE, WATER, X, Y, Z
from game.scenes.burning_cloth.ashes import AGE, GLOWS_S, LIFE, SIZE, TURN
from game.scenes.burning_cloth.ashes import X as ASH_X
from game.scenes.burning_cloth.ashes import Y as ASH_Y
from game.scenes.burning_cloth.hand import BurningClothHand
from game.scenes.burning_cloth.model import BurningClothModel, BurningClothState
from game.scenes.burning_cloth.sheet_painter import (
    COLUMNS,
    GLOW_FROM,
    GLOW_TO,
    PX,
    PY,
    paint_sheet,
    tint_sheet,
)
from game.scenes.burning_cloth.tables import HALF, TALL
from game.scenes.burning_cloth.yard import SOURCES, Yard, light_on_yard
from game.scenes.shared.polygons import NO_EDGE, paint
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark

Floats = NDArray[np.float64]
BOX = ((-HALF, 0.0), (HALF, TALL))
EYE, FAR = 1.0, 6.0  # m: how high the eye is, and how far before the cloth
FLAME = (
    (0.0, pygame.Color(0, 0, 0)), (0.16, pygame.Color(70, 8, 0)), (0.36, pygame.Color(196, 52, 4)),
    (0.6, pygame.Color(250, 130, 20)), (0.82, pygame.Color(255, 206, 92)), (1.0, pygame.Color(255, 246, 206)),
)  # fmt: skip
SMOKE = {True: pygame.Color(64, 62, 64), False: pygame.Color(104, 100, 98)}
SUN = np.array((-0.42, 0.5, 0.76))  # where the light of the sky comes from
SKY_LIGHT = {True: (0.44, 0.47, 0.58), False: (1.0, 0.99, 0.95)}
FIRE = (1.25, 0.72, 0.34)  # of a cloth with fire before and behind it
COLD, HOTTEST = 293.0, 1200.0  # K, of the views of heat
HEAT_STOPS = ((0.0, "stage"), (0.25, "violet"), (0.55, "vermilion"), (0.8, "amber"), (1.0, "yellow"))
SPARSE = 3  # of patches in each direction that throw a soft light


class BurningClothView:
    """Draws a model and its hand."""

    def __init__(self, model: BurningClothModel, hand: BurningClothHand):
        self.model, self.hand = model, hand
        self._yard = Yard()
        ny, nx = model.cloth.whole.shape
        self._vertices = np.zeros((2 * ny + 1, 2 * nx + 1, COLUMNS))
        random = np.random.default_rng(4)
        self._linen = (1.0 + 0.022 * random.standard_normal((2 * ny + 1, 2 * nx + 1))).astype(np.float64)

    def legend(self) -> list[tuple[str, str, str]]:
        """What a view other than that of the eye shows."""
        words = {
            "heat": "cloth: 293 K dark to 1200 K bright", "saltpetre": "saltpetre: none to full",
            "gas": "gas: 293 K dark to 1200 K bright",
        }  # fmt: skip
        view = self.model.parameters.view
        return [("square:amber", words[view], "")] if view in words else []

    def draw(self, canvas: Canvas, previous: BurningClothState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        dark, model = is_dark(canvas), self.model
        veil = model.air.veil()
        glow = self._glow()
        light = self._shining(veil, glow)
        spread = light_on_yard(light)
        self._yard.draw(canvas, dark, spread)
        nodes = self._between(previous, alpha)
        self._draw_cloth(canvas, nodes, dark, light)
        if canvas.teaching and model.parameters.marks:
            self._draw_threads(canvas, nodes)
        self._draw_match(canvas)
        if model.parameters.view == "gas":
            canvas.field((model.air.temperature - COLD) / (HOTTEST - COLD), *BOX, HEAT_STOPS, 0.85)
        elif model.parameters.view == "fire":
            self._draw_veil(canvas, veil, SMOKE[dark])
            self._draw_light(canvas, nodes, veil, glow)
        self._draw_ashes(canvas, dark)
        canvas.bloom(0.8 if dark else 0.45)
        self._draw_hand(canvas)

    # -- what shines ------------------------------------------------------------------------------------

    def _glow(self) -> Floats:
        """(rows, columns) 0 to 1: how bright each patch glows."""
        patches = self.model.cloth.patches
        return np.asarray(np.clip((patches[HOT] - GLOW_FROM) / (GLOW_TO - GLOW_FROM), 0.0, 1.0))

    def _shining(self, veil: NDArray[np.float32], glow: Floats) -> NDArray[np.float32]:
        """(SOURCES) how much light comes from blocks of the gas and the cloth in them, and the match."""
        rows, columns = SOURCES
        ny, nx = veil.shape[:2]
        across, up = np.arange(nx) * columns // nx, np.arange(ny) * rows // ny
        block = (up[:, None] * columns + across[None, :]).ravel()
        found = np.bincount(block, veil[..., 1].ravel(), rows * columns).reshape(SOURCES)
        found *= 0.5 * rows * columns / (nx * ny)
        b, a = np.nonzero(glow > 0.05)
        nodes = self.model.cloth.nodes
        x, y = nodes[X, b // PER, a // PER], nodes[Y, b // PER, a // PER]
        i = np.clip(((x + HALF) / (2.0 * HALF) * columns).astype(int), 0, columns - 1)
        j = np.clip((y / TALL * rows).astype(int), 0, rows - 1)
        area = self.model.cloth.size * self.model.cloth.size
        np.add.at(found, (j, i), glow[b, a] * (9.0 * area))
        match = self.model.match
        if match.lit(self.model.time):
            (x0, y0), _ = match.place(self.model.time)
            i0 = min(max(int((x0 + HALF) / (2.0 * HALF) * columns), 0), columns - 1)
            found[min(max(int(y0 / TALL * rows), 0), rows - 1), i0] += 0.16 * match.strength(self.model.time)
        return found.astype(np.float32)

    def _draw_veil(self, canvas: Canvas, veil: NDArray[np.float32], smoke: pygame.Color) -> None:
        """Flames and smoke, as far as there are any."""
        seen = np.max(veil, axis=2) > 0.002
        rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
        if not len(rows):
            return
        low, high = max(int(rows[0]) - 1, 0), min(int(rows[-1]) + 2, seen.shape[0])
        left, right = max(int(columns[0]) - 1, 0), min(int(columns[-1]) + 2, seen.shape[1])
        cell = self.model.air.cell
        canvas.veil(
            veil[low:high, left:right], (-HALF + cell * left, cell * low),
            (-HALF + cell * right, cell * high),
            smoke, FLAME,
        )  # fmt: skip

    def _draw_light(self, canvas: Canvas, nodes: Floats, veil: NDArray[np.float32], glow: Floats) -> None:
        """The light about flames and embers."""
        ny, nx = veil.shape[:2]
        block = max(nx // 24, 1)
        rows, columns = ny // block, nx // block
        light = (
            veil[: rows * block, : columns * block, 1].reshape(rows, block, columns, block).mean(axis=(1, 3))
        )
        j, i = np.nonzero(light > 0.03)
        if len(j):
            step = 2.0 * HALF / nx * block
            at = np.stack([-HALF + (i + 0.5) * step, (j + 0.5) * step], axis=1)
            inks = np.full(len(j), 0xFF8A30, dtype=np.uint32)
            canvas.soft_glow(at, np.full(len(j), 1.8 * step), inks, 0.45 * np.minimum(light[j, i], 0.8))
        b, a = np.nonzero(glow[::SPARSE, ::SPARSE] > 0.08)
        if len(b):
            b, a = b * SPARSE, a * SPARSE
            at = self._seen(nodes, b // PER, a // PER)
            inks = np.full(len(b), 0xFF6418, dtype=np.uint32)
            canvas.soft_glow(at, np.full(len(b), 0.045), inks, 0.5 * glow[b, a])
            lively = glow[b, a] * (0.7 + 0.3 * np.sin(9.0 * self.model.time + 2.4 * a + 1.7 * b))
            canvas.glow(at[lively > 0.5], np.uint32(0x8A3A08), 1, None)

    # -- the cloth --------------------------------------------------------------------------------------

    def _between(self, previous: BurningClothState | None, alpha: float) -> Floats:
        """(4, ny + 1, nx + 1) places m and which nodes are there; those beside one that is have a place
        too.
        """
        nodes = self.model.cloth.nodes
        found = np.concatenate([nodes[X : Z + 1], nodes[THERE][None]])
        if previous is not None and previous.cloth.nodes.shape == nodes.shape:
            found[:3] -= (1.0 - alpha) * (nodes[X : Z + 1] - previous.cloth.nodes[X : Z + 1])
        there = found[3] > 0.0
        if there.all():
            return found
        return _with_rim(found, there, self.model.cloth.spacing)

    def _seen(self, nodes: Floats, rows: Any, columns: Any) -> Floats:
        """(n, 2) m: places of nodes as the eye sees them, in perspective."""
        near = 1.0 + nodes[2, rows, columns] / FAR
        return np.stack(
            [nodes[0, rows, columns] * near, EYE + (nodes[1, rows, columns] - EYE) * near], axis=-1
        )

    def _draw_cloth(self, canvas: Canvas, nodes: Floats, dark: bool, light: NDArray[np.float32]) -> None:
        cloth, v = self.model.cloth, self._vertices
        near = 1.0 + nodes[2] / FAR
        seen = np.stack([nodes[0] * near, EYE + (nodes[1] - EYE) * near], axis=2)
        places = canvas.place_all(seen.reshape(-1, 2)).reshape(seen.shape)
        v[..., PX : PY + 1] = _doubled(places)
        patches = cloth.patches
        left = (patches[FUEL] + patches[CHAR]) / cloth.made_of.dry
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
        plain = (left > 0.9) & (patches[HOT] < 400.0) & (patches[SALT] < 0.02) & (patches[WATER] < 0.02)
        plain = plain.reshape(*whole.shape[:1], PER, whole.shape[1], PER).all(axis=(1, 3))
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
            return _by_stops(_corners((patches[HOT] - COLD) / (HOTTEST - COLD)))
        salt = _corners(patches[SALT])[..., None]
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

    def _draw_threads(self, canvas: Canvas, nodes: Floats) -> None:
        """Each mesh that holds, as its threads."""
        ties = self.model.cloth.ties
        rows, columns = np.nonzero(ties.across > 0.0)
        canvas.segments(
            self._seen(nodes, rows, columns), self._seen(nodes, rows, columns + 1), "chalk", 0.7, 0.45
        )
        rows, columns = np.nonzero(ties.along > 0.0)
        canvas.segments(
            self._seen(nodes, rows, columns), self._seen(nodes, rows + 1, columns), "chalk", 0.7, 0.45
        )

    # -- match, ashes, hand -----------------------------------------------------------------------------

    def _draw_match(self, canvas: Canvas) -> None:
        model = self.model
        (x, y), (tx, ty) = model.match.place(model.time)
        wood = pygame.Color(206, 170, 118)
        canvas.line((x, y), (tx, ty), wood, 0.0075 * canvas.pixels_per_unit / canvas.k)
        strong = model.match.strength(model.time)
        burnt = model.match.used(model.time) or strong > 0.0
        canvas.circle((x, y), 0.0075, pygame.Color(36, 28, 26) if burnt else pygame.Color(168, 44, 30))
        if strong <= 0.0:
            return
        sway = 0.006 * float(np.sin(13.0 * model.time)) + 0.006 * float(model.air.flows[2])
        for high, wide, color, share in ((0.062, 0.013, (255, 120, 20), 0.6),
                                         (0.045, 0.0095, (255, 190, 70), 0.8),
                                         (0.026, 0.006, (255, 244, 200), 0.95)):  # fmt: skip
            high *= 0.8 + 0.3 * strong
            side = np.linspace(0.0, 1.0, 9)
            half = wide * np.sin(np.pi * np.sqrt(side)) ** 0.8
            lean = sway * side * side * (high / 0.062)
            rise = y - 0.008 + high * side
            outline = np.concatenate([
                np.stack([x + lean - half, rise], axis=1), np.stack([x + lean + half, rise], axis=1)[::-1],
            ])  # fmt: skip
            canvas.polygon(outline, fill=pygame.Color(*color), fill_alpha=share)
        inks = np.array([0xFFA040], dtype=np.uint32)
        canvas.soft_glow(np.array([[x, y + 0.02]]), np.array([0.13 * strong]), inks, 0.7)

    def _draw_ashes(self, canvas: Canvas, dark: bool) -> None:
        ashes = self.model.ashes.alive()
        if not len(ashes):
            return
        at = ashes[:, ASH_X : ASH_Y + 1]
        turn, size = ashes[:, TURN], ashes[:, SIZE]
        c, s = np.cos(turn) * size, np.sin(turn) * size
        flat = 0.35 + 0.65 * np.abs(np.sin(1.7 * turn))
        corners = np.stack([
            np.stack([-c + s * flat, -s - c * flat], 1), np.stack([c + s * flat, s - c * flat], 1),
            np.stack([c - s * flat, s + c * flat], 1), np.stack([-c - s * flat, -s + c * flat], 1),
        ], axis=1) * 0.5 + at[:, None]  # fmt: skip
        inks = np.full(len(ashes), 0x1A1716 if dark else 0x2C2826, dtype=np.int64)
        fade = np.clip((ashes[:, LIFE] - ashes[:, AGE]) / 3.0, 0.0, 1.0)
        starts = np.arange(0, 4 * len(ashes) + 1, 4, dtype=np.int64)
        flat_corners = np.ascontiguousarray(corners.reshape(-1, 2))
        paint(
            canvas, flat_corners, starts, inks, np.ascontiguousarray(0.85 * fade),
            np.full(len(ashes), NO_EDGE, dtype=np.int64), np.zeros_like(flat_corners),
        )  # fmt: skip
        hot = np.clip(1.0 - ashes[:, AGE] / GLOWS_S, 0.0, 1.0)
        lit = hot > 0.05
        if lit.any():
            red, green = (255.0 * hot[lit]).astype(np.uint32), (110.0 * hot[lit] ** 2).astype(np.uint32)
            canvas.glow(at[lit], red << 16 | green << 8, 1, 0.6 * hot[lit])

    def _draw_hand(self, canvas: Canvas) -> None:
        point, tool = self.hand.point, self.model.parameters.tool
        if point is None:
            return
        if tool == "blow":
            canvas.arrow(point, np.array(self.hand.way()) * 0.25, "chalk")
        elif tool != "match":
            canvas.handle(point)


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
