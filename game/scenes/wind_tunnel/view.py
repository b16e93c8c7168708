"""How the tunnel is drawn: the air, the smoke, the shape, what is measured; charts and flights beside."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.wind_tunnel.chart import draw_curves, draw_now, draw_polar
from game.scenes.wind_tunnel.falling import draw_flights, draw_shaft
from game.scenes.wind_tunnel.hand import WindTunnelHand
from game.scenes.wind_tunnel.layout import Layout, layout_of
from game.scenes.wind_tunnel.model import WindTunnelModel, WindTunnelState
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.standing import Standing

SPEED = ((0.0, "violet"), (0.28, "stage"), (0.6, "stage"), (0.8, "body"), (1.0, "chalk"))
SIGNED = ((0.0, "vermilion"), (0.5, "stage"), (1.0, "chalk"))
PRESSURE = ((0.0, "chalk"), (0.5, "stage"), (1.0, "vermilion"))
NEAR = 2.0  # %, that drag by both ways may differ without a word
FASTEST, STEEPEST = 1.6, 6.0  # of the wind, and of wind over chord: drawn in the last colour
ARROW = 1.0  # chords that a coefficient of 1 is long
WORDS = {
    "smoke": "", "speed": "0 to 1.6 of the wind", "vorticity": "−6 to 6 of wind over chord",
    "pressure": "−1 to 1 of the wind's own",
}  # fmt: skip


class WindTunnelView:
    """Draws a model and its hand."""

    def __init__(self, model: WindTunnelModel, hand: WindTunnelHand):
        self.model, self.hand = model, hand
        self._standing = Standing()

    def layout(self) -> Layout:
        """Where all stands."""
        return layout_of(self.model)

    def draw(self, canvas: Canvas, previous: WindTunnelState | None, alpha: float) -> None:
        """All of it; flights ``alpha`` of the way from the state before to now."""
        place = self.layout()
        tunnel, chosen = place.tunnel, self.model.parameters
        measured = (self.model.sweep.table.tobytes(), chosen.measure, int(chosen.order))
        self._standing.draw(canvas, self._paint_charts, place, *measured)
        with canvas.within((tunnel.left, tunnel.bottom), (tunnel.right, tunnel.top)):
            self._draw_air(canvas, place)
            if self.model.parameters.streaks:
                self._draw_smoke(canvas)
            self._draw_shape(canvas)
        self._draw_walls(canvas, place)
        self._draw_state(canvas, place)
        draw_now(canvas, self.model, place.curves, place.polar)
        before = previous.flights if previous is not None else None
        draw_flights(canvas, self.model, place.flights, before, alpha)
        if len(self.hand.path) > 1:
            canvas.polyline(np.array(self.hand.path), "amber", 2.4)

    def _paint_charts(self, canvas: Canvas) -> None:
        """The ground of all, and the charts, which change only when an angle has been measured."""
        place = self.layout()
        canvas.fill()
        draw_curves(canvas, self.model, place.curves)
        draw_polar(canvas, self.model, place.polar)
        draw_shaft(canvas, place.flights)

    def _draw_air(self, canvas: Canvas, place: Layout) -> None:
        tunnel, view = self.model.tunnel, self.model.parameters.view
        gas, pace = tunnel.gas, tunnel.settings.pace
        corners = (place.tunnel.left, place.tunnel.bottom), (place.tunnel.right, place.tunnel.top)
        if view == "speed":
            flow = gas.velocity()
            speed = np.sqrt(flow[..., 0] ** 2 + flow[..., 1] ** 2)
            canvas.field(speed / (FASTEST * pace), *corners, SPEED, 0.85)
        elif view == "vorticity":
            nodes = gas.vorticity()
            cells = 0.25 * (nodes[1:, 1:] + nodes[:-1, 1:] + nodes[1:, :-1] + nodes[:-1, :-1])
            scale = STEEPEST * pace / tunnel.outline.chord
            canvas.field(0.5 + 0.5 * cells / scale, *corners, SIGNED)
        elif view == "pressure":
            canvas.field(0.5 + 0.5 * gas.pressure / (0.5 * pace * pace), *corners, PRESSURE)

    def _draw_smoke(self, canvas: Canvas) -> None:
        plain = self.model.parameters.view == "smoke"
        for line in self.model.rake.lines():
            canvas.polyline(line, "text1", 1.6 if plain else 1.2, alpha=0.8 if plain else 0.45)

    def _draw_shape(self, canvas: Canvas) -> None:
        tunnel = self.model.tunnel
        corners = tunnel.placed.corners
        canvas.polygon(corners, "body", 1.0, "text1", 1.8)
        x, y = tunnel.settings.place
        chord = tunnel.outline.chord
        c, s = math.cos(tunnel.attack), -math.sin(tunnel.attack)
        reach = 0.75 * max(chord, 2.0 * tunnel.outline.reach)
        canvas.line(
            (x - reach * c, y - reach * s), (x + reach * c, y + reach * s), "text3", 1.0, dash=(5.0, 5.0)
        )
        canvas.line((x - 1.1 * reach, y), (x, y), "text3", 1.0, dash=(2.0, 5.0))
        if self.model.parameters.box:
            h = tunnel.grid.cell
            left, right, low, high = (float(k) * h for k in tunnel.box)
            box = np.array([(left, low), (right, low), (right, high), (left, high)])
            canvas.polygon(box, outline="amber", width=1.4, dash=(6.0, 4.0))
        if self.model.parameters.forces and self.model.average.settled:
            self._draw_forces(canvas, (x, y))
        canvas.dot((x, y), 3.0, "amber")

    def _draw_forces(self, canvas: Canvas, at: tuple[float, float]) -> None:
        mean = self.model.mean()
        drag, lift, moment = mean.book if self.model.parameters.measure == "book" else mean.wall
        length = ARROW * self.model.tunnel.outline.chord
        canvas.arrow(at, (length * drag, 0.0), "vermilion", "D")
        canvas.arrow(at, (0.0, length * lift), "green", "L")
        turn = min(max(4.0 * moment, -2.6), 2.6)
        if abs(turn) > 0.05:
            radius = 0.62 * self.model.tunnel.outline.chord
            start = math.pi - self.model.tunnel.attack
            canvas.arc(at, radius, start, start - turn, "violet", 2.4)
            end = start - turn
            tip = (at[0] + radius * math.cos(end), at[1] + radius * math.sin(end))
            canvas.dot(tip, 3.6, "violet")

    def _draw_walls(self, canvas: Canvas, place: Layout) -> None:
        tunnel = place.tunnel
        dash = (8.0, 6.0) if self.model.parameters.walls == "open" else None
        for y in (tunnel.bottom, tunnel.top):
            canvas.line((tunnel.left, y), (tunnel.right, y), "text2", 2.4, dash=dash)
        wind = self.model.tunnel.settings.wind
        for share in (0.2, 0.5, 0.8):
            y = tunnel.bottom + share * (tunnel.top - tunnel.bottom)
            canvas.arrow((tunnel.left + 0.05, y), (0.03 * self.model.wide * wind, 0.0), "accent", width=1.8)

    def _draw_state(self, canvas: Canvas, place: Layout) -> None:
        """The angle, and how far its measurement is, as a bar along the tunnel's top."""
        model, tunnel = self.model, place.tunnel
        words = f"α {model.attack:+.1f}°".replace("-", "−")
        if model.sweep.running:
            words += f"   {int(model.sweep.at[0]) + 1} of {len(model.sweep.table)}"
        corner = (tunnel.right, tunnel.top)
        _draw_plate(canvas, corner, words, 13, "semibold", -1.0)
        canvas.label(corner, words, "text1", 13, "semibold", anchor="topright", offset=(-8.0, 8.0))
        share = model.average.progress
        settle = model.average.settle / max(model.average.settle + model.average.window, 1e-12)
        left, right = tunnel.left, tunnel.right
        y = tunnel.top
        end = left + share * (right - left)
        first = left + min(share, settle) * (right - left)
        canvas.line((left, y), (first, y), "text3", 4.0)
        if share > settle:
            canvas.line((first, y), (end, y), "amber", 4.0)
        if WORDS[model.parameters.view]:
            words = f"{model.parameters.view}: {WORDS[model.parameters.view]}"
            low = (tunnel.right, tunnel.bottom)
            _draw_plate(canvas, low, words, 11, "medium", 1.0)
            canvas.label(low, words, "text2", 11, anchor="bottomright", offset=(-8.0, -6.0))
        words = apart_words(model)
        if words:
            low = (tunnel.left, tunnel.bottom)
            canvas.label(
                low, canvas.figure("apart", words), "text2", 11, anchor="bottomleft", offset=(8.0, -6.0)
            )


def apart_words(model: WindTunnelModel) -> str:
    """How far drag at the wall is from that by momentum, and why; nothing while they are near."""
    mean = model.mean()
    if not mean.seconds > 0.0 or not abs(mean.book[0]) > 1e-9:
        return ""
    more = 100.0 * (mean.wall[0] / mean.book[0] - 1.0)
    if abs(more) < NEAR:
        return ""
    cells = int(model.parameters.cells)
    side = "more" if more > 0.0 else "less"
    return f"drag at the wall {abs(more):.0f} % {side}: read in {cells} cells a chord"


def _draw_plate(
    canvas: Canvas, corner: tuple[float, float], words: str, size: int, weight: str, side: float
) -> None:  # fmt: skip
    """Ground behind words in a corner of the tunnel, above it (side 1) or below, so that no smoke is read
    with them.
    """
    wide, tall = (canvas.px(value / canvas.k) for value in canvas.fonts.size(words, size, weight))
    gap, rim = canvas.px(8.0), canvas.px(4.0)
    right, near = corner[0] - gap + rim, corner[1] + side * (gap - rim)
    left, far = corner[0] - gap - wide - rim, corner[1] + side * (gap + tall + 0.5 * rim)
    box = np.array([(left, near), (right, near), (right, far), (left, far)])
    canvas.polygon(box, fill="stage", fill_alpha=0.86)
