"""Pictures without a window: of a stage, and of a scene's demo."""

from __future__ import annotations

import os

import pygame

from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script, demo_of, demo_steps
from game.app.stagehand.view import StageView
from game.stage import Stage
from game.stage.catalogue import Entry
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

DEMO_SHOWN_S = 2.5  # s into the demo at which its picture is taken


def prepare() -> None:
    """Make pygame able to draw where there is no screen."""
    os.environ["SDL_VIDEODRIVER"] = "dummy"
    pygame.display.init()
    pygame.font.init()


def picture_of_stage(stage: Stage, size: tuple[int, int], theme: str = "dark") -> pygame.Surface:
    """The scene's picture alone, filling the whole size in pixels."""
    prepare()
    look = Look(theme_named(theme), auto_scale(*size))
    surface = pygame.Surface(size, 0, 32)
    surface.fill(look.theme.stage)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    view.draw(surface)
    return surface


def demo_picture(entry: Entry, size: tuple[int, int]) -> pygame.Surface:
    """Play a scene's demo as fast as it goes; its picture from the midst of it."""
    scene_type = entry.load()
    stage = Opening().make_stage(scene_type)
    script = Script(stage, demo_of(scene_type))
    script.run(min(round(DEMO_SHOWN_S / stage.dt), demo_steps(scene_type, stage.dt)))
    surface = picture_of_stage(stage, size)
    script.run(max(0, demo_steps(scene_type, stage.dt) - stage.step_number))
    return surface
