"""The row of key hints at the foot of a scene; messages share it, so that nothing covers the play."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from game.ui.look.look import Look
from game.ui.widgets import keycap

GAP = 22  # design px between hints
FADE_AFTER_S = 12.0
FADED = 0.5


class HintBar:
    """Hints that fit from the left; after a while without a change they fade to half."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.hints: tuple[tuple[tuple[str, ...], str], ...] = ()
        self._age_s = 0.0
        self._picture: pygame.Surface | None = None
        self._used = 0

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window and an appearance."""
        self.rect, self.look = pygame.Rect(rect), look
        self._picture = None

    def show(self, hints: Sequence[tuple[tuple[str, ...], str]]) -> None:
        """The hints to show: keys, and what they do; the most useful first."""
        hints = tuple((tuple(keys), text) for keys, text in hints)
        if hints != self.hints:
            self.hints = hints
            self._age_s = 0.0
            self._picture = None

    def wake(self) -> None:
        """Show the hints at full strength again."""
        if self._age_s > FADE_AFTER_S:
            self._picture = None
        self._age_s = 0.0

    def update(self, dt_s: float) -> None:
        """Let time pass."""
        before = self._strength()
        self._age_s += dt_s
        if self._strength() != before:
            self._picture = None

    @property
    def used_width(self) -> int:
        """Window px from the left edge that hints take; a message may use the rest."""
        return self._used

    def draw(self, surface: pygame.Surface, free_width: int | None = None) -> None:
        """Show the row; ``free_width`` leaves the rest of it to a message."""
        if self.rect.w < 1 or self.rect.h < 1:
            return
        if self._picture is None:
            self._picture = self._paint()
        surface.blit(self._picture, self.rect)
        if free_width is not None and free_width < self._used:
            cover = pygame.Rect(self.rect.x + self._cut(free_width), self.rect.y, self.rect.w, self.rect.h)
            surface.fill(self.look.theme.bg, cover.clip(self.rect))

    def _strength(self) -> float:
        if self.look.less_motion:
            return 1.0
        steps = min(max(self._age_s - FADE_AFTER_S, 0.0) / 1.0, 1.0)
        return 1.0 - (1.0 - FADED) * round(steps * 8) / 8  # in eighths: the row is painted again for each

    def _ends(self) -> list[int]:
        """Right ends of the hints, window px from the left edge."""
        px, ends, x = self.look.px, [], self.look.px(16)
        for keys, text in self.hints:
            x += keycap.keys_width(self.look, keys) + px(keycap.TO_WORDS)
            x += self.look.fonts.size(text, 12)[0]
            ends.append(x)
            x += px(GAP)
        return ends

    def _cut(self, width: int) -> int:
        """Right end of the last hint that is wholly inside ``width``."""
        return max((end for end in self._ends() if end <= width), default=0)

    def _paint(self) -> pygame.Surface:
        look, px = self.look, self.look.px
        picture = pygame.Surface(self.rect.size, 0, 32)
        picture.fill(look.theme.bg)
        x, self._used = px(16), 0
        for (keys, text), end in zip(self.hints, self._ends(), strict=True):
            if end > self.rect.w - px(12):
                break
            x += keycap.draw_keys(picture, look, x, self.rect.h // 2, keys) + px(keycap.TO_WORDS)
            look.text(picture, text, (x, self.rect.h / 2), 12, "medium", "text2")
            x, self._used = end + px(GAP), end
        strength = self._strength()
        if strength < 1.0:
            veil = pygame.Surface(self.rect.size, 0, 32)
            veil.fill(look.theme.bg)
            veil.set_alpha(round((1.0 - strength) * 255))
            picture.blit(veil, (0, 0))
        border = look.border
        picture.fill(look.theme.line, (0, 0, self.rect.w, border))
        return picture
