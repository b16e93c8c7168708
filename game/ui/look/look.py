"""Theme, fonts and scale in one hand: what every widget needs to draw itself."""

from __future__ import annotations

import pygame

from game.ui.look.fonts import SMALLEST_PX, FontBook
from game.ui.look.measures import Metrics, metrics
from game.ui.look.theme import DataColor, Theme, color_names


class Look:
    """The appearance of the interface at one scale; a new one is made when theme or scale change.

    ``least``: px, of the smallest letters, whatever the scale.
    """

    def __init__(
        self, theme: Theme, k: float = 1.0, *, less_motion: bool = False, least: int = SMALLEST_PX
    ) -> None:
        self.theme = theme
        self.k = k
        self.fonts = FontBook(k, least)
        self.metrics: Metrics = metrics(k)
        self.less_motion = less_motion

    def px(self, x: float) -> int:
        """A design measure in whole window pixels."""
        return round(x * self.k)

    @property
    def border(self) -> int:
        """Width of an outline, window px."""
        return self.metrics.border

    def color(self, token: str | pygame.Color, *, words: bool = False) -> pygame.Color:
        """A colour by its token; ``words`` takes the shade of a data colour that is legible as text."""
        if isinstance(token, pygame.Color):
            return token
        found = getattr(self.theme, token, None)
        if isinstance(found, DataColor):
            return found.text if words else found.mark
        if isinstance(found, pygame.Color):
            return found
        raise ValueError(f"colour {token!r}: expected one of {', '.join(color_names(self.theme))}")

    def text(
        self,
        surface: pygame.Surface,
        text: str,
        at: tuple[float, float],
        size: float = 13,
        weight: str = "medium",
        color: str | pygame.Color = "text1",
        align: str = "left",
    ) -> pygame.Rect:
        """Place one line, vertically centred on ``at``; the rectangle it covers."""
        return self.fonts.draw(surface, text, at, size, weight, self.color(color, words=True), align)
