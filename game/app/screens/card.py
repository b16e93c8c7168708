"""Base of the screens that are a card over another one: veil, fade, cross, Esc."""

from __future__ import annotations

from typing import ClassVar

import pygame

from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.window.commands import Actions
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.overlay import Overlay, draw_close

TITLE_Y, HEAD = 36, 72  # design px: the title's middle, and where the content begins


class CardScreen(Screen):
    """A card with a title. Subclasses paint the content and say what its places do."""

    overlay: ClassVar[bool] = True
    height: ClassVar[float] = 600.0  # design px
    width: ClassVar[float] = 720.0

    def __init__(self, host: Host):
        super().__init__(host)
        self.veil = Overlay(host.look, self.height, self.width)
        self.spots = Hotspots()
        self.leaving = False
        self._picture: pygame.Surface | None = None
        self._painted_state: object = None

    # -- for subclasses -----------------------------------------------------------------------------

    @property
    def heading(self) -> str:
        """The card's title."""
        return ""

    def places(self) -> list[Hotspot]:
        """Places in the card that can be pressed, window px."""
        return []

    def pressed(self, name: str) -> None:
        """A place was pressed, or chosen by Enter."""

    def paint(self, picture: pygame.Surface) -> None:
        """Draw the content on the card's own surface (its corner is (0, 0))."""

    def state(self) -> object:
        """What the content depends on besides the places; a change paints it again."""
        return None

    # -- screen -------------------------------------------------------------------------------------

    def restyle(self) -> None:
        self.veil.place(pygame.Rect((0, 0), self.host.size), self.host.look)
        self.refresh()

    def refresh(self) -> None:
        """Place and paint everything again."""
        self.spots.place([*self.places(), self.veil.close_spot()])
        self._picture = None

    def close(self) -> None:
        """Fade out; the screen below goes on when the card has gone."""
        self.leaving = True
        self.veil.leave()

    @property
    def actions(self) -> Actions:
        return {"back": self.close}

    def handle(self, event: pygame.Event) -> None:
        if self.leaving:
            return
        if event.type == pygame.KEYDOWN and event.key in (pygame.K_TAB, pygame.K_DOWN, pygame.K_UP):
            back = event.key == pygame.K_UP or bool(event.mod & pygame.KMOD_SHIFT)
            if self.spots.focus_next(back) is None:
                self.spots.focus_next(back)
            return
        name = self.spots.handle(event)
        if name == "close":
            self.close()
        elif name is not None:
            self.pressed(name)

    def cancel(self) -> None:
        self.spots.pressed = None

    def update(self, elapsed_s: float) -> None:
        self.spots.update(elapsed_s, self.host.look)
        if not self.veil.update(elapsed_s):
            self.host.pop()

    def draw(self, surface: pygame.Surface) -> None:
        self.veil.draw_veil(surface)
        state = (self.spots.state(), self.state())
        if self._picture is None or state != self._painted_state:
            self._picture, self._painted_state = self.veil.background(), state
            self._paint_head(self._picture)
            self.paint(self._picture)
        self.veil.draw_card(surface, self._picture)

    def inner(self, rect: pygame.Rect) -> pygame.Rect:
        """A window rectangle on the card's own surface."""
        return rect.move(-self.veil.card.x, -self.veil.card.y)

    def _paint_head(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        space = picture.get_width() - px(32 + 64)
        look.text(
            picture, look.fonts.fit(self.heading, 20, "display", space), (px(32), px(TITLE_Y)), 20, "display"
        )
        spot = self.spots.find("close")
        if spot is not None:
            draw_close(picture, look, self.inner(spot.rect), self.spots.hover("close"))

    def draw_button(self, picture: pygame.Surface, name: str, words: str, primary: bool = False) -> None:
        """A button at its place: filled with the accent if it is the primary one."""
        spot = self.spots.find(name)
        if spot is None:
            return
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        rect, lit = self.inner(spot.rect), self.spots.hover(name)
        if primary:
            draw_box(picture, rect, px(8), theme.accent.lerp(theme.text1, 0.15 * lit))
            color = theme.on_accent
        else:
            draw_box(picture, rect, px(8), theme.inset.lerp(theme.hover, lit), theme.line2, look.border)
            color = theme.text1
        words = look.fonts.fit(words, 13, "semibold" if primary else "medium", rect.w - px(8))
        look.text(picture, words, rect.center, 13, "semibold" if primary else "medium", color, "center")
        if self.spots.focused == name:
            reach = px(1) + max(2, px(2))
            draw_box(
                picture, rect.inflate(2 * reach, 2 * reach), px(8) + reach, None, theme.accent, max(2, px(2))
            )
