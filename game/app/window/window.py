"""The window: made, resized, full screen, lost and found again; pixels and points.

pygame.Window gives a drawing surface of true pixels on screens that scale (a display made by
``pygame.display.set_mode`` is stretched there). Positions of the mouse come in points and are brought to
pixels here, so nothing else needs to know. No sound is opened here: no sound card is needed.
"""

from __future__ import annotations

import os
import sys
from typing import Any

import pygame

from game.ui.look.assets import asset

TITLE = "Carom"
SMALLEST = (320, 240)  # px; smaller windows work, but only by force
_POINTED = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)


class NoDisplayError(Exception):
    """There is no screen to open a window on; the message says why."""


def display_missing() -> str:
    """Why no window can be opened, as far as the environment tells; empty if one may be tried."""
    driver = os.environ.get("SDL_VIDEODRIVER", "")
    if driver in ("dummy", "offscreen"):
        return f"SDL_VIDEODRIVER is {driver}"
    if sys.platform.startswith("linux") and not driver:
        if not os.environ.get("DISPLAY") and not os.environ.get("WAYLAND_DISPLAY"):
            return "neither DISPLAY nor WAYLAND_DISPLAY is set"
    return ""


class Window:
    """One resizable window with a surface of true pixels."""

    def __init__(self, size: tuple[int, int], full_screen: bool = False):
        """``size`` in points. Raises NoDisplayError if the system will not give a window."""
        os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")
        os.environ.setdefault("SDL_VIDEO_X11_WMCLASS", TITLE)
        self.full_screen = full_screen
        self._size = size
        self.window = self._open()

    def _open(self) -> pygame.Window:
        try:
            pygame.display.init()
            pygame.font.init()
            window = pygame.Window(TITLE, self._size, resizable=True, allow_high_dpi=True)
            if self.full_screen:
                window.set_fullscreen(True)
            window.get_surface()
        except pygame.error as error:
            raise NoDisplayError(str(error)) from None
        window.minimum_size = SMALLEST
        return window

    @property
    def surface(self) -> pygame.Surface:
        """The surface to draw a frame on; its size is the window's in pixels."""
        return self.window.get_surface()

    @property
    def size(self) -> tuple[int, int]:
        """Size in pixels."""
        return self.surface.get_size()

    @property
    def points(self) -> tuple[int, int]:
        """Size in points, as the settings keep it."""
        return self.window.size

    @property
    def refresh_hz(self) -> float:
        """The screen's refresh rate, or 60."""
        try:
            rates = pygame.display.get_desktop_refresh_rates()
        except (pygame.error, AttributeError):
            return 60.0
        return float(rates[0]) if rates and rates[0] > 0 else 60.0

    def show_start(self, theme: str) -> None:
        """The first picture, before anything else is loaded: the ground and the program's name."""
        dark = theme == "dark"
        surface = self.surface
        surface.fill("#0E1317" if dark else "#E9E5DC")
        font = pygame.font.Font(asset("fonts", "CaromDisplay-Bold.otf"), max(20, self.size[1] // 24))
        name = font.render(TITLE, True, "#ECE8DE" if dark else "#1A232A")
        surface.blit(name, name.get_rect(center=surface.get_rect().center))
        pygame.event.pump()
        self.flip()

    def set_icon(self, icon: pygame.Surface) -> None:
        """The picture in the task bar."""
        self.window.set_icon(icon)

    def set_title(self, scene_title: str) -> None:
        """Name the scene beside the program."""
        self.window.title = f"{scene_title} – {TITLE}" if scene_title else TITLE

    def resize(self, size: tuple[int, int]) -> None:
        """Ask for another size in points."""
        self.window.size = size

    def toggle_full_screen(self) -> bool:
        """Between a window and the whole screen; True if it is full screen now."""
        self.full_screen = not self.full_screen
        if self.full_screen:
            self.window.set_fullscreen(True)
        else:
            self.window.set_windowed()
        return self.full_screen

    def flip(self) -> None:
        """Show the frame. A lost display is opened again; NoDisplayError if that fails too."""
        try:
            self.window.flip()
        except pygame.error:
            self.reopen()

    def reopen(self) -> None:
        """Open a new window in place of one that was lost."""
        self.close()
        self.window = self._open()

    def close(self) -> None:
        """Give the window back."""
        self.window.destroy()

    def to_pixels(self, event: pygame.Event) -> pygame.Event:
        """The event with its mouse position in pixels instead of points."""
        if event.type not in _POINTED:
            return event
        (pixels_x, pixels_y), (points_x, points_y) = self.size, self.points
        if (pixels_x, pixels_y) == (points_x, points_y):
            return event
        fields: dict[str, Any] = dict(event.dict)
        scale_x, scale_y = pixels_x / max(points_x, 1), pixels_y / max(points_y, 1)
        for name in ("pos", "rel"):
            if name in fields:
                fields[name] = (round(fields[name][0] * scale_x), round(fields[name][1] * scale_y))
        return pygame.Event(event.type, fields)
