"""Words on the stage of what it stands for: a scene that is being worked at, a recording that is watched."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from game.ui.look.layout import Layout
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc

PATIENCE_S = 0.3  # before anything is said
WORDS = "Working…"


class Standstill:
    """Keeps the picture for as long as the scene may not be looked into."""

    def __init__(self) -> None:
        self._picture: pygame.Surface | None = None

    def show(self, surface: pygame.Surface) -> None:
        """What was last seen of the scene; the first time that is what the surface shows now."""
        if self._picture is None or self._picture.get_size() != surface.get_size():
            self._picture = surface.copy()
        surface.blit(self._picture, (0, 0))

    def end(self) -> None:
        """The scene is seen again."""
        self._picture = None

    @staticmethod
    def tell(surface: pygame.Surface, look: Look, stage: pygame.Rect, seconds: float) -> None:
        """Say at the foot of the stage that the scene is being worked at, once it has been for a moment."""
        if seconds > PATIENCE_S:
            words = look.fonts.render_on_halo(WORDS, 13, "semibold", look.theme.text1, look.theme.bg)
            surface.blit(words, words.get_rect(midbottom=(stage.centerx, stage.bottom - look.px(16))))


def draw_signs(surface: pygame.Surface, look: Look, layout: Layout, lines: Sequence[str]) -> None:
    """At the top right of the stage: that a recording is seen, that a film is made; below each other."""
    px, stage = look.px, layout.free_stage
    top = stage.y + px(16) if not layout.overlaid else layout.top_bar.bottom + px(8)
    for words in filter(None, lines):
        place = pygame.Rect(0, top, look.fonts.size(words, 12, "semibold")[0] + px(36), px(28))
        place.right = stage.right - px(16)
        if place.left < stage.left:
            continue
        draw_box(surface, place, px(8), look.theme.panel, look.color("amber"), look.border)
        draw_disc(surface, (place.x + px(14), place.centery), 4 * look.k, look.color("amber"))
        look.text(surface, words, (place.x + px(24), place.centery), 12, "semibold", "text1")
        top = place.bottom + px(8)
