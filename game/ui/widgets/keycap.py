"""Key caps: the small pictures of keys in hint bar and help page."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

CAPS = {
    "left": "←", "right": "→", "up": "↑", "down": "↓", "leftbracket": "[", "rightbracket": "]",
    "escape": "Esc", "return": "Enter", "page down": "PgDn", "page up": "PgUp", "pagedown": "PgDn",
    "pageup": "PgUp", "backspace": "Back",
}  # fmt: skip
HEIGHT, NARROWEST, PADDING, GAP, TO_WORDS = 20, 20, 6, 4, 8  # design px


def key_name(key: str) -> str:
    """A key as it is printed on its cap: "Z", "Ctrl+Z", "←", "[", "Enter"."""
    return "+".join(CAPS.get(part, part[:1].upper() + part[1:]) for part in key.split("+"))


def key_width(look: Look, key: str) -> int:
    """Width of one cap in window px."""
    return max(look.px(NARROWEST), look.fonts.size(key, 11)[0] + 2 * look.px(PADDING))


def keys_width(look: Look, keys: Sequence[str]) -> int:
    """Width of several caps beside each other."""
    return sum(key_width(look, key) for key in keys) + look.px(GAP) * max(len(keys) - 1, 0)


def draw_key(surface: pygame.Surface, look: Look, left: int, center_y: int, key: str) -> int:
    """Draw one cap with its left edge and middle there; its width."""
    rect = pygame.Rect(left, 0, key_width(look, key), look.px(HEIGHT))
    rect.centery = center_y
    theme = look.theme
    radius = look.px(4)
    edge = theme.line.lerp(theme.line2, 0.4)
    draw_box(surface, rect, radius, edge)  # the side of the cap, seen below its top
    top = pygame.Rect(rect.x, rect.y, rect.w, rect.h - max(1, look.px(1)))
    draw_box(surface, top, radius, theme.inset, edge, look.border)
    look.text(surface, key, top.center, 11, "medium", "text1", "center")
    return rect.w


def draw_keys(surface: pygame.Surface, look: Look, left: int, center_y: int, keys: Sequence[str]) -> int:
    """Draw caps beside each other; the width they take."""
    x = left
    for key in keys:
        x += draw_key(surface, look, x, center_y, key) + look.px(GAP)
    return max(0, x - look.px(GAP) - left)
