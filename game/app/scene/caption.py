"""The caption of a hard case: what it is and what is to be seen, until the user lets it run."""

from __future__ import annotations

import pygame

from game.app.screens.host import Host
from game.levels import Level
from game.stage import Stage
from game.ui.look.shapes import draw_box, draw_shadow
from game.ui.widgets import keycap

WIDEST, NARROWEST = 560, 200  # design px
FOOT = 52  # design px below it, where scenes say which step of a walk is shown
PADDING, LINE = 16, 20


class LevelCaption:
    """Shown near the foot of the stage while a hard case stands at its beginning; a press lets it run."""

    def __init__(self, host: Host, welcome: bool):
        """``welcome``: whether hard cases are introduced here at all; a game is not."""
        self.host = host
        self.rect = pygame.Rect(0, 0, 0, 0)
        self._welcome = welcome
        self._stage = pygame.Rect(0, 0, 0, 0)
        self._shown: Level | None = None

    def introduces(self, level: Level | None) -> bool:
        """Whether a level is one that begins standing still, under this caption."""
        return self._welcome and level is not None and bool(level.hard_case and level.about)

    def place(self, stage: pygame.Rect) -> None:
        """Take the stage's place."""
        self._stage = stage
        self._lay_out()

    def follow(self, stage: Stage, watched: bool) -> None:
        """Stand while a hard case waits at its beginning, and no recording is watched."""
        waits = stage.paused and stage.step_number == 0 and not watched
        level = stage.level if waits and self.introduces(stage.level) else None
        if level is not self._shown:
            self._shown = level
            self._lay_out()

    @property
    def words(self) -> str:
        """What is to be read now; empty if it is not shown."""
        return self._shown.about if self._shown is not None and self.rect.w else ""

    def handle(self, event: pygame.Event) -> bool:
        """True if the event presses it."""
        pressed = event.type == pygame.MOUSEBUTTONDOWN and event.button == 1
        return pressed and bool(self.words) and bool(self.rect.collidepoint(event.pos))

    def _lines(self) -> list[str]:
        look = self.host.look
        assert self._shown is not None
        return look.fonts.wrap(self._shown.about, 13, "medium", self.rect.w - 2 * look.px(PADDING))

    def _lay_out(self) -> None:
        """As high as its words need; nothing where there is no space for them."""
        px = self.host.look.px
        width = min(px(WIDEST), self._stage.w - 2 * px(PADDING))
        self.rect = pygame.Rect(0, 0, max(width, 0), 0)
        if self._shown is None or width < px(NARROWEST):
            self.rect.w = 0
            return
        self.rect.h = px(2 * PADDING) + px(LINE) * (len(self._lines()) + 2)
        self.rect.midbottom = (self._stage.centerx, self._stage.bottom - px(FOOT))
        if self.rect.top < self._stage.top:
            self.rect.w = 0

    def draw(self, surface: pygame.Surface) -> None:
        """Title, words, and the key that goes on."""
        if self._shown is None or not self.rect.w:
            return
        look, px, rect = self.host.look, self.host.look.px, self.rect
        draw_shadow(surface, rect, 5 * look.k, 2 * look.k, 0.4)
        draw_box(surface, rect, px(10), look.theme.panel, look.color("amber"), look.border)
        x, y = rect.x + px(PADDING), rect.y + px(PADDING) + px(LINE) // 2
        space = rect.w - 2 * px(PADDING)
        title = look.fonts.fit(self._shown.title or "Hard case", 13, "semibold", space)
        look.text(surface, title, (x, y), 13, "semibold", "text1")
        for line in self._lines():
            y += px(LINE)
            look.text(surface, line, (x, y), 13, "medium", "text2")
        y += px(LINE) + px(4)
        keys = (self.host.keys.label("pause"),)
        keycap.draw_keys(surface, look, x, y, keys)
        at = (x + keycap.keys_width(look, keys) + px(8), y)
        look.text(surface, "lets it run", at, 12, "medium", "text2")
