"""The film of any scene: its stage goes on by a frame's time, is drawn off screen, and is heard."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pygame

from game.app.film.progress import Progress
from game.app.film.soundtrack import Ear, Soundtrack
from game.app.film.video import VideoWriter
from game.app.stagehand.headless import prepare
from game.app.stagehand.script import Script
from game.app.stagehand.view import StageView
from game.stage import Stage, Stamped
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named


def write_scene_film(
    stage: Stage, events: Sequence[Stamped], path: Path, size: tuple[int, int], fps: int, seconds: float,
    theme: str = "dark", players: bool = False,
) -> int:  # fmt: skip
    """Film a stage while events act at their steps; the pictures made. VideoError in one line.

    A scene that is stopped ends its film. players: the scene's own players play, and no time passes while
    they think.
    """
    prepare()
    look = Look(theme_named(theme), auto_scale(*size))
    surface = pygame.Surface(size, 0, 32)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    script = Script(stage, events, players)
    track = Soundtrack()
    ear = Ear(track)
    sounding = stage.scene.is_heard()
    progress = Progress("Film")
    count = max(round(seconds * fps), 1)
    with VideoWriter(path, size, fps, sound=sounding) as video:
        for i in range(count):
            surface.fill(look.theme.stage)
            view.draw(surface)
            if sounding:
                ear.follow(stage.scene.hearing(), 1.0 / fps)
            video.add(surface, track.take((i + 1) / fps) if sounding else None)
            progress.tell(i + 1, count)
            if stage.fault is not None:
                return i + 1
            script.advance(1.0 / fps)
    return count
