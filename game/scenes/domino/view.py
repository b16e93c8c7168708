"""How the world of dominoes is drawn: landscape, boards, dominoes, balls, blocks; and what teaches."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Flags, Floats, Longs
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC
from game.scenes.domino.course import height_at
from game.scenes.domino.shapes import (
    BAND,
    BOARD,
    FRONT,
    GRAIN,
    LIT,
    SHADED,
    pools_of,
    posts_of,
    rainbow,
    spans_of,
)
from game.scenes.domino.world import DominoState, DominoWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import NOBODY, Hand
from game.worlds.members.solids import bodies_between
from game.worlds.painting.boards import (
    WHOLE,
    boards_of,
    moved,
    paint_quads,
    paint_shadows,
    paint_shapes,
    placed,
)
from game.worlds.painting.inks import color_of, lighter, scaled
from game.worlds.painting.landscape import Landscape
from game.worlds.painting.marks import draw_contacts, draw_velocities
from game.worlds.painting.spheres import draw_spheres

GROUND = -2.0  # m, of the meadow that all stands on
NAMED_PX = 60.0  # design px to a m from which blocks are named
GRAIN_PX = 26.0  # px to a m at which grain can be seen
LANE_STEP = (0.12, 0.17)  # m: how much farther right and up each lane behind the first is seen
# by day and at night: wood of dominoes, boards, their lit edge, posts, shadow
WOOD = (
    (0xD9B076, 0xB07A45, 0xE2B57C, 0x7C5635, 0x2A1D10),
    (0xB58C5C, 0x6B4A33, 0xA87C52, 0x3A2A22, 0x04060A),
)
BALLS = {"steel": 0x9AA7B4, "glass": 0x6FC3D8, "wood": 0xC08A4E, "cork": 0xD8B98A}
BLOCKS = (0xD65F5F, 0xE0A03C, 0x6FA84F, 0x4E8FC9, 0x9A6CC4)


class DominoView:
    """Draws a model and its hand."""

    def __init__(self, model: DominoWorld, hand: Hand):
        self.model, self.hand = model, hand
        self._asked = False  # marks are asked for by key
        self._landscape = Landscape(GROUND)
        floors, points = model.content.floors, model.floors
        boards = [one for one, floor in zip(points, floors, strict=True) if floor.look == "board"]
        others = [one for one, floor in zip(points, floors, strict=True) if floor.look != "ground"]
        posts = [posts_of(floor, one, others, GROUND) for one, floor in zip(points, floors, strict=True)]
        self._boards, self._edges = ([boards_of(one, thick) for one in boards] for thick in (BOARD, FRONT))
        self._posts = np.concatenate([np.zeros((0, 2)), *posts])
        self._spans = [span for floor in floors for span in spans_of(floor)]
        self._pools = [pool for floor in floors for pool in pools_of(floor)]
        self._lanes = [boards_of(points[k], BOARD) for k, one in enumerate(floors) if one.look == "lane"]
        self._ways = {
            entry.floor: (boards_of(points[entry.floor], 3.2 * BOARD), boards_of(points[entry.floor], 0.17))
            for entry in model.content.sliders
        }

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        if not (self.model.parameters.marks or self._asked):
            return []
        rows = [("disc:amber", "contact", ""), ("line:chalk", "velocity", "")]
        if len(self.model.content.sliders):
            rows.append(("dash:text1", "v² / (2 g (μ cos − sin))", ""))
        return rows

    def draw(self, canvas: Canvas, previous: DominoState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        self._landscape.draw(canvas)
        places, angles = bodies_between(self.model.world, previous and previous.world, alpha)
        turned = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        tones = WOOD[is_dark(canvas)]
        paint_quads(canvas, self._posts, tones[3], edges=0x000000)
        self._draw_bridges(canvas, tones)
        self._draw_lanes(canvas, places, turned, tones)
        for board in self._boards:
            paint_shapes(canvas, board, tones[1])
        self._draw_planks(canvas, places, turned, tones)
        self._draw_dominoes(canvas, places, turned, tones)
        for edge in self._edges:
            paint_shapes(canvas, edge, tones[2])
        self._draw_balls(canvas, places, turned)
        self._name_blocks(canvas, places)
        self._asked = canvas.asked
        if canvas.marks(self.model.parameters.marks):
            draw_marks(canvas, self.model, places)
        if self.hand.held != NOBODY and self.hand.point is not None:
            canvas.ring(self.hand.point, 9.0, "amber", 2.0)

    def _seen(self, canvas: Canvas, places: Floats, bodies: Longs) -> Flags:
        """Which bodies may be in the picture."""
        seen, rows = canvas.camera.visible(), self.model.world.bodies
        reach, at = rows.reaches[bodies] + 0.6, places[bodies]
        inside: Flags = (
            (at[:, 0] + reach > seen.left) & (at[:, 0] - reach < seen.right)
            & (at[:, 1] + reach > seen.bottom) & (at[:, 1] - reach < seen.top)
        )  # fmt: skip
        return inside

    # -- painting -------------------------------------------------------------------------------------

    def _draw_bridges(self, canvas: Canvas, tones: tuple[int, ...]) -> None:
        """An arch below each bridge, and struts up to it; water in gaps."""
        for left, bottom, right, top in self._pools:
            pool = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
            canvas.polygon(pool, fill="chalk", fill_alpha=0.55)
            canvas.line((left, top), (right, top), "text1", 1.2, alpha=0.5)
        for left, right, y in self._spans:
            half, middle = 0.5 * (right - left), 0.5 * (left + right)
            t = np.linspace(-1.0, 1.0, 25)
            arch = np.stack([middle + half * t, y - BOARD - 2.0 * t**2 - 0.1], axis=1)
            struts = arch[2:-2:3]
            heads = np.column_stack([struts[:, 0], np.full(len(struts), y - BOARD)])
            for a, b in zip(struts, heads, strict=True):
                canvas.polygon(_beam(a, b, 0.16), fill=color_of(tones[3]))
            bow = np.concatenate([arch, arch[::-1] - np.array((0.0, 0.34))])
            canvas.polygon(bow, fill=color_of(tones[3]), outline=color_of(tones[4]), width=1.0)

    def _draw_planks(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        for entry, body in zip(self.model.content.planks, self.model.plank_ids, strict=True):
            shift = -0.02 * entry.length if entry.seesaw else 0.0
            c, s = turned[body].tolist()
            sizes = 0.5 * np.array([[entry.length, entry.thickness]])
            at = places[body : body + 1]
            if entry.seesaw:  # its pin is where it is told to be
                at = np.array([[entry.at[0] + c * shift, entry.at[1] + s * shift]])
                x, y = entry.at
                foot = np.array([(x - 0.45, y - 0.5), (x + 0.45, y - 0.5), (x, y)])
                canvas.polygon(foot, fill=color_of(tones[3]))
            paint_quads(canvas, placed(WHOLE, sizes, at, turned[body : body + 1]), tones[2], edges=tones[4])
            if entry.seesaw:
                canvas.circle(entry.at, 0.09, color_of(tones[4]))

    def _draw_dominoes(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        table, there = self.model.dominoes.table, self.model.dominoes.there()
        bodies = table.body[there]
        seen = self._seen(canvas, places, bodies)
        there, bodies = there[seen], bodies[seen]
        if not len(there):
            return
        dark = is_dark(canvas)
        sizes = 0.5 * np.stack([table.thick[there], table.tall[there]], axis=1)
        at, turn = places[bodies], turned[bodies]
        colours = rainbow(len(table.body), dark)[there]
        whole = placed(WHOLE, sizes, at, turn)
        paint_shadows(canvas, whole, tones[4])
        paint_quads(
            canvas, whole, tones[0], edges=tones[4] if canvas.pixels_per_unit > GRAIN_PX else tones[1]
        )
        if canvas.pixels_per_unit > GRAIN_PX:
            for box in GRAIN:
                paint_quads(canvas, placed(box, sizes, at, turn), tones[1], 0.55)
        paint_quads(canvas, placed(BAND, sizes, at, turn), colours)
        for side, box in ((1.0, LIT), (-1.0, SHADED)):
            paint_quads(canvas, placed(box, sizes, at, turn), 0xFFFFFF if side > 0 else 0x000000, 0.2)

    def _draw_lanes(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        """Lanes side by side from the back to the front, each with its block."""
        model = self.model
        if not len(model.content.sliders):
            for board in self._lanes:
                paint_shapes(canvas, board, tones[1])
            return
        bodies = model.blocks.table.body
        entries = model.content.sliders
        for lane in range(len(entries) - 1, -1, -1):
            shift = np.array(LANE_STEP) * lane
            share = 0.08 * lane
            side, upper = self._ways[entries[lane].floor]
            paint_shapes(canvas, moved(side, shift), scaled(tones[1], 0.75 - share))
            paint_shapes(canvas, moved(upper, shift), scaled(tones[2], 1.0 - share))
            body = bodies[lane : lane + 1]
            sizes = 0.5 * np.array([entries[lane].size])
            if entries[lane].speed > 0.0:
                sizes = sizes[:, ::-1]
            at, turn = places[body] + shift, turned[body]
            whole = placed(WHOLE, sizes, at, turn)
            paint_quads(canvas, whole + np.array((0.09, -0.06)), tones[4], 0.35)
            paint_quads(canvas, whole, BLOCKS[lane % len(BLOCKS)], edges=tones[4])
            paint_quads(canvas, placed(LIT, sizes, at, turn), 0xFFFFFF, 0.25)

    def _draw_balls(self, canvas: Canvas, places: Floats, turned: Floats) -> None:
        bodies = self.model.ball_ids
        entries = self.model.content.balls
        radii = np.array([entry.radius for entry in entries])
        inks = np.array([BALLS[entry.made_of] for entry in entries], dtype=np.int64)
        draw_spheres(canvas, places[bodies], radii, turned[bodies], inks)

    def _name_blocks(self, canvas: Canvas, places: Floats) -> None:
        """Friction and mass beside each block in its lane, where they are large enough to be told apart."""
        if canvas.pixels_per_unit < NAMED_PX * canvas.k:
            return
        table, rows = self.model.blocks.table, self.model.world.bodies
        seen = self._seen(canvas, places, table.body)
        for lane in np.flatnonzero(seen).tolist()[::-1]:
            body = int(table.body[lane])
            words = canvas.figure(
                f"block {lane + 1}", f"μ {table.mu[lane]:.2f}, {1.0 / rows.inverse_masses[body]:.3g} kg"
            )
            x, y = (places[body] + np.array(LANE_STEP) * lane).tolist()
            ink, above = color_of(lighter(BLOCKS[lane % len(BLOCKS)], 0.4)), y + canvas.px(30.0 + 23.0 * lane)
            canvas.line((x, y), (x, above), ink, 1.2, alpha=0.6)
            canvas.label((x, above), words, ink, 15, "semibold", "bottom", (0.0, -1.0))


def _beam(a: Floats, b: Floats, breadth: float) -> Floats:
    """Corners (4, 2) m of an upright beam between two points."""
    side = np.array([0.5 * breadth, 0.0])
    return np.array([a - side, a + side, b + side, b - side])


SECONDS = 0.15  # s: a velocity is drawn as the way of this time
SLOW = 0.15  # m/s, no mark


def draw_marks(canvas: Canvas, model: DominoWorld, places: Floats) -> None:
    """All of them."""
    world = model.world
    draw_contacts(canvas, world, 2.2)
    rows = world.bodies
    awake = np.flatnonzero(rows.flags & (DYNAMIC | ASLEEP) == DYNAMIC)
    moving = awake[np.hypot(*rows.velocities[awake].T) > SLOW]
    draw_velocities(canvas, places[moving], rows.velocities[moving], SECONDS, 1.8)
    wave = model.dominoes.wave.speed
    if model.dominoes.last >= 0:
        x, y = model.front()
        canvas.line((x, y - 0.9), (x, y + 1.1), "vermilion", 1.4, dash=EXACT_DASH)
        if wave > 0.0:
            words = canvas.figure("wave", f"{wave:.2f} m/s, theory {model.theory():.2f}")
            canvas.label((x, y + 1.2), words, "vermilion", 13, "semibold", "bottom", (0.0, -4.0), clear=True)
    for k, entry in enumerate(model.content.sliders):
        stop = model.blocks.stop_by_law(k, model.gravity())
        if math.isfinite(stop):
            shift_x, shift_y = 0.12 * k, 0.17 * k
            y, _ = height_at(model.floors[entry.floor], stop)
            foot = stop + shift_x, y + shift_y
            canvas.line(foot, (foot[0], foot[1] + 0.8), "text1", 1.4, dash=EXACT_DASH)
