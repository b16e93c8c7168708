"""Push buttons of panel foot and overlays: one accented, the others quiet."""

from __future__ import annotations

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

HEIGHT = 32  # design px
SIZES = (13, 12, 11)  # of the words, design px: the largest with which they fit


def draw_button(
    surface: pygame.Surface, look: Look, rect: pygame.Rect, words: str, *, primary: bool = False,
    lit: float = 0.0, pressed: bool = False, enabled: bool = True,
) -> None:  # fmt: skip
    """A button with its words; ``lit`` 0 to 1 is the pointer over it."""
    theme = look.theme
    if not enabled:
        fill, edge, ink = theme.panel, theme.line, theme.text3
    elif primary:
        fill = (
            theme.accent.lerp(theme.text1, 0.16 * lit)
            if theme.name == "dark"
            else theme.accent.lerp(theme.chalk.mark, 0.3 * lit)
        )
        fill = theme.accent.lerp(theme.bg, 0.2) if pressed else fill
        edge, ink = fill, theme.on_accent
    else:
        fill = theme.line if pressed else theme.inset.lerp(theme.hover, lit)
        edge, ink = (
            theme.line.lerp(theme.accent if pressed else theme.line2, 1.0 if pressed else lit),
            theme.text1,
        )
    draw_box(surface, rect, look.px(8), fill, edge, look.border)
    weight = "semibold" if primary else "medium"
    room = rect.w - look.px(8)
    size = look.fonts.largest(words, SIZES, weight, room)
    look.text(surface, look.fonts.fit(words, size, weight, room), rect.center, size, weight, ink, "center")
