"""``play`` and no command at all: the window. Without a display the billiard demo runs headless instead."""

from __future__ import annotations

import argparse
import os
import sys
import threading
from pathlib import Path
from typing import Any

from game.app.commands import given, stories
from game.app.window.mistake import MistakeError
from game.app.window.window import NoDisplayError, Window, display_missing
from game.app.window.words import printable, say

DEMO_SCENES = ("billiards", "lecture-table")  # the first of these that there is
PICTURE_SIZE = (1280, 720)


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("play", help="open a scene in the window", allow_abbrev=False)
    given.add_scene_options(parser)
    parser.add_argument("--replay", metavar="FILE", help="watch a recording made of this scene")
    parser.add_argument("--story", nargs="?", const="", metavar="NAME", help="play a story of the scene")
    parser.set_defaults(execute=execute)


def execute_menu(options: argparse.Namespace) -> int:
    """The menu."""
    reason = display_missing()
    if not reason:
        try:
            return _run_window("")
        except NoDisplayError as error:
            reason = str(error)
    return _play_demo(reason)


def execute(options: argparse.Namespace) -> int:
    """One scene, opened at once."""
    from game.app.stagehand.opening import Opening

    scene_type = given.scene_type_named(options.scene)
    recording = given.read_replay(options, scene_type.name)
    if options.story is not None:
        given.refuse_beside_story(options)
        stories.named(scene_type, options.story)
    opening = Opening(
        level=given.read_level(scene_type, options.level).path if options.level is not None else None,
        parameters=given.read_parameters(scene_type, options.parameters),
        effects_off=given.read_effects(scene_type, options.effects_off),
        seed=given.read_seed(options.seed),
        recording=recording,
        story=_story_word(options.story),
    )
    return open_window(scene_type.name, opening, "run does the same without a window")


def open_window(scene_name: str, opening: Any, instead: str) -> int:
    """A scene in the window; MistakeError, saying what else there is, where there is no display."""
    reason = display_missing()
    if reason:
        raise MistakeError(f"no display: {reason}; {instead}")
    try:
        return _run_window(scene_name, opening)
    except NoDisplayError as error:
        raise MistakeError(f"no display: {error}; {instead}") from None


def _story_word(word: str | None) -> str | Path | None:
    """A story by its file or its name."""
    return Path(word) if word is not None and word.endswith(".toml") else word


def _run_window(scene_name: str, opening: Any = None) -> int:
    """Open the window first and load the rest after it, so that something is seen at once."""
    from game.app.window.settings import load_settings
    from game.folders import user_folder

    loaded = load_settings(user_folder())
    settings = loaded.settings
    if loaded.complaint:
        print(f"carom: {printable(loaded.complaint)}", file=sys.stderr)
    window = Window((settings.width, settings.height), settings.full_screen)
    try:
        window.show_start(settings.theme)
        from game.app.start import start

        start(window, loaded, scene_name, opening)
    finally:
        window.close()
    _leave_compilers_behind()
    return 0


def _leave_compilers_behind() -> None:
    """End the process at once if a kernel is still being compiled: the compiler cannot be interrupted, and
    the interpreter must not be taken down under it."""
    if threading.active_count() > 1:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)


def _play_demo(reason: str) -> int:
    """Say that there is no display, play the table's demo and save a picture of it."""
    from game.app.stagehand.headless import demo_picture
    from game.app.window.pictures import save_picture
    from game.scenes import CATALOGUE

    names = [entry.name for entry in CATALOGUE]
    name = next((name for name in DEMO_SCENES if name in names), names[0])
    surface = demo_picture(CATALOGUE[name], PICTURE_SIZE)
    try:
        path = save_picture(surface, CATALOGUE[name].title)
    except OSError as error:
        raise MistakeError(f"no display ({reason}), and no picture: {error}") from None
    say(f"carom: no display ({reason}); the demo of {name} ran without one, its picture is {path}")
    return 0
