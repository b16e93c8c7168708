"""Rehearsals of stories, kept in the cache: the first headless run tells length and chapters."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from game.files import FileProblem, read_text, write_text
from game.folders import cache_folder
from game.stage.story.rehearsal import Rehearsal, rehearse

if TYPE_CHECKING:
    from game.stage import Scene
    from game.stage.script.lines import Story

LARGEST = 1 << 20  # bytes


def kept_at(story: Story) -> Path:
    """Where the rehearsal of a story is kept: by its words, and by the program that plays it."""
    return cache_folder() / "stories" / f"{story.scene}-{story.name}-{_digest(story)}.json"


def kept_rehearsal(story: Story) -> Rehearsal | None:
    """What an earlier rehearsal found; None if there was none, or if it cannot be read."""
    path = kept_at(story)
    try:
        return msgspec.json.decode(read_text(path, LARGEST), type=Rehearsal)
    except (FileProblem, msgspec.MsgspecError, ValueError):
        return None


def keep(story: Story, found: Rehearsal) -> None:
    """Keep what was found; a cache that cannot be written is no loss."""
    path = kept_at(story)
    with contextlib.suppress(FileProblem, OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        write_text(path, msgspec.json.encode(found).decode("utf-8"))


def rehearsal_of(
    story: Story, scene_type: type[Scene], progress: Callable[[float], object] | None = None
) -> Rehearsal:
    """What is kept of a story, or else a rehearsal now."""
    found = kept_rehearsal(story)
    if found is None:
        found = rehearse(story, scene_type, progress=progress)
        if found.ended:
            keep(story, found)
    return found


def _digest(story: Story) -> str:
    """Of all that a run depends on: the story's words, its level, and the sources of scene and physics."""
    from game.levels import format_level

    words = msgspec.json.encode([story.lines, story.expectations]).decode("utf-8")
    text = "\n".join((format_level(story.level), words, _sources()))
    return hashlib.blake2b(text.encode("utf-8"), digest_size=8).hexdigest()


def _sources() -> str:
    """Newest change and total size of the program's modules that a run goes through."""
    package = Path(__file__).resolve().parents[2]
    newest = total = 0
    for folder in ("physics", "billiards", "worlds", "scenes", "stage"):
        for path in (package / folder).rglob("*.py"):
            found = path.stat()
            newest, total = max(newest, found.st_mtime_ns), total + found.st_size
    return f"{newest} {total}"
