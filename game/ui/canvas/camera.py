"""The camera: world units to window pixels and back, with pan, zoom and smooth changes of view.

A view is a centre and a scale (pixels to a world unit). Quarter turns and the sense of y are part of the map,
so a scene always speaks in its own frame. Changes of view follow a critically damped spring whose steps are
exact, so that the path does not depend on the frame rate. A drag follows the hand at once.
"""

from __future__ import annotations

import math

import pygame

from game.stage import Frame

STIFFNESS = 10.0  # 1/s, of the spring towards the wanted view
NEAREST = 400.0  # most times closer than the whole frame
FARTHEST = 0.02  # least
_TURNS = ((1.0, 0.0, 0.0, 1.0), (0.0, -1.0, 1.0, 0.0), (-1.0, 0.0, 0.0, -1.0), (0.0, 1.0, -1.0, 0.0))


class Camera:
    """Maps world points to pixels inside ``rect``; ``fit`` sets the view that ``home`` returns to."""

    def __init__(self, *, y_up: bool = True, quarter_turns: int = 0) -> None:
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.y_up = y_up
        a, b, c, d = _TURNS[quarter_turns % 4]
        sign = -1.0 if y_up else 1.0
        self._turn = (a, b * sign, c, d * sign)  # world to picture, y of the picture down
        self._home = (0.0, 0.0, 0.0)  # centre x, centre y, log of the scale
        self._view = [0.0, 0.0, 0.0]
        self._wanted = [0.0, 0.0, 0.0]
        self._speed = [0.0, 0.0, 0.0]
        self._anchor: tuple[float, float, float, float] | None = None  # world x, y that stays at pixel x, y

    # -- the map ------------------------------------------------------------------------------------

    @property
    def scale(self) -> float:
        """Pixels to a world unit."""
        return math.exp(self._view[2])

    @property
    def center(self) -> tuple[float, float]:
        """World point in the middle of the rectangle."""
        return self._view[0], self._view[1]

    @property
    def wanted(self) -> tuple[float, float, float]:
        """The view that it is, or is on its way to: centre x and y, and the log of the scale."""
        x, y, scale = self._wanted
        return x, y, scale

    def affine(self) -> tuple[float, float, float, float, float, float]:
        """(a, b, c, d, e, f): pixel x = a x + b y + e, pixel y = c x + d y + f."""
        s = self.scale
        a, b, c, d = (s * part for part in self._turn)
        x, y = self._view[0], self._view[1]
        left, top = self.rect.x + 0.5 * self.rect.w, self.rect.y + 0.5 * self.rect.h
        return a, b, c, d, left - a * x - b * y, top - c * x - d * y

    def to_screen(self, x: float, y: float) -> tuple[float, float]:
        """Pixels of a world point."""
        a, b, c, d, e, f = self.affine()
        return a * x + b * y + e, c * x + d * y + f

    def to_world(self, px: float, py: float) -> tuple[float, float]:
        """World point at a pixel."""
        s = self.scale
        a, b, c, d = self._turn  # a rotation or reflection: its inverse is its transpose
        u = (px - self.rect.x - 0.5 * self.rect.w) / s
        v = (py - self.rect.y - 0.5 * self.rect.h) / s
        return self._view[0] + a * u + c * v, self._view[1] + b * u + d * v

    def angle_to_screen(self, angle: float) -> float:
        """Angle in the picture (from +x towards +y down, rad) of a world direction."""
        a, b, c, d = self._turn
        cos, sin = math.cos(angle), math.sin(angle)
        return math.atan2(c * cos + d * sin, a * cos + b * sin)

    @property
    def handedness(self) -> float:
        """-1 if the picture mirrors the sense of turning (y up), else 1."""
        a, b, c, d = self._turn
        return a * d - b * c

    def visible(self) -> Frame:
        """The part of the world inside the rectangle."""
        x0, y0 = self.to_world(self.rect.left, self.rect.top)
        x1, y1 = self.to_world(self.rect.right, self.rect.bottom)
        return Frame(min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))

    def magnified(self, rect: pygame.Rect, center: tuple[float, float], times: float) -> Camera:
        """Another camera, ``times`` as near as this one now, with a world point in the middle of ``rect``."""
        other = Camera()
        other.y_up, other._turn, other.rect = self.y_up, self._turn, pygame.Rect(rect)
        other._view = [*center, self._view[2] + math.log(times)]
        other._home = (*center, other._view[2])
        other._wanted = list(other._view)
        return other

    # -- changes of view ----------------------------------------------------------------------------

    def fit(self, frame: Frame, rect: pygame.Rect, margin: float = 20.0) -> None:
        """Show the whole frame inside ``rect`` with ``margin`` px about it, at once.

        If only the rectangle has changed and the view was moved by hand, it keeps its centre and its zoom
        relative to home.
        """
        old_home = self._home
        self.rect = pygame.Rect(rect)
        width, height = frame.right - frame.left, frame.top - frame.bottom
        if self._turn[0] == 0.0:
            width, height = height, width
        room_x, room_y = max(rect.w - 2.0 * margin, 1.0), max(rect.h - 2.0 * margin, 1.0)
        if not (math.isfinite(width) and math.isfinite(height)):
            width = height = 1.0
        scale = min(room_x / max(width, 1e-12), room_y / max(height, 1e-12))
        x, y = 0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top)
        self._home = (x, y, math.log(scale)) if math.isfinite(x + y) else (0.0, 0.0, math.log(scale))
        if self._wanted == list(old_home) or old_home == (0.0, 0.0, 0.0):
            self._wanted = list(self._home)
        else:
            self._wanted[2] += self._home[2] - old_home[2]
        self._jump()

    def home(self, *, smooth: bool = True) -> None:
        """Go back to the fitted view."""
        self._wanted = list(self._home)
        self._anchor = None
        if not smooth:
            self._jump()

    def look_at(self, frame: Frame, margin: float = 20.0) -> None:
        """Move smoothly to show a frame, without making it home."""
        home, rect = self._home, self.rect
        other = Camera(y_up=self.y_up)
        other._turn = self._turn
        other.fit(frame, rect, margin)
        self._wanted, self._home, self._anchor = list(other._home), home, None

    def fitted(self) -> Camera:
        """A camera of the same rectangle that stands at the fitted view."""
        other = Camera(y_up=self.y_up)
        other._turn, other.rect = self._turn, self.rect
        other._home, other._view, other._wanted = self._home, list(self._home), list(self._home)
        return other

    def show(self, frame: Frame) -> None:
        """Show a frame at once and without a margin, without making it home."""
        self.look_at(frame, 0.0)
        self._jump()

    @property
    def is_home(self) -> bool:
        """Whether the view is, or is on its way to, the fitted one."""
        return self._wanted == list(self._home)

    def pan(self, dx_px: float, dy_px: float) -> None:
        """Move the picture by so many pixels, with the hand."""
        if not (math.isfinite(dx_px) and math.isfinite(dy_px)):
            return
        self._jump()
        a, b, c, d = self._turn
        u, v = dx_px / self.scale, dy_px / self.scale
        self._wanted[0] -= a * u + c * v
        self._wanted[1] -= b * u + d * v
        self._jump()

    def zoom(self, factor: float, about: tuple[float, float], *, smooth: bool = True) -> None:
        """Multiply the scale; the world point at the pixel ``about`` stays where it is."""
        if not (math.isfinite(factor) and factor > 0.0):
            return
        wx, wy = self.to_world(*about)
        self._anchor = (wx, wy, *about)
        low, high = self._home[2] + math.log(FARTHEST), self._home[2] + math.log(NEAREST)
        self._wanted[2] = min(max(self._wanted[2] + math.log(factor), low), high)
        self._wanted[:2] = self._anchored_center(self._wanted[2])
        if not smooth:
            self._jump()

    def update(self, dt_s: float) -> bool:
        """Let the view follow for so many seconds; True while it moves."""
        if self._view == self._wanted:
            return False
        if not (0.0 <= dt_s < 10.0):
            self._jump()
            return True
        decay = math.exp(-STIFFNESS * dt_s)
        for i in range(3):
            gap = self._view[i] - self._wanted[i]
            push = (self._speed[i] + STIFFNESS * gap) * dt_s
            self._view[i] = self._wanted[i] + (gap + push) * decay
            self._speed[i] = (self._speed[i] - STIFFNESS * push) * decay
        if self._anchor is not None:
            self._view[:2] = self._anchored_center(self._view[2])
        limit = 0.05 / self.scale  # a twentieth of a pixel
        off = max(abs(self._view[0] - self._wanted[0]), abs(self._view[1] - self._wanted[1]))
        if off < limit and abs(self._view[2] - self._wanted[2]) < 1e-4:
            self._jump()
        return True

    def _anchored_center(self, log_scale: float) -> list[float]:
        """Centre that keeps the anchor at its pixel at that scale."""
        assert self._anchor is not None
        wx, wy, px, py = self._anchor
        s = math.exp(log_scale)
        a, b, c, d = self._turn
        u = (px - self.rect.x - 0.5 * self.rect.w) / s
        v = (py - self.rect.y - 0.5 * self.rect.h) / s
        return [wx - a * u - c * v, wy - b * u - d * v]

    def _jump(self) -> None:
        self._view = list(self._wanted)
        self._speed = [0.0, 0.0, 0.0]
        self._anchor = None
