"""The stop-watch: simulated time between two presses, whether the scene is slowed down, paused or stepped."""

from __future__ import annotations

import pygame

from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

SIZE, BUTTON = (196, 40), 32  # design px


class StopWatch:
    """Shown over the picture; ``place_at``: its middle as shares of the stage, from the top left."""

    name = "stop-watch"

    def __init__(self) -> None:
        self.place_at = (0.5, 0.12)
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.cross = pygame.Rect(0, 0, 0, 0)
        self._button = pygame.Rect(0, 0, 0, 0)
        self._zero = pygame.Rect(0, 0, 0, 0)
        self._since_s: float | None = None  # simulated time at which it was started; None: it stands
        self._before_s = 0.0  # measured before that
        self._session: object = None

    @property
    def runs(self) -> bool:
        """Whether it runs."""
        return self._since_s is not None

    def seconds(self, time_s: float) -> float:
        """What it shows at a simulated time, s."""
        since = 0.0 if self._since_s is None else time_s - self._since_s
        return max(self._before_s + since, 0.0)

    def toggle(self, time_s: float) -> None:
        """Start, or stop."""
        if self._since_s is None:
            self._since_s = time_s
        else:
            self._before_s, self._since_s = self.seconds(time_s), None

    def zero(self, time_s: float) -> None:
        """From nought; it goes on if it runs."""
        self._before_s = 0.0
        self._since_s = time_s if self.runs else None

    def follow(self, session: object, time_s: float) -> None:
        """The scene has begun anew if ``session`` is another: then nothing has been measured."""
        if session != self._session:
            self._session = session
            self.zero(time_s)

    def press(self, position: tuple[int, int], time_s: float) -> bool:
        """True if a button is pressed there."""
        if self._button.collidepoint(position):
            self.toggle(time_s)
        elif self._zero.collidepoint(position):
            self.zero(time_s)
        else:
            return False
        return True

    def draw(self, surface: pygame.Surface, look: Look, stage: pygame.Rect, time_s: float) -> None:
        """Time, start and stop, nought, and a cross."""
        px = look.px
        self.rect = pygame.Rect(0, 0, px(SIZE[0]), px(SIZE[1]))
        self.rect.center = (
            stage.x + round(self.place_at[0] * stage.w), stage.y + round(self.place_at[1] * stage.h)
        )  # fmt: skip
        self.rect.clamp_ip(stage)
        color = look.color("amber")
        draw_box(surface, self.rect, px(9), look.theme.panel, color, look.border)
        size = px(BUTTON)
        self._button = pygame.Rect(self.rect.x + px(4), self.rect.centery - size // 2, size, size)
        self.cross = pygame.Rect(self.rect.right - px(26), self.rect.y, px(26), self.rect.h)
        self._zero = pygame.Rect(self.cross.x - px(26), self.rect.y, px(26), self.rect.h)
        quiet = look.theme.text2
        for name, place, big, ink in (
            ("pause" if self.runs else "play", self._button, 18, color),
            ("reset", self._zero, 15, quiet),
            ("close", self.cross, 12, quiet),
        ):
            sign = icon(name, px(big), ink)
            surface.blit(sign, sign.get_rect(center=place.center))
        words = f"{self.seconds(time_s):.3f} s"
        look.text(surface, words, (self._zero.x - px(8), self.rect.centery), 15, "semibold", "text1", "right")
