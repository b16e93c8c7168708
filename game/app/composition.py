"""What a frame shows: the screens, a gamepad's pointer, messages, and the picture before fading over all."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from game.app.window.transition import CrossFade
from game.ui.look.shapes import draw_disc

if TYPE_CHECKING:
    from game.app.application import App


class Composition:
    """Draws a frame; keeps what stands still under a card."""

    def __init__(self) -> None:
        self._fade = CrossFade()
        self._backdrop: pygame.Surface | None = None

    def begin_change(self, shown: pygame.Surface, length_s: float) -> None:
        """What is shown now will fade over what comes."""
        self._fade.begin(shown, length_s)

    def forget(self) -> None:
        """Draw anew what is under a card."""
        self._backdrop = None

    def draw(self, app: App, elapsed_s: float) -> None:
        """Draw everything on the window's surface."""
        surface = app.window.surface
        self._draw_below(app, surface)
        with app.watch(app.screens.top):
            app.screens.top.draw(surface)
        _draw_gamepad_pointer(app, surface)
        app.toasts.draw(surface, app.screens.visible()[0].message_row())
        self._fade.update(elapsed_s)
        self._fade.draw(surface)

    def _draw_below(self, app: App, surface: pygame.Surface) -> None:
        """What is under an overlay stands still, so it is drawn once and kept."""
        below = app.screens.visible()[:-1]
        if not below:
            return
        if self._backdrop is None or self._backdrop.get_size() != surface.get_size():
            for screen in below:
                with app.watch(screen):
                    screen.draw(surface)
            self._backdrop = surface.copy()
        surface.blit(self._backdrop, (0, 0))


def _draw_gamepad_pointer(app: App, surface: pygame.Surface) -> None:
    """The place that a gamepad's stick has moved to: there is no mouse arrow there."""
    place = app.gamepads.pointer
    if place is not None and app.screens.top.gamepad == "pointer":
        px, theme = app.look.px, app.look.theme
        draw_disc(surface, place, px(9), None, theme.bg, max(3, px(4)))
        draw_disc(surface, place, px(8), None, theme.accent, max(1, px(2)))
