"""How the valley is drawn: hills, bed, lit water, concrete, timber, the rocket, fire, smoke, fronts."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise, linear
from game.scenes.valley.dam import FOOT, HIGH, thickness
from game.scenes.valley.parameters import TOOLS
from game.scenes.valley.rocket import LONG, THICK
from game.scenes.valley.world import BED, LOG, ValleyState, ValleyWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import NOBODY, Hand, legend_of
from game.worlds.members.dust import AGE, LIFE, as_seen
from game.worlds.members.solids import turned_between
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.dust import draw_dust
from game.worlds.painting.flames import glow_inks
from game.worlds.painting.inks import color_of, scaled, shaded
from game.worlds.painting.landscape import DUSK, Landscape
from game.worlds.painting.liquid import LiquidPainter
from game.worlds.painting.marks import draw_contacts
from game.worlds.painting.polygons import NO_EDGE, paint

# by day and late: rock, its foot, turf, wet ground, concrete, its edge, light on it, bark, wood, steel, the
# valley's side, trees on it
TONES = (
    (0x7C6A54, 0x4A3E32, 0x7FA05A, 0x4A4436, 0xB9B6AE, 0x6C6960, 0xFFF6E0, 0x6B4A2E, 0xD8B583, 0xD9DDE2,
     0x6F8A62, 0x4E6C4C),
    (0x453A40, 0x1C181E, 0x4A5A34, 0x231F26, 0x8E868C, 0x3C363E, 0xFFC080, 0x4A3020, 0xB98A58, 0x9AA0AC,
     0x34293C, 0x221C2C),
)  # fmt: skip
ROCK, BASE, TURF, WET, CONCRETE, EDGE, LIT, BARK, WOOD, STEEL, SIDE, TREES = range(12)
SMOKE = ((0xF2EEE6, 0x8E8A86), (0xE0A888, 0x40363C))  # lit and in the shade, by day and late
DUST = ((0xF0ECE2, 0xB8B2A6), (0xE8B890, 0x7A6460))
DEEP, TURF_DEEP, WET_DEEP = 60.0, 0.35, 0.28  # m of rock, of grass, of wet ground
DARKEST, HOTTEST, COOLS = 1000.0, 2600.0, 0.75  # K of fire that is just seen, of fresh fire; share it loses
FLASH, FLASH_S, GLOW = 12.0, 0.3, 0.12  # m, s of the light of an explosion; strength of that of a puff
STRATA = (1.6, 3.4, 5.6)  # m below the bed
BLOCKS = (1.0, 0.94, 1.05, 0.9, 0.98, 1.03, 0.92)  # of the concrete's colour, piece after piece
BEHIND = np.array([
    (-80.0, 44.0), (-46.0, 27.0), (-24.0, 19.5), (0.0, 14.0), (9.0, 12.8), (24.0, 8.2), (42.0, 5.0),
    (60.0, 2.0), (84.0, 0.5), (110.0, 8.0), (140.0, 26.0),
])  # m: the far side of the valley, into which the dam is built  # fmt: skip
RINGS = ((1.0, BARK), (0.84, WOOD))  # shares of a log's radius
PUDDLE = 9  # columns: smaller gaps between wet ground are wet too
FRONTS = (
    ("front", "chalk", "measured"), ("front, shallow", "green", "shallow water"),
    ("front, Ritter", "vermilion", "Ritter"), ("front, experiment", "amber", "filmed"),
)  # fmt: skip


class ValleyView:
    """Draws a world and its hand."""

    def __init__(self, model: ValleyWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.painter = LiquidPainter(model.liquid)
        self._landscape = Landscape(ground=-4.0, late=DUSK)
        self._side, self._trees = _far_side()

    def legend(self) -> list[tuple[str, str, str]]:
        """What the hand does, and whose fronts are marked."""
        rows = list(legend_of(TOOLS, self.model.parameters.tool))
        if self.model.parameters.fronts and self.model.dam.broken:
            rows += [(f"line:{ink}", f"front, {whose}", "") for _, ink, whose in FRONTS]
        return rows

    def draw(self, canvas: Canvas, previous: ValleyState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        model, late = self.model, is_dark(canvas)
        tones = TONES[late]
        self._landscape.draw(canvas)
        before = previous.solids if previous is not None else None
        places, turned = turned_between(model.solids.world, before, alpha)
        self._draw_far_side(canvas, tones)
        self._draw_bed(canvas, tones)
        water = model.liquid.places
        if previous is not None and len(previous.liquid.places) == len(water):
            water = previous.liquid.places + alpha * (water - previous.liquid.places)
        self.painter.draw(canvas, water)
        self._draw_pieces(canvas, places, turned, tones)
        self._draw_logs(canvas, places[model.logs], turned[model.logs], tones)
        draw_dust(canvas, as_seen(model.dust.rows), DUST[late], (0.2, 0.15), 60)
        draw_dust(canvas, as_seen(model.rocket.smoke.rows), SMOKE[late], (0.25, 0.2), 60)
        self._draw_rocket(canvas, places, turned, tones)
        self._draw_fire(canvas)
        self._landscape.draw_front(canvas)
        if canvas.marks(model.parameters.fronts):
            self._draw_fronts(canvas)
        if canvas.asked:
            draw_contacts(canvas, model.solids.world, 2.2)
            self._draw_flow(canvas)

    def _draw_bed(self, canvas: Canvas, tones: tuple[int, ...]) -> None:
        """Rock with its strata, grass where it has stayed dry, dark ground where water has been."""
        model, seen = self.model, canvas.camera.visible()
        left, right = min(seen.left, BED[0, 0]) - 1.0, max(seen.right, BED[-1, 0]) + 1.0
        line = np.concatenate([[(left, BED[0, 1])], BED, [(right, BED[-1, 1])]])
        paint_quads(canvas, _strips(line, 0.0, -DEEP), tones[ROCK])
        for k, down in enumerate(STRATA):
            paint_quads(canvas, _strips(line, -down, -DEEP), tones[BASE], 0.3 + 0.1 * k)
        paint_quads(canvas, _strips(line, 0.0, -TURF_DEEP), tones[TURF])
        x, bed = model.columns, model.bed
        wet = (model.wet > bed + 0.05) & (np.abs(bed) < 20.0)
        wet = np.convolve(np.convolve(wet, np.ones(PUDDLE), "same") < 0.5, np.ones(PUDDLE), "same") < 0.5
        half = 0.5 * model.liquid.grid.cell
        rise = np.array((half, 0.0))[None] + np.gradient(bed, x)[:, None] * np.array((0.0, half))
        middle = np.stack([x, bed], axis=1)[wet]
        ends = np.stack([middle - rise[wet], middle + rise[wet]], axis=1)
        for top, deep, ink, share in ((0.0, WET_DEEP, tones[WET], 1.0), (0.0, 0.07, tones[LIT], 0.35)):
            low, high = ends - (0.0, deep), ends - (0.0, top)
            corners = np.stack([low[:, 0], low[:, 1], high[:, 1], high[:, 0]], axis=1)
            paint_quads(canvas, corners.reshape(-1, 2), ink, share)

    def _draw_far_side(self, canvas: Canvas, tones: tuple[int, ...]) -> None:
        """The slope beyond, with trees; wet where the lake has stood."""
        ridge = self._side
        for down, share in ((0.0, 1.18), (2.6, 1.0), (6.5, 0.86)):  # the sun comes over it
            below = [(ridge[-1, 0], -DEEP), (ridge[0, 0], -DEEP)]
            canvas.polygon([*(ridge - (0.0, down)).tolist(), *below], color_of(scaled(tones[SIDE], share)))
        canvas.polyline(ridge, color_of(tones[LIT]), 1.4, alpha=0.4)
        paint_quads(canvas, self._trees.reshape(-1, 2), tones[TREES])
        level = self.model.depth
        scar = [(BED[0, 0], level), (0.0, level), (0.0, HIGH), (thickness(HIGH), HIGH), (FOOT, 0.0)]
        canvas.polygon([*scar, (BED[0, 0], 0.0)], color_of(tones[BASE]), 0.5)

    def _draw_logs(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        """Ends of trunks: bark, wood, rings, a crack that shows how they turn."""
        for share, tone in RINGS:
            canvas.discs(places, share * LOG, color_of(tones[tone]))
        for share, veil in ((0.62, 0.35), (0.4, 0.35), (0.16, 0.6)):
            canvas.discs(places, share * LOG, color_of(scaled(tones[WOOD], 0.78)), veil)
        canvas.segments(places, places + 0.7 * LOG * turned, color_of(tones[BARK]), 1.6)

    def _draw_pieces(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        """The dam or what is left of it: concrete, lit from the right; its courses while it is whole."""
        model, world = self.model, self.model.solids.world
        starts, parts, inks = [0], list[Floats](), list[int]()
        for number, body in enumerate(model.dam.bodies.tolist()):
            c, s = turned[body].tolist()
            for shape in world.shapes_of(body).tolist():
                first = int(world.shapes.starts[shape])
                own = world.pool.corners[first : first + int(world.shapes.counts[shape])]
                parts.append(own @ np.array([[c, s], [-s, c]]) + places[body])
                starts.append(starts[-1] + len(own))
                inks.append(scaled(tones[CONCRETE], BLOCKS[number % len(BLOCKS)]))
        if not parts:
            return
        many = np.array(inks, dtype=np.int64)
        edges = np.full(len(many), tones[EDGE], dtype=np.int64)
        corners, begins = np.concatenate(parts), np.array(starts, dtype=np.int64)
        moved = np.zeros((max(map(len, parts)) + 2, 2))
        paint(canvas, corners, begins, many, np.ones(len(many)), edges, moved)
        middles = np.repeat(np.array([part.mean(axis=0) for part in parts]), np.diff(begins), axis=0)
        lit = middles + 0.72 * (corners - middles) + np.array((0.08, 0.08))
        none = np.full(len(many), NO_EDGE, dtype=np.int64)
        paint(canvas, lit, begins, shaded(many, 0.18), np.full(len(many), 0.55), none, moved)
        if not model.dam.broken:
            self._draw_courses(canvas, tones)

    def _draw_courses(self, canvas: Canvas, tones: tuple[int, ...]) -> None:
        """Joints of the whole dam, its lit face, the rail on its crest, marks of the depth."""
        for y in np.arange(1.5, HIGH, 1.5).tolist():
            canvas.line((0.0, y), (thickness(y), y), color_of(tones[EDGE]), 1.0)
        canvas.line((FOOT, 0.0), (thickness(HIGH), HIGH), color_of(tones[LIT]), 2.6)
        canvas.line((0.0, HIGH + 0.9), (thickness(HIGH), HIGH + 0.9), color_of(tones[EDGE]), 1.4)
        for x in np.linspace(0.1, thickness(HIGH) - 0.1, 4).tolist():
            canvas.line((x, HIGH), (x, HIGH + 0.9), color_of(tones[EDGE]), 1.2)

    def _draw_rocket(self, canvas: Canvas, places: Floats, turned: Floats, tones: tuple[int, ...]) -> None:
        body = self.model.rocket.body
        if body == NOBODY:
            return
        along = turned[body]
        across, at = np.array((-along[1], along[0])), places[body]

        def point(u: float, v: float) -> tuple[float, float]:
            x, y = (at + 0.5 * LONG * u * along + 0.5 * THICK * v * across).tolist()
            return x, y

        steel, edge = color_of(tones[STEEL]), color_of(tones[EDGE])
        for side in (1.0, -1.0):
            canvas.polygon([point(-0.6, side), point(-1.0, side), point(-1.15, 2.3 * side)], "vermilion")
        hull = [point(-1.0, -1.0), point(0.5, -1.0), point(1.0, 0.0), point(0.5, 1.0), point(-1.0, 1.0)]
        canvas.polygon(hull, steel, outline=edge)
        canvas.polygon([point(0.5, -1.0), point(1.0, 0.0), point(0.5, 1.0)], "vermilion")
        canvas.line(point(-0.95, 0.5), point(0.5, 0.5), color_of(tones[LIT]), 2.0)

    def _draw_fire(self, canvas: Canvas) -> None:
        """Puffs of burning gas as they cool, with their light on what is near."""
        rows = self.model.rocket.fire.rows
        if not len(rows):
            return
        at, ages, radii = as_seen(rows)
        hot = 1.0 - COOLS * ages
        inks = glow_inks(hot, DARKEST, HOTTEST).astype(np.uint32) | np.uint32(0xFF000000)
        order = np.argsort(hot, kind="stable")
        big = rows[:, LIFE] > 0.5
        size = np.where(big, 2.2, 1.8) * radii
        canvas.soft_glow(at[order], size[order], inks[order], GLOW * (1.0 - ages[order]) ** 2)
        young = 1.0 - 0.5 * ages[order]
        for share, veil in ((1.0, 0.12), (0.8, 0.16), (0.55, 0.3), (0.3, 0.5)):
            canvas.discs(at[order], share * radii[order] * young, inks[order], veil)
        flash = 1.0 - rows[big, AGE].min() / FLASH_S if big.any() else 0.0
        if flash > 0.0:
            middle = at[big].mean(axis=0)[None]
            canvas.soft_glow(middle, FLASH, glow_inks(np.array([1.0]), DARKEST, HOTTEST), 0.8 * flash * flash)
        canvas.bloom(0.9)

    def _draw_fronts(self, canvas: Canvas) -> None:
        """Stakes in the ground, as far as the front is by each."""
        model = self.model
        found = (model.front(), model.shallow_front(), model.ritter_front(), model.filmed_front())
        for k, (x, (_, ink, whose)) in enumerate(zip(found, FRONTS, strict=True)):
            if math.isnan(x) or x <= 0.0:
                continue
            foot = float(np.interp(x, BED[:, 0], BED[:, 1]))
            top = foot + 5.2 + 1.5 * k
            canvas.line((x, foot), (x, top), ink, 2.2, dash=None if k == 0 else (6.0, 4.0))
            canvas.label((x, top), f"{whose} {x:.0f} m", ink, 13, "semibold", "center", offset=(0.0, -9.0))

    def _draw_flow(self, canvas: Canvas) -> None:
        """Speeds of every so many particles."""
        liquid = self.model.liquid
        every = max(1, liquid.count // 400)
        places, speeds = liquid.places[::every], liquid.speeds[::every]
        canvas.segments(places, places + 0.12 * speeds, "chalk", 1.2)


def _far_side() -> tuple[Floats, Floats]:
    """Its ridge (n, 2) m, and corners (m, 4, 2) m of trees that stand on it."""
    x = np.arange(BEHIND[0, 0], BEHIND[-1, 0], 1.0)
    waves = 0.5 * elementwise.sin(0.37 * x) + 0.3 * elementwise.sin(0.93 * x + 1.0)
    ridge = np.stack([x, linear.interpolated(x, BEHIND[:, 0], BEHIND[:, 1]) + waves], axis=1)
    k = np.arange(len(x) * 2)
    feet = x[0] + 0.5 * k + 0.4 * elementwise.sin(7.7 * k)
    down = 5.0 * elementwise.sin(3.1 * k) ** 2
    ground = linear.interpolated(feet, ridge[:, 0], ridge[:, 1]) - down
    tall = 1.6 + 1.2 * elementwise.sin(5.3 * k) ** 2
    tips = np.stack([feet, ground + tall], axis=1)
    corners = [np.stack([feet - 0.5, ground], axis=1), np.stack([feet + 0.5, ground], axis=1), tips, tips]
    some = elementwise.sin(0.41 * k) + elementwise.sin(0.13 * k) > -0.3  # clearings
    return ridge, np.stack(corners, axis=1)[some]


def _strips(line: Floats, top: float, bottom: float) -> Floats:
    """Corners (4 (n - 1), 2) m of what lies between so many m above and below a line (n, 2) m."""
    a, b = line[:-1], line[1:]
    up, down = np.array((0.0, top)), np.array((0.0, bottom))
    return np.stack([a + down, b + down, b + up, a + up], axis=1).reshape(-1, 2)
