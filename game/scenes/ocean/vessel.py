"""How the boat is drawn: its hull in space, heeled and pitched as it is, cabin, spars, sail, helmsman."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats
from game.scenes.ocean.boat import CORNERS, HEEL, MAST, PITCHED, SWUNG, UP, Boat
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.inks import channels, color_of, packed
from game.worlds.painting.sea.cuts import Light, projected

ANTIFOUL, TOPSIDE, STRIPE, DECK, KEEL = 0x8E3A2C, 0xF1EADB, 0x2C5E7A, 0xC69A62, 0x3A3E44
CLOTH, SEAM, SPAR, CABIN, GLASS, ROPE = 0xB9552C, 0x7E3419, 0xC8964E, 0xEFE6D2, 0x32505E, 0xD8CBB0
OILSKIN, FACE, FLAG = 0xE0A81E, 0xC98F6C, 0xC8352B
KEEL_SIDE = np.array([(-1.3, -0.35, 0.0), (1.2, -0.4, 0.0), (0.6, -1.2, 0.0), (-0.9, -1.2, 0.0)])
# cabin: x, y, z of a box's corners in the boat's frame, m
CABIN_LOW, CABIN_HIGH = (-0.6, 0.62, -0.72), (1.7, 1.12, 0.72)
MAST_TOP = 6.9
SUN_SHARE = 0.55
BOOT, BELOW = 0.05, 6  # m over the drawn water line to which the hull is red; rows of its skin below


class Vessel:
    """Draws a boat: points of its own frame, x m before amidships, y over the drawn water line, z to
    leeward."""

    def __init__(self, boat: Boat):
        self.boat = boat
        x = boat.hull.stations + boat.middle_x
        half, draft, free = (boat.ends[:, k, None] for k in range(3))
        low = -draft + (draft + BOOT) * np.linspace(0.0, 1.0, BELOW) ** 2
        high = BOOT + (free - BOOT) * np.array(((0.33, 0.66, 0.7, 0.93, 1.0),))
        y = np.concatenate([low, high], axis=1)
        share = np.sqrt(np.clip((y + draft) / (draft + free), 0.0, 1.0))
        z = half * (1.0 - (1.0 - share) ** 2)  # as `rounded_sections` has them
        along = np.broadcast_to(x[:, None], y.shape)
        side = np.stack([along, y, -z], axis=2)
        self.skin = np.concatenate([side, side[:, ::-1] * np.array((1.0, 1.0, -1.0))], axis=1)  # (n, p, 3)
        one, other = self.skin[:-1], self.skin[1:]
        self.quads: Floats = np.stack([one[:, :-1], one[:, 1:], other[:, 1:], other[:, :-1]], axis=2).reshape(
            -1, 4, 3
        )
        bands = [ANTIFOUL] * (BELOW - 1) + [TOPSIDE] * 3 + [STRIPE, TOPSIDE]
        row = channels(np.array([*bands, DECK, *bands[::-1]]))
        self.inks = np.tile(row, (len(x) - 1, 1))

    # -- places -----------------------------------------------------------------------------------------

    def pose(self, previous: Any, alpha: float) -> tuple[float, float, float, float]:
        """Height, pitch, heel and swing of the boom between two steps."""
        now = self.boat.pose
        before = previous.pose if previous is not None else now
        mixed = before + alpha * (now - before)
        return tuple(float(mixed[k]) for k in (UP, PITCHED, HEEL, SWUNG))  # type: ignore[return-value]

    def place(self, points: Floats, pose: tuple[float, float, float, float]) -> Floats:
        """Points (..., 3) of the boat as they stand over the sea: x, y, z m."""
        up, pitch, heel, _ = pose
        x, y, z = points[..., 0] - self.boat.middle_x, points[..., 1] - self.boat.middle_y, points[..., 2]
        c, s = math.cos(heel), math.sin(heel)
        across, high = z * c + y * s, y * c - z * s
        tc, ts = math.cos(pitch), math.sin(pitch)
        return np.stack([x * tc - high * ts, up + x * ts + high * tc, across], axis=-1)

    # -- drawing ----------------------------------------------------------------------------------------

    def draw(
        self, canvas: Canvas, eye: float, pose: tuple[float, float, float, float], light: Light, air: Any
    ) -> None:
        """All of it; what is farther first. air: m/s of the wind along and across."""
        self._eye, self._light = eye, light
        # heeled away, its near side hides what stands on deck; swung out to leeward, the sail is behind all
        body = [self._cabin, self._hull] if math.sin(pose[2]) > 0.0 else [self._hull, self._cabin]
        parts = [self._keel, self._rig, *body] if pose[3] >= 0.0 else [self._keel, *body, self._rig]
        for part in parts:
            part(canvas, pose, air)

    def _seen(self, points: Floats) -> Floats:
        return np.asarray(projected(self._eye, points[..., 0], points[..., 1], points[..., 2]))

    def _paint(
        self, canvas: Canvas, quads: Floats, colors: Floats, both: bool = False, sort: bool = True
    ) -> None:
        """Quadrangles (n, 4, 3) m over the sea, colours (n, 3); those that look away only if ``both``."""
        normal = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
        normal /= np.maximum(np.sqrt(np.sum(normal * normal, axis=1)), 1e-9)[:, None]
        looks = normal[:, 2] < 0.02
        if both:
            normal = np.where(looks[:, None], normal, -normal)
        else:
            quads, colors, normal = quads[looks], colors[looks], normal[looks]
        if not len(quads):
            return
        to = self._light.to
        sun = np.clip(normal[:, 0] * to[0] + normal[:, 1] * to[1] - 0.35 * normal[:, 2], 0.0, 1.0)
        sky = 0.5 + 0.5 * normal[:, 1]
        shade = 0.42 + 0.3 * sky + SUN_SHARE * sun * min(self._light.glint, 1.0)
        tint = np.array(self._light.sun) / max(max(self._light.sun), 1.0) * 0.35 + 0.65
        inks = packed(np.clip(colors * shade[:, None] * tint, 0.0, 255.0))
        order = np.argsort(-quads[:, :, 2].mean(axis=1), kind="stable") if sort else slice(None)
        paint_quads(canvas, self._seen(quads[order]).reshape(-1, 2), inks[order], edges=inks[order])

    def _hull(self, canvas: Canvas, pose: Any, air: Any) -> None:
        self._paint(canvas, self.place(self.quads, pose), self.inks)

    def _keel(self, canvas: Canvas, pose: Any, air: Any) -> None:
        canvas.polygon(self._seen(self.place(KEEL_SIDE, pose)), color_of(KEEL))
        rudder = np.array([(-3.55, 0.5, 0.0), (-3.9, 0.45, 0.0), (-3.95, -0.75, 0.0), (-3.5, -0.7, 0.0)])
        canvas.polygon(self._seen(self.place(rudder, pose)), color_of(0x6E4A2C))

    def _cabin(self, canvas: Canvas, pose: Any, air: Any) -> None:
        (x0, y0, z0), (x1, y1, z1) = CABIN_LOW, CABIN_HIGH
        corner = np.array([[x, y, z] for x in (x0, x1 - 0.15) for y in (y0, y1) for z in (z0, z1)])
        faces = corner[[(0, 4, 6, 2), (1, 3, 7, 5), (2, 6, 7, 3), (4, 5, 7, 6), (0, 2, 3, 1)]]
        self._paint(canvas, self.place(faces, pose), np.tile(channels(CABIN), (5, 1)))
        panes = np.array(
            [
                [(x, 0.8, z0), (x + 0.34, 0.8, z0), (x + 0.34, 0.99, z0), (x, 0.99, z0)]
                for x in (-0.35, 0.3, 0.95)
            ]
        )
        self._paint(canvas, self.place(panes, pose), np.tile(channels(GLASS), (3, 1)))
        self._sit(canvas, pose)

    def _sit(self, canvas: Canvas, pose: Any) -> None:
        """The helmsman, on the windward side."""
        body = np.array([(-2.55, 0.75, -0.5), (-2.2, 0.75, -0.5), (-2.2, 1.4, -0.62), (-2.5, 1.42, -0.62)])
        arm = np.array([(-2.45, 1.3, -0.6), (-3.0, 1.05, -0.3)])
        at, scale = self.place(body, pose), canvas.pixels_per_unit / canvas.k
        canvas.polygon(self._seen(at), color_of(OILSKIN), outline=color_of(0x8E6A12), width=1.0)
        canvas.polyline(self._seen(self.place(arm, pose)), color_of(0xC8951A), 0.12 * scale)
        head = self._seen(self.place(np.array([[-2.34, 1.58, -0.64], [-2.36, 1.66, -0.64]]), pose))
        canvas.circle(tuple(head[0]), 0.14, color_of(FACE))
        canvas.circle(tuple(head[1]), 0.13, color_of(OILSKIN))

    def _rig(self, canvas: Canvas, pose: Any, air: Any) -> None:
        """Mast, boom, gaff, sail, sheet and flag."""
        scale, swing = canvas.pixels_per_unit / canvas.k, pose[3]

        def out(u: float, y: float) -> tuple[float, float, float]:
            return MAST - u * math.cos(swing), y, u * math.sin(swing)

        def spar(one: Any, other: Any, wide: float, ink: int = SPAR) -> None:
            ends = self._seen(self.place(np.array((one, other)), pose))
            canvas.polyline(ends, color_of(0x5E4020), (wide + 0.03) * scale)
            canvas.polyline(ends, color_of(ink), wide * scale)

        stay = self._seen(self.place(np.array(((MAST, MAST_TOP - 0.3, 0.0), (3.55, 1.25, 0.0))), pose))
        canvas.polyline(stay, color_of(ROPE), 0.025 * scale)
        spar((MAST, 0.7, 0.0), (MAST, MAST_TOP, 0.0), 0.15)
        self._sail(canvas, pose)
        (_, tack), (_, throat), (peak_u, peak_y), (clew_u, clew_y) = CORNERS.tolist()
        spar(out(0.0, tack - 0.15), out(clew_u + 0.15, clew_y - 0.15), 0.11)
        spar(out(0.0, throat), out(peak_u + 0.12, peak_y + 0.1), 0.09)
        sheet = np.array((out(clew_u - 0.3, clew_y - 0.1), (-3.3, 0.85, 0.0)))
        canvas.polyline(self._seen(self.place(sheet, pose)), color_of(ROPE), 0.03 * scale)
        halyard = np.array((out(0.6 * peak_u, throat + 0.6 * (peak_y - throat)), (MAST, MAST_TOP - 0.1, 0.0)))
        canvas.polyline(self._seen(self.place(halyard, pose)), color_of(ROPE), 0.025 * scale)
        self._fly(canvas, pose, air)

    def _fly(self, canvas: Canvas, pose: Any, air: Any) -> None:
        """A flag at the masthead, with the wind."""
        at = self.place(np.array((MAST, MAST_TOP, 0.0)), pose)
        strong = math.hypot(*air)
        share = min(strong / 5.0, 1.0)
        time = self.boat.time
        points = []
        for k in range(7):
            far = 0.16 * k
            wave = 0.05 * k / 6.0 * math.sin(9.0 * time - 1.1 * k)
            x = at[0] + far * share * air[0] / max(strong, 0.1)
            z = at[2] + far * share * air[1] / max(strong, 0.1)
            points.append((x, at[1] - 0.12 - far * (1.0 - share) + wave * share, z))
        middle = np.array(points)
        drop = np.array((0.0, 0.13, 0.0)) * (1.0 - np.arange(7) / 8.0)[:, None]
        canvas.polygon(self._seen(np.concatenate([middle + drop, (middle - drop)[::-1]])), color_of(FLAG))

    def _sail(self, canvas: Canvas, pose: Any) -> None:
        nodes = self.boat.sail.nodes[:3]
        points = np.moveaxis(nodes, 0, 2) + np.array((MAST, 0.0, 0.0))
        placed = self.place(points, pose)
        quads = np.stack(
            [placed[:-1, :-1], placed[:-1, 1:], placed[1:, 1:], placed[1:, :-1]], axis=2
        ).reshape(-1, 4, 3)
        colors = np.tile(channels(CLOTH), (len(quads), 1))
        columns = placed.shape[1] - 1
        colors *= np.where(np.arange(len(quads)) % columns % 3 == 2, 0.92, 1.0)[
            :, None
        ]  # panels of the cloth
        self._paint(canvas, quads, colors, both=True)
        edge = np.concatenate([placed[0], placed[:, -1], placed[-1, ::-1]])
        canvas.polyline(self._seen(edge), color_of(SEAM), 1.4)
        for row in (-4, -7):
            reefs = self._seen(placed[row, 1:-1])
            canvas.segments(reefs, reefs - np.array((0.0, 0.16)), color_of(ROPE), 1.2)
