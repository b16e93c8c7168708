"""Stars that were won in puzzles, kept in one file of the user's folder: stars.toml.

A file that cannot be understood costs one line and no more: it is kept beside as stars.broken.toml.
"""

from __future__ import annotations

import contextlib
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import msgspec
import tomli_w

from game.files import FileProblem, read_text, write_text
from game.folders import user_folder

if TYPE_CHECKING:
    from game.stage import Stage

FILE_NAME = "stars.toml"
BROKEN_NAME = "stars.broken.toml"
LARGEST_BYTES = 1_000_000
HEAD = "# Carom. Stars won in puzzles, as LEVEL = [won, to be won].\n"

Count = Annotated[int, msgspec.Meta(ge=0, le=9)]
Table = dict[str, dict[str, tuple[Count, Count]]]


class Stars(NamedTuple):
    """Stars won in a level, and how many there are."""

    won: int
    most: int

    @property
    def words(self) -> str:
        """Full and empty stars."""
        return "★" * self.won + "☆" * max(self.most - self.won, 0)


def stars_path() -> Path:
    """The file."""
    return user_folder() / FILE_NAME


def kept_stars(scene_name: str) -> dict[str, Stars]:
    """Stars of a scene's levels, by the name of their file; none if there is no file or it is broken."""
    try:
        return {level: Stars(*pair) for level, pair in _read().get(scene_name, {}).items()}
    except ValueError:
        return {}


def keep_stars(scene_name: str, level: str, stars: Stars) -> str:
    """Keep what was won in a level unless more was won before. What there is to complain of, in a line."""
    complaint = ""
    try:
        table = _read()
    except ValueError as error:
        table, complaint = {}, f"{FILE_NAME}: {' '.join(str(error).split())}{_put_aside()}"
    levels = table.setdefault(scene_name, {})
    if level in levels and levels[level][0] >= stars.won:
        return complaint
    levels[level] = (stars.won, stars.most)
    try:
        write_text(stars_path(), HEAD + tomli_w.dumps(msgspec.to_builtins(table)))
    except FileProblem as error:
        return f"{FILE_NAME}: {error}"
    return complaint


class StarKeeper:
    """Keeps what is won in the scene that is played."""

    def __init__(self) -> None:
        self._seen: object = None

    def update(self, stage: Stage) -> str:
        """Keep stars that have just been won in a level. What there is to complain of, in a line."""
        won, level = stage.scene.stars, stage.level
        if (
            won is None
            or not won[0]
            or level is None
            or level.path is None
            or (level.path, won) == self._seen
        ):
            return ""
        self._seen = level.path, won
        return keep_stars(stage.scene.name, level.path.stem, Stars(*won))


def _read() -> Table:
    """Everything that is kept; ValueError if it cannot be understood."""
    if not stars_path().exists():
        return {}
    try:
        return msgspec.convert(tomllib.loads(read_text(stars_path(), LARGEST_BYTES)), Table)
    except RecursionError:
        raise ValueError("nested too deeply") from None


def _put_aside() -> str:
    """Rename a broken file so that nothing in it is lost."""
    with contextlib.suppress(OSError):
        stars_path().replace(stars_path().with_name(BROKEN_NAME))
        return f"; the file is kept as {BROKEN_NAME}"
    return ""
