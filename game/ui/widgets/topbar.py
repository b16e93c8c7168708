"""The bar at the top of a scene: way back, name, transport, measured values, camera, help and panel.

It is drawn into a picture of its own and only when something in it has changed. In a narrow window the
least needed parts go first: measured values, the speed, the title, then single buttons.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import pygame

from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING, format_si
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.wishes import Wish

RIGHT = ("panel", "help", "screenshot", "film", "tools")  # buttons, from the right
NARROW, NARROWEST = 960, 480  # design px of width below which fewer of them are shown
COLUMN = 76  # design px, width of a readout whose words are no longer than that
TIPS = {
    "menu": "Back to the menu", "reset": "Reset", "step-back": "One step back", "pause": "Pause or go on",
    "step": "One step", "slower": "Slower", "faster": "Faster", "speed": "Normal speed",
    "screenshot": "Save a picture", "film": "Film this, or the last ten seconds",
    "tools": "Ruler, protractor, stop-watch, charts", "help": "Help", "panel": "Panel on or off",
}  # fmt: skip
TOO_SLOW = "Steps or pictures take too long for the speed that is set. Click for normal speed"
SPEED_WISHES = {
    "slower": Wish("speed", -1),
    "faster": Wish("speed", 1),
    "speed": Wish("speed", 0),
}


class BarState(NamedTuple):
    """What the bar shows. ``readouts``: at most four (caption, value, unit); not ``ready`` greys it out.

    ``reached``: the speed at which the scene really runs, where that is less than ``speed``. ``filming``: a
    film is being taken.
    """

    task: str
    title: str
    paused: bool = False
    speed: float = 1.0
    panel: bool = True
    readouts: tuple[tuple[str, float, str], ...] = ()
    ready: bool = True
    reached: float | None = None
    filming: bool = False


def speed_text(speed: float) -> str:
    """1, 2 or 4 times, or a fraction: "1/8×"."""
    if not (math.isfinite(speed) and speed > 0.0):
        return NOTHING
    inverse = 1.0 / speed
    if speed < 1.0 and abs(inverse - round(inverse)) < 1e-9:
        return f"1/{round(inverse)}×"
    return f"{speed:g}×"


class TopBar:
    """The bar as a widget: ``handle`` gives commands, ``update`` takes the state, ``draw`` shows it."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.slim = False
        self.spots = Hotspots()
        self.state = BarState("", "")
        self._shown: tuple[tuple[str, float, str], ...] = ()
        self._picture: pygame.Surface | None = None
        self._drawn: tuple[object, ...] = ()

    def place(self, rect: pygame.Rect, look: Look, slim: bool = False) -> None:
        """Take a place in the window and an appearance. slim: the outer buttons alone, over a picture."""
        self.rect, self.look, self.slim = pygame.Rect(rect), look, slim
        self._picture = None
        self._place_spots()

    def covers(self, position: tuple[int, int]) -> bool:
        """Whether a button is at a place, window px."""
        return any(spot.rect.collidepoint(position) for spot in self.spots.spots)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """The command of a press, if the event makes one."""
        name = self.spots.handle(event)
        return None if name is None else SPEED_WISHES.get(name, Wish(name))

    def update(self, dt_s: float, state: BarState, fresh: bool = True) -> None:
        """Let time pass; numbers change if they are ``fresh``, everything else at once."""
        self.spots.update(dt_s, self.look)
        fresh = fresh or state.ready != self.state.ready or state.task != self.state.task
        placed_again = len(state.readouts) != len(self.state.readouts) or state.ready != self.state.ready
        placed_again = placed_again or state.reached != self.state.reached
        self.state = state
        if fresh:
            self._shown = state.readouts
        if placed_again:
            self._place_spots()

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """Tool tip of the place under the pointer, and where that is."""
        spot = self.spots.find(self.spots.hovered) if self.spots.hovered else None
        return (spot.tip, spot.rect) if spot is not None and spot.tip else None

    def draw(self, surface: pygame.Surface) -> None:
        """Show the bar; its picture is made again only when something has changed."""
        if self.rect.w < 1 or self.rect.h < 1:
            return
        wanted = (self.state._replace(readouts=()), self._shown, self.spots.state())
        if self._picture is None or self._drawn != wanted:
            if self._picture is None:
                self._picture = pygame.Surface(self.rect.size, pygame.SRCALPHA if self.slim else 0, 32)
            self._drawn = wanted
            self._paint(self._picture)
        surface.blit(self._picture, self.rect)

    # -- places -------------------------------------------------------------------------------------

    def _place_spots(self) -> None:
        px, rect = self.look.px, self.rect
        spots: list[Hotspot] = []

        def add(name: str, center_x: float, width: int, height: int, enabled: bool = True) -> None:
            place = pygame.Rect(0, 0, px(width), px(height))
            place.center = (round(center_x), rect.centery)
            slow = name == "speed" and self.state.reached is not None
            spots.append(Hotspot(name, place, enabled, TOO_SLOW if slow else TIPS[name]))

        k, width, ready = self.look.k, self.rect.w / self.look.k, self.state.ready
        add("menu", rect.x + px(24), 32, 32)
        shown = 2 if width < NARROWEST else 3 if width < NARROW else len(RIGHT)
        for i, name in enumerate(RIGHT[:shown]):
            add(name, rect.right - px(24) - i * px(32), 32, 32)
        if not self.slim:
            self._add_transport(add, k, width, ready)
        self.spots.place(spots)

    def _add_transport(self, add: Callable[..., None], k: float, width: float, ready: bool) -> None:
        """The buttons in the middle, as far as they have space in ``width`` design px."""
        rect = self.rect
        middle = rect.x + (0.5 * width - (88 if width >= 880 else 0)) * k
        if width >= 560:
            add("reset", middle - 84 * k, 32, 32, ready)
            add("step-back", middle - 44 * k, 32, 32, ready)
        add("pause", middle, 36, 36, ready)
        add("step", middle + 44 * k, 32, 32, ready)
        if width >= 640:
            add("slower", middle + 88 * k, 32, 28, ready)
            add("speed", middle + 122 * k, 36, 28, ready)
            add("faster", middle + 156 * k, 32, 28, ready)

    def _readout_space(self) -> tuple[int, int]:
        """Right edge of the readouts and the space left of it, both px; no space where they are not shown."""
        px = self.look.px
        last, faster = self.spots.find("tools") or self.spots.find("screenshot"), self.spots.find("faster")
        if last is None or faster is None:
            return 0, 0
        right = last.rect.x - px(20)
        return right, max(0, right - faster.rect.right - px(8))

    def columns(self) -> list[tuple[int, str, str]]:
        """The readouts that have space, from the right: right edge (px in the bar), caption, words.

        A column is as wide as its caption and its words need, in halves of the usual width so that
        it seldom changes.
        """
        right, space = self._readout_space()
        x, found = right - self.rect.x, []
        for caption, value, unit in reversed(self._shown[:4]):
            words = format_si(value, unit) if self.state.ready else NOTHING
            width = self._column_width(caption, words)
            if width > space:
                break
            found.append((x, caption, words))
            x, space = x - width, space - width
        return found

    def _column_width(self, caption: str, words: str) -> int:
        """Width a readout takes, px: whole halves of the usual one."""
        fonts, px = self.look.fonts, self.look.px
        wide = max(fonts.size(words, 13, "semibold")[0], fonts.size(caption, 11, "medium")[0]) + px(8)
        return px(COLUMN) if wide <= px(COLUMN) else round(-(-wide // px(COLUMN / 2)) * px(COLUMN / 2))

    # -- picture ------------------------------------------------------------------------------------

    def _paint(self, surface: pygame.Surface) -> None:
        theme, px = self.look.theme, self.look.px
        surface.fill((0, 0, 0, 0) if self.slim else theme.panel)
        if not self.slim:
            line = self.look.border
            surface.fill(theme.line, (0, self.rect.h - line, self.rect.w, line))
            self._paint_title(surface)
            self._paint_speed(surface)
        for spot in self.spots.spots:
            if spot.name == "pause":
                self._paint_play(surface, spot)
            elif spot.name != "speed":
                self._paint_button(surface, spot)
        self._paint_readouts(surface)
        shifted = Hotspots()
        shifted.place([spot._replace(rect=self._inner(spot.rect)) for spot in self.spots.spots])
        shifted.focused = self.spots.focused
        shifted.draw_focus(surface, self.look, px(8))

    def _inner(self, rect: pygame.Rect) -> pygame.Rect:
        return rect.move(-self.rect.x, -self.rect.y)

    def _paint_title(self, surface: pygame.Surface) -> None:
        look, px = self.look, self.look.px
        first = next(s for s in self.spots.spots if s.name in ("reset", "pause"))
        x, limit = px(48), self._inner(first.rect).x - px(12)
        if self.state.task:
            words = look.fonts.size(self.state.task, 12, "semibold")[0]
            chip = pygame.Rect(x, 0, words + 2 * px(8), px(24))
            chip.centery = self.rect.h // 2
            if chip.right <= limit:
                draw_box(surface, chip, px(6), look.theme.accent_soft)
                look.text(surface, self.state.task, chip.center, 12, "semibold", "accent", "center")
                x = chip.right + px(10)
        title = look.fonts.fit(self.state.title, 15, "semibold", max(0, limit - x))
        if len(title) > 1:
            look.text(surface, title, (x, self.rect.h / 2), 15, "semibold")

    def _paint_speed(self, surface: pygame.Surface) -> None:
        slower, faster = self.spots.find("slower"), self.spots.find("faster")
        if slower is None or faster is None:
            return
        tray = self._inner(slower.rect.union(faster.rect))
        draw_box(surface, tray, self.look.px(8), self.look.theme.inset)
        words, (x, y) = speed_text(self.state.speed), tray.center
        if self.state.reached is None:
            self.look.text(surface, words, (x, y), 13, "semibold", "text1", "center")
        else:
            px, reached = self.look.px, f"{self.state.reached:.2g}"
            self.look.text(surface, reached, (x, y - px(6)), 13, "semibold", "amber", "center")
            self.look.text(surface, f"of {words}", (x, y + px(8)), 11, "medium", "amber", "center")

    def _paint_play(self, surface: pygame.Surface, spot: Hotspot) -> None:
        look, theme = self.look, self.look.theme
        rect = self._inner(spot.rect)
        lit = self.spots.hover("pause")
        fill = theme.accent.lerp(theme.text1 if theme.name == "dark" else theme.ink, 0.15 * lit)
        if self.spots.pressed == "pause":
            fill = theme.accent.lerp(theme.bg, 0.18)
        ink = theme.on_accent
        if not spot.enabled:
            fill, ink = theme.hover, theme.text3
        draw_disc(surface, (rect.x + rect.w / 2, rect.y + rect.h / 2), rect.w / 2, fill)
        stopped = self.state.paused or not self.state.ready
        self._paint_icon(surface, "play" if stopped else "pause", rect, look.px(20), ink)

    def _paint_button(self, surface: pygame.Surface, spot: Hotspot) -> None:
        theme, rect = self.look.theme, self._inner(spot.rect)
        on = spot.name == "panel" and self.state.panel
        lit = self.spots.hover(spot.name)
        color = theme.accent if on else theme.text2.lerp(theme.text1, lit)
        if not spot.enabled:
            color = theme.line2
        base = theme.inset if spot.name in ("slower", "faster") else theme.panel
        if on:
            base = theme.accent_soft
        if on or lit > 0.0:
            target = theme.line if self.spots.pressed == spot.name else theme.hover
            draw_box(surface, rect, self.look.px(8), base if on else base.lerp(target, lit))
        names = {"slower": "minus", "faster": "plus", "screenshot": "camera", "menu": "back"} | {
            "film": "record",
            "tools": "ruler",
        }
        if spot.name == "film" and self.state.filming:
            color = self.look.color("vermilion")
        size = self.look.px(14 if spot.name in ("slower", "faster") else 20)
        self._paint_icon(surface, names.get(spot.name, spot.name), rect, size, color)

    def _paint_icon(
        self, surface: pygame.Surface, name: str, rect: pygame.Rect, size: int, color: pygame.Color
    ) -> None:
        picture = icon(name, size, color)
        surface.blit(picture, picture.get_rect(center=rect.center))

    def _paint_readouts(self, surface: pygame.Surface) -> None:
        look, px = self.look, self.look.px
        right, space = self._readout_space()
        if space < px(COLUMN):
            return
        surface.fill(look.theme.line, (right - self.rect.x + px(12), px(12), look.border, px(24)))
        for x, caption, words in self.columns():
            look.text(surface, words, (x, px(17)), 13, "semibold", "text1", "right")
            look.text(surface, caption, (x, px(34)), 11, "medium", "text3", "right")
