"""The foot of the panel, which does not scroll: what accuracy costs, and back to the defaults."""

from __future__ import annotations

import pygame

from game.ui.look.look import Look
from game.ui.widgets.buttons import HEIGHT, draw_button
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.wishes import Wish

PADDING, GAP, RESET = 16, 8, 80  # design px
WORDS = {"accuracy": "What accuracy costs", "defaults": "Reset"}


class PanelFoot:
    """One or two buttons."""

    def __init__(self, look: Look, has_study: bool) -> None:
        self.look = look
        self.has_study = has_study
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.spots = Hotspots()
        self._picture: pygame.Surface | None = None
        self._drawn: tuple[object, ...] = ()

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window and an appearance."""
        self.look, self.rect = look, pygame.Rect(rect)
        self._picture = None
        px = look.px
        left, right = rect.x + px(PADDING), rect.right - px(PADDING)
        if right - left < px(RESET):
            self.spots.place([])
            return
        reset = pygame.Rect(0, rect.bottom - px(PADDING) - px(HEIGHT), px(RESET), px(HEIGHT))
        reset.right = right
        spots = [Hotspot("defaults", reset, True, "All values back to their defaults")]
        wide = pygame.Rect(left, reset.y, reset.x - px(GAP) - left, reset.h)
        if self.has_study and wide.w > px(60):
            spots.insert(0, Hotspot("accuracy", wide, True, "Error against computing time, of this scene"))
        self.spots.place(spots)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """The command of a press, if the event makes one."""
        if event.type == pygame.KEYDOWN:
            return None
        name = self.spots.handle(event)
        return Wish(name) if name is not None else None

    def update(self, dt_s: float) -> None:
        """Let hover light move on."""
        self.spots.update(dt_s, self.look)

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """Tool tip of the button under the pointer."""
        spot = self.spots.find(self.spots.hovered) if self.spots.hovered else None
        return (spot.tip, spot.rect) if spot is not None else None

    def draw(self, surface: pygame.Surface, more_below: bool) -> None:
        """Draw on the panel's colour; a line above it when rows go on below."""
        wanted = (self.spots.state(), more_below)
        if self._picture is None or wanted != self._drawn:
            self._drawn = wanted
            self._picture = self._paint(more_below)
        surface.blit(self._picture, self.rect)

    def _paint(self, more_below: bool) -> pygame.Surface:
        picture = pygame.Surface(self.rect.size, 0, 32)
        picture.fill(self.look.theme.panel)
        if more_below:
            picture.fill(self.look.theme.line, (0, 0, self.rect.w, self.look.border))
        for spot in self.spots.spots:
            draw_button(
                picture, self.look, spot.rect.move(-self.rect.x, -self.rect.y), WORDS[spot.name],
                primary=spot.name == "accuracy", lit=self.spots.hover(spot.name),
                pressed=self.spots.pressed == spot.name,
            )  # fmt: skip
        return picture
