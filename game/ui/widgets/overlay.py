"""A card over everything: a veil, a shadow, a rounded card that rises 8 px while it fades in."""

from __future__ import annotations

import pygame

from game.ui.look import motion
from game.ui.look.icons import icon
from game.ui.look.layout import overlay_rect
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_shadow
from game.ui.widgets.hotspots import Hotspot

RISE = 8  # design px
RADIUS = 16
BLUR, DOWN = 26.0, 12.0
SHADES = {"dark": 0.5, "light": 0.28}


class Overlay:
    """Veil and card. The owner draws on what ``background`` makes and hands it to ``draw_card``."""

    def __init__(self, look: Look, height: float, width: float = 1056.0) -> None:
        self.look = look
        self.size = (width, height)
        self.card = pygame.Rect(0, 0, 1, 1)
        self.fade = motion.Fade(motion.OVERLAY_S, on=False)
        self.fade.on = True
        self._veil: pygame.Surface | None = None

    def place(self, window: pygame.Rect, look: Look) -> None:
        """Take a window and an appearance."""
        self.look = look
        self.card = overlay_rect(window, look.k, self.size[1], self.size[0])
        self._veil = None

    def close_spot(self) -> Hotspot:
        """The cross at the card's top right corner."""
        px = self.look.px
        place = pygame.Rect(0, 0, px(32), px(32))
        place.center = (self.card.right - px(32), self.card.y + px(36))
        return Hotspot("close", place, True, "Close")

    def update(self, dt_s: float) -> bool:
        """Let time pass; False when the card has gone after ``leave``."""
        self.fade.duration_s = 0.0 if self.look.less_motion else motion.OVERLAY_S
        self.fade.update(dt_s)
        return self.fade.on or self.fade.amount > 0.0

    def leave(self) -> None:
        """Start to fade out."""
        self.fade.on = False

    def draw_veil(self, surface: pygame.Surface) -> None:
        """Darken what is below and throw the card's shadow on it."""
        look, amount = self.look, self.fade.amount
        if self._veil is None or self._veil.get_size() != surface.get_size():
            self._veil = pygame.Surface(surface.get_size(), 0, 32)
            self._veil.fill(look.theme.scrim)
        self._veil.set_alpha(round(look.theme.scrim.a * amount))
        surface.blit(self._veil, (0, 0))
        if amount >= 1.0:
            draw_shadow(surface, self.card, BLUR * look.k / 2, DOWN * look.k, SHADES[look.theme.name])

    def background(self) -> pygame.Surface:
        """A fresh picture of the empty card, to be drawn on with (0, 0) as its corner."""
        look = self.look
        picture = pygame.Surface(self.card.size, pygame.SRCALPHA, 32)
        rect = picture.get_rect()
        draw_box(picture, rect, look.px(RADIUS), look.theme.panel, look.theme.line2, look.border)
        return picture

    def draw_card(self, surface: pygame.Surface, picture: pygame.Surface) -> None:
        """Show the card's picture, risen and faded in as far as it is."""
        amount = self.fade.amount
        picture.set_alpha(255 if amount >= 1.0 else round(255 * amount))
        surface.blit(picture, self.card.move(0, round((1.0 - amount) * RISE * self.look.k)))


def draw_close(surface: pygame.Surface, look: Look, rect: pygame.Rect, lit: float) -> None:
    """The cross of an overlay."""
    if lit > 0.0:
        draw_box(surface, rect, look.px(8), look.theme.panel.lerp(look.theme.hover, lit))
    picture = icon("close", look.px(20), look.theme.text2.lerp(look.theme.text1, lit))
    surface.blit(picture, picture.get_rect(center=rect.center))
