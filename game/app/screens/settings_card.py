"""The card of the settings: theme, size of the interface, sound, motion, full screen, name, keys."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.screens.question import Question
from game.app.window.settings import settings_path
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot

ROW, LEAST_ROW, FOOT = 56, 36, 48  # design px
LABELS, FEW_LABELS, ROOMY = 260, 116, 560  # design px: before the segments; with words; of a card's width
VOLUMES = ((0.0, "Off"), (0.25, "Soft"), (0.7, "Normal"), (1.0, "Loud"))
SCALES = (0.75, 0.9, 1.0, 1.25, 1.5, 2.0)


class _Line(NamedTuple):
    label: str
    about: str
    options: tuple[tuple[str, str], ...]  # name of the place, words


LONGEST_NAME = 40  # letters, as the settings have it
NOBODY = "No name yet"
LINES = (
    _Line("Theme", "colours of the interface", (("theme-dark", "Dark"), ("theme-light", "Light"))),
    _Line("Size", "of letters and controls", tuple((f"scale-{s:g}", f"{s * 100:.0f} %") for s in SCALES)),
    _Line("Sound", "of balls and cushions", tuple((f"volume-{v:g}", w) for v, w in VOLUMES)),
    _Line("Motion", "fades and lifts of the interface", (("motion-all", "All"), ("motion-less", "Less"))),
    _Line(
        "Window",
        "as it is, or the whole screen",
        (("screen-window", "Window"), ("screen-full", "Full screen")),
    ),
    _Line("Name", "of the player, in titles of stories", (("name-asked", NOBODY),)),
    _Line("Keys", "each by its place", (("keys-shown", "See and change keys"),)),
)


class SettingsCard(CardScreen):
    """Segments; a press acts at once and is kept."""

    called: ClassVar[str] = "The settings"

    def __init__(self, host: Host):
        super().__init__(host)
        self.veil.size = (self.width, HEAD + ROW * len(LINES) + FOOT + 16)
        self.restyle()

    @property
    def heading(self) -> str:
        return "Settings"

    @property
    def _roomy(self) -> bool:
        """Whether there is space for words about each line."""
        return self.veil.card.w >= self.host.look.px(ROOMY)

    @property
    def _row(self) -> int:
        """Height of a line, window px: less in a low window."""
        px = self.host.look.px
        fits = (self.veil.card.h - px(HEAD)) // len(LINES)
        return min(px(ROW), max(px(LEAST_ROW), fits))

    def _chosen(self) -> set[str]:
        settings = self.host.settings
        return {
            f"theme-{settings.theme}",
            f"scale-{settings.ui_scale:g}",
            f"volume-{settings.volume:g}",
            "motion-less" if settings.less_motion else "motion-all",
            "screen-full" if self.host.full_screen else "screen-window",
        }

    def state(self) -> object:
        return self.host.settings.name, *sorted(self._chosen())

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        spots = []
        left = card.x + px(LABELS if self._roomy else FEW_LABELS)
        space = max(card.right - px(32) - left, 1)
        for i, line in enumerate(LINES):
            y = card.y + px(HEAD) + i * self._row + (self._row - px(32)) // 2 - px(4)
            for j, (name, _) in enumerate(line.options):
                x0, x1 = (left + space * n // len(line.options) for n in (j, j + 1))
                spots.append(Hotspot(name, pygame.Rect(x0, y, max(x1 - x0, 1), px(32))))
        return spots

    def pressed(self, name: str) -> None:
        kind, _, value = name.partition("-")
        settings = self.host.settings
        if kind == "keys":
            self.host.cards.open_keys()
            return
        if kind == "name":
            self._ask_name()
            return
        if kind == "theme":
            settings.theme = "light" if value == "light" else "dark"
        elif kind == "scale":
            settings.ui_scale = float(value)
        elif kind == "volume":
            settings.volume = self.host.sounds.volume = float(value)
            self.host.sounds.prepare()
        elif kind == "motion":
            settings.less_motion = value == "less"
        elif (value == "full") != self.host.full_screen:
            self.host.toggle_full_screen()
        self.host.save_settings()
        self.host.restyle()

    def _ask_name(self) -> None:
        about = "Titles of stories and films name it; it stays on this machine"
        question = Question("Your name", about, "Keep", self.host.settings.name, NOBODY, LONGEST_NAME)
        self.host.cards.open_name(question, self._take_name)

    def _take_name(self, name: str) -> None:
        self.host.settings.name = name
        self.host.save_settings()
        self.refresh()

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        chosen = self._chosen()
        for i, line in enumerate(LINES):
            y = px(HEAD) + i * self._row + self._row // 2 - px(4)
            up = px(9) if self._roomy else 0
            look.text(picture, line.label, (px(32), y - up), 13, "semibold", "text1")
            if self._roomy:
                look.text(picture, line.about, (px(32), y + up), 12, "medium", "text3")
            rects = [self.inner(spot.rect) for name, _ in line.options if (spot := self.spots.find(name))]
            draw_box(picture, rects[0].unionall(rects[1:]), px(8), look.theme.inset)
            for (name, words), rect in zip(line.options, rects, strict=True):
                words = self.host.settings.name or words if name == "name-asked" else words
                self._paint_segment(picture, rect, words, name in chosen, self.spots.hover(name))
                if self.spots.focused == name:
                    draw_box(
                        picture, rect.inflate(px(4), px(4)), px(10), None, look.theme.accent, max(2, px(2))
                    )
        if picture.get_height() - px(HEAD) - self._row * len(LINES) < px(FOOT):
            return
        where = f"Kept in {settings_path(self.host.folder)}"
        where = look.fonts.fit(where, 12, "medium", picture.get_width() - px(64))
        look.text(picture, where, (px(32), picture.get_height() - px(28)), 12, "medium", "text3")

    def _paint_segment(
        self, picture: pygame.Surface, rect: pygame.Rect, words: str, on: bool, lit: float
    ) -> None:
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        inner = rect.inflate(-px(4), -px(4))
        color = theme.text2
        if on:
            draw_box(picture, inner, px(6), theme.accent)
            color = theme.on_accent
        elif lit:
            draw_box(picture, inner, px(6), theme.inset.lerp(theme.hover, lit))
        weight = "semibold" if on else "medium"
        look.text(
            picture, look.fonts.fit(words, 13, weight, inner.w), rect.center, 13, weight, color, "center"
        )
