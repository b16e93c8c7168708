"""How the marble run is drawn: wall, tracks, what stands and hangs, balls, the basin; and what teaches."""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.arrays import Floats
from game.physics.solids.tracks import DISC
from game.physics.solids.tracks.curves import Pieces
from game.physics.solids.tracks.descent import loop_drop
from game.physics.solids.tracks.motion import RADIUS, VX, VY
from game.scenes.metal.balls import NONE, NOT_YET
from game.scenes.metal.gauges import VALUE
from game.scenes.metal.level import MetalContent
from game.scenes.metal.making import LEDGE, cradle_places
from game.scenes.metal.parameters import TOOLS
from game.scenes.metal.told import exact_now
from game.scenes.metal.world import MetalState, MetalWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.painters.steel import draw_steel
from game.ui.painters.wall import LAMPS, Wall, is_dark
from game.worlds.entries.tracks import curve_of
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.hands.marks import draw_track_hand
from game.worlds.members.solids import bodies_between
from game.worlds.members.tracks import balls_between
from game.worlds.painting.boards import WHOLE, boards_of, moved, paint_quads, paint_shapes, placed
from game.worlds.painting.inks import color_of, scaled
from game.worlds.painting.marks import draw_contacts, draw_velocities
from game.worlds.painting.rails import Rail, draw_rail_shadows, draw_rails, rails_of

TOP_EDGE, LOW_EDGE = (-1.0, 0.72, 1.0, 1.0), (-1.0, -1.0, 1.0, -0.78)
CAST = np.array((0.11, -0.15))  # m: where the shadow on the wall lies
SHADOW, BLACK = 0x000000, pygame.Color(0, 0, 0)
GATES = 0xD0763C
LAMPS_AT = np.array(LAMPS)  # m
BELOW = 0.3  # m: the bench is so far below a track
CUP = (math.radians(-160.0), math.radians(-20.0))  # rad: what a holder covers of a ball
BLOCKS = (0xC7703F, 0xD9A24B, 0x7E9B58, 0x4F86A6, 0xA86A7F)
# by day and at night: wood, its lit edge, dark wood, felt, steel of floors and its edge
MADE = {
    False: (0xC08E5C, 0xE3BC88, 0x7A5738, 0x4F7D63, 0x98A1A8, 0xE6EBEE),
    True: (0x7E5839, 0xAE8358, 0x46301F, 0x2F5444, 0x59646E, 0xA9B6C0),
}


class MetalView:
    """Draws a model and its hand; keeps the lines of tracks until these change."""

    def __init__(self, model: MetalWorld, hand: Hand):
        self.model, self.hand = model, hand
        self._asked = False  # marks are asked for by key
        self._wall = Wall(bench_of(model.content))
        self._of: Pieces | None = None
        self._rails: list[Rail] = []
        floors = model.content.floors
        self._floors = [
            (entry.made_of, boards_of(np.array(entry.points), entry.thick),
             boards_of(np.array(entry.points), min(0.3 * entry.thick, 0.04)))
            for entry in floors
        ]  # fmt: skip

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean, and what the tool in the hand does next."""
        rows = []
        if self.model.parameters.marks or self._asked:
            rows = [
                ("disc:amber", "contact", ""),
                ("line:chalk", "velocity", ""),
                ("dash:text1", "exact", ""),
            ]
        tool = self.model.parameters.tool
        return [*rows, *legend_of(TOOLS, tool)] if tool != "hand" else rows

    def draw(self, canvas: Canvas, previous: MetalState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        dark = is_dark(canvas)
        self._wall.draw(canvas, dark)
        balls, riders = self.model.balls, self.model.tracks.riders
        places, angles = balls_between(balls.rows, previous and previous.riders.rows, alpha)
        bodies, turns = bodies_between(self.model.world, previous and previous.world, alpha)
        turned = np.stack([np.cos(turns), np.sin(turns)], axis=1)
        radii, there = balls.rows[:, RADIUS], balls.there()
        if self._of is not riders.pieces:
            self._of, self._rails = riders.pieces, rails_of(riders.pieces, riders.curves)
        strength = 0.34 if dark else 0.2
        self._draw_shadows(canvas, places[there], radii[there], bodies, turned, strength)
        self._draw_cradles(canvas, places, dark)
        self._draw_floors(canvas, dark, glass=False)
        draw_rails(canvas, self._rails, dark)
        self._draw_blocks(canvas, bodies, turned, dark)
        self._draw_seesaws(canvas, bodies, turned, dark)
        self._draw_plugs(canvas, dark)
        self._draw_holders(canvas, places)
        draw_steel(canvas, places[there], radii[there], angles[there], LAMPS_AT, dark)
        self._draw_floors(canvas, dark, glass=True)
        self._asked = canvas.asked
        if canvas.marks(self.model.parameters.marks):
            draw_marks(canvas, self.model, places)
        draw_track_hand(canvas, self.hand, 2.4)

    # -- painting -------------------------------------------------------------------------------------

    def _draw_shadows(
        self, canvas: Canvas, places: Floats, radii: Floats, bodies: Floats, turned: Floats, strength: float
    ) -> None:
        """What all things cast on the wall, away from the lamps."""
        model = self.model
        for made_of, whole, _ in self._floors:
            paint_shapes(
                canvas, moved(whole, CAST), SHADOW, 0.3 * strength if made_of == "glass" else strength
            )
        draw_rail_shadows(canvas, self._rails, CAST, strength)
        if model.block_ids:
            paint_quads(canvas, self._block_corners(bodies, turned) + CAST, SHADOW, strength)
        for entry, body in zip(model.content.seesaws, model.seesaw_ids, strict=True):
            sizes = 0.5 * np.array([[entry.length, entry.thickness]])
            at = np.array([entry.at])
            paint_quads(canvas, placed(WHOLE, sizes, at, turned[body : body + 1]) + CAST, SHADOW, strength)
        if len(places):
            canvas.discs(places + CAST, 1.06 * radii, BLACK, 0.55 * strength)
            canvas.discs(places + CAST, 0.92 * radii, BLACK, 0.7 * strength)

    def _block_corners(self, bodies: Floats, turned: Floats, part: tuple[float, ...] = WHOLE) -> Floats:
        model, found, first = self.model, [], 0
        for entry in model.content.towers:
            count = entry.counts[0] * entry.counts[1]
            ids = np.array(model.block_ids[first : first + count])
            first += count
            sizes = np.broadcast_to(0.5 * np.array(entry.size), (count, 2))
            found.append(placed(part, sizes, bodies[ids], turned[ids]))  # type: ignore[arg-type]
        return np.concatenate(found)

    def _draw_blocks(self, canvas: Canvas, bodies: Floats, turned: Floats, dark: bool) -> None:
        if not self.model.block_ids:
            return
        count = len(self.model.block_ids)
        inks = np.array([scaled(BLOCKS[k % len(BLOCKS)], 0.78 if dark else 1.0) for k in range(count)])
        paint_quads(canvas, self._block_corners(bodies, turned), inks, edges=scaled(MADE[dark][2], 0.7))
        paint_quads(canvas, self._block_corners(bodies, turned, TOP_EDGE), 0xFFFFFF, 0.16)
        paint_quads(canvas, self._block_corners(bodies, turned, LOW_EDGE), 0x000000, 0.18)

    def _draw_seesaws(self, canvas: Canvas, bodies: Floats, turned: Floats, dark: bool) -> None:
        tones = MADE[dark]
        for entry, body in zip(self.model.content.seesaws, self.model.seesaw_ids, strict=True):
            turn, at = turned[body : body + 1], np.array([entry.at])
            sizes = 0.5 * np.array([[entry.length, entry.thickness]])
            x, y = entry.at
            foot = np.array([(x - 0.32, y - 0.62), (x + 0.32, y - 0.62), (x + 0.07, y), (x - 0.07, y)])
            paint_quads(canvas, foot, tones[2], edges=scaled(tones[2], 0.6))
            paint_quads(canvas, placed(WHOLE, sizes, at, turn), tones[0], edges=scaled(tones[2], 0.7))
            paint_quads(canvas, placed((-1.0, 0.4, 1.0, 1.0), sizes, at, turn), tones[1])
            edge = LEDGE / entry.length
            up = 1.0 + 2.0 * entry.ledge / entry.thickness
            for side in (-1.0, 1.0 - 2.0 * edge):
                ledge = placed((side, 1.0, side + 2.0 * edge, up), sizes, at, turn)
                paint_quads(canvas, ledge, tones[2])
            canvas.circle(entry.at, 0.07, color_of(tones[5]), outline=color_of(tones[2]), width=1.2)

    def _draw_holders(self, canvas: Canvas, places: Floats) -> None:
        """A cup below each ball that a gate still holds."""
        table, rows = self.model.balls.table, self.model.balls.rows
        held = (table.freed == NOT_YET) & (table.gate != NONE) & (table.rod == NONE)
        for ball in np.flatnonzero(held).tolist():
            radius = 1.12 * float(rows[ball, RADIUS])
            width = max(0.035 * canvas.pixels_per_unit / canvas.k, 1.4)
            canvas.arc(places[ball].tolist(), radius, *CUP, color_of(GATES), width)

    def _draw_plugs(self, canvas: Canvas, dark: bool) -> None:
        for entry, body in zip(self.model.content.plugs, self.model.machine.plugs.tolist(), strict=True):
            if body >= 0:
                width = canvas.pixels_per_unit * entry.thick / canvas.k
                canvas.line(entry.start, entry.end, color_of(scaled(MADE[dark][2], 0.7)), width + 1.6)
                canvas.line(entry.start, entry.end, color_of(GATES), width)

    def _draw_cradles(self, canvas: Canvas, places: Floats, dark: bool) -> None:
        """A beam, and a rod to each ball that still hangs."""
        model, tones = self.model, MADE[dark]
        for entry, balls in zip(model.content.cradles, model.cradle_balls, strict=True):
            hung = np.array([one for one, _ in cradle_places(entry)])
            left, right = hung[0, 0] - 0.9, hung[-1, 0] + 0.9
            y = entry.at[1]
            beam = np.array([(left, y - 0.02), (right, y - 0.02), (right, y + 0.2), (left, y + 0.2)])
            paint_quads(canvas, beam + CAST, SHADOW, 0.25)
            tied = model.balls.table.rod[balls] != NONE
            if tied.any():
                ends = places[balls][tied]
                canvas.segments(hung[tied] + CAST, ends + CAST, BLACK, 2.0, 0.16)
                canvas.segments(hung[tied], ends, color_of(tones[4]), 1.6)
                canvas.discs(hung[tied], 0.035, color_of(tones[5]))
            paint_quads(canvas, beam, tones[0], edges=scaled(tones[2], 0.7))
            paint_quads(canvas, beam * (1.0, 0.0) + (0.0, y + 0.15) + _upper(beam, y), tones[1])

    def _draw_floors(self, canvas: Canvas, dark: bool, glass: bool) -> None:
        tones = MADE[dark]
        for made_of, whole, upper in self._floors:
            if (made_of == "glass") != glass:
                continue
            if glass:
                paint_shapes(canvas, whole, 0xBFE3EC, 0.3)
                paint_shapes(canvas, upper, 0xF2FCFF, 0.55)
                continue
            body, edge = {"wood": (tones[0], tones[1]), "felt": (tones[3], scaled(tones[3], 1.3))}.get(
                made_of, (tones[4], tones[5])
            )
            paint_shapes(canvas, whole, body)
            paint_shapes(canvas, upper, edge)


def bench_of(content: MetalContent) -> float:
    """Height (m) of the bench: below all floors and tracks; without any, where the view ends."""
    floors = [y for one in content.floors for _, y in one.points]
    tracks = [float(np.min(np.asarray(curve_of(one).points)[:, 1])) - BELOW for one in content.tracks]
    return min([*floors, *tracks], default=content.view.bottom)


def _upper(beam: Floats, y: float) -> Floats:
    """Heights of the lit upper edge of a beam, over its lower border."""
    return np.stack([np.zeros(4), np.where(beam[:, 1] > y, 0.05, 0.0)], axis=1)


SECONDS = 0.12  # s: a velocity is drawn as the way of this time
SLOW = 0.15  # m/s, no mark
BESIDE = 0.35  # m


def draw_marks(canvas: Canvas, model: MetalWorld, places: Floats) -> None:
    """All of them."""
    for one in model.content.yards:
        corners = np.array(
            [(one.left, one.bottom), (one.right, one.bottom), (one.right, one.top), (one.left, one.top)]
        )
        canvas.polygon(corners, outline="text3", width=1.0, dash=EXACT_DASH, alpha=0.6)
    draw_contacts(canvas, model.world, 2.6)
    rows, balls = model.balls.rows, model.balls
    fast = (np.hypot(rows[:, VX], rows[:, VY]) > SLOW) & (balls.table.freed != NOT_YET) & balls.there()
    draw_velocities(canvas, places[fast], rows[fast][:, [VX, VY]], SECONDS, 2.0)
    _draw_limits(canvas, model)
    _draw_times(canvas, model)


def _draw_limits(canvas: Canvas, model: MetalWorld) -> None:
    """From where a ball without slip would just come round each loop."""
    shown: set[int] = set()
    for gauge, ball in zip(model.content.gauges, model.measured, strict=True):
        if gauge.measure != "drop" or gauge.track >= len(model.content.tracks) or gauge.track in shown:
            continue
        shown.add(gauge.track)
        track = model.content.tracks[gauge.track]
        radius = float(model.balls.rows[ball, RADIUS])
        drop = loop_drop(track.size[0], radius, DISC)
        y, x = track.at[1] + radius + drop, track.at[0]
        left = x - 1.7 * track.size[1]
        canvas.line((left, y), (x + track.size[0], y), "text1", 1.4, dash=EXACT_DASH)
        words = f"11/4 (R − r) = {drop:.3f} m"
        canvas.label((x, y), words, "text1", 13, "semibold", "bottom", (0.0, -4.0), clear=True)


def _draw_times(canvas: Canvas, model: MetalWorld) -> None:
    """Times of a race beside the exact ones, where the tracks end."""
    tracks = model.content.tracks
    for gauge, ball, noted in zip(model.content.gauges, model.measured, model.machine.gauges, strict=True):
        if gauge.measure != "arrives" or gauge.track >= len(tracks):
            continue
        track = tracks[gauge.track]
        exact = exact_now(model, gauge, ball, noted)
        if not exact > 0.0:
            continue
        value = float(noted[VALUE])
        words = f"exact {exact:.4f} s" if value == NOT_YET else f"{value:.4f} s, exact {exact:.4f} s"
        place = (track.at[0] + 0.5 * track.size[0], track.at[1] + BESIDE)
        canvas.label(
            place, canvas.figure(gauge.name, words), "text1", 13, "semibold", "center", (0.0, 0.0), clear=True
        )
