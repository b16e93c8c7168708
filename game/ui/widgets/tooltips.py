"""Tool tips: what the thing under the pointer is, after half a second of rest."""

from __future__ import annotations

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

DELAY_S = 0.5
WIDEST = 240  # design px of a line


class ToolTip:
    """Shows the text of whatever rests under the pointer; the owner says each frame what that is."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self._about: tuple[str, tuple[int, ...]] | None = None
        self._age_s = 0.0
        self._picture: pygame.Surface | None = None

    def place(self, look: Look) -> None:
        """Take another appearance."""
        self.look = look
        self._picture = None

    def update(self, dt_s: float, about: tuple[str, pygame.Rect] | None) -> None:
        """What is under the pointer now, if anything that has a text."""
        key = None if about is None else (about[0], tuple(about[1]))
        if key != self._about:
            self._about, self._age_s, self._picture = key, 0.0, None
        else:
            self._age_s += dt_s

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the tip below its thing, or above it where there is no space; always inside the window."""
        if self._about is None or self._age_s < DELAY_S:
            return
        if self._picture is None:
            self._picture = self._paint(self._about[0])
        place = self._picture.get_rect()
        thing = pygame.Rect(self._about[1])
        gap = self.look.px(6)
        place.midtop = (thing.centerx, thing.bottom + gap)
        window = surface.get_rect()
        if place.bottom > window.bottom:
            place.bottom = thing.top - gap
        place.clamp_ip(window.inflate(-2 * gap, -2 * gap))
        surface.blit(self._picture, place)

    def _paint(self, text: str) -> pygame.Surface:
        look, px = self.look, self.look.px
        lines = look.fonts.wrap(text, 12, "medium", px(WIDEST))
        height = look.fonts.line_height(12)
        width = max(look.fonts.size(line, 12)[0] for line in lines) + 2 * px(8)
        picture = pygame.Surface((width, len(lines) * height + 2 * px(6)), pygame.SRCALPHA, 32)
        draw_box(picture, picture.get_rect(), px(6), look.theme.hover, look.theme.line2, look.border)
        for i, line in enumerate(lines):
            look.text(picture, line, (px(8), px(6) + (i + 0.5) * height), 12, "medium", "text1")
        return picture
