"""What a person has chosen for the whole program, in one file of the user's folder: settings.toml.

A file that cannot be understood costs one line and nothing else: what is sound in it holds, defaults stand
for the rest, and the broken file is kept beside as settings.broken.toml.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
import tomli_w

from game.app.window.keys import Keys
from game.files import read_text, write_text

FILE_NAME = "settings.toml"
LARGEST_BYTES = 100_000
MOST_BROKEN = 99  # files put aside; then the last one is written over
HEAD = '# Carom. Keys are named by their place on a US keyboard: pause = "space", save = "ctrl+s".\n'

Scale = Annotated[float, msgspec.Meta(ge=0.75, le=2.0)]
Side = Annotated[int, msgspec.Meta(ge=1, le=16_384)]
SceneNames = Annotated[list[Annotated[str, msgspec.Meta(max_length=100)]], msgspec.Meta(max_length=500)]


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
    story_toured: bool = False  # that of stories has
    favourites: SceneNames = []  # scenes with a star, as starred; one that there is no more is kept too
    recent: SceneNames = []  # scenes opened, the last one first
    keys: dict[str, str] = {}
    start: dict[str, dict[str, str]] = {}  # by scene: what was chosen before the last game


class Loaded(msgspec.Struct):
    """Settings, the line to tell if the file was broken, and whether there was none: the very first start."""

    settings: Settings
    complaint: str = ""
    first_start: bool = False


def settings_path(folder: Path) -> Path:
    """The file in the user's folder."""
    return folder / FILE_NAME


def load_settings(folder: Path) -> Loaded:
    """Read the settings of a folder; defaults for what is missing or broken. Never raises."""
    path = settings_path(folder)
    if not path.exists():
        return Loaded(Settings(), first_start=True)
    settings, reason = Settings(), ""
    try:
        table = tomllib.loads(read_text(path, LARGEST_BYTES))
        settings, reason = _sound_part(table)
    except (ValueError, RecursionError) as error:
        reason = str(error)
    if not reason:
        return Loaded(settings)
    return Loaded(settings, f"{path.name}: {' '.join(reason.split())}; {_rest(settings)}{_put_aside(path)}")


def _sound_part(table: dict[str, Any]) -> tuple[Settings, str]:
    """Settings of the fields that can be understood, and what is wrong with the first of the others."""
    sound: dict[str, Any] = {}
    reason = ""
    for name, value in table.items():
        try:
            field = msgspec.convert({name: value}, Settings)
            Keys(field.keys)
        except (ValueError, RecursionError) as error:
            reason = reason or str(error)
        else:
            sound[name] = value
    return msgspec.convert(sound, Settings), reason


def _rest(settings: Settings) -> str:
    """What is in force instead of what is broken."""
    return "the defaults hold" if settings == Settings() else "its default holds, the rest is kept"


def _put_aside(path: Path) -> str:
    """Rename a broken file, not onto an earlier one, so that nothing that its owner wrote is lost."""
    names = [path.with_name(f"settings.broken{number}.toml") for number in ("", *range(2, MOST_BROKEN + 1))]
    aside = next((name for name in names if not name.exists()), names[-1])
    try:
        path.replace(aside)
    except OSError:
        return ""
    return f", the file is kept as {aside.name}"


def save_settings(settings: Settings, folder: Path) -> None:
    """Write the file whole or not at all; FileProblem if it cannot be written."""
    write_text(settings_path(folder), HEAD + tomli_w.dumps(msgspec.to_builtins(settings)))
