"""The picture of a whole window without one: a scene with its bar, panel, strips, legend and hints."""

from __future__ import annotations

import pygame

from game.app.application import App
from game.app.scene.play import ScenePlay
from game.app.scene.shell import Shell
from game.app.stagehand.headless import prepare
from game.app.stagehand.opening import Opening
from game.app.window.settings import Settings
from game.app.window.window import Window
from game.folders import user_folder
from game.stage import Stage
from game.stage.catalogue import Catalogue


def picture_of_window(
    stage: Stage, catalogue: Catalogue, size: tuple[int, int], theme: str
) -> pygame.Surface:
    """What a window of that size (px) shows of a stage as it stands; ``theme``: dark or light."""
    prepare()
    window = Window(size)
    settings = Settings(theme="light" if theme == "light" else "dark", panel_in_games=True, volume=0.0)
    host = App(window, catalogue, settings, user_folder(), background=False)
    play = ScenePlay(host, Shell(host, catalogue[stage.scene.name]), stage, Opening())
    play.shell.update(1.0, stage, None)
    play.banner.update(1.0, play.trouble)
    picture = window.surface.copy()
    play.draw(picture)
    play.close()
    window.close()
    return picture
