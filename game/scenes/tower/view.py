"""How the tower is drawn: evening light, a town far off, façade, floors and columns, debris, dust."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats, Longs
from game.scenes.tower.building import floor_height, half_width
from game.scenes.tower.frame import FLOORS
from game.scenes.tower.measures import fall_of, front_of
from game.scenes.tower.tables import COLUMN, NOT_YET
from game.scenes.tower.world import TowerState, TowerWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.canvas.standing import Standing
from game.worlds.hands.hand import Hand
from game.worlds.members.dust import LIFE, as_seen
from game.worlds.members.solids import bodies_between
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.dust import draw_dust
from game.worlds.painting.inks import color_of
from game.worlds.painting.marks import draw_contacts
from game.worlds.painting.polygons import NO_EDGE, paint

BEHIND = ((0.12, 1.5), (0.3, 0.9))  # of the far and the near town: share of the camera's way, of its size
PANES = 3  # windows in a bay
SPARED = 4  # of so many puffs one is drawn where the air's own dust is
GROUND_BANDS, GROUND_M = 14, 16.0  # bands of the field, m below the horizon in all


class Hour(NamedTuple):
    """Colours 0xRRGGBB of an hour; its sky from above to the horizon."""

    sky: tuple[int, int, int]
    sun: int
    towns: tuple[int, int]
    ground: tuple[int, int]
    slab: int
    column: int
    rubble: tuple[int, int]
    edge: int
    glass: tuple[int, int]  # no lamp is on: the house is empty; some panes mirror the sky
    dust: tuple[int, int]
    sheen: int  # added where light from the sun or the moon falls on dust


DAY = Hour(
    (0x8FB7DA, 0xC9DDE8, 0xF6E7CF), 0xFFF6DC, (0xA9BCCB, 0x8499AB), (0x8D9A78, 0x5E6B52),
    0xB9B2A6, 0x9C968C, (0x8A847A, 0xA59E92), 0x4A463F, (0x8FB4C8, 0xBFD8E2), (0xE6DCCB, 0xA99F90), 0x38322A,
)  # fmt: skip
NIGHT = Hour(
    (0x0A1024, 0x1C2444, 0x6E4A5C), 0xF0C9A0, (0x232A44, 0x161B2E), (0x3A3A44, 0x1B1F25),
    0x7F7C80, 0x65636A, (0x57555C, 0x6E6B70), 0x0A0B10, (0x2D3E58, 0x3A4A66), (0x9A8F8C, 0x4C464A), 0x8A6E5C,
)  # fmt: skip


def hour_of(canvas: Canvas) -> Hour:
    """By the theme."""
    color = canvas.color("stage")
    return NIGHT if color.r + color.g + color.b < 384 else DAY


class TowerView:
    """Draws a model."""

    def __init__(self, model: TowerWorld, hand: Hand):
        self.model = model
        self._asked = False  # marks are asked for by key
        self._standing = Standing()
        random = np.random.default_rng(3)
        self._towns = [_town(random, scale) for _, scale in BEHIND]

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        if not (self.model.parameters.marks or self._asked):
            return []
        return [("disc:amber", "contact", ""), ("dash:vermilion", "front by the law", "")]

    def draw(self, canvas: Canvas, previous: TowerState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        hour = hour_of(canvas)
        self._standing.draw(canvas, self._paint_behind)
        self._facade(canvas, hour)
        self._bodies(canvas, hour, previous, alpha)
        if self.model.parameters.dust:
            self._dust(canvas, hour)
        self._asked = canvas.asked
        if canvas.marks(self.model.parameters.marks):
            self._marks(canvas)

    # -- behind ---------------------------------------------------------------------------------------

    def _paint_behind(self, canvas: Canvas) -> None:
        """Sky, sun, two rows of a town, and the ground."""
        hour = hour_of(canvas)
        seen = canvas.camera.visible()
        rows = np.array([[0.0], [0.35], [1.0]])
        stops = [(0.0, color_of(hour.sky[2])), (0.4, color_of(hour.sky[1])), (1.0, color_of(hour.sky[0]))]
        low = min(seen.bottom, 0.0)
        canvas.field(np.repeat(rows, 2, axis=1), (seen.left, low), (seen.right, seen.top), stops)
        width, (x, _) = seen.right - seen.left, canvas.camera.center
        sun = seen.left + 0.76 * width, 0.3 * (seen.top - seen.bottom) + max(seen.bottom, 0.0)
        for share, veil in ((2.2, 0.08), (1.5, 0.14), (1.0, 1.0)):
            canvas.discs(np.array([sun]), 0.02 * width * share, color_of(hour.sun), veil)
        for (slide, _), town, ink in zip(BEHIND, self._towns, hour.towns, strict=True):
            shifted = town + np.array(((1.0 - slide) * x, 0.0))
            near = (shifted[:, 0] > seen.left - 40.0) & (shifted[:, 0] < seen.right + 40.0)
            kept = shifted[near]
            if len(kept) > 2:
                outline = np.concatenate([[(kept[0, 0], -2.0)], kept, [(kept[-1, 0], -2.0)]])
                canvas.polygon(outline, fill=color_of(ink))
        self._paint_ground(canvas, hour, sun[0])

    @staticmethod
    def _paint_ground(canvas: Canvas, hour: Hour, sun_x: float) -> None:
        """A field in bands, the nearer the darker, with the light of the sun or the moon on it."""
        seen = canvas.camera.visible()
        near, far = color_of(hour.ground[1]), color_of(hour.ground[0])
        heights = -GROUND_M * np.linspace(0.0, 1.0, GROUND_BANDS + 1) ** 1.6
        heights[-1] = min(seen.bottom, -GROUND_M) - 1.0
        wide = 0.02 * (seen.right - seen.left)
        for k in range(GROUND_BANDS):
            ink = far.lerp(near, k / (GROUND_BANDS - 1.0))
            top, low = float(heights[k]), float(heights[k + 1])
            canvas.polygon(
                [(seen.left, top), (seen.right, top), (seen.right, low), (seen.left, low)], fill=ink
            )
            half = wide * (0.8 + 0.22 * k)
            lit = [(sun_x - half, top), (sun_x + half, top), (sun_x + half + 0.22 * wide, low),
                   (sun_x - half - 0.22 * wide, low)]  # fmt: skip
            canvas.polygon(lit, fill=color_of(hour.sun), fill_alpha=0.12 * (1.0 - k / GROUND_BANDS) ** 2)

    def _facade(self, canvas: Canvas, hour: Hour) -> None:
        """Panes between the floors of storeys that stand."""
        content = self.model.content
        half, boxes, inks = half_width(content), [], []
        for storey in range(1, content.storeys + 1):
            if self.model.frame.storeys.cut[storey - 1] != NOT_YET or self._is_falling(storey):
                continue
            low, high = floor_height(content, storey - 1), floor_height(content, storey) - content.slab
            for k in range(content.bays * PANES):
                left = -half + (k + 0.12) * content.bay / PANES
                right = left + 0.76 * content.bay / PANES
                boxes.append(
                    [(left, low + 0.7), (right, low + 0.7), (right, high - 0.15), (left, high - 0.15)]
                )
                inks.append(hour.glass[1] if (7 * storey + 5 * k) % 11 in (0, 4) else hour.glass[0])
        if boxes:
            paint_quads(canvas, np.array(boxes).reshape(-1, 2), np.array(inks), 0.75, hour.edge)

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
        self._shadow(canvas, points, firsts, hour)
        none = np.zeros((64, 2))
        paint(canvas, points, firsts, inks, np.ones(len(inks)), np.full(len(inks), hour.edge), none)
        flat = np.isin(kinds, FLOORS)
        centre = np.repeat(places[bodies], counts, axis=0)
        lit = centre + (points - centre) * np.array((1.0, 0.9))
        lit[:, 1] += 0.04
        paint(canvas, lit, firsts, np.full(len(inks), 0xFFFFFF), np.where(flat, 0.16, 0.05),
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
        """What the air carries, then puffs."""
        dust, air = self.model.dust.rows, self.model.air.on
        if air:
            sheen = ((0.0, pygame.Color(0, 0, 0)), (1.0, color_of(hour.sheen)))
            canvas.veil(self.model.air.veil(), *self.model.air.box(), color_of(hour.dust[1]), sheen)
            dust = dust[np.floor(997.0 * dust[:, LIFE]) % SPARED == 0.0]  # the same ones in each picture
        draw_dust(canvas, as_seen(dust), hour.dust)

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


def _town(random: np.random.Generator, scale: float) -> Any:
    """Roofs (n, 2) m of a town, from the left to the right."""
    points, x = [], -240.0
    while x < 240.0:
        wide, tall = random.uniform(2.0, 5.5) * scale, random.uniform(2.5, 10.0) * scale
        points += [(x, tall), (x + wide, tall)]
        if random.random() < 0.25:  # a mast
            middle = x + 0.5 * wide
            points[-1:-1] = [(middle - 0.1, tall), (middle, tall + 2.2 * scale), (middle + 0.1, tall)]
        x += wide
        if random.random() < 0.4:
            gap = random.uniform(0.6, 4.0) * scale
            points += [(x, 1.2 * scale), (x + gap, 1.2 * scale)]
            x += gap
    return np.array(points)
