"""How the candle is drawn: room and table in two lights, wax, smoke, flame, the glass before them."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.scenes.candle.air import (
    AIR,
    HALF,
    HIGH,
    LOOK,
    PER_VOLUME,
    RADIUS,
    RIM,
    ROOM,
    SINCE,
    SUPPLY,
    TALL,
    TOP,
)  # fmt: skip
from game.scenes.candle.things import FLAME_HALF, draw_glass, draw_wax, flame_picture, glass_inside
from game.scenes.candle.world import CandleState, CandleWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.members.burning_air import FRESH
from game.worlds.painting.dusk_room import SHINES, draw_dusk_room
from game.worlds.painting.flames import FIRELIGHT, HEAT_STOPS, glow_stops
from game.worlds.painting.inks import color_of
from game.worlds.painting.shades import Light, finer, grid_of, in_two_lights, lay_lit

BOX = ((-HALF, 0.0), (HALF, TALL))
OWN: dict[bool, Light] = {
    True: (0.86, 0.95, 1.2),
    False: (1.25, 1.2, 1.12),
}  # the room's, at night and by day
WARM = (1.0, 0.68, 0.38)
SMOKE = {True: (0xA2AAC0, 0xD8B48C), False: (0x6C6E76, 0x94836E)}  # in the room's light, and in the flame's
EMBER_S = 4.0  # s that a wick still glows
REACH, SHORTEST, LONGEST = 0.013, 0.012, 0.062  # m beside its axis that are the flame's; its height
STEADIES = 300.0  # K of gas warmer than 500 K in a row of cells, with which its axis is half aside
EASED = np.array((1.0, 2.0, 3.0, 4.0, 3.0, 2.0, 1.0)) / 16.0  # of an axis, over so many rows of cells
WICK = ((0.0, TOP - 0.001), (0.0002, TOP + 0.004), (0.0012, TOP + 0.0075), (0.0024, TOP + 0.0088))
LIMIT = 16.0 / PER_VOLUME  # of fresh air's oxygen, with which no candle burns
OXYGEN_STOPS = ((0.0, "vermilion"), (LIMIT, "amber"), (1.0, "chalk"))
STICK, LEANS, MATCH_FROM = 0.09, (0.88, 0.47), (0.16, 0.05)  # m of a match; its direction; m it comes from
FOOT_ROWS, VEILS = 2, 0.85  # cells below the table, to the near rim; how much a measured field hides
MATCH_SIZE, MATCH_LIGHT = 0.34, 0.45  # of the candle's flame


class CandleView:
    """Draws a model and its hand."""

    def __init__(self, model: CandleWorld, hand: Hand):
        self.model, self.hand = model, hand

    def legend(self) -> list[tuple[str, str, str]]:
        """What is shown of the gas, if it is not what the eye sees."""
        words = {"oxygen": "16 % of oxygen; blue: fresh air", "temperature": "293 K dark to 1800 K bright"}
        shown = self.model.parameters.shown
        return [("square:amber", words[shown], "")] if shown in words else []

    def draw(self, canvas: Canvas, previous: CandleState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        air, dark, burns, (near, _) = (
            self.model.air,
            is_dark(canvas),
            self._strength(),
            self.model.air.match(),
        )
        strength = max(burns, MATCH_LIGHT * near)
        red, green, blue = (part * (1.0 - 0.48 * strength) for part in OWN[dark])  # the eye gets used to less
        own: Light = (red, green, blue)
        flame: Light = (WARM[0] * strength, WARM[1] * strength, WARM[2] * strength)
        rim = float(air.flows[RIM])
        if previous is not None:
            before = float(previous.air.flows[RIM])
            rim = before + alpha * (rim - before)
        draw_dusk_room(canvas, own, flame)
        self._draw_gas(canvas, dark, strength)
        draw_wax(canvas, own, flame)
        self._draw_wick(canvas)
        if burns > 0.02:
            self._draw_flame(canvas, burns)
        if near > 0.0:
            self._draw_match(canvas, near)
        draw_glass(canvas, (float(air.flows[RADIUS]), float(air.flows[HIGH])), rim, own, flame)
        if canvas.marks(False):
            self._draw_marks(canvas)
        if self.hand.point is not None:
            canvas.ring(self.hand.point, 9.0, "amber", 2.0)

    def _strength(self) -> float:
        """How bright the flame is, as the eye has it: 1 where all that the wick may carry up burns."""
        return self.model.air.strength() ** 0.5

    def axis(self, rows: int) -> tuple[float, Floats]:
        """Height (m) of the flame above the wick's foot, and how far its axis is aside in so many rows, as
        its picture has them. It is as high as vapour comes (Roper 1977); its axis is that of the hot gas,
        from one row of cells to the next.
        """
        air = self.model.air
        x, y = (one.reshape(-1) for one in (air.gas.grid.centres()[0][:1], air.gas.grid.centres()[1][:, :1]))
        middle, places = 0.0, [(TOP, 0.0)]
        high = SHORTEST + (LONGEST - SHORTEST) * air.strength()
        for j in np.flatnonzero((y > TOP) & (y < TOP + 1.5 * LONGEST)).tolist():
            excess = np.maximum(air.temperature[j] - 500.0, 0.0) * (np.abs(x - middle) < REACH)
            total = float(excess.sum())
            middle += (float(np.sum(excess * x)) - total * middle) / (total + STEADIES)
            places.append((float(y[j]), middle))
        up = TOP + high * (-0.06 + 1.2 * (np.arange(rows) + 0.5) / rows)
        known = np.array(places)
        eased = np.convolve(np.pad(known[:, 1], 3, mode="edge"), EASED, mode="valid")
        bent = np.interp(up, known[:, 0], eased)
        return high, bent * np.clip((up - TOP) / 0.025, 0.0, 1.0)

    def _draw_wick(self, canvas: Canvas) -> None:
        """The wick, and its tip as long as it glows."""
        flows = self.model.air.flows
        ember = 1.0 if flows[SUPPLY] > 0.0 else max(1.0 - float(flows[SINCE]) / EMBER_S, 0.0)
        thick = canvas.pixels_per_unit / canvas.k
        canvas.polyline(WICK, color_of(0x17110E), 0.0012 * thick)
        canvas.polyline(WICK[:3], color_of(0x5A4A3C), 0.0003 * thick, alpha=0.7)
        if ember > 0.0:
            canvas.polyline(WICK[2:], color_of(0xC83A12), 0.0013 * thick, alpha=ember)
            canvas.circle(WICK[3], 0.0006, color_of(0xFF9A48), ember)
            canvas.soft_glow(
                np.array([WICK[3]]), np.array([0.006]), np.array([FIRELIGHT], np.uint32), 0.9 * ember
            )

    def _draw_gas(self, canvas: Canvas, dark: bool, strength: float) -> None:
        air, shown = self.model.air, self.model.parameters.shown
        if shown == "flame":
            veil = finer(air.veil())
            veil[..., 1] *= 0.25 * (strength * veil[..., 1]) ** 2  # the teardrop is drawn by itself
            smoke = color_of(SMOKE[dark][0]).lerp(color_of(SMOKE[dark][1]), 0.8 * strength)
            canvas.veil(veil, *BOX, smoke, glow_stops(LOOK.dark, LOOK.bright))
            return
        fresh = air.gas.field("oxygen") / air.gas.field("air") * (AIR / FRESH)
        oxygen = shown == "oxygen"
        values, stops = (fresh, OXYGEN_STOPS) if oxygen else ((air.temperature - ROOM) / 1500.0, HEAT_STOPS)
        box, cover = BOX, finer(air.edge)
        if self.model.sealed():  # what is under the glass goes on into its wall, and to its near rim
            rows, columns = (np.flatnonzero(air.under().any(axis=one)) for one in (1, 0))
            down = np.arange(-FOOT_ROWS, len(values))
            values = values[np.clip(down, rows[0], rows[-1])]
            values = values[:, np.clip(np.arange(values.shape[1]), columns[0], columns[-1])]
            box = ((-HALF, -FOOT_ROWS * air.cell), BOX[1])
            x, y = grid_of(box, finer(values).shape)
            cover = glass_inside(x, y, float(air.flows[RADIUS]), float(air.flows[HIGH]))
        values, cover = finer(values), VEILS * cover
        inks = np.array([tuple(canvas.color(ink))[:3] for _, ink in stops], dtype=np.float64)
        color = [np.interp(values, [at for at, _ in stops], inks[:, c]) * cover for c in range(3)]
        own = np.stack(color, axis=2)
        lay_lit(canvas, in_two_lights(own, np.zeros_like(own), cover), box, (1.0, 1.0, 1.0), (0.0, 0.0, 0.0))

    def _draw_flame(self, canvas: Canvas, strength: float) -> None:
        """The teardrop of it, as high as gas is hot there and bent as it flows, and the light about it."""
        picture = flame_picture()
        high, bent = self.axis(picture.shape[0])
        box = ((-FLAME_HALF, TOP - 0.06 * high), (FLAME_HALF, TOP + 1.14 * high))
        glow = min(2.0 * strength, 1.0)
        lay_lit(canvas, picture, box, (glow, glow, glow), (strength, strength, strength), bent)
        at = np.array([(0.0, SHINES), (0.0, SHINES)])
        inks, parts = np.full(2, FIRELIGHT, np.uint32), strength * np.array((0.2, 0.35))
        canvas.soft_glow(at, np.array((0.3, 0.06)), inks, parts)
        canvas.bloom(0.5 if is_dark(canvas) else 0.3)

    def _draw_match(self, canvas: Canvas, near: float) -> None:
        """A match on its way to the wick: a stick, its burnt head, a small flame."""
        x, y = (a + near * (b - a) for a, b in zip(MATCH_FROM, (0.004, TOP + 0.008), strict=True))
        thick, end = canvas.pixels_per_unit / canvas.k, (x + STICK * LEANS[0], y - STICK * LEANS[1])
        canvas.polyline(((x, y), end), color_of(0x8A6236), 0.0026 * thick)
        canvas.polyline(((x, y + 0.0007), (end[0], end[1] + 0.0007)), color_of(0xE8B878), 0.001 * thick)
        canvas.circle((x, y), 0.0019, color_of(0x2A1610))
        half, high = MATCH_SIZE * FLAME_HALF, MATCH_SIZE * LONGEST
        box = ((x - half, y - 0.1 * high), (x + half, y + 1.1 * high))
        lay_lit(canvas, flame_picture(), box, (1.0, 1.0, 1.0), (0.9, 0.9, 0.9))
        at, inks = np.array([(x, y + 0.5 * high)]), np.array([FIRELIGHT], np.uint32)
        canvas.soft_glow(at, np.array((0.05,)), inks, 0.4)

    def _draw_marks(self, canvas: Canvas) -> None:
        """Where the gas goes."""
        air, size = self.model.air, self.model.air.cell
        x, y = np.meshgrid(np.arange(-0.14, 0.15, 0.02), np.arange(0.01, TALL - 0.02, 0.02))
        points = np.stack([x.ravel(), y.ravel()], axis=1)
        wind = air.wind_at(points)
        fast = np.sqrt(np.sum(wind * wind, axis=1)) > 4.0 * size
        canvas.segments(points[fast], points[fast] + 0.03 * wind[fast], "chalk", 1.4, 0.8)
