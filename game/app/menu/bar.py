"""The bar of categories below the menu's header: a press, or Tab, leads to where one begins."""

from __future__ import annotations

import pygame

from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot, Hotspots

CHIP, PAD, SPACE = 28, 12, 6  # design px: height, beside the words, between
WHEEL = 60  # design px for a notch


class CategoryBar:
    """Draws itself; ``handle`` names the category that was pressed."""

    def __init__(self) -> None:
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.names: tuple[str, ...] = ()
        self.current = ""
        self.spots = Hotspots()
        self._shift = 0  # px that the chips are moved to the left, where they are wider than the window
        self._width = 0
        self._signs: dict[str, str] = {}

    def place(self, rect: pygame.Rect, names: tuple[str, ...], look: Look, signs: dict[str, str]) -> None:
        """Take a place and categories; ``signs``: icons before the names of some."""
        self.rect, self.names, self._signs = rect, names, signs
        widths = [self._chip_width(name, look) for name in names]
        self._width = sum(widths) + look.px(SPACE) * max(0, len(names) - 1)
        self._shift = min(self._shift, self._farthest(look))
        spots, x = [], rect.x + look.px(32) - self._shift
        for name, width in zip(names, widths, strict=True):
            chip = pygame.Rect(x, 0, width, look.px(CHIP))
            chip.centery = rect.centery
            spots.append(Hotspot(name, chip))
            x = chip.right + look.px(SPACE)
        self.spots.place(spots)

    def _chip_width(self, name: str, look: Look) -> int:
        sign = look.px(18) if name in self._signs else 0
        return look.fonts.size(name, 13, "semibold")[0] + 2 * look.px(PAD) + sign

    def _farthest(self, look: Look) -> int:
        return max(0, self._width + 2 * look.px(32) - self.rect.w)

    def show(self, current: str, look: Look) -> bool:
        """That category is the present one; its chip is brought into the window. True if this is news."""
        if current == self.current:
            return False
        self.current = current
        spot = self.spots.find(current)
        if spot is not None:
            left, right = spot.rect.left - look.px(64), spot.rect.right + look.px(64) - self.rect.w
            self._move(min(left, 0) + max(right, 0), look)
        return True

    def _move(self, by: int, look: Look) -> None:
        shift = min(max(self._shift + by, 0), self._farthest(look))
        if shift != self._shift:
            self._shift = shift
            self.place(self.rect, self.names, look, self._signs)

    def handle(self, event: pygame.Event, look: Look) -> str | None:
        """The category that a press asks for."""
        if event.type == pygame.KEYDOWN:
            return None
        return self.spots.handle(event)

    def wheel(self, turns: float, look: Look) -> None:
        """The wheel was turned over the bar."""
        self._move(-round(turns * look.px(WHEEL)), look)

    def beside(self, offset: int) -> str:
        """The category so many places on from the present one, round the end; "" if there is none."""
        if not self.names:
            return ""
        at = self.names.index(self.current) if self.current in self.names else -offset
        return self.names[(at + offset) % len(self.names)]

    def draw(self, surface: pygame.Surface, look: Look) -> None:
        """Draw the chips on what is there."""
        theme, px = look.theme, look.px
        before = surface.get_clip()
        surface.set_clip(self.rect)
        for spot in self.spots.spots:
            on, lit = spot.name == self.current, self.spots.hover(spot.name)
            if on or lit:
                fill = theme.accent_soft if on else theme.bg.lerp(theme.hover, lit)
                draw_box(surface, spot.rect, spot.rect.h / 2, fill)
            x = spot.rect.x + px(PAD)
            color = theme.text1 if on else theme.text2
            if spot.name in self._signs:
                sign = icon(self._signs[spot.name], px(14), theme.accent if on else theme.text2)
                surface.blit(sign, sign.get_rect(midleft=(x, spot.rect.centery)))
                x += px(18)
            look.text(surface, spot.name, (x, spot.rect.centery), 13, "semibold", color)
        surface.set_clip(before)
