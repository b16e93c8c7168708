"""The room behind the fire: wall, hearth, hood and flue in a cut, a floor of boards; lit by what burns."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Inks
from game.compiler.decorator import inner_kernel, lean_kernel
from game.scenes.fireplace import tables
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.backdrops import Painted, Seen
from game.worlds.painting.inks import opaque

Floats = NDArray[Any]  # of single precision, for pictures
CELL = 1.0 / 200.0  # m of the room in a cell of its picture
LEFT, BOTTOM, RIGHT, TOP = -2.6, -0.75, 2.6, 2.3  # m that are painted
SLAB, SLAB_HALF = 0.1, 0.98  # m: how thick the hearth is, and half as wide
FLOOR = -0.1  # m, where the floor begins
BRICK, COURSE, MORTAR = 0.19, 0.066, 0.007  # m
MIDDLE = (0.0, 0.3)  # m, of the light of a fire
# night, day: plaster, brick, mortar, stone, boards; light of the room itself, red, green, blue (256: all)
NIGHT = (0x6A5A4C, 0x7A4430, 0x2E2520, 0x6A6259, 0x6A4630, (86, 93, 116))
DAY = (0xE9DFCB, 0xA8624A, 0xB9A894, 0xA8A198, 0x9A6B44, (232, 232, 232))
WARM = (400, 240, 120)  # red, green, blue of firelight where it is strongest, at full strength

MOST, OPAQUE = np.int32(255), np.uint32(0xFF000000)  # of a channel; the alpha of a pixel


Piece = tuple[NDArray[np.bool_], Floats, Floats]  # where it is, its colours (h, w, 3), firelight (h, w)
LEATHER, RATTAN = (92.0, 44.0, 34.0), (122.0, 92.0, 58.0)
BARK, SAWN = (78.0, 54.0, 38.0), (176.0, 134.0, 90.0)
# m: boxes with round corners of which the chair is made: middle, half width and height, radius, how light
CUSHIONS = (
    (-1.24, 0.14, 0.2, 0.42, 0.11, 0.8), (-1.02, -0.3, 0.2, 0.3, 0.06, 0.66),
    (-1.06, -0.02, 0.15, 0.07, 0.065, 1.0),
)  # fmt: skip
ENDS = ((0.94, -0.045), (1.05, -0.05), (1.16, -0.045), (0.995, 0.045), (1.105, 0.04), (1.05, 0.13))  # m
END = 0.055  # m, radius of a log in the basket
BASKET = (1.05, -0.3, 0.2, 0.22)  # m: middle, half width at its foot, half height
FLARES = 0.18  # how much wider it is above
RIM = 0.05  # m over which what is turned to the fire catches its light


class RoomPicture(NamedTuple):
    """colors (h, w) 0xFFRRGGBB; lit (h, w) 0 to 255: how much firelight comes there; own: red, green, blue
    of the light of the room itself.
    """

    colors: Inks
    lit: NDArray[np.uint8]
    own: tuple[int, int, int]


@inner_kernel
def _lay_row(row, colors, lit, own, warm):
    """In 32 bits throughout, which compilers make vector instructions of; no product is beyond 2 ** 20."""
    red_own, green_own, blue_own = own
    red_warm, green_warm, blue_warm = warm
    for x in range(row.size):
        ink, near = np.int32(colors[x] & np.uint32(0xFFFFFF)), np.int32(lit[x])
        red = np.int32(red_own + np.int32(np.int32(red_warm * near) >> 8))
        green = np.int32(green_own + np.int32(np.int32(green_warm * near) >> 8))
        blue = np.int32(blue_own + np.int32(np.int32(blue_warm * near) >> 8))
        red = np.int32(np.int32(np.int32(ink >> 16) * red) >> 8)
        green = np.int32(np.int32(np.int32(np.int32(ink >> 8) & 255) * green) >> 8)
        blue = np.int32(np.int32(np.int32(ink & 255) * blue) >> 8)
        word = np.int32(min(red, MOST) << 16) | np.int32(min(green, MOST) << 8) | min(blue, MOST)
        row[x] = np.uint32(word) | OPAQUE


@lean_kernel
def paint_room(pixels, clip, colors, lit, own, warm):
    """Lay colors (h, w) into the clip, times own (3,) + warm (3,) lit (h, w) / 256 (256: as it is)."""
    left, top, wide = clip[0], clip[1], colors.shape[1]
    lamp = np.int32(own[0]), np.int32(own[1]), np.int32(own[2])
    fire = np.int32(warm[0]), np.int32(warm[1]), np.int32(warm[2])
    for y in range(colors.shape[0]):
        row = pixels[top + y, left : left + wide]
        _lay_row(row, colors[y], lit[y], lamp, fire)


class Room:
    """Paints the room behind all else."""

    def __init__(self) -> None:
        self._seen = Seen()

    def draw(self, canvas: Canvas, dark: bool, strength: float) -> None:
        """strength: of the firelight, 0 to 1."""
        picture = room_picture(dark)
        pixels, clip = canvas.raster_target
        colors, lit = self._seen.of(canvas, Painted(LEFT, TOP, CELL), (picture.colors, picture.lit))
        warm = np.array([int(part * strength) for part in WARM], dtype=np.int64)
        paint_room(pixels, clip, colors, lit, np.array(picture.own, dtype=np.int64), warm)


def warm_up_room() -> None:
    """Compile what paints, on a tiny picture."""
    paint_room(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((4, 4), np.uint32),
        np.zeros((4, 4), np.uint8), np.zeros(3, np.int64), np.zeros(3, np.int64),
    )  # fmt: skip


def _parts(ink: int) -> Floats:
    return np.array([ink >> 16 & 255, ink >> 8 & 255, ink & 255], dtype=np.float32)


def hood_half(y: Floats) -> Floats:
    """Half the inner width of hood and flue at heights y, m."""
    share = np.clip((y - tables.HOOD_FOOT) / (tables.THROAT - tables.HOOD_FOOT), 0.0, 1.0)
    return np.asarray(tables.HOOD_OUT + (tables.HOOD_IN - tables.HOOD_OUT) * share)


@lru_cache(maxsize=2)
def room_picture(dark: bool) -> RoomPicture:
    """All of it, as the theme has it."""
    plaster, brick, mortar, stone, boards = (_parts(ink) for ink in (NIGHT if dark else DAY)[:5])
    x = (np.arange(LEFT, RIGHT, CELL)[None, :] + 0.5 * CELL).astype(np.float32)
    y = (np.arange(TOP, BOTTOM, -CELL)[:, None] - 0.5 * CELL).astype(np.float32)
    shape = (y.shape[0], x.shape[1])
    random = np.random.default_rng(26)
    grain = random.standard_normal(shape, dtype=np.float32)
    cloud = _smooth(random, shape)
    colors = plaster * (1.0 + 0.05 * cloud + 0.012 * grain)[..., None]
    wall = _bricks(x, y, brick, mortar, random)
    back = (np.abs(x) < tables.HOOD_OUT + 0.05) & (y < tables.HOOD_FOOT + 0.02)
    recess = 0.45 + 0.55 * np.clip((tables.HOOD_OUT + 0.05 - np.abs(x)) / 0.22, 0.0, 1.0)
    _lay(colors, back & (y > 0.0), wall * ((0.5 + 0.1 * cloud) * recess)[..., None])
    half = hood_half(y)
    inner = (y >= tables.HOOD_FOOT) & (np.abs(x) < half)
    _lay(colors, inner, wall * (0.26 + 0.06 * cloud)[..., None])
    shell = (y >= tables.HOOD_FOOT) & (np.abs(x) >= half) & (np.abs(x) < half + tables.WALL * 1.35)
    edge = np.clip((np.abs(x) - half) / (1.35 * tables.WALL), 0.0, 1.0)
    _lay(colors, shell, stone * (0.72 + 0.4 * edge + 0.06 * cloud + 0.02 * grain)[..., None])
    beam = (np.abs(y - tables.HOOD_FOOT + 0.012) < 0.03) & (
        np.abs(np.abs(x) - tables.HOOD_OUT - 0.05) < 0.085
    )
    _lay(colors, beam, boards * (0.9 + 0.07 * np.sin(170.0 * y + 6.0 * cloud))[..., None])
    for side in (-1.0, 1.0):  # the two pillars that the hood stands on
        pillar = (
            (np.abs(x - side * (tables.HOOD_OUT + 0.085)) < 0.045)
            & (y > 0.0)
            & (y < tables.HOOD_FOOT - 0.015)
        )
        across = (x - side * (tables.HOOD_OUT + 0.085)) / 0.045
        _lay(colors, pillar, stone * (0.8 - 0.18 * side * across + 0.07 * cloud + 0.02 * grain)[..., None])
    slab = (np.abs(x) < SLAB_HALF) & (y <= 0.0) & (y > -SLAB)
    _lay(colors, slab, stone * (0.82 + 1.8 * np.clip(y + 0.012, 0.0, 0.012) / 0.012 * 0.18
                                + 0.07 * cloud + 0.03 * grain)[..., None])  # fmt: skip
    ground = (y <= FLOOR) & ~slab
    away = (FLOOR - y) / (FLOOR - BOTTOM)  # 0 at the wall, 1 in front
    wide = 0.16 * (1.0 + 1.6 * away)
    number = np.floor(x / wide + 40.0)
    tint = random.uniform(-1.0, 1.0, 200).astype(np.float32)[np.clip(number, 0, 199).astype(int)]
    seam = np.abs(x / wide - np.round(x / wide)) * wide < 0.004 * (1.0 + away)
    wood = boards * (0.7 + 0.5 * away + 0.07 * tint + 0.04 * cloud - 0.35 * seam)[..., None]
    _lay(colors, ground, wood)
    edge = np.clip((SLAB_HALF + 0.1 - np.abs(x)) / 0.2, 0.0, 1.0)
    shade = np.exp(-np.clip(FLOOR - y, 0.0, None) / 0.05) * edge
    colors *= np.where(ground, 1.0 - 0.45 * shade, 1.0)[..., None]
    light = _light(x, y, ground)
    x, y = np.broadcast_arrays(x, y)
    for piece in (chair, basket):
        _lay_piece(colors, light, *piece(x, y, cloud))
    lit = np.clip(255.0 * light, 0.0, 255.0).astype(np.uint8)
    return RoomPicture(opaque(colors), lit, (NIGHT if dark else DAY)[5])


def _lay_piece(colors: Floats, light: Floats, where: NDArray[np.bool_], over: Floats, lit: Floats) -> None:
    """Furniture before the wall: its colours, and how much firelight comes to it."""
    _lay(colors, where, over)
    light[where] = lit[where]


def _lay(colors: Floats, where: NDArray[np.bool_], over: Floats) -> None:
    """Other colours where a shape is."""
    colors[where] = np.broadcast_to(over, colors.shape)[where]


def _smooth(random: np.random.Generator, shape: tuple[int, int]) -> Floats:
    """Soft patches, about -1 to 1."""
    found = np.zeros(shape, np.float32)
    for coarse, share in ((12, 0.6), (40, 0.4)):
        small = random.standard_normal((shape[0] // coarse + 2, shape[1] // coarse + 2), dtype=np.float32)
        rows, columns = (
            np.arange(shape[0], dtype=np.float32) / coarse,
            np.arange(shape[1], dtype=np.float32) / coarse,
        )
        i, j = rows.astype(int), columns.astype(int)
        f, g = (rows - i)[:, None], (columns - j)[None, :]
        upper = small[i][:, j] * (1.0 - g) + small[i][:, j + 1] * g
        lower = small[i + 1][:, j] * (1.0 - g) + small[i + 1][:, j + 1] * g
        found += share * (upper * (1.0 - f) + lower * f)
    return found


def _bricks(x: Floats, y: Floats, brick: Floats, mortar: Floats, random: np.random.Generator) -> Floats:
    """Courses of bricks, each with a tint of its own."""
    course = np.floor(y / COURSE)
    along = x / BRICK + 0.5 * np.mod(course, 2.0)
    number = np.floor(along)
    tints = random.uniform(-1.0, 1.0, (97, 89)).astype(np.float32)
    tint = tints[np.mod(course, 97).astype(int), np.mod(number, 89).astype(int)]
    joint = ((along - number) * BRICK < MORTAR) | (np.mod(y, COURSE) < MORTAR)
    tone = brick * (0.85 + 0.2 * tint)[..., None]
    return np.where(joint[..., None], mortar, tone)


def _light(x: Floats, y: Floats, ground: NDArray[np.bool_]) -> Floats:
    """Firelight (h, w), 0 to 1: falls off with the distance, shaded by the pillars and the hood."""
    away = np.sqrt((x - MIDDLE[0]) ** 2 + (1.15 * (y - MIDDLE[1])) ** 2)
    light = 1.0 / (1.0 + (away / 0.42) ** 2)
    side = np.clip((np.abs(x) - tables.HOOD_OUT) / 0.12, 0.0, 1.0)
    above = np.clip((y - tables.HOOD_FOOT) / 0.5, 0.0, 1.0)
    light = light * (1.0 - 0.55 * side * above)
    down = np.clip(FLOOR - y, 0.0, None)
    light = np.where(ground, 0.85 * np.exp(-((x / 1.25) ** 2)) * np.exp(-down / 0.55), light)
    return np.asarray(light)


def _inside(x: Floats, y: Floats, box: tuple[float, ...]) -> Floats:
    """(h, w) m: how deep within a box with round corners, below 0 outside."""
    cx, cy, wide, tall, radius = box[:5]
    dx, dy = np.abs(x - cx) - wide + radius, np.abs(y - cy) - tall + radius
    outside = np.sqrt(np.maximum(dx, 0.0) ** 2 + np.maximum(dy, 0.0) ** 2)
    return np.asarray(radius - outside - np.minimum(np.maximum(dx, dy), 0.0))


def chair(x: Floats, y: Floats, cloud: Floats) -> Piece:
    """An armchair of leather to the left, turned to the fire."""
    where, over = np.zeros(x.shape, bool), np.zeros((*x.shape, 3), np.float32)
    lit = np.zeros(x.shape, np.float32)
    for box in CUSHIONS:
        deep = _inside(x, y, box)
        part = deep > 0.0
        round_off = np.clip(deep / 0.06, 0.0, 1.0)
        tone = box[5] * (0.45 + 0.55 * round_off) + 0.05 * cloud
        over[part] = (np.array(LEATHER) * tone[..., None])[part]
        turned = np.clip((x - box[0]) / box[2], 0.0, 1.0) ** 2
        lit[part] = (0.05 + 0.3 * turned * np.clip(1.3 - deep / RIM, 0.15, 1.0))[part]
        where |= part
    return where, over, lit


def basket(x: Floats, y: Floats, cloud: Floats) -> Piece:
    """A basket with logs for later, to the right."""
    where, over = np.zeros(x.shape, bool), np.zeros((*x.shape, 3), np.float32)
    lit = np.zeros(x.shape, np.float32)
    for cx, cy in ENDS:
        away = np.sqrt((x - cx) ** 2 + (y - cy) ** 2)
        part = away < END
        rings = 0.86 + 0.1 * np.sin(away * 620.0 + 3.0 * cloud) + 0.05 * cloud
        tone = np.where((away < 0.84 * END)[..., None], np.array(SAWN) * rings[..., None], np.array(BARK))
        over[part] = tone[part]
        lit[part] = (0.1 + 0.12 * np.clip((cx - x) / END, -0.6, 1.0))[part]
        where |= part
    cx, cy, wide, tall = BASKET
    half = wide * (1.0 + FLARES * (y - cy) / tall)
    part = (np.abs(x - cx) < half) & (np.abs(y - cy) < tall)
    weave = 0.72 + 0.2 * np.sin(95.0 * x) * np.sign(np.sin(120.0 * y)) - 0.22 * (np.abs(y - cy) > 0.9 * tall)
    across = (x - cx) / half
    over[part] = (np.array(RATTAN) * (weave * (1.0 - 0.35 * across * across))[..., None])[part]
    lit[part] = (0.06 + 0.16 * np.clip(-across, 0.0, 1.0) ** 2)[part]
    return where | part, over, lit
