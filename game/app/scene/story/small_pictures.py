"""Small pictures of a story as it was seen: what its bar shows of a moment that it is dragged to."""

from __future__ import annotations

import pygame

SIZE = (240, 135)  # px
EVERY_S = 1.0  # of film
NEAR_S = 3.0  # s of film to the moment that one may stand for


class SmallPictures:
    """One for each second of the film that has been shown; those of a part not yet seen are missing."""

    def __init__(self) -> None:
        self._kept: dict[int, pygame.Surface] = {}

    def see(self, film_s: float, surface: pygame.Surface, place: pygame.Rect) -> None:
        """Keep what is in a rectangle of the window, if that second has no picture yet."""
        number = int(film_s / EVERY_S)
        part = place.clip(surface.get_rect())
        if number in self._kept or part.w < 2 or part.h < 2:
            return
        self._kept[number] = pygame.transform.smoothscale(surface.subsurface(part), SIZE)

    def at(self, film_s: float | None) -> pygame.Surface | None:
        """The picture nearest to a moment; None if there is none near it."""
        if film_s is None or not self._kept:
            return None
        nearest = min(self._kept, key=lambda number: abs((number + 0.5) * EVERY_S - film_s))
        return self._kept[nearest] if abs((nearest + 0.5) * EVERY_S - film_s) <= NEAR_S else None
