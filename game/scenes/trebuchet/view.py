"""How the trebuchet is drawn: timber, ropes, counterweight, stone, wall, the trail of a shot."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.scenes.trebuchet.machine import BEAM, COCKED, LONG, LOOSE, LOW, PIVOT, SHORT, THROWING, stone_radius
from game.scenes.trebuchet.parameters import TOOLS
from game.scenes.trebuchet.world import TrebuchetState, TrebuchetWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.members.dust import as_seen
from game.worlds.members.solids import turned_between
from game.worlds.painting.boards import (
    WHOLE,
    beams,
    paint_blocks,
    paint_pits,
    paint_quads,
    paint_shadows,
    paint_timber,
    placed,
    rects,
)  # fmt: skip
from game.worlds.painting.dust import draw_dust
from game.worlds.painting.inks import color_of, scaled
from game.worlds.painting.landscape import DUSK, Landscape
from game.worlds.painting.marks import draw_contacts
from game.worlds.painting.spheres import draw_spheres

# by day and late: timber, its lit edge, edge, rope, iron, stone, mortar, light on what faces the sun
TONES = (
    (0x8A6038, 0xC29460, 0x2A1D10, 0xD8C6A0, 0x4C5258, 0xB8AB96, 0x8F836F, 0xFFF0D0),
    (0x6E4A30, 0xE0A468, 0x160E10, 0xC8A884, 0x3A3640, 0x9A8880, 0x4E4248, 0xFFB060),
)
DUST = ((0xF0E0C0, 0xB8A890), (0xFFC890, 0x8A6A66))  # lit and in the shade, by day and late
SPREAD = 2.2  # m: of the frame's legs
STAKES, STAKE_M, FAR_STAKE = 15, 10.0, 50.0  # along the field; m from one to the next, m between tall ones
NUMBERED = 90.0  # design px between stakes that all have their numbers
SHARES = (1.0, 0.93, 1.06, 0.88, 0.98, 1.04)  # of the wall's colour, block after block
# of the castle behind the wall: left, right, top m, beside CASTLE_AT; merlons on top; windows
CASTLE = ((-5.0, 34.0, 4.6), (-7.0, -2.5, 7.6), (7.0, 13.0, 11.6), (3.0, 17.0, 8.6), (30.0, 36.0, 8.4))
CASTLE_AT, CASTLE_INK = 112.0, (0x8A9098, 0x4A3650)
WINDOWS = [
    (x, y, x + 0.25, y + 0.7)
    for x, y in ((-5.0, 5.8), (5.0, 6.4), (9.8, 9.4), (14.6, 6.4), (32.8, 6.6), (9.8, 5.0))
]


class TrebuchetView:
    """Draws a model and its hand."""

    def __init__(self, model: TrebuchetWorld, hand: Hand):
        self.model, self.machine, self.hand = model, model.machine, hand
        self._asked = False  # marks are asked for by key
        self._landscape = Landscape(late=DUSK)

    def legend(self) -> list[tuple[str, str, str]]:
        """What the hand does, and what the marks mean."""
        rows = legend_of(TOOLS, self.model.parameters.tool)
        marks = [("dash:text1", "parabola, without air", ""), ("disc:amber", "contact", "")]
        return [*rows, *marks] if self._asked else rows

    def draw(self, canvas: Canvas, previous: TrebuchetState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        self._landscape.draw(canvas)
        model, late = self.model, is_dark(canvas)
        tones = TONES[late]
        self._draw_castle(canvas, late)
        places, turned = turned_between(model.world, previous and previous.world, alpha)
        self._draw_field(canvas, tones)
        self._draw_wall(canvas, places[model.blocks], turned[model.blocks], tones)
        self._draw_frame(canvas, turned, tones)
        self._draw_arm(canvas, places, turned, tones)
        if model.trail:
            canvas.discs(np.array(model.trail), canvas.px(2.2), "text1", 0.55)
        stones = self.machine.stones
        radii = [stone_radius(1.0 / one) for one in model.world.bodies.inverse_masses[stones].tolist()]
        least, inks = canvas.px(2.4), np.full(len(stones), tones[5], dtype=np.int64)
        draw_spheres(canvas, places[stones], np.maximum(radii, least), turned[stones], inks)
        draw_dust(canvas, as_seen(model.dust.rows), DUST[late], (0.12, 0.08), 40)
        self._landscape.draw_front(canvas)
        self._asked = canvas.asked
        if canvas.marks(False):
            self._draw_marks(canvas)
        if self.hand.point is not None:
            canvas.ring(self.hand.point, 9.0, "amber", 2.0)

    def _draw_castle(self, canvas: Canvas, late: bool) -> None:
        """What the wall is for: towers behind it, lit from the side, and light in their windows."""
        at, ink = np.array((CASTLE_AT, 0.0)), CASTLE_INK[late]
        for left, right, top in CASTLE:
            merlons = np.arange(left, right - 0.4, 1.0).tolist()  # as wide as what is between them
            parts = [(left, 0.0, right, top), *((one, top, one + 0.5, top + 0.7) for one in merlons)]
            edge = [(right - 0.12 * (right - left), 0.0, right, top)]  # the low sun is on the right
            courses = [(left, y, right, y + 0.06) for y in np.arange(1.2, top, 1.2).tolist()]
            paint_quads(canvas, at + rects(parts), ink)
            paint_quads(canvas, at + rects(courses), TONES[late][2], 0.25)
            paint_quads(canvas, at + rects(edge), TONES[late][7], 0.16)
        paint_quads(canvas, at + rects(WINDOWS), 0xFFC060, 0.9 if late else 0.1)

    def _draw_field(self, canvas: Canvas, tones: tuple[int, ...]) -> None:
        """Stakes every ten metres from the axle, with their numbers; those at fifty are taller and banded."""
        far = STAKE_M * np.arange(1.0, STAKES + 1.0)
        tall = np.where(far % FAR_STAKE == 0.0, 1.8, 0.9)
        feet, heads = np.stack([far, 0.0 * far], axis=1), np.stack([far, tall], axis=1)
        paint_timber(canvas, np.stack([feet, heads], axis=1), 0.16, (tones[0], tones[1], tones[2]))
        bands = np.stack([heads - (0.0, 0.3), heads], axis=1)
        paint_quads(canvas, beams(bands, 0.2), tones[3], edges=tones[2])
        apart = STAKE_M * canvas.pixels_per_unit / canvas.k
        for x, (_, high) in zip(far.tolist(), heads.tolist(), strict=True):
            if apart > NUMBERED or x % FAR_STAKE == 0.0:
                canvas.label((x, high), f"{x:.0f} m", "text1", offset=(0.0, -10.0))

    def _draw_wall(self, canvas: Canvas, at: Floats, turn: Floats, tones: tuple[int, ...]) -> None:
        sizes = 0.5 * self.model.sizes
        inks = np.array([scaled(tones[5], SHARES[(5 * k) % 6]) for k in range(len(at))], dtype=np.int64)
        paint_shadows(canvas, placed(WHOLE, sizes, at, turn), tones[2], -1.0)
        paint_blocks(canvas, sizes, at, turn, inks, tones[6])
        paint_pits(canvas, sizes, at, turn, tones[6])
        up = turn[:, 0] > 0.7  # the low sun is on the right
        paint_quads(canvas, placed((0.78, -1.0, 1.0, 1.0), sizes[up], at[up], turn[up]), tones[7], 0.4)

    def _draw_frame(self, canvas: Canvas, turned: Floats, tones: tuple[int, ...]) -> None:
        """Shadow, braces, legs, sill and winch behind the arm; its rope while it holds."""
        x, wood = self.machine.tip[0], (tones[0], tones[1], tones[2])
        shadow = np.array([(x - 2.0, 0.0), (SPREAD + 0.4, 0.0), (SPREAD - 0.6, -0.35), (x - 1.0, -0.35)])
        canvas.polygon(shadow, fill=color_of(tones[2]), fill_alpha=0.3)
        legs = np.array([[(k * SPREAD, 0.0), (0.12 * k, PIVOT + 0.15)] for k in (-1.0, 1.0, -0.55, 0.55)])
        brace = np.array([[(-0.62 * SPREAD, 1.35), (0.62 * SPREAD, 1.35)]])
        sill = np.array([[(1.15 * x, 0.12), (SPREAD + 0.8, 0.12)], [(x, 0.12), (x, LOW)]])
        for ends, breadth in ((brace, 0.2), (legs[2:], 0.2), (sill, 0.24), (legs[:2], 0.3)):
            paint_timber(canvas, ends, breadth, wood)
        canvas.circle((x, 0.35), 0.3, color_of(tones[0]), outline=color_of(tones[2]), width=1.2)
        if self.machine.phase not in (LOOSE, THROWING):
            c, s = turned[self.machine.arm].tolist()
            canvas.line((x, 0.35), (LONG * c, PIVOT + LONG * s), color_of(tones[3]), 2.4)

    def _draw_arm(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        """The weight on its hinge, the beam, the sling."""
        machine, (c, s) = self.machine, turned[self.machine.arm].tolist()
        hinge, tip = (np.array((far * c, PIVOT + far * s)) for far in (-SHORT, LONG))
        at, turn, half = places[machine.weight], turned[machine.weight], 0.5 * machine.side
        up = half * np.array((-turn[1], turn[0]))
        straps = np.array([[hinge, at + up + side * 0.7 * half * turn] for side in (-1.0, 1.0)])
        paint_quads(canvas, beams(straps, 0.09), tones[4], edges=tones[2])
        for low, high, ink in ((-1.0, 1.0, 0.8), (-0.92, -0.4, 1.0), (-0.3, 0.22, 1.0), (0.32, 0.86, 1.0)):
            plank = placed((-ink, low, ink, high), np.full((1, 2), half), at[None], turn[None])
            paint_quads(canvas, plank, scaled(tones[0], ink), edges=tones[2])
        beam = np.array([[hinge - 0.2 * turned[machine.arm], tip]])
        paint_timber(canvas, beam, BEAM, (tones[0], tones[1], tones[2]))
        for place, radius in (((0.0, PIVOT), 0.2), ((float(hinge[0]), float(hinge[1])), 0.13)):
            canvas.circle(place, radius, color_of(tones[4]), outline=color_of(tones[2]), width=1.2)
        held = [machine.stones[-1]] if machine.phase in (COCKED, THROWING) else []
        line = np.concatenate([tip[None], places[[*machine.links, *held]]])
        canvas.polyline(line, color_of(tones[2]), 3.6, alpha=0.6)
        canvas.polyline(line, color_of(tones[3]), 2.2)

    def _draw_marks(self, canvas: Canvas) -> None:
        """Contacts, the stone's velocity, and the parabola that began as the stone did."""
        model, shot, gravity = self.model, self.machine.shot, self.model.gravity()
        draw_contacts(canvas, model.world, 2.2)
        (x, y), (vx, vy) = (rows[self.machine.stones[-1]].tolist() for rows in model.world.bodies[:4:3])
        canvas.arrow((x, y), (vx, vy), "chalk", "v", 0.2)
        if shot is not None and model.trail:
            t = np.linspace(0.0, 10.0, 200)
            curve = np.stack([shot.x + shot.vx * t, shot.y + t * (shot.vy - 0.5 * gravity * t)], axis=1)
            canvas.polyline(curve[curve[:, 1] > 0.0], "text1", 1.6, dash=EXACT_DASH)
