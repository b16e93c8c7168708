"""What a person has chosen for the whole program, in one file of the user's folder: settings.toml.

A file that cannot be understood costs one line and nothing else: the defaults hold, and the broken file
is kept beside as settings.broken.toml.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Annotated, Literal

import msgspec
import tomli_w

from game.app.window.keys import Keys
from game.files import read_text, write_text

FILE_NAME = "settings.toml"
LARGEST_BYTES = 100_000
HEAD = '# Carom. Keys are named by their place on a US keyboard: pause = "space", save = "ctrl+s".\n'

Scale = Annotated[float, msgspec.Meta(ge=0.75, le=2.0)]
Side = Annotated[int, msgspec.Meta(ge=1, le=16_384)]


class Settings(msgspec.Struct, forbid_unknown_fields=True):
    """All settings with their defaults."""

    name: Annotated[str, msgspec.Meta(max_length=40)] = ""  # of the player, on the title card of a story
    theme: Literal["dark", "light"] = "dark"
    ui_scale: Scale = 1.0  # times the automatic scale
    less_motion: bool = False
    full_screen: bool = False
    width: Side = 1280  # px, window
    height: Side = 720
    panel: bool = True
    panel_in_games: bool = False  # a game has all of the window until its panel is asked for
    volume: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 0.7  # of sounds; 0 is silence
    toured: bool = False  # the tour has been shown
    keys: dict[str, str] = {}


class Loaded(msgspec.Struct):
    """Settings, and the line to tell if the file was broken."""

    settings: Settings
    complaint: str = ""


def settings_path(folder: Path) -> Path:
    """The file in the user's folder."""
    return folder / FILE_NAME


def load_settings(folder: Path) -> Loaded:
    """Read the settings of a folder; the defaults if there is no file or it is broken. Never raises."""
    path = settings_path(folder)
    if not path.exists():
        return Loaded(Settings())
    try:
        settings = msgspec.convert(tomllib.loads(read_text(path, LARGEST_BYTES)), Settings)
        Keys(settings.keys)
    except (ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())
        return Loaded(Settings(), f"{path.name}: {reason}; the defaults hold{_put_aside(path)}")
    return Loaded(settings)


def _put_aside(path: Path) -> str:
    """Rename a broken file so that saving does not overwrite what its owner wrote."""
    aside = path.with_name("settings.broken.toml")
    try:
        path.replace(aside)
    except OSError:
        return ""
    return f", the file is kept as {aside.name}"


def save_settings(settings: Settings, folder: Path) -> None:
    """Write the file whole or not at all; FileProblem if it cannot be written."""
    write_text(settings_path(folder), HEAD + tomli_w.dumps(msgspec.to_builtins(settings)))
