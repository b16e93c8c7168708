"""A film of the last seconds, gone through once more beside the scene in play: a picture a frame or so."""

from __future__ import annotations

import pygame

from game.app.film.soundtrack import Ear, Soundtrack
from game.app.scene.film.live import QUIET
from game.app.scene.film.writers import Writer
from game.app.stagehand.view import StageView
from game.stage.replays.rerun import Rerun
from game.ui.canvas.camera import Camera
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

SLOW_S = 0.03  # of steps for one picture, from which on a thread makes them


class FilmAgain:
    """Draws a rerun into a writer. ``speed``: simulated seconds to one of film. ``camera``: of the window."""

    label = "Film of the last seconds"

    def __init__(self, rerun: Rerun, writer: Writer, speed: float, theme: str, camera: Camera) -> None:
        self.rerun, self.writer = rerun, writer
        look = Look(theme_named(theme), auto_scale(*writer.size))
        self._surface = pygame.Surface(writer.size, 0, 32)
        self._ground = look.theme.stage
        self._view = StageView(rerun, look)
        self._view.place(self._surface.get_rect(), look)
        if not camera.is_home:
            self._view.camera.show(camera.visible())
        self._begin_s, self._speed = rerun.time_s, speed
        last_s = rerun.time_s + (rerun.kept.last - rerun.step) * rerun.kept.dt
        self.count = max(1, round((last_s - self._begin_s) / speed * writer.rate))
        self.pictures = 0
        self._track = Soundtrack()
        self._ear = Ear(self._track) if rerun.scene.is_heard() else None

    @property
    def share(self) -> float:
        """How much of it is drawn, 0 to 1."""
        return min(self.pictures / self.count, 1.0)

    @property
    def finished(self) -> bool:
        """Whether there is nothing more to draw."""
        return self.pictures >= self.count or self.rerun.failed

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self.rerun.dt

    @property
    def failed(self) -> bool:
        """Whether it could not be gone through."""
        return self.rerun.failed

    @property
    def same(self) -> bool:
        """Whether it came to the same end."""
        return bool(self.rerun.same)

    def step(self) -> None:
        """Make the steps of the next picture; any thread may do it."""
        rerun = self.rerun
        wanted_s = self._begin_s + self.pictures * self._speed / self.writer.rate
        if self.pictures >= self.count - 1:
            rerun.advance_to(rerun.kept.last)
        while rerun.time_s < wanted_s and not rerun.finished:
            rerun.advance_to(rerun.step + 1)
        ahead = (rerun.time_s - wanted_s) / max(rerun.dt, 1e-12)
        rerun.alpha = min(max(1.0 - ahead, 0.0), 1.0)

    def draw(self) -> None:
        """Draw the next picture and hand it over."""
        self._surface.fill(self._ground)
        self._view.draw(self._surface)
        sounds = [QUIET]
        if self._ear is not None:
            self._ear.follow(self.rerun.scene.hearing(), 1.0 / self.writer.rate)
            sounds = [self._track.take((self.pictures + 1) / self.writer.rate)]
        self.writer.add(self._surface, sounds)
        self.pictures += 1
