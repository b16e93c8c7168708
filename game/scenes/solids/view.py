"""How solids are drawn: shaded bodies, joints, and what teaches: contacts, forces, islands."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pygame

from game.arrays import Floats, Longs
from game.physics.solids.arrays.layout import HERTZ, JOINT_NAMES, LENGTH
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC
from game.scenes.solids.bodies import COLOURS, place_of, whole_joints
from game.scenes.solids.cutting import Outlines, outlines_of
from game.scenes.solids.hand import LINKERS, NOBODY, SolidHand
from game.scenes.solids.level import Point
from game.scenes.solids.measures import contact_points, islands
from game.scenes.solids.model import ModelState, SolidModel
from game.scenes.solids.parameters import TOOLS
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.worlds.hands.hand import legend_of
from game.worlds.members.solids import bodies_between
from game.worlds.painting.inks import mixed, shaded
from game.worlds.painting.polygons import NO_EDGE, paint

SOLID = {"wood": "B98955", "stone": "A3A29B", "steel": "8096A6", "brass": "BFA15A"}  # the same in both themes
LIGHT = np.array([-0.45, 0.89])  # where light comes from
MOST_BEVELLED = 700  # polygons; more are too small to show it
ASLEEP_SHARE = 0.5
FORCE_LENGTH = 0.12  # of the height in view, for the largest force


class SolidView:
    """Draws a model and its hand; keeps outlines until shapes come or go."""

    def __init__(self, model: SolidModel, hand: SolidHand):
        self.model, self.hand = model, hand
        self._of: bytes = b""
        self._outlines: Outlines | None = None

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean, and what the tool in the hand does next."""
        parameters, rows = self.model.parameters, []
        if parameters.contacts:
            rows.append(("disc:amber", "contact", ""))
        if parameters.forces:
            rows.append(("line:amber", "force of a contact", ""))
        if parameters.loads:
            rows.append(("line:vermilion", "force of a joint", ""))
        if parameters.islands:
            rows.append(("dash:green", "island", ""))
        return [*rows, *legend_of(TOOLS, parameters.tool)]

    def draw(self, canvas: Canvas, previous: ModelState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        canvas.grid(None, "y")
        self._draw_ground(canvas)
        self.draw_bodies(canvas, previous, alpha)
        self._draw_joints(canvas)
        self._draw_marks(canvas)
        self._draw_inspected(canvas)
        self._draw_hand(canvas)

    def draw_bodies(
        self, canvas: Canvas, previous: ModelState | None, alpha: float, offset: Point = (0.0, 0.0)
    ) -> None:
        """Bodies alone, moved by an offset m."""
        places, angles = bodies_between(self.model.world, previous and previous.world, alpha)
        places = places + np.array(offset)
        outlines = self._shapes()
        turned = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        self._draw_polygons(canvas, outlines, places, turned)
        self._draw_discs(canvas, outlines, places, turned)
        self._draw_segments(canvas, outlines, places, turned)

    # -- bodies ---------------------------------------------------------------------------------------

    def _shapes(self) -> Outlines:
        """Made again when shapes have come or gone."""
        shapes = self.model.world.shapes
        now = shapes.kinds.tobytes() + shapes.starts.tobytes() + shapes.bodies.tobytes()
        if self._outlines is None or now != self._of:
            hidden = np.isin(shapes.bodies, [0, *self.model.floors])
            kinds = np.where(hidden, -1, shapes.kinds)
            self._outlines, self._of = outlines_of(shapes._replace(kinds=kinds), self.model.world.pool), now
        return self._outlines

    def _inks(self, canvas: Canvas) -> tuple[Longs, Floats]:
        """Colour and opacity of each body's fill."""
        table = np.array([canvas.ink(_fill(canvas, name)) for name in COLOURS], dtype=np.int64)
        flags = self.model.world.bodies.flags
        inks = table[np.minimum(self.model.tints.rows[: len(flags)] & 255, len(COLOURS) - 1)]
        fixed = flags & DYNAMIC == 0
        inks[fixed & (inks == table[0])] = canvas.ink("body")
        shares = np.where(flags & ASLEEP != 0, ASLEEP_SHARE, 1.0)
        return inks, shares

    def _draw_polygons(self, canvas: Canvas, shapes: Outlines, places: Floats, turned: Floats) -> None:
        count = len(shapes.starts) - 1
        if not count:
            return
        inks, shares = self._inks(canvas)
        owners = shapes.owners[shapes.starts[:-1]]
        corners = _moved(shapes.corners, shapes.owners, places, turned)
        own, opacity = inks[owners], shares[owners]
        edges = np.where(opacity < 1.0, NO_EDGE, shaded(own, -0.42))
        paint(canvas, corners, shapes.starts, own, opacity, edges, np.zeros((len(corners), 2)))
        if count > MOST_BEVELLED:
            return
        inside = _moved(shapes.bevels, shapes.owners, places, turned)
        c, s = turned[shapes.owners, 0], turned[shapes.owners, 1]
        normals = shapes.normals
        facing = (c * normals[:, 0] - s * normals[:, 1]) * LIGHT[0] + (
            s * normals[:, 0] + c * normals[:, 1]
        ) * LIGHT[1]
        after = np.arange(len(corners)) + 1
        after[shapes.starts[1:] - 1] = shapes.starts[:-1]
        quads = np.stack([corners, corners[after], inside[after], inside], axis=1).reshape(-1, 2)
        starts = np.arange(0, len(quads) + 1, 4)
        none = np.full(len(corners), NO_EDGE, dtype=np.int64)
        tones = shaded(inks[shapes.owners], 0.24 * facing)
        paint(canvas, quads, starts, tones, shares[shapes.owners], none, np.zeros((4, 2)))

    def _draw_discs(self, canvas: Canvas, shapes: Outlines, places: Floats, turned: Floats) -> None:
        """A dark rim, the fill, a lighter cap towards the light, and the line of a radius."""
        if not len(shapes.radii):
            return
        inks, shares = self._inks(canvas)
        owners, radii = shapes.disc_owners, shapes.radii
        centres = _moved(shapes.centres, owners, places, turned)
        flat = canvas.ink("stage")
        own = mixed(inks[owners], flat, 1.0 - shares[owners])
        rim = canvas.px(0.9)
        canvas.discs(centres, radii + rim, shaded(own, -0.42).astype(np.uint32))
        canvas.discs(centres, radii, own.astype(np.uint32))
        canvas.discs(centres + 0.12 * radii[:, None] * LIGHT, 0.8 * radii,
                     shaded(own, 0.10).astype(np.uint32))  # fmt: skip
        seen = radii * canvas.pixels_per_unit > 4.0
        rims = centres + radii[:, None] * turned[owners]
        dynamic = seen & (self.model.world.bodies.flags[owners] & DYNAMIC != 0)
        if dynamic.any():
            dark = shaded(own[dynamic], -0.5).astype(np.uint32)
            canvas.segments(centres[dynamic], rims[dynamic], dark, 1.4)

    def _draw_segments(self, canvas: Canvas, shapes: Outlines, places: Floats, turned: Floats) -> None:
        if len(shapes.ends):
            a = _moved(shapes.ends[:, 0], shapes.end_owners, places, turned)
            b = _moved(shapes.ends[:, 1], shapes.end_owners, places, turned)
            canvas.segments(a, b, "text2", 2.4)

    def _draw_ground(self, canvas: Canvas) -> None:
        content = self.model.content
        if content.floor is not None:
            canvas.ground(content.floor)
        if content.walls is not None:
            seen = canvas.camera.visible()
            for x, side in zip(content.walls, (seen.left, seen.right), strict=True):
                base = content.floor if content.floor is not None else seen.bottom
                corners = ((x, base), (side, base), (side, seen.top), (x, seen.top))
                if (x - side) * (content.walls[0] - content.walls[1]) * (
                    1 if side == seen.left else -1
                ) < 0.0:
                    canvas.polygon(np.array(corners), fill="body", fill_alpha=0.75)
                canvas.line((x, base), (x, seen.top), "line2", 1.0)

    # -- joints ---------------------------------------------------------------------------------------

    def _draw_joints(self, canvas: Canvas) -> None:
        world = self.model.world
        pins: list[Point] = []
        for joint in whole_joints(world):
            kind = JOINT_NAMES[int(world.joints.kinds[joint])]
            a, b = place_of(world, joint, 0), place_of(world, joint, 1)
            if kind == "spring" or (kind == "distance" and world.joints.parameters[joint, HERTZ] > 0.0):
                canvas.polyline(_coil(a, b, canvas.px(5.0)), "text2", 1.5)
            elif kind == "rope":
                rest = float(world.joints.parameters[joint, LENGTH])
                canvas.polyline(_slack(a, b, rest), "text2", 1.6)
            elif kind in ("distance", "slider"):
                canvas.line(a, b, "text2", 1.6)
            elif kind == "weld":
                self._cross(canvas, a)
                continue
            if kind == "motor":
                canvas.ring(a, 7.0, "text1", 2.0)
            pins += [a] if kind in ("pin", "motor") else [a, b]
        if len(pins) <= 400:
            for place in pins:
                canvas.dot(place, 2.6, "stage")
                canvas.ring(place, 2.6, "text1", 1.2)
        if self.model.parameters.loads:
            self._draw_loads(canvas)

    def _cross(self, canvas: Canvas, place: Point) -> None:
        (x, y), r = place, canvas.px(4.0)
        canvas.line((x - r, y - r), (x + r, y + r), "text1", 1.8)
        canvas.line((x - r, y + r), (x + r, y - r), "text1", 1.8)

    def _draw_loads(self, canvas: Canvas) -> None:
        world = self.model.world
        joints = whole_joints(world)
        loads = [world.joint_load(joint)[0] for joint in joints]
        most = max(loads, default=0.0)
        if most <= 0.0:
            return
        for joint, load in zip(joints, loads, strict=True):
            place = place_of(world, joint, 0)
            canvas.ring(place, 4.0 + 12.0 * load / most, "vermilion", 1.6)
        if len(joints) <= 12:
            for joint, load in zip(joints, loads, strict=True):
                words = canvas.figure(("load", joint), f"{load:.3g} N")
                at = place_of(world, joint, 0)
                canvas.label(at, words, "vermilion", 12, "semibold", "left", (18.0, -8.0), clear=True)

    # -- what teaches -----------------------------------------------------------------------------------

    def _draw_marks(self, canvas: Canvas) -> None:
        parameters = self.model.parameters
        if parameters.islands:
            self._draw_islands(canvas)
        if not (parameters.contacts or parameters.forces):
            return
        points = contact_points(self.model.world)
        if parameters.contacts:
            canvas.discs(points.places, canvas.px(3.0), "amber")
        most = float(points.pushes.max(initial=0.0))
        if parameters.forces and most > 0.0:
            view = self.model.content.view
            reach = FORCE_LENGTH * (view.top - view.bottom) * points.pushes / most
            along = points.normals * reach[:, None]
            canvas.segments(points.places - 0.5 * along, points.places + 0.5 * along, "amber", 2.0)

    def _draw_islands(self, canvas: Canvas) -> None:
        """A dashed box round each island of more than one body."""
        names, rows = islands(self.model.world), self.model.world.bodies
        for name in np.unique(names[names >= 0]).tolist():
            mine = np.flatnonzero(names == name)
            if len(mine) < 2:
                continue
            places, reach = rows.positions[mine], rows.reaches[mine][:, None]
            (x0, y0), (x1, y1) = (places - reach).min(axis=0), (places + reach).max(axis=0)
            color = "text3" if rows.flags[mine[0]] & ASLEEP else "green"
            box = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
            canvas.polygon(box, outline=color, width=1.2, dash=(6.0, 5.0))

    def _draw_inspected(self, canvas: Canvas) -> None:
        """A dashed ring about the body or the joint whose card is open."""
        if (joint := self.hand.shown_joint) != NOBODY:
            for end in (0, 1):
                place = place_of(self.model.world, joint, end)
                canvas.circle(place, canvas.px(9.0), outline="accent", width=1.6, dash=(5.0, 4.0))
        body = self.hand.inspected
        if body != NOBODY and body in self.model.movable():
            place, reach = self.model.world.bodies.positions[body], self.model.world.bodies.reaches[body]
            canvas.circle(place, float(reach) + canvas.px(4.0), outline="accent", width=1.6, dash=(5.0, 4.0))

    def _draw_hand(self, canvas: Canvas) -> None:
        hand, world = self.hand, self.model.world
        start, point = hand.start, hand.point
        if start is None or point is None:
            return
        if hand.holding:
            held = place_of(world, hand.grip, 1)
            canvas.line(held, point, "amber", 1.4, dash=PREDICTION_DASH)
            canvas.dot(held, 4.5, "amber")
        elif hand.verb == "throw" and hand.held != NOBODY:
            canvas.line(start, point, "amber", 1.4, dash=PREDICTION_DASH)
            canvas.arrow(start, (start[0] - point[0], start[1] - point[1]), "chalk", "v")
        elif hand.verb == "cut":
            canvas.line(start, point, "vermilion", 1.8, dash=PREDICTION_DASH)
        elif hand.verb == "outline" and len(hand.path) > 1:
            canvas.polyline(np.array(hand.path), "accent", 2.0)
            canvas.line(hand.path[-1], hand.path[0], "accent", 1.0, dash=PREDICTION_DASH)
        elif hand.verb in LINKERS or hand.verb in ("capsule", "duplicate"):
            canvas.line(start, point, "accent", 1.8, dash=PREDICTION_DASH)
        elif hand.verb in ("disc", "polygon"):
            canvas.circle(start, math.dist(start, point), outline="accent", width=1.8, dash=PREDICTION_DASH)
        elif hand.verb == "box":
            box = np.array([start, (point[0], start[1]), point, (start[0], point[1])])
            canvas.polygon(box, outline="accent", width=1.8, dash=PREDICTION_DASH)


def _fill(canvas: Canvas, name: str) -> Any:
    """The colour of a body: materials as they are, others mixed with the ground they lie on."""
    if name in SOLID:
        return pygame.Color(f"#{SOLID[name]}")
    if name == "plain":
        return canvas.color("ghost").lerp(canvas.color("body"), 0.45)
    return canvas.color(name).lerp(canvas.color("body"), 0.3)


def _moved(points: Floats, owners: Longs, places: Floats, turned: Floats) -> Floats:
    """Points (v, 2) in the frames of their bodies, in the world."""
    c, s = turned[owners, 0], turned[owners, 1]
    x, y = points[:, 0], points[:, 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=1) + places[owners]


def _coil(a: Point, b: Point, breadth: float, turns: int = 10) -> Floats:
    """A spring from a to b."""
    way = np.array(b) - np.array(a)
    length = float(np.hypot(*way))
    if length == 0.0:
        return np.array([a, b])
    across = np.array([-way[1], way[0]]) / length * breadth
    steps = np.concatenate([[0.0, 0.12], np.linspace(0.12, 0.88, 2 * turns + 2)[1:-1], [0.88, 1.0]])
    sides = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * turns) % 2 == 0, 1.0, -1.0), [0.0, 0.0]])
    return np.array(a) + steps[:, None] * way + sides[:, None] * across


def _slack(a: Point, b: Point, rest: float) -> Floats:
    """A rope from a to b: it sags by what is left of its length."""
    t = np.linspace(0.0, 1.0, 17)
    apart = math.dist(a, b)
    sag = math.sqrt(max(0.375 * apart * max(rest - apart, 0.0), 0.0)) if apart > 0.0 else 0.5 * rest
    points = np.array(a) + t[:, None] * (np.array(b) - np.array(a))
    points[:, 1] -= 4.0 * sag * t * (1.0 - t)
    return points
