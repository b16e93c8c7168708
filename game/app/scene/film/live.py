"""A film of what is seen from now on: pictures of the window's stage, as many as their rate asks for.

If a picture comes late the one before it is shown longer. So the film lasts as long as what it shows, and
play never waits for it.
"""

from __future__ import annotations

import numpy as np
import pygame

from game.app.film.soundtrack import Ear, Soundtrack
from game.app.scene.film.writers import LONGEST_S, Writer
from game.arrays import Samples
from game.stage.declarations import Hearing

MOST_OWED_S = 1.0  # a window that is not drawn stops the film
QUIET = np.zeros((0, 2), np.int16)


class LiveFilm:
    """Feeds one writer. ``sounding``: whether the scene is heard."""

    def __init__(self, writer: Writer, sounding: bool) -> None:
        self.writer = writer
        self.pictures = 0
        self._passed = 0.0  # pictures that time has asked for
        self._track = Soundtrack()
        self._ear = Ear(self._track) if sounding else None

    @property
    def seconds(self) -> float:
        """Length of the film so far, s."""
        return self.pictures / self.writer.rate

    @property
    def finished(self) -> bool:
        """Whether it is as long as such a film may be."""
        return self.seconds >= LONGEST_S[self.writer.path.suffix[1:]]

    def pass_time(self, elapsed_s: float, hearing: Hearing | None) -> None:
        """Let real time pass; ``hearing``: what is heard of the scene now."""
        if self._ear is not None:
            self._ear.follow(hearing, elapsed_s)
        most = self.pictures + MOST_OWED_S * self.writer.rate
        self._passed = min(self._passed + elapsed_s * self.writer.rate, most)

    def see(self, surface: pygame.Surface, place: pygame.Rect) -> None:
        """Take a picture of this part of the window, if one is due and the writer has a place for it."""
        due = int(self._passed) - self.pictures
        if due < 1 or self.writer.full or place.w < 2 or place.h < 2:
            return
        picture = pygame.Surface(self.writer.size, 0, 32)
        part = surface.subsurface(place.clip(surface.get_rect()))
        share = min(picture.get_width() / part.get_width(), picture.get_height() / part.get_height())
        size = (round(part.get_width() * share), round(part.get_height() * share))
        shown = part if size == part.get_size() else pygame.transform.smoothscale(part, size)
        picture.blit(shown, shown.get_rect(center=picture.get_rect().center))
        sounds: list[Samples] = [QUIET] * due
        if self._ear is not None:
            sounds = [self._track.take((self.pictures + i + 1) / self.writer.rate) for i in range(due)]
        self.writer.add(picture, sounds)
        self.pictures += due
