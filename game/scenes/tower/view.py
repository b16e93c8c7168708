"""How the tower is drawn: evening light, façade, floors and columns, charges, debris, dust."""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.arrays import Floats, Longs
from game.scenes.tower.building import COLUMN, GONE, NOT_YET, RUBBLE, column_place, floor_height, half_width
from game.scenes.tower.frame import FLOORS
from game.scenes.tower.measures import fall_of, front_of
from game.scenes.tower.site import Hour, Site, hour_of, lamplight, lit
from game.scenes.tower.world import TowerState, TowerWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.canvas.standing import Standing
from game.worlds.hands.hand import Hand
from game.worlds.members.dust import AGE, LIFE, PLACE, SIZE
from game.worlds.members.solids import bodies_between
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.inks import color_of, scaled, shaded
from game.worlds.painting.marks import draw_contacts
from game.worlds.painting.polygons import NO_EDGE, paint

PACK, STRAP = (0.5, 0.36), 0.08  # m: half a pack's width and height, half a strap's height
LAMP_PX, HALO_PX = 2.4, 6.5  # design px, of the lamp on a pack and of the light about it
BLINK_S, DIM = 0.8, 0.3  # s from one light of a lamp to the next; what it gives between them
FLASH_S, FLASH_M, LEAST = 0.07, 9.0, 0.02  # s in which a flash is weaker by e; m it reaches; what is not seen
BOARD, BAND = pygame.Color(176, 128, 62), pygame.Color(58, 44, 32)
LAMP, FIRE = pygame.Color(255, 74, 58), pygame.Color(255, 206, 140)


def packs_of(model: TowerWorld) -> Floats:
    """Where charges still lie (n, 2), m."""
    frame = model.frame
    return model.world.bodies.positions[frame.bodies((COLUMN,), (model.first_storey(),))]


def flashes_of(model: TowerWorld) -> tuple[Floats, Floats]:
    """Where charges have gone off a moment ago (n, 2) m, and what is left (n,) of the light of each."""
    content, parts, first = model.content, model.frame.parts, model.first_storey()
    if model.course.fired == NOT_YET:
        return np.zeros((0, 2)), np.zeros(0)
    own = np.flatnonzero((parts.kind == COLUMN) & (parts.storey == first) & (parts.body == GONE))
    age = model.time - model.course.fired - model.parameters.delay * parts.place[own]
    left = np.array([math.exp(-max(each, 0.0) / FLASH_S) for each in age.tolist()])
    seen = left > LEAST
    y = floor_height(content, first) - content.slab - 0.5 * (content.storey - content.slab)
    places = [(column_place(content, k), y) for k in parts.place[own][seen].tolist()]
    return np.array(places).reshape(-1, 2), left[seen]


def draw_packs(canvas: Canvas, model: TowerWorld) -> None:
    """A pack on each column that is cut first, with a lamp that blinks."""
    bright = 1.0 if model.time % BLINK_S < 0.5 * BLINK_S else DIM
    wide, tall = PACK
    for x, y in packs_of(model).tolist():
        for high, ink in ((tall, BOARD), (STRAP, BAND)):
            corners = [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]
            canvas.polygon(np.array(corners), fill=ink)
        for size, veil in ((HALO_PX, 0.3), (LAMP_PX, 1.0)):
            canvas.dot((x, y), size, LAMP, veil * bright)


def draw_flashes(canvas: Canvas, model: TowerWorld) -> None:
    """The light of charges that have gone off a moment ago."""
    places, left = flashes_of(model)
    if not len(places):
        return
    canvas.soft_glow(places, FLASH_M, np.uint32(FIRE.r << 16 | FIRE.g << 8 | FIRE.b), left)
    for place, share in zip(places.tolist(), left.tolist(), strict=True):
        canvas.discs([place], 0.7 + 0.6 * share, FIRE, share)
    canvas.bloom(0.8)


PANES = 3  # windows in a bay
SPARED = 4  # of so many puffs one is drawn where the air's own dust is
WET_TO = 26.0  # m of height that the wet street mirrors
SPREAD = 0.2  # of brightness from piece to piece
HEAP_M, DARKEST = 1.6, 0.55  # m below the top of a heap at which most of the light is lost; what is lost
CHUNK = 160  # puffs that are painted at once, the oldest first


class TowerView:
    """Draws a model."""

    def __init__(self, model: TowerWorld, hand: Hand):
        self.model = model
        self._asked = False  # marks are asked for by key
        self._standing, self._site = Standing(), Site()

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        if not (self.model.parameters.marks or self._asked):
            return []
        return [("disc:amber", "contact", ""), ("dash:vermilion", "front by the law", "")]

    def draw(self, canvas: Canvas, previous: TowerState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        hour = hour_of(canvas)
        self._standing.draw(canvas, self._site.paint)
        self._facade(canvas, hour)
        self._bodies(canvas, hour, previous, alpha)
        draw_packs(canvas, self.model)
        if self.model.parameters.dust:
            self._dust(canvas, hour)
        draw_flashes(canvas, self.model)
        if hour.mirrors:
            canvas.water(0.0, WET_TO, 0.0, color_of(hour.ground[1]), hour.mirrors)
        self._asked = canvas.asked
        if canvas.marks(self.model.parameters.marks):
            self._marks(canvas)

    # -- behind ---------------------------------------------------------------------------------------

    def _facade(self, canvas: Canvas, hour: Hour) -> None:
        """Rooms and panes of storeys that stand: a back wall, the ceiling in the lamps' light, columns behind
        the panes.
        """
        content = self.model.content
        half, boxes, inks, veils = half_width(content), [], [], []

        def box(left: float, low: float, right: float, high: float, ink: int, veil: float) -> None:
            boxes.append([(left, low), (right, low), (right, high), (left, high)])
            inks.append(ink)
            veils.append(veil)

        for storey in range(1, content.storeys + 1):
            if self.model.frame.storeys.cut[storey - 1] != NOT_YET or self._is_falling(storey):
                continue
            low, high = floor_height(content, storey - 1), floor_height(content, storey) - content.slab
            light = float(lamplight(hour, low))
            box(-half, low, half, high, hour.room, 0.82)
            seen_up = (0.1 + 0.55 * storey / content.storeys) * content.slab  # from below
            box(-half, high - 2.2 * seen_up, half, high, hour.lamp, 0.05 + 0.16 * light)
            box(-half, high - seen_up, half, high, hour.lamp, 0.1 + 0.3 * light)
            for k in range(content.bays + 1):
                x, wide = 0.93 * (-half + k * content.bay), 0.3 * content.column
                box(x - wide, low, x + wide, high - seen_up, scaled(hour.column, 0.5 + 0.5 * light), 0.9)
            for k in range(content.bays * PANES):
                left = -half + (k + 0.12) * content.bay / PANES
                right = left + 0.76 * content.bay / PANES
                bright = (7 * storey + 5 * k) % 11 in (0, 4)
                box(left, low + 0.7, right, high - 0.15, hour.glass[bright], 0.55 if bright else 0.35)
        if boxes:
            paint_quads(canvas, np.array(boxes).reshape(-1, 2), np.array(inks), np.array(veils))

    def _is_falling(self, storey: int) -> bool:
        """True if the floor that carries a storey is not where it was built."""
        model = self.model
        own = model.frame.bodies((COLUMN,), (storey,))
        if not len(own):
            return True
        middle = floor_height(model.content, storey) - model.content.slab
        middle -= 0.5 * (model.content.storey - model.content.slab)
        return bool(abs(model.world.bodies.positions[own, 1] - middle).max() > 0.4)

    # -- bodies ---------------------------------------------------------------------------------------

    def _bodies(self, canvas: Canvas, hour: Hour, previous: TowerState | None, alpha: float) -> None:
        model = self.model
        rows, world = model.frame.rows(), model.world
        kinds = model.frame.parts.kind[rows]
        order = np.argsort(np.where(kinds == COLUMN, 0, kinds + 1), kind="stable")
        bodies, kinds = model.frame.parts.body[rows[order]], kinds[order]
        places, angles = bodies_between(world, previous.world if previous else None, alpha)
        shape_of = np.full(len(world.bodies.flags), -1)
        used = np.flatnonzero(world.shapes.kinds >= 0)
        shape_of[world.shapes.bodies[used]] = used
        shapes = shape_of[bodies]
        starts, counts = world.shapes.starts[shapes], world.shapes.counts[shapes]
        firsts = np.concatenate([[0], np.cumsum(counts)])
        owner = np.repeat(np.arange(len(bodies)), counts)
        corners = world.pool.corners[starts[owner] + np.arange(firsts[-1]) - firsts[owner]]
        c, s = np.cos(angles[bodies])[owner], np.sin(angles[bodies])[owner]
        at = places[bodies][owner]
        points = (
            np.stack([c * corners[:, 0] - s * corners[:, 1], s * corners[:, 0] + c * corners[:, 1]], 1) + at
        )
        inks = np.array([hour.slab, hour.column, hour.rubble[0], hour.rubble[1]])[kinds]
        inks = lit(hour, inks, places[bodies, 1])
        inks = shaded(inks, SPREAD * ((bodies * 37 % 17) / 16.0 - 0.5) - _in_the_heap(places[bodies], kinds))
        self._shadow(canvas, points, firsts, hour)
        none = np.zeros((64, 2))
        paint(canvas, points, firsts, inks, np.ones(len(inks)), np.full(len(inks), hour.edge), none)
        flat = np.isin(kinds, FLOORS)
        centre = np.repeat(places[bodies], counts, axis=0)
        upper = centre + (points - centre) * np.array((1.0, 0.9))
        upper[:, 1] += 0.04
        paint(canvas, upper, firsts, np.full(len(inks), 0xFFFFFF), np.where(flat, 0.16, 0.05),
              np.full(len(inks), NO_EDGE), none)  # fmt: skip

    def _shadow(self, canvas: Canvas, points: Floats, firsts: Longs, hour: Hour) -> None:
        """A soft band on the ground below what is low."""
        low = np.minimum.reduceat(points[:, 1], firsts[:-1])
        left, right = (
            np.minimum.reduceat(points[:, 0], firsts[:-1]),
            np.maximum.reduceat(points[:, 0], firsts[:-1]),
        )
        near = low < 6.0
        if not near.any():
            return
        a, b = float(left[near].min()), float(right[near].max())
        for wider, veil in ((0.6, 0.22), (2.2, 0.14), (5.0, 0.08)):
            quad = np.array([(a - 0.3 * wider, 0.0), (b + wider, 0.0), (b + 0.6 * wider, -0.9), (a, -0.9)])
            canvas.polygon(quad, fill=color_of(hour.edge), fill_alpha=veil)

    # -- in front -------------------------------------------------------------------------------------

    def _dust(self, canvas: Canvas, hour: Hour) -> None:
        """What the air carries, then puffs, old ones first, lighter above: discs in discs, thin at the
        rim.
        """
        dust, air = self.model.dust.rows, self.model.air.on
        if air:
            some, most = map(color_of, hour.sheen)
            sheen = ((0.0, pygame.Color(0, 0, 0)), (0.5, some), (1.0, most))
            canvas.veil(self.model.air.veil(hour.lamps), *self.model.air.box(), color_of(hour.dust[1]), sheen)
            dust = dust[np.floor(997.0 * dust[:, LIFE]) % SPARED == 0.0]  # the same ones in each picture
        if not len(dust):
            return
        age = dust[:, AGE] / dust[:, LIFE]
        radius = dust[:, SIZE] * (0.6 + 1.5 * np.sqrt(dust[:, AGE]))
        for first in range(0, len(dust), CHUNK):
            part = slice(first, first + CHUNK)
            fade = float(np.mean((1.0 - age[part]) * np.minimum(1.0, 6.0 * age[part] + 0.2)))
            where = dust[part][:, PLACE]
            shade, light = color_of(hour.dust[1]), color_of(hour.dust[0])
            for share, ink, veil in (
                (1.0, shade, 0.03),
                (0.8, shade, 0.03),
                (0.6, shade, 0.03),
                (0.4, light, 0.04),
            ):
                shift = (0.0, 0.0) if ink is shade else (0.3, 0.2)
                canvas.discs(where + np.array(shift), radius[part] * share, ink, veil * min(1.0, 1.6 * fade))

    def _marks(self, canvas: Canvas) -> None:
        model = self.model
        draw_contacts(canvas, model.world, 2.0)
        half = half_width(model.content) + 3.0
        struck = np.flatnonzero(model.frame.storeys.struck != NOT_YET)
        for k in struck.tolist():
            y = floor_height(model.content, k + 1)
            canvas.line((half, y), (half + 1.5, y), "amber", 1.6)
        x, y = front_of(model)
        canvas.line((x - half, y), (x + half, y), "vermilion", 1.4, dash=EXACT_DASH)
        took, law, _ = fall_of(model)
        if math.isfinite(took):
            words = canvas.figure("fall", f"{took:.2f} s, law {law:.2f} s")
            canvas.label((half, y), words, "vermilion", 13, "semibold", "left", (8.0, 0.0), clear=True)


def _in_the_heap(places: Floats, kinds: Longs) -> Floats:
    """Share of light (n,) that pieces at places (n, 2) m lose to those above them, column by column."""
    columns = np.floor(places[:, 0]).astype(np.int64)
    columns -= columns.min(initial=0)
    loose = kinds >= RUBBLE
    top = np.full(int(columns.max(initial=0)) + 1, -np.inf)
    np.maximum.at(top, columns[loose], places[loose, 1])
    below = np.where(loose, np.maximum(top[columns] - places[:, 1] - 0.3, 0.0), 0.0)
    return np.asarray(DARKEST * (1.0 - np.exp(-below / HEAP_M)))
