"""The banner over a scene that was stopped: what went wrong, at which step, and a button to begin again."""

from __future__ import annotations

import pygame

from game.app.screens.host import Host
from game.ui.look.icons import icon
from game.ui.look.shapes import draw_box, draw_shadow
from game.ui.widgets.hotspots import Hotspot, Hotspots

HEIGHT, WIDEST, BUTTON = 48, 640, 72  # design px


class FaultBanner:
    """Shown at the top of the stage while there is trouble; ``handle`` is True when reset is pressed."""

    def __init__(self, host: Host):
        self.host = host
        self.text = ""
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.spots = Hotspots()

    def place(self, stage: pygame.Rect) -> None:
        """Take the stage's place."""
        px = self.host.look.px
        self.rect = pygame.Rect(0, stage.y + px(16), max(0, min(px(WIDEST), stage.w - px(32))), px(HEIGHT))
        self.rect.centerx = stage.centerx
        self._place_button()

    def _place_button(self) -> None:
        px = self.host.look.px
        button = pygame.Rect(0, 0, px(BUTTON), px(32))
        button.midright = (self.rect.right - px(8), self.rect.centery)
        self.spots.place([Hotspot("reset", button)] if self.text else [])

    def handle(self, event: pygame.Event) -> bool:
        """Follow an event; True if it presses reset."""
        return bool(self.text) and event.type != pygame.KEYDOWN and self.spots.handle(event) == "reset"

    def update(self, elapsed_s: float, text: str) -> None:
        """What is wrong now, empty for nothing."""
        if text != self.text:
            self.text = text
            self._place_button()
        self.spots.update(elapsed_s, self.host.look)

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the banner if there is something to say."""
        if not self.text or self.rect.w < self.host.look.px(160):
            return
        look, px, theme, rect = self.host.look, self.host.look.px, self.host.look.theme, self.rect
        draw_shadow(surface, rect, 5 * look.k, 2 * look.k, 0.4)
        draw_box(surface, rect, px(10), theme.panel, look.color("vermilion"), max(1, px(1.5)))
        sign = icon("warning", px(20), look.color("vermilion"))
        surface.blit(sign, sign.get_rect(center=(rect.x + px(24), rect.centery)))
        button = self.spots.spots[0].rect
        x = rect.x + px(44)
        lines = look.fonts.wrap(self.text, 12, "medium", button.x - px(12) - x)[:2]
        for i, line in enumerate(lines):
            y = rect.centery + (i - 0.5 * (len(lines) - 1)) * px(17)
            look.text(
                surface, look.fonts.fit(line, 12, "medium", button.x - px(12) - x), (x, y), 12, "medium"
            )
        lit = self.spots.hover("reset")
        draw_box(surface, button, px(8), theme.accent.lerp(theme.text1, 0.15 * lit))
        look.text(surface, "Reset", button.center, 13, "semibold", theme.on_accent, "center")
