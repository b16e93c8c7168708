"""Messages that come, stay four seconds and go: what happened in bold, what follows in plain words.

They stand at the right end of the hint row and no higher than it. The newest is shown and the rest wait their
turn, so that no message ever covers the play.
"""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

import pygame

from game.ui.look import motion
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import box, draw_box

HEIGHT, LEAST_HEIGHT, USUAL_WIDTH, WAITING = 40, 24, 496, 4
EDGE = 2  # design px of the row above and below it
BESIDE_WORDS = 44 + 7 + 14  # design px: sign, gap, and the end
KINDS = {"info": ("accent", "info"), "warning": ("vermilion", "warning"), "marker": ("amber", "warning")}


class Toast(NamedTuple):
    """A message: its cause, its consequence, and its kind ("info", "warning" or "marker")."""

    cause: str
    consequence: str = ""
    kind: str = "info"


class Toasts:
    """A queue of messages, one shown at a time; a message that is waiting already is not added again."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self._queue: deque[Toast] = deque()
        self._age_s = 0.0
        self._picture: pygame.Surface | None = None

    def place(self, look: Look) -> None:
        """Take another appearance."""
        self.look = look
        self._picture = None

    def add(self, cause: str, consequence: str = "", kind: str = "info") -> None:
        """Show a message; one that is shown starts to leave at once if others wait."""
        toast = Toast(cause, consequence, kind)
        if toast in self._queue:
            if self._queue[0] == toast:
                self._age_s = min(self._age_s, motion.TOAST_IN_S)
            return
        while len(self._queue) >= WAITING:
            del self._queue[1]
        self._queue.append(toast)

    def clear(self) -> None:
        """Forget all messages."""
        self._queue.clear()
        self._age_s = 0.0
        self._picture = None

    def withdraw(self, consequence: str) -> None:
        """Forget a message, shown or waiting."""
        if self._queue and self._queue[0].consequence == consequence:
            self._age_s = 0.0
            self._picture = None
        self._queue = deque(toast for toast in self._queue if toast.consequence != consequence)

    @property
    def shown(self) -> Toast | None:
        """The message on show."""
        return self._queue[0] if self._queue else None

    def update(self, dt_s: float) -> None:
        """Let time pass: the next message follows when one has gone."""
        if not self._queue:
            return
        self._age_s += max(dt_s, 0.0)
        stay = motion.TOAST_STAY_S if len(self._queue) == 1 else 1.5
        if self._age_s >= motion.TOAST_IN_S + stay + motion.TOAST_OUT_S:
            self._queue.popleft()
            self._age_s = 0.0
            self._picture = None

    def width(self, space: int) -> int:
        """Window px that the message on show will take of a row that wide: more only for many words."""
        if not self._queue:
            return 0
        toast, fonts, px = self._queue[0], self.look.fonts, self.look.px
        words = fonts.size(toast.cause, 13, "semibold")[0] + fonts.size(toast.consequence, 13)[0]
        return min(space, max(px(USUAL_WIDTH), px(BESIDE_WORDS) + words))

    def draw(self, surface: pygame.Surface, row: pygame.Rect) -> None:
        """Show the message at the right end of a row and, unless that is lower than letters, inside it."""
        px = self.look.px
        if not self._queue or row.w < px(80):
            return
        width = self.width(row.w - 2 * px(8))
        height = max(min(px(HEIGHT), row.h - 2 * px(EDGE)), px(LEAST_HEIGHT))
        if self._picture is None or self._picture.get_size() != (width, height):
            self._picture = self._paint(self._queue[0], width, height)
        amount, rise = self._presence()
        self._picture.set_alpha(round(255 * amount))
        x = row.right - px(8) - width
        y = row.bottom - px(EDGE) - height + round(rise * self.look.k)
        surface.blit(self._picture, (x, max(0, y)))

    def _presence(self) -> tuple[float, float]:
        """Opacity, and design px below its place."""
        if self.look.less_motion:
            return 1.0, 0.0
        stay = motion.TOAST_STAY_S if len(self._queue) == 1 else 1.5
        if self._age_s < motion.TOAST_IN_S:
            amount = motion.ease_out(self._age_s / motion.TOAST_IN_S)
            return amount, 8.0 * (1.0 - amount)
        leaving = (self._age_s - motion.TOAST_IN_S - stay) / motion.TOAST_OUT_S
        return 1.0 - motion.ease_in(leaving), 0.0

    def _paint(self, toast: Toast, width: int, height: int) -> pygame.Surface:
        look, px = self.look, self.look.px
        color, sign = KINDS[toast.kind]
        picture = pygame.Surface((max(width, 1), max(height, 1)), pygame.SRCALPHA, 32)
        rect = picture.get_rect()
        draw_box(picture, rect, px(8), look.theme.panel, look.theme.line, look.border)
        bar = box(rect.size, px(8), look.color(color))
        picture.blit(bar, (0, 0), (0, 0, px(3), rect.h))
        mark = icon(sign, px(20), look.color(color))
        picture.blit(mark, mark.get_rect(center=(px(25), rect.h // 2)))
        x, limit = px(44), rect.w - px(12)
        cause = look.fonts.fit(toast.cause, 13, "semibold", limit - x)
        x += look.text(picture, cause, (x, rect.h / 2), 13, "semibold", "text1").w + px(7)
        rest = look.fonts.fit(toast.consequence, 13, "medium", max(0, limit - x))
        if len(rest) > 1:
            look.text(picture, rest, (x, rect.h / 2), 13, "medium", "text2")
        return picture
