"""How wood is drawn: round in the firelight, bark that turns to char and ash, and what glows in it."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats, Longs
from game.physics.heat.nodes import FUEL, TEMPERATURE, WATER
from game.scenes.fireplace import tables
from game.scenes.fireplace.wood import Wood
from game.ui.canvas.canvas import Canvas
from game.worlds.painting import boards
from game.worlds.painting.boards import paint_quads, placed, placed_parts
from game.worlds.painting.flames import glow_inks
from game.worlds.painting.inks import packed, shaded

BARK, CHAR, ASH = (104, 70, 44), (24, 20, 19), (112, 107, 102)
NIGHT, FIRE = np.array((0.55, 0.57, 0.64)), np.array((0.95, 0.66, 0.4))  # light of the room, of a large fire
DAY = np.array((0.95, 0.94, 0.9))
DARK = 750.0  # K of what is just seen to glow
BRIGHT, ADAPTED = 1460.0, 1060.0  # K that are brightest to an eye that sees a large fire, or embers alone
PATCHES = (9, 8)  # along and across a piece, each of which is as bright and warm as chance has it
UNDER = 0.4  # of a patch that lies below the next ones, so that no seam between them shows what is behind
VARIES = 220.0  # K from the coldest to the hottest of them, which is as hot as the piece
SOFT = 0.35  # of the light that is about what glows


def _patches() -> tuple[Floats, Floats]:
    """Boxes (k, 4) of all patches, in shares of half sizes, and light (k, 1) on each of a round piece."""
    along, across = PATCHES
    boxes, light = [], []
    for i in range(along):
        for k in range(across):
            right, high = min(i + 1 + UNDER, along), min(k + 1 + UNDER, across)
            boxes.append((-1.0 + 2.0 * i / along, -1.0 + 2.0 * k / across,
                          -1.0 + 2.0 * right / along, -1.0 + 2.0 * high / across))  # fmt: skip
            middle = -1.0 + 2.0 * (k + 0.5) / across
            light.append(1.0 - 0.62 * middle * middle)
    return np.array(boxes), np.array(light)[:, None]


PATCH_BOXES, ROUND = _patches()


def adapted(power: float) -> float:
    """K that are brightest to the eye while flames of W/m burn: the darker, the less."""
    return round((ADAPTED + (BRIGHT - ADAPTED) * min(1.0, (max(power, 0.0) / 5.0e4) ** 0.5)) / 10.0) * 10.0


class WoodPicture:
    """Paints wood."""

    def __init__(self) -> None:
        chance = np.random.default_rng(5)
        self._tints = chance.uniform(-1.0, 1.0, (61, *PATCHES))
        for _ in range(3):  # the grain of wood is long
            self._tints += 0.7 * (np.roll(self._tints, 1, 1) + np.roll(self._tints, -1, 1))
        self._tints /= np.max(np.abs(self._tints))
        rough = chance.uniform(-1.0, 1.0, (61, *PATCHES))
        for axis in (1, 2):  # what is hot is beside what is hot
            rough += 0.5 * (np.roll(rough, 1, axis) + np.roll(rough, -1, axis))
        self._heats = 0.5 * (rough / np.max(np.abs(rough)) - 1.0)

    def draw(
        self, canvas: Canvas, wood: Wood, at: tuple[Floats, Floats], strength: float, dark: bool,
        bright: float,
    ) -> None:  # fmt: skip
        """at: places (n, 2) m, cosines and sines (n, 2); strength of the firelight; bright: see `adapted`."""
        if not wood.count:
            return
        table, (places, turned) = wood.table, at
        half = table[:, tables.HALF_THICK] * table[:, tables.SCALE]
        sizes = np.stack([table[:, tables.HALF_LENGTH] * 1.03, half], axis=1)
        kelvin = wood.nodes.nodes[TEMPERATURE, : wood.count]
        inks = self._bark(wood, kelvin, strength, dark)
        rim = sizes + canvas.px(1.0)
        paint_quads(canvas, placed(boards.WHOLE, rim, places, turned), shaded(inks, -0.6))
        numbers = np.arange(wood.count) % len(self._tints)
        tints, heats = (chance[numbers].reshape(len(numbers), -1).T for chance in (self._tints, self._heats))
        share = np.clip((kelvin + VARIES * heats - DARK) / (bright - DARK), 0.0, 1.0)
        colors = _brighter(_scaled(inks, ROUND + 0.13 * tints), glow_inks(share, DARK, bright))
        paint_quads(canvas, placed_parts(PATCH_BOXES, sizes, places, turned), colors.reshape(-1))
        self._draw_cracks(canvas, sizes, at, kelvin, bright)

    def _bark(self, wood: Wood, kelvin: Floats, strength: float, dark: bool) -> Longs:
        """Colours (n,) of the pieces: bark, then char, at the end ash where it is cold, in the light there
        is.
        """
        bark, char, ash = (np.array(color, dtype=np.float64) for color in (BARK, CHAR, ASH))
        whole, rows = wood.table[:, tables.WHOLE], wood.nodes.nodes
        left = np.clip(rows[FUEL, : wood.count] / whole, 0.0, 1.0)
        wet = np.minimum(1.0, rows[WATER, : wood.count] / whole)
        hot = np.clip((kelvin - 500.0) / 300.0, 0.0, 1.0)
        charred = np.clip((1.0 - left) * 5.0 + 2.0 * hot, 0.0, 1.0)[:, None]
        grey = (np.clip(0.3 - left, 0.0, 0.3) / 0.3 * (1.0 - hot))[:, None]
        colors = bark * (1.0 - 0.35 * wet[:, None])
        colors = colors + (char - colors) * charred
        colors = colors + (ash - colors) * 0.75 * grey
        light = (NIGHT if dark else DAY) + FIRE * min(strength, 1.0)
        return packed(np.clip(colors * light, 0.0, 255.0))

    def _draw_cracks(
        self, canvas: Canvas, sizes: Floats, at: tuple[Floats, Floats], kelvin: Floats, bright: float
    ) -> None:
        """Lines across hot pieces, into which one sees deeper, and the light about all that glows."""
        glowing = np.flatnonzero(kelvin > DARK)
        if not len(glowing):
            return
        places, turned = at[0][glowing], at[1][glowing]
        numbers, corners, inks = glowing % len(self._tints), [], []
        share = np.clip((kelvin[glowing] - DARK) / (bright - DARK), 0.0, 1.0)
        colors = glow_inks(share, DARK, bright)
        for i, k in ((0, 1), (1, 4), (2, 2), (1, 1), (2, 5), (0, 3)):
            x, y = 0.9 * self._tints[numbers, i, k], 3.0 * self._heats[numbers, i, k] + 1.5
            for box, moved in (((-0.022, -0.3, 0.022, 0.3), 0.0), ((-0.12, -0.02, 0.12, 0.02), 0.2)):
                up = np.clip(y + moved, -0.7, 0.7)
                shift = np.stack([x * sizes[glowing, 0], up * sizes[glowing, 1]], 1)
                c, s = turned.T
                own = np.stack([c * shift[:, 0] - s * shift[:, 1], s * shift[:, 0] + c * shift[:, 1]], 1)
                corners.append(placed(box, sizes[glowing], places + own, turned))
                inks.append(colors)
        paint_quads(canvas, np.concatenate(corners), np.concatenate(inks), 0.55)
        canvas.soft_glow(places, 2.6 * sizes[glowing, 0], colors.astype(np.uint32), SOFT * share)


def _scaled(inks: Longs, shares: Floats) -> Longs:
    """Colours (n,) with all channels times shares (..., n)."""
    channels = [np.clip((inks >> shift & 255) * shares, 0.0, 255.0).astype(np.int64) for shift in (16, 8, 0)]
    return channels[0] << 16 | channels[1] << 8 | channels[2]


def _brighter(inks: Longs, others: Longs) -> Longs:
    """The stronger of both in each channel."""
    return np.asarray(sum(np.maximum(inks >> s & 255, others >> s & 255) << s for s in (16, 8, 0)))
