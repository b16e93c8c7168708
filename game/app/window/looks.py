"""Appearances that were used last: coming back to one finds all the words that it has drawn."""

from __future__ import annotations

from game.ui.look.look import Look
from game.ui.look.theme import theme_named

KEPT = 3  # dark and light, a window as it is and as it was


class Looks:
    """A few looks by theme, scale and motion."""

    def __init__(self) -> None:
        self._kept: dict[tuple[str, float, bool], Look] = {}  # the one used last at the end

    def get(self, theme: str, scale: float, less_motion: bool) -> Look:
        """The look, made if need be. ValueError for a theme that there is not."""
        key = theme, scale, less_motion
        look = self._kept.pop(key, None) or Look(theme_named(theme), scale, less_motion=less_motion)
        self._kept[key] = look
        while len(self._kept) > KEPT:
            del self._kept[next(iter(self._kept))]
        return look
