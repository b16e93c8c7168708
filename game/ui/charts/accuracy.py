"""What accuracy costs, as an overlay: the plot, a table of orders and costs, a sentence, the progress.

The overlay knows nothing of how a study is run: it is given ``AccuracyData`` and how far the runs are, and
gives back commands: ``stop``, ``save-csv``, ``save-picture``, ``close``, ``point`` with the parameters of
the point that was clicked, and ``study`` with the number of another study of the scene.
"""

from __future__ import annotations

import math

import pygame

from game.ui.charts.accuracy_data import AccuracyData, Progress
from game.ui.charts.accuracy_table import paint_table
from game.ui.charts.plot import WorkPrecisionPlot
from game.ui.look.look import Look
from game.ui.look.numerals import format_si
from game.ui.look.shapes import draw_box
from game.ui.widgets.buttons import HEIGHT as BUTTON
from game.ui.widgets.buttons import draw_button
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.loading import seconds_text
from game.ui.widgets.overlay import Overlay, draw_close
from game.ui.widgets.wishes import Wish

TITLE = "What accuracy costs"
CARD, PADDING, FOOT = 608, 32, 72  # design px
TABLE = 320  # design px that the table takes at the right
TAB, TAB_MOST = 28, 168  # design px: height and greatest width of a study's tab
WORDS = {"stop": ("Stop", 72), "save-csv": ("Save CSV", 96), "save-picture": ("Save picture", 112)}


class AccuracyPage:
    """The overlay as a widget."""

    def __init__(self, look: Look, data: AccuracyData) -> None:
        self.look = look
        self.data = data
        self.progress = Progress()
        self.plot = WorkPrecisionPlot(look, data.axes)
        self.overlay = Overlay(look, CARD)
        self.spots = Hotspots()
        self._point: tuple[int, int] | None = None
        self._pressed: tuple[int, int] | None = None
        self._card: pygame.Surface | None = None
        self._drawn: object = None
        self.show(data)

    def place(self, window: pygame.Rect, look: Look) -> None:
        """Take a window and an appearance."""
        self.look = self.plot.look = look
        self.overlay.place(window, look)
        self._place_spots()
        self._card = None

    def show(self, data: AccuracyData) -> None:
        """New data, as runs come in."""
        changed = data.studies != self.data.studies
        self.data = data
        if changed:
            self._place_spots()
        self.plot.axes = data.axes
        self.plot.show(data.series, data.present, data.target, data.floor)
        self._point = None
        self._card = None

    def report(self, progress: Progress) -> None:
        """How far the runs are now."""
        if progress != self.progress:
            changed = (progress.running, bool(progress.done)) != (
                self.progress.running,
                bool(self.progress.done),
            )
            self.progress = progress
            self._card = None
            if changed:
                self._place_spots()

    def leave(self) -> None:
        """Start to fade out."""
        self.overlay.leave()

    def update(self, dt_s: float) -> bool:
        """Let time pass; False when the card has gone."""
        self.spots.update(dt_s, self.look)
        return self.overlay.update(dt_s)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """The command of an event, if it makes one."""
        if event.type in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            at = (event.pos[0] - self.overlay.card.x, event.pos[1] - self.overlay.card.y)
            self._point = self._clickable(self.plot.hit(at))
            if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
                self._pressed = self._point
                if not self.overlay.card.collidepoint(event.pos):
                    return Wish("close")
            elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
                pressed, self._pressed = self._pressed, None
                if pressed is not None and pressed == self._point:
                    i, j = pressed
                    return Wish("point", dict(self.data.series[i].runs[j].parameters))
        name = self.spots.handle(event)
        if name is not None and name.startswith("study-"):
            return Wish("study", int(name.removeprefix("study-")))
        return Wish(name) if name is not None else None

    def _clickable(self, hit: tuple[int, int] | None) -> tuple[int, int] | None:
        """Only a point that says how to set the scene."""
        if hit is None or not self.data.series[hit[0]].runs[hit[1]].parameters:
            return None
        return hit

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """What the point under the pointer is."""
        if self._point is None:
            return None
        i, j = self._point
        one, point = self.data.series[i], self.data.series[i].runs[j]
        x, y = self.plot.place(i, point)
        came = "failed" if point.diverged else self.plot.error_text(point.y)
        words = f"{one.name}, {point.words}" if point.words else one.name
        place = pygame.Rect(0, 0, 2 * self.look.px(8), 2 * self.look.px(8))
        place.center = (round(x) + self.overlay.card.x, round(y) + self.overlay.card.y)
        if self.data.axes.x_unit != "s":
            return f"{words}\n{came}", place
        return f"{words}\n{came} for {format_si(point.x, 's')}", place

    # -- places -------------------------------------------------------------------------------------

    def _place_spots(self) -> None:
        px, card = self.look.px, self.overlay.card
        spots: list[Hotspot] = []
        right = card.right - px(PADDING)
        for name in ("save-picture", "save-csv", "stop"):
            place = pygame.Rect(0, 0, px(WORDS[name][1]), px(BUTTON))
            place.midright = (right, card.bottom - px(FOOT) + px(32))
            right = place.x - px(8)
            enabled = self.progress.running if name == "stop" else self.progress.done > 0
            spots.insert(0, Hotspot(name, place, enabled))
        self.spots.place([*spots, *self._tabs(), self.overlay.close_spot()])

    def _tabs(self) -> list[Hotspot]:
        """A tab for each study of the scene, in a row that ends before the cross."""
        px, card = self.look.px, self.overlay.card
        names = self.data.studies
        title = self.look.fonts.size(TITLE, 22, "display")[0]
        right = card.right - px(72)
        space = right - (card.x + px(PADDING) + title + px(24))
        if len(names) < 2 or space < px(60) * len(names):
            return []
        most = min(px(TAB_MOST), space // len(names) - px(8))
        widths = [min(self.look.fonts.size(name, 13, "semibold")[0] + px(24), most) for name in names]
        x = right - sum(widths) - px(8) * (len(names) - 1)
        tabs = []
        for i, width in enumerate(widths):
            tabs.append(Hotspot(f"study-{i}", pygame.Rect(x, card.y + px(22), width, px(TAB))))
            x += width + px(8)
        return tabs

    def _plot_rect(self) -> pygame.Rect:
        """The plot on the card."""
        px, card = self.look.px, self.overlay.card
        right = card.w - px(PADDING) - (px(TABLE) if self._has_table() else 0)
        top, bottom = px(104), card.h - px(FOOT) - px(56)
        return pygame.Rect(px(88), top, max(1, right - px(88)), max(1, bottom - top))

    def _has_table(self) -> bool:
        return self.overlay.card.w >= self.look.px(760)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Draw veil and card; the card's picture is kept while nothing changes."""
        self.overlay.draw_veil(surface)
        state = (self.spots.state(), self._point)
        if self._card is None or state != self._drawn:
            self._drawn = state
            self._card = self._paint()
        self.overlay.draw_card(surface, self._card)

    def picture(self) -> pygame.Surface:
        """The card alone, to be saved."""
        return self._paint()

    def _paint(self) -> pygame.Surface:
        look, px = self.look, self.look.px
        card = self.overlay.background()
        flat = pygame.Surface(card.get_size(), 0, 32)  # the plot's kernels want an opaque ground
        flat.fill(look.theme.panel)
        self._paint_heading(flat)
        self.plot.draw(flat, self._plot_rect(), self._point)
        if self._has_table():
            target = self.plot.error_text(self.data.target, 1) if math.isfinite(self.data.target) else ""
            area = pygame.Rect(flat.get_width() - px(TABLE), px(104), px(TABLE) - px(PADDING), 0)
            area.h = flat.get_height() - px(FOOT) - area.y
            paint_table(flat, look, area, self.data, target)
        self._paint_foot(flat)
        inside = card.get_rect().inflate(-2 * look.border, -2 * look.border)
        corner = px(PADDING) // 2
        for part in (inside.inflate(-2 * corner, 0), inside.inflate(0, -2 * corner)):
            card.blit(flat, part, part)
        return card

    def _paint_heading(self, flat: pygame.Surface) -> None:
        """What the card is, and what was measured against what: in one line if it fits, else in two,
        smaller if need be.
        """
        look, px = self.look, self.look.px
        space = flat.get_width() - px(PADDING) - px(64)
        parts = [part for part in (self.data.title, self.data.subtitle) if part]
        whole = ". ".join(parts)
        lines = [whole] if look.fonts.size(whole, 13, "medium")[0] <= space else parts
        size = 13 if all(look.fonts.size(words, 13, "medium")[0] <= space for words in lines) else 12
        raised = px(7) * (len(lines) - 1)
        look.text(flat, TITLE, (px(PADDING), px(36) - raised), 22, "display")
        for at, words in enumerate(lines):
            place = (px(PADDING), px(62) - raised + px(18) * at)
            look.text(flat, look.fonts.fit(words, size, "medium", space), place, size, "medium", "text2")

    def _paint_foot(self, flat: pygame.Surface) -> None:
        """Progress at the left, buttons at the right."""
        look, px, card = self.look, self.look.px, self.overlay.card
        top = flat.get_height() - px(FOOT)
        flat.fill(look.theme.line, (0, top, flat.get_width(), look.border))
        stop = self.spots.find("stop")
        end = (stop.rect.x - card.x if stop is not None else flat.get_width()) - px(24)
        space = min(px(440), end - px(PADDING))
        if space > px(80):
            self._paint_progress(flat, px(PADDING), top, space)
        for spot in self.spots.spots:
            rect = spot.rect.move(-card.x, -card.y)
            if spot.name == "close":
                draw_close(flat, look, rect, self.spots.hover("close"))
                continue
            number = spot.name.removeprefix("study-")
            tab = number != spot.name
            words = self.data.studies[int(number)] if tab else WORDS[spot.name][0]
            chosen = tab and int(number) == self.data.study
            draw_button(
                flat, look, rect, words, primary=chosen, lit=self.spots.hover(spot.name),
                pressed=self.spots.pressed == spot.name, enabled=spot.enabled,
            )  # fmt: skip

    def _paint_progress(self, flat: pygame.Surface, left: int, top: int, space: int) -> None:
        look, px, p = self.look, self.look.px, self.progress
        words = (
            f"Measuring {p.label}"
            if p.running
            else "All runs measured"
            if p.done and p.done == p.total
            else "Stopped"
        )
        if not p.total:
            words = "Nothing measured yet"
        x = (
            left
            + look.text(flat, look.fonts.fit(words, 13, "medium", space), (left, top + px(20)), 13).w
            + px(10)
        )
        rest = f"{p.done} of {p.total} runs" if p.total else ""
        if p.running and math.isfinite(p.left_s):
            rest += f", {seconds_text(p.left_s)} left"
        rest = look.fonts.fit(rest, 13, "medium", max(0, left + space - x))
        look.text(flat, rest, (x, top + px(20)), 13, "medium", "text3")
        bar = pygame.Rect(left, top + px(38), space, px(6))
        draw_box(flat, bar, px(3), look.theme.hover)
        if p.total > 0 and p.done > 0:
            bar.w = max(bar.h, round(space * min(p.done / p.total, 1.0)))
            draw_box(flat, bar, px(3), look.theme.accent)
