"""What the user gives on the command line, read and checked; a MistakeError names what is wrong with it."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from game.app.window.mistake import MistakeError
from game.definition import DefinitionError
from game.stage.opening.definition import check_strips

if TYPE_CHECKING:
    from game.levels import Level
    from game.stage import Recording, Scene, Stage

MOST_STEPS = 1_000_000_000
LARGEST_SIDE = 8192  # px
MOST_PIXELS = 40_000_000
SMALLEST_FILM = 64  # px, of a side
MOST_FPS = 120
MOST_NAMES = 3  # of levels that may have been meant


def add_scene_options(parser: argparse.ArgumentParser) -> None:
    """The options that say how a scene begins: play and run share them."""
    parser.add_argument("scene", metavar="SCENE", help="name of a scene (see: list)")
    parser.add_argument("--set", action="append", default=[], metavar="K=V", dest="parameters",
                        help="set a parameter; may be given several times")  # fmt: skip
    parser.add_argument(
        "--level", metavar="FILE", help="level file, or the name of one of the scene's levels"
    )
    parser.add_argument("--effects-off", default="", metavar="A,B", help="effects to leave out")
    parser.add_argument("--seed", metavar="N", help="seed of the random numbers")


def scene_type_named(name: str) -> type[Scene]:
    """The scene's class."""
    from game.scenes import CATALOGUE

    try:
        entry = CATALOGUE[name.lower()]
    except KeyError as error:
        raise MistakeError(str(error.args[0])) from None
    try:
        return entry.load()
    except ImportError as error:
        raise MistakeError(f"{name} cannot be opened: {error}", status=1) from error


def make_stage(options: argparse.Namespace, **more: Any) -> Stage:
    """The stage that the scene options describe."""
    from game.levels import LevelError
    from game.stage import ParameterError, Stage

    scene_type = scene_type_named(options.scene)
    named = options.level is not None
    level = read_level(scene_type, options.level) if named else default_level(scene_type)
    try:
        stage = Stage(
            scene_type,
            level=level,
            parameters=read_parameters(scene_type, options.parameters),
            effects_off=read_effects(scene_type, options.effects_off),
            seed=read_seed(options.seed),
            **more,
        )
        check_strips(stage.scene)
        return stage
    except (ParameterError, LevelError) as error:
        raise MistakeError(str(error)) from None
    except DefinitionError:
        raise
    except ValueError as error:
        raise MistakeError(f"{options.scene}: {error}") from None


def read_parameters(scene_type: type[Scene], words: Iterable[str]) -> dict[str, Any]:
    """Values by name from ``k=v`` words, each checked by its parameter."""
    from game.stage import ParameterError

    values: dict[str, Any] = {}
    for word in words:
        name, equals, text = word.partition("=")
        if not equals or not name.strip():
            raise MistakeError(f"--set {word}: expected NAME=VALUE")
        try:
            values[name.strip()] = scene_type.parameter(name.strip()).parse(text)
        except ParameterError as error:
            raise MistakeError(f"--set {error}") from None
    return values


def read_effects(scene_type: type[Scene], text: str) -> tuple[str, ...]:
    """Effect names from a list with commas, each declared by the scene."""
    from game.stage import ParameterError

    names = tuple(word.strip() for word in text.split(",") if word.strip())
    for name in names:
        try:
            scene_type.effect(name)
        except ParameterError as error:
            raise MistakeError(f"--effects-off {error}") from None
    return names


def read_seed(text: str | None) -> int | None:
    """A seed: a whole number of at most 63 bits, not negative."""
    if text is None:
        return None
    try:
        seed = int(text)
    except ValueError:
        raise MistakeError(f"--seed {text}: expected a whole number") from None
    if not 0 <= seed < 2**63:
        raise MistakeError(f"--seed {text}: outside 0 to 2^63 - 1")
    return seed


def read_level(scene_type: type[Scene], word: str) -> Level:
    """A level by its path, or by the name of one of the scene's own files."""
    from game.levels import LevelError, level_files, load_level

    path = Path(word)
    if not path.exists():
        own = {file.stem: file for file in level_files(scene_type.name)}
        name = path.stem if path.suffix == ".toml" and path.parent == Path() else word
        if name not in own and path.suffix != ".toml" and path.parent == Path():
            raise MistakeError(_no_such_level(scene_type.name, word, sorted(own)))
        path = own.get(name, path)
    try:
        return load_level(path, scene_type.name, scene_type.content_type)
    except LevelError as error:
        raise MistakeError(str(error)) from None


def _no_such_level(scene: str, word: str, names: list[str]) -> str:
    """What is said of a name that no level of a scene has: those that are alike, else all."""
    parts = [name for name in names if set(word.split("-")) & set(name.split("-"))]
    alike = list(dict.fromkeys([*get_close_matches(word, names, MOST_NAMES, 0.6), *parts]))[:MOST_NAMES]
    offered = f"did you mean {' or '.join(alike)}?" if alike else f"there are {', '.join(names)}"
    return f"no level of {scene} is called {word} ({offered})"


def default_level(scene_type: type[Scene]) -> Level | None:
    """The scene's default level if it has one."""
    from game.levels import level_files

    files = [file for file in level_files(scene_type.name) if file.stem == "default"]
    return read_level(scene_type, str(files[0])) if files else None


def read_recording(word: str, scene_name: str = "") -> Recording:
    """A recording from its file, or from the text of a run, of that scene if one is named."""
    from game.stage import Recording, RecordingError
    from game.stage.records.run_text import looks_like_a_run, recording_in

    try:
        recording = recording_in(word) if looks_like_a_run(word) else Recording.load(word)
    except RecordingError as error:
        raise MistakeError(str(error)) from None
    if scene_name and recording.scene != scene_name:
        raise MistakeError(f"{word[:80]}: a recording of {recording.scene}, not of {scene_name}")
    return recording


def read_replay(options: argparse.Namespace, scene_name: str) -> Recording | None:
    """The recording that --replay names, if any; MistakeError beside an option that it says itself."""
    if options.replay is None:
        return None
    said = {
        "--set": options.parameters, "--level": options.level, "--effects-off": options.effects_off,
        "--seed": options.seed,
    }  # fmt: skip
    for option, value in said.items():
        if value:
            raise MistakeError(f"{option}: goes not with --replay; the recording says how it begins")
    return read_recording(options.replay, scene_name)


def refuse_beside_story(options: argparse.Namespace) -> None:
    """MistakeError for an option that a story says itself."""
    said = {
        "--set": options.parameters, "--level": options.level, "--effects-off": options.effects_off,
        "--seed": options.seed,
    }  # fmt: skip
    for option, value in said.items():
        if value:
            raise MistakeError(f"{option}: goes not with --story; the story says how it begins")


def read_seconds(text: str, name: str = "--seconds") -> float:
    """A time that is finite and not negative, s."""
    try:
        seconds = float(text)
    except ValueError:
        raise MistakeError(f"{name} {text}: expected a number") from None
    if not math.isfinite(seconds) or seconds < 0.0:
        raise MistakeError(f"{name} {text}: expected a finite number of seconds, 0 or more")
    return seconds


def steps_in(seconds: float, dt: float) -> int:
    """Whole steps in a time; MistakeError if they are absurdly many."""
    if seconds / dt > MOST_STEPS:
        raise MistakeError(f"--seconds {seconds:g}: that is more than {MOST_STEPS} steps of {dt:g} s")
    return round(seconds / dt)


def read_size(text: str) -> tuple[int, int]:
    """Width and height of a picture from ``1280x720``, px."""
    found = re.fullmatch(r"([0-9]{1,6})[xX×]([0-9]{1,6})", text.strip())
    if found is None:
        raise MistakeError(f"--size {text}: expected WIDTHxHEIGHT, such as 1280x720")
    width, height = int(found[1]), int(found[2])
    if not (1 <= width <= LARGEST_SIDE and 1 <= height <= LARGEST_SIDE and width * height <= MOST_PIXELS):
        raise MistakeError(
            f"--size {text}: expected sides of 1 to {LARGEST_SIDE} and at most {MOST_PIXELS} pixels"
        )
    return width, height


class Film(NamedTuple):
    """A film that is asked for: its file, size px, and pictures a second."""

    path: Path
    size: tuple[int, int]
    fps: int


def read_film(word: str, size: str, fps: str, option: str) -> Film:
    """What a film is to be, checked before anything long is begun."""
    from game.app.commands import output
    from game.app.film.video import VideoError, check_video

    output.check_writable(word, option)
    width, height = read_size(size)
    if width % 2 or height % 2 or min(width, height) < SMALLEST_FILM:
        raise MistakeError(f"--size {size}: expected even numbers, at least {SMALLEST_FILM}, for a film")
    if not re.fullmatch("[0-9]{1,9}", fps) or not 1 <= int(fps) <= MOST_FPS:
        raise MistakeError(f"--fps {fps}: expected a whole number from 1 to {MOST_FPS}")
    try:
        check_video(Path(word))
    except VideoError as error:
        raise MistakeError(f"{option} {error}") from None
    return Film(Path(word), (width, height), int(fps))
