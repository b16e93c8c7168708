"""The change from one screen to another: the old picture fades over the new one."""

from __future__ import annotations

import pygame

SCENE_S = 0.22  # s, another scene
OVERLAY_S = 0.20  # s, a card over the scene


class CrossFade:
    """Holds the old picture and lets it vanish."""

    def __init__(self) -> None:
        self._old: pygame.Surface | None = None
        self._left_s = 0.0
        self._length_s = 0.0

    @property
    def running(self) -> bool:
        """Whether an old picture is still to be seen."""
        return self._old is not None

    def begin(self, shown: pygame.Surface, length_s: float) -> None:
        """Take the picture shown now; ``length_s`` 0 changes at once."""
        if length_s <= 0.0:
            self._old = None
            return
        self._old = shown.copy()
        self._left_s = self._length_s = length_s

    def update(self, elapsed_s: float) -> None:
        """Let the old picture vanish a little more."""
        self._left_s -= elapsed_s
        if self._left_s <= 0.0:
            self._old = None

    def draw(self, surface: pygame.Surface) -> None:
        """Lay what is left of the old picture over the new one (ease-out cubic)."""
        if self._old is None:
            return
        if self._old.get_size() != surface.get_size():
            self._old = None
            return
        left = self._left_s / self._length_s
        self._old.set_alpha(round(255 * left * left * left))
        surface.blit(self._old, (0, 0))
