"""How far the menu is scrolled: smoothly where it is sent, at once where it is dragged; and its thumb."""

from __future__ import annotations

import math

import pygame

from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

RATE = 16.0  # 1/s: the rest of the way shrinks e-fold in 1/RATE
ARRIVED = 0.5  # px
THUMB_WIDTH, THUMB_LEAST, THUMB_REACH = 6, 32, 20  # design px; pressed within REACH of the edge
DRAG_FROM = 8  # design px that a pointer moves before it drags what it pressed


class Scroll:
    """Pixels of content above the view. Content and view are told by ``bound``."""

    def __init__(self) -> None:
        self.at = 0.0
        self.target = 0.0
        self.view = pygame.Rect(0, 0, 1, 1)
        self._content = 1
        self._look: Look | None = None
        self._pressed: tuple[int, float] | None = None  # y of the press, and where the content stood
        self._grip = 1.0  # px of content for a pixel of the pointer, negative: content follows the pointer
        self.dragging = False

    @property
    def offset(self) -> int:
        """Whole pixels of content above the view."""
        return round(self.at)

    @property
    def most(self) -> int:
        """The farthest, at which the content's end is the view's."""
        return max(0, self._content - self.view.h)

    @property
    def moving(self) -> bool:
        """On its way."""
        return self.at != self.target

    def bound(self, content: int, view: pygame.Rect, look: Look) -> None:
        """Content so high, px, is seen through that part of the window from now on."""
        self._content, self.view, self._look = content, view, look
        self.go(self.target)
        self.at = min(self.at, float(self.most))

    def go(self, target: float, at_once: bool = False) -> None:
        """Send it there, as far as it can go."""
        self.target = min(max(float(target), 0.0), float(self.most))
        if at_once or (self._look is not None and self._look.less_motion):
            self.at = self.target

    def show(self, top: float, bottom: float, at_once: bool = False) -> None:
        """Send it as little as brings that part of the content wholly into view; the top goes before."""
        self.go(min(max(self.target, bottom - self.view.h), top), at_once)

    def update(self, elapsed_s: float) -> bool:
        """Let time pass; True if it has moved."""
        before = self.offset
        self.at += (self.target - self.at) * -math.expm1(-RATE * max(elapsed_s, 0.0))
        if abs(self.target - self.at) < ARRIVED:
            self.at = self.target
        return self.offset != before

    # -- drag ---------------------------------------------------------------------------------------

    def press(self, position: tuple[int, int], look: Look) -> None:
        """A pointer was pressed in the view: it may become a drag, of the thumb at once."""
        thumb = self.thumb(look)
        near = thumb is not None and position[0] >= self.view.right - look.px(THUMB_REACH)
        self._pressed = (position[1], self.at)
        self.dragging = False
        self._grip = -1.0
        if near and thumb is not None:
            self._grip = self.most / max(1, self.view.h - thumb.h)
            self.dragging = True
            if not thumb.top <= position[1] < thumb.bottom:
                self.go((position[1] - self.view.y - thumb.h / 2) * self._grip, at_once=True)
                self._pressed = (position[1], self.at)

    def drag(self, position: tuple[int, int], look: Look) -> bool:
        """The pointer moved; True if what it pressed is dragged."""
        if self._pressed is None:
            return False
        y, before = self._pressed
        self.dragging = self.dragging or abs(position[1] - y) > look.px(DRAG_FROM)
        if self.dragging:
            self.go(before + (position[1] - y) * self._grip, at_once=True)
        return self.dragging

    def release(self) -> bool:
        """The pointer was let go; True if it had dragged."""
        dragged, self.dragging, self._pressed = self.dragging, False, None
        return dragged

    # -- thumb --------------------------------------------------------------------------------------

    def thumb(self, look: Look) -> pygame.Rect | None:
        """Where the thumb is, window px; None if all of the content is in view."""
        if self.most == 0:
            return None
        height = min(max(look.px(THUMB_LEAST), self.view.h * self.view.h // self._content), self.view.h)
        top = self.view.y + round((self.view.h - height) * self.at / self.most)
        width = look.px(THUMB_WIDTH)
        return pygame.Rect(self.view.right - look.px(6) - width, top, width, height)

    def draw(self, surface: pygame.Surface, look: Look) -> None:
        """Draw the thumb."""
        thumb = self.thumb(look)
        if thumb is not None:
            draw_box(
                surface,
                thumb,
                thumb.w / 2,
                look.theme.line2 if self.dragging or self.moving else look.theme.hover,
            )
