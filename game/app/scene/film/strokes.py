"""A film of several strokes of a match, one after the other, each played again beside the scene in play."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from game.app.film.soundtrack import Ear, Soundtrack
from game.app.film.video import VideoError
from game.app.scene.film.writers import Writer
from game.app.stagehand.view import StageView
from game.stage import Scene, Stage
from game.stage.records.excerpt import Excerpt
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named


class FilmOfStrokes:
    """Draws excerpts into a writer, at life's pace. VideoError if one of them cannot be played."""

    label = "Film of the deciding strokes"
    same = True

    def __init__(
        self, scene_type: type[Scene], excerpts: Sequence[Excerpt], writer: Writer, theme: str
    ) -> None:
        self.writer = writer
        self._scene_type, self._excerpts = scene_type, tuple(excerpts)
        self._look = Look(theme_named(theme), auto_scale(*writer.size))
        self._surface = pygame.Surface(writer.size, 0, 32)
        self._track = Soundtrack()
        self._ear = Ear(self._track)
        self.pictures, self._stroke, self._time_s = 0, -1, 0.0
        self._done_s = 0.0
        self._next()
        self._total_s = sum(one.steps for one in self._excerpts) * self.dt

    def _next(self) -> None:
        """Open the next stroke."""
        self._stroke += 1
        if self.finished:
            return
        excerpt = self._excerpts[self._stroke]
        try:
            self._stage = Stage(
                self._scene_type, level=excerpt.level, effects=excerpt.active, seed=excerpt.seed, record=False
            )
            for event in excerpt.events:
                self._stage.post(event)
        except ValueError as error:
            raise VideoError(f"{excerpt.name}: {error}") from None
        self._view = StageView(self._stage, self._look)
        self._view.place(self._surface.get_rect(), self._look)
        self._time_s = 0.0

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self._stage.dt

    @property
    def failed(self) -> bool:
        """Whether a stroke has been stopped."""
        return self._stage.fault is not None

    @property
    def share(self) -> float:
        """How much of it is drawn, 0 to 1."""
        return min((self._done_s + self._time_s) / self._total_s, 1.0)

    @property
    def finished(self) -> bool:
        """Whether there is nothing more to draw."""
        return self._stroke >= len(self._excerpts)

    def step(self) -> None:
        """Make the steps of the next picture; any thread may do it."""
        wanted = min(round(self._time_s / self.dt), self._excerpts[self._stroke].steps)
        if wanted > self._stage.step_number:
            self._stage.run(wanted - self._stage.step_number)
        self._time_s += 1.0 / self.writer.rate

    def draw(self) -> None:
        """Draw the next picture and hand it over; after the last of a stroke the next one is opened."""
        self._surface.fill(self._look.theme.stage)
        self._view.draw(self._surface)
        self._ear.follow(self._stage.scene.hearing(), 1.0 / self.writer.rate)
        self.pictures += 1
        self.writer.add(self._surface, [self._track.take(self.pictures / self.writer.rate)])
        if self._stage.step_number >= self._excerpts[self._stroke].steps:
            self._done_s += self._time_s
            self._next()
