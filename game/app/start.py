"""From an open window to the running program."""

from __future__ import annotations

import sys

import pygame

from game.app.application import App
from game.app.loop import Loop
from game.app.stagehand.opening import Opening
from game.app.window.settings import Loaded
from game.app.window.window import Window
from game.folders import user_folder
from game.scenes import CATALOGUE
from game.ui.look.icons import logo

REPEAT_AFTER_MS, REPEAT_MS = 350, 50
SWITCH_S = 0.0005  # the compiler in the background lets go of the interpreter so often (Python: 0.005)


def start(window: Window, loaded: Loaded, scene_name: str = "", opening: Opening | None = None) -> None:
    """Run the program until its window is closed, beginning with the menu or with a scene."""
    sys.setswitchinterval(SWITCH_S)
    pygame.key.set_repeat(REPEAT_AFTER_MS, REPEAT_MS)
    app = App(window, CATALOGUE, loaded.settings, user_folder())
    window.set_icon(logo(64, app.look.theme))
    app.tour_due = not loaded.settings.toured
    app.story_tour_due = not loaded.settings.story_toured
    app.welcome_due = loaded.first_start and not scene_name
    app.open_menu()
    if scene_name:
        app.open_scene(scene_name, opening=None if opening == Opening() else opening)
    if loaded.complaint:
        app.tell("Settings not read.", loaded.complaint, kind="warning")
    try:
        Loop(app).run()
    finally:
        app.save_settings()
