"""What the end of a story offers: the next story, and the same one with one thing changed."""

from __future__ import annotations

import pygame

from game.ui.look.look import Look
from game.ui.widgets.buttons import draw_button
from game.ui.widgets.hotspots import Hotspot, Hotspots

HEIGHT, GAP, SIDE = 40, 12, 24  # design px, of a button; between two; to the edge of the picture
FROM_FOOT = 0.16  # of the picture's height: below the words of the end card
NEXT, WHAT_IF, AGAIN = "story-next", "story-what-if", "story-again"


class Offers:
    """Buttons over the picture; ``handle`` gives the name of the one that is pressed."""

    def __init__(self, look: Look, rows: tuple[tuple[str, str], ...]) -> None:
        """rows: (name, words) of each, the most wanted first."""
        self.look = look
        self.rows = rows
        self.spots = Hotspots()
        self.shown = False
        self._rect = pygame.Rect(0, 0, 0, 0)

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """The picture lies here now."""
        self.look, self._rect = look, pygame.Rect(rect)
        self._place_spots()

    def show(self, shown: bool) -> None:
        """Whether they are there."""
        if shown != self.shown:
            self.shown = shown
            self._place_spots()

    def _place_spots(self) -> None:
        """Beside one another in the middle, or below one another in a narrow picture."""
        look, px, rect = self.look, self.look.px, self._rect
        widths = [
            min(look.fonts.size(words, 14, "semibold")[0] + px(36), max(rect.w - 2 * px(SIDE), 1))
            for _, words in self.rows
        ]
        total = sum(widths) + px(GAP) * (len(widths) - 1)
        beside = total <= rect.w - 2 * px(SIDE)
        y = rect.bottom - round(FROM_FOOT * rect.h) - px(HEIGHT)
        x = rect.centerx - total // 2
        spots = []
        for i, ((name, words), width) in enumerate(zip(self.rows, widths, strict=True)):
            place = pygame.Rect(x, y, width, px(HEIGHT))
            if beside:
                x = place.right + px(GAP)
            else:
                place.centerx = rect.centerx
                place.y = y - (len(widths) - 1 - i) * px(HEIGHT + GAP)
            spots.append(Hotspot(name, place, True, words))
        self.spots.place(spots if self.shown else ())

    def handle(self, event: pygame.Event) -> tuple[bool, str]:
        """Whether the event was for a button, and the name of the one that it presses, else ""."""
        if not self.shown or event.type == pygame.KEYDOWN:
            return False, ""
        held = self.spots.pressed
        name = self.spots.handle(event)
        position = getattr(event, "pos", None)
        over = position is not None and self.spots.at(position) is not None
        button = getattr(event, "button", 0) == 1
        return (over and button) or held is not None, name or ""

    def update(self, elapsed_s: float) -> None:
        """Let time pass."""
        self.spots.update(elapsed_s, self.look)

    def draw(self, surface: pygame.Surface) -> None:
        """The buttons; the first is the one that is lit."""
        for i, spot in enumerate(self.spots.spots):
            lit, held = self.spots.hover(spot.name), self.spots.pressed == spot.name
            draw_button(surface, self.look, spot.rect, spot.tip, primary=i == 0, lit=lit, pressed=held)
