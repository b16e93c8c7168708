"""How the show is drawn: from the sky to the near bank, and what explains it."""

from __future__ import annotations

import math

import numpy as np

from game.physics.fields import WIND
from game.physics.generations.step import FIELDS
from game.scenes.fireworks import model as m
from game.scenes.fireworks import thunder
from game.scenes.fireworks.eye import Seen, projected, seen_from
from game.scenes.fireworks.hand import FireworksHand
from game.scenes.fireworks.landscape import Landscape
from game.scenes.fireworks.looks import FLASH_COLORS, GOLD, look_of, shades_of
from game.scenes.fireworks.measures import NAMED_S, burst_middle, burst_now
from game.scenes.fireworks.model import FireworksModel, FireworksState
from game.scenes.fireworks.shells import SHELLS
from game.scenes.fireworks.shine import CELLS, FLASH_FADES, Glow, light_smoke, shed_light, shine
from game.ui.canvas.canvas import EXACT_DASH, Canvas

MOST_LIGHTS = 160_000
MOST_PUFFS = 8_000
MANY_STARS = 30_000  # with more than that tails have fewer dots
SOME = 500  # stars of a kind, of which each lights smoke; of more a part is taken for all
BLOOM = 1.25
MOST_WAVES = 4  # of sound that are drawn
FLASH_S = 1.6  # s, for which a flash is drawn
SOUND_S = 4.0  # s, for which a wave of sound is drawn


class FireworksView:
    """Draws the show; keeps the arrays that drawing needs."""

    def __init__(self, model: FireworksModel, hand: FireworksHand):
        self.model, self.hand = model, hand
        self.landscape = Landscape()
        self._looks = {kind.name: look_of(kind.name) for kind in model.system.kinds}
        self._shades = {name: shades_of(look) for name, look in self._looks.items()}
        self._places = np.zeros((0, 2))

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        rows = [
            ("dash:text1", "the newest burst by ballistics", ""),
            ("ring:chalk", "sound on its way", f"{int(self.model.thunder.counts[thunder.WAITING])}"),
            ("ring:accent", "the listener", f"{self.model.parameters.distance:.0f} m off"),
        ]
        if WIND in self.model.active:
            rows.append(("arrow:green", "wind", ""))
        return rows

    def draw(self, canvas: Canvas, previous: FireworksState | None, alpha: float) -> None:
        """All of it, from the back to the front."""
        self._reserve()
        back = (1.0 - alpha) * self.model.parameters.step_length
        seen = seen_from(
            float(canvas.camera.center[0]), self.model.system.time_s - back, back, self.model.bearing
        )
        flashes = self._flashes_now(seen.time)
        lit = min(sum(math.exp(-(seen.time - row[0]) / FLASH_FADES) for row in flashes.tolist()), 2.5) / 2.5
        self.landscape.behind(canvas, seen, lit)
        self.landscape.fleet(canvas, seen, lit)
        self._draw_smoke(canvas, seen, flashes)
        self._draw_flashes(canvas, seen)
        self._draw_lights(canvas, seen)
        canvas.bloom(BLOOM)
        night = self.landscape.night(canvas)
        canvas.water(0.0, canvas.camera.visible().top, seen.time, night.water, night.mirror)
        self.landscape.before(canvas, seen, lit)
        self._draw_listener(canvas)
        if canvas.teaching:
            self._explain(canvas, seen)

    def _reserve(self) -> None:
        if not len(self._places):
            self._places = np.zeros((MOST_LIGHTS, 2))
            self._colors = np.zeros(MOST_LIGHTS, np.uint32)
            self._sizes = np.zeros(MOST_LIGHTS, np.uint8)
            self._shares = np.zeros(MOST_LIGHTS)
            self._puffs = np.zeros((MOST_PUFFS, 2))
            self._radii = np.zeros(MOST_PUFFS)
            self._puff_colors = np.zeros(MOST_PUFFS, np.uint32)
            self._puff_shares = np.zeros(MOST_PUFFS)
            self._cells = np.zeros((math.prod(CELLS), 7))

    # -- light --------------------------------------------------------------------------------------

    def _draw_lights(self, canvas: Canvas, seen: Seen) -> None:
        system, line = self.model.system, 0
        fewer = 0.5 if len(system) > MANY_STARS else 1.0
        for kind in system.kinds:
            stars = system.stars(kind.name)
            if not stars.shape[1] or kind.name == "smoke":
                continue
            glow = self._glow_of(kind.name, fewer)
            line = shine(
                stars, self._shades[kind.name], glow, seen, self._places, self._colors, self._sizes,
                self._shares, line,
            )  # fmt: skip
        canvas.glow(self._places[:line], self._colors[:line], self._sizes[:line], self._shares[:line])

    def _glow_of(self, kind: str, fewer: float = 1.0) -> Glow:
        look = self._looks[kind]
        return Glow(look.size, int(look.dots * fewer), look.tail_s, look.bloom, look.blink, look.twinkle)

    def _lamps(self, time: float) -> np.ndarray:
        """(n, 6): x, y, z m of the light of stars near one another, and its red, green and blue."""
        cells = self._cells
        cells[:] = 0.0
        for kind in self.model.system.kinds:
            stars = self.model.system.stars(kind.name)
            if stars.shape[1] and kind.name != "smoke":
                every = 1 + stars.shape[1] // SOME
                shed_light(stars, self._shades[kind.name], self._glow_of(kind.name), time, every, cells)
        some = cells[cells[:, 6] > 0.0]
        return np.concatenate((some[:, :3] / some[:, 6:], some[:, 3:6]), axis=1)

    def _draw_smoke(self, canvas: Canvas, seen: Seen, flashes: np.ndarray) -> None:
        ambient = np.array(self.landscape.night(canvas).ambient)
        line = light_smoke(
            self.model.system.stars("smoke"), flashes, self._lamps(seen.time), seen, ambient, self._puffs,
            self._radii, self._puff_colors, self._puff_shares,
        )  # fmt: skip
        canvas.soft_glow(
            self._puffs[:line], self._radii[:line], self._puff_colors[:line], self._puff_shares[:line]
        )

    def _recent(self, time: float) -> list[list[float]]:
        """Flashes that are still to be seen."""
        rows = self.model.flashes
        return rows[
            (rows[:, m.INSTANT] >= 0.0) & (time - rows[:, m.INSTANT] < FLASH_S) & (rows[:, m.INSTANT] <= time)
        ].tolist()

    def _flashes_now(self, time: float) -> np.ndarray:
        """(n, 7): instant s, place m, depth m and colour of the bursts that light the smoke."""
        rows = [
            (row[m.INSTANT], row[m.FLASH_X], row[m.FLASH_Y], row[m.FLASH_DEPTH], *_color_of(row))
            for row in self._recent(time)
        ]
        return np.array(rows).reshape(-1, 7)

    def _draw_flashes(self, canvas: Canvas, seen: Seen) -> None:
        """The burst itself, the air about it, and a mortar's mouth."""
        places, radii, colors, shares = [], [], [], []
        for row in self._recent(seen.time):
            age, burst = seen.time - row[m.INSTANT], row[m.FLASH_WHAT] > 0.0
            x, y, near = projected(seen, row[m.FLASH_X], row[m.FLASH_Y], row[m.FLASH_DEPTH])
            at = (x, y)
            red, green, blue = _color_of(row)
            tint = (int(127 + 128 * red) << 16) | (int(127 + 128 * green) << 8) | int(127 + 128 * blue)
            sizes = ((11.0, 0.9 * math.exp(-age / 0.07)), (95.0, 0.13 * math.exp(-age / FLASH_FADES)))
            for radius, share in sizes if burst else ((7.0, 0.9 * math.exp(-age / 0.09)),):
                places.append(at)
                radii.append(radius * near)
                colors.append(tint)
                shares.append(share)
        if places:
            canvas.soft_glow(places, np.array(radii), np.array(colors, np.uint32), np.array(shares))

    # -- what explains ------------------------------------------------------------------------------

    def _draw_listener(self, canvas: Canvas) -> None:
        x, y = self.model.listener_place()
        ink = self.landscape.night(canvas).bank
        canvas.circle((x, y + 4.3), 1.1, fill=ink)
        canvas.polygon([(x - 1.5, y), (x - 1.3, y + 3.2), (x + 1.3, y + 3.2), (x + 1.5, y)], fill=ink)

    def _explain(self, canvas: Canvas, seen: Seen) -> None:
        """The measured burst in its ballistic circle, waves of sound, wind and listener."""
        model = self.model
        newest = burst_now(model)
        if newest is not None and newest.age < NAMED_S:
            x, y, near = projected(seen, *burst_middle(model))
            canvas.circle(
                (x, y), near * newest.ballistics, outline="text1", width=1.2, dash=EXACT_DASH, alpha=0.6
            )
        waves = model.thunder.waves[: int(model.thunder.counts[thunder.WAITING])]
        for wave in waves[-MOST_WAVES:].tolist():
            age = seen.time - wave[thunder.EMITTED]
            if 0.02 < age < SOUND_S:
                fade = 0.35 * (1.0 - age / SOUND_S)
                x, y, near = projected(seen, *wave[thunder.AT_X : thunder.AT_DEPTH + 1])
                canvas.circle(
                    (x, y),
                    near * thunder.SPEED_OF_SOUND * age,
                    outline="chalk",
                    width=1.0,
                    alpha=fade,
                )
        if WIND in model.active:
            self._draw_wind(canvas)
        x, y = self.model.listener_place()
        canvas.handle((x, y + 7.5), self.hand.held)

    def _draw_wind(self, canvas: Canvas) -> None:
        frame, wind = self.model.content.view, self.model.wind
        if abs(wind) < 0.05:
            return
        length = 0.16 * (frame.right - frame.left) * min(abs(wind) / 12.0, 1.0)
        middle = 0.5 * (frame.left + frame.right)
        tail = (middle - 0.5 * math.copysign(length, wind), frame.top - 6.0)
        canvas.arrow(tail, (math.copysign(length, wind), 0.0), "green", "w")


def _color_of(row: list[float]) -> tuple[float, float, float]:
    """The light of a flash: of its shell's stars; gold for a mortar's."""
    if row[m.FLASH_WHAT] <= 0.0:
        return GOLD
    return FLASH_COLORS.get(SHELLS[int(row[m.FLASH_SHELL])], GOLD)


def warm_up_shine() -> None:
    """Compile the kernels of the picture, on one star and one puff."""
    stars, seen, one = np.zeros((FIELDS, 1)), Seen(0.0, 0.0, 0.0), np.zeros(1)
    shades, colors = shades_of(look_of("red")), np.zeros(1, np.uint32)
    glow = Glow(0, 0, 0.0, 0.0, 0.0, 0.0)
    shine(
        stars, shades, glow, seen, np.zeros((1, 2)), colors,
        np.zeros(1, np.uint8), one, 0,
    )  # fmt: skip
    shed_light(stars, shades, glow, 0.0, 1, np.zeros((math.prod(CELLS), 7)))
    light_smoke(
        stars, np.zeros((0, 7)), np.zeros((0, 6)), seen, np.zeros(4), np.zeros((1, 2)), one, colors, one,
    )  # fmt: skip
