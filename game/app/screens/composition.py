"""What a frame shows: the screens, a gamepad's pointer, messages, and the picture before fading over all."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager

import pygame

from game.app.screens.screen import Screen
from game.app.screens.stack import ScreenStack
from game.app.window.transition import CrossFade
from game.ui.look.look import Look
from game.ui.look.shapes import draw_disc
from game.ui.widgets.toasts import Toasts

Watch = Callable[[Screen], AbstractContextManager[None]]


class Composition:
    """Draws a frame of a stack of screens; keeps what stands still under a card.

    ``watch``: within what it gives a screen is drawn, which may raise.
    """

    def __init__(self, screens: ScreenStack, watch: Watch) -> None:
        self._screens = screens
        self._watch = watch
        self._fade = CrossFade()
        self._backdrop: pygame.Surface | None = None

    def begin_change(self, shown: pygame.Surface, length_s: float) -> None:
        """What is shown now will fade over what comes."""
        self._fade.begin(shown, length_s)

    def forget(self) -> None:
        """Draw again what is under a card."""
        self._backdrop = None

    def draw(
        self,
        surface: pygame.Surface,
        look: Look,
        toasts: Toasts,
        pointer: tuple[float, float] | None,
        elapsed_s: float,
    ) -> None:
        """Draw everything on the window's surface; ``pointer``: where a gamepad's stick has moved to, px."""
        self._draw_below(surface)
        with self._watch(self._screens.top):
            self._screens.top.draw(surface)
        if pointer is not None and self._screens.top.gamepad == "pointer":
            _draw_pointer(surface, look, pointer)
        toasts.draw(surface, self._screens.visible()[0].message_row())
        self._fade.update(elapsed_s)
        self._fade.draw(surface)

    def _draw_below(self, surface: pygame.Surface) -> None:
        """What is under an overlay stands still, so it is drawn once and kept."""
        below = self._screens.visible()[:-1]
        if not below:
            return
        if self._backdrop is None or self._backdrop.get_size() != surface.get_size():
            for screen in below:
                with self._watch(screen):
                    screen.draw(surface)
            self._backdrop = surface.copy()
        surface.blit(self._backdrop, (0, 0))


def _draw_pointer(surface: pygame.Surface, look: Look, place: tuple[float, float]) -> None:
    """There is no mouse arrow where a gamepad points."""
    px, theme = look.px, look.theme
    draw_disc(surface, place, px(9), None, theme.bg, max(3, px(4)))
    draw_disc(surface, place, px(8), None, theme.accent, max(1, px(2)))
