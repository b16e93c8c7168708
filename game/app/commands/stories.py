"""``stories``: which scenes play themselves, how long, in which chapters."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output
from game.app.window.mistake import MistakeError
from game.app.window.words import say

if TYPE_CHECKING:
    from game.stage import Scene
    from game.stage.script.lines import Story
    from game.stage.story.rehearsal import Rehearsal


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("stories", help="list the stories that scenes play", allow_abbrev=False)
    parser.add_argument("scene", nargs="?", metavar="SCENE", help="only those of this scene")
    parser.add_argument("--json", metavar="FILE", help="write the list; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Print or write the list; what has not been rehearsed before is run once, headless."""
    output.check_writable(options.json, "--json")
    from game.app.stagehand.stories import rehearsal_of
    from game.levels import LevelError
    from game.scenes import CATALOGUE
    from game.stage.story.reading import stories_of

    names = [given.scene_type_named(options.scene).name] if options.scene else [one.name for one in CATALOGUE]
    rows = []
    for name in names:
        scene_type = CATALOGUE[name].load()
        try:
            for story in stories_of(scene_type):
                rows.append(describe(story, rehearsal_of(story, scene_type)))
                if options.json != output.STANDARD_OUTPUT:
                    _print(rows[-1])
        except LevelError as error:
            raise MistakeError(str(error)) from None
    if options.json:
        output.write_json({"stories": rows}, options.json)
    return 0


def describe(story: Story, found: Rehearsal) -> dict[str, Any]:
    """A story and what its rehearsal has found, for JSON."""
    return {
        "scene": story.scene,
        "name": story.name,
        "title": story.title,
        "about": story.level.about,
        "film_s": found.film_s,
        "simulated_s": found.time_s,
        "chapters": [{"title": one.chapter, "film_s": one.film_s} for one in found.chapters],
        "failures": found.failures,
    }


def _print(row: dict[str, Any]) -> None:
    say(f"{row['scene']:<16} {row['name']:<20} {_clock(row['film_s'])}  {row['title']}")
    for chapter in row["chapters"]:
        say(f"    {_clock(chapter['film_s'])}  {chapter['title']}")


def _clock(seconds: float) -> str:
    return f"{int(seconds) // 60}:{seconds % 60:04.1f}"


def at_quality(story: Story, scene_type: type[Scene], word: str | None) -> Story:
    """The story with the scene's parameter "quality" (such as play, teach, film) set; MistakeError."""
    import msgspec

    if word is None:
        return story
    value = given.read_parameters(scene_type, [f"quality={word}"])
    level = msgspec.structs.replace(story.level, parameters={**story.level.parameters, **value})
    return msgspec.structs.replace(story, level=level)


def named(scene_type: type[Scene], word: str) -> Story:
    """The story that ``--story`` names, or the first one; MistakeError."""
    from game.levels import LevelError
    from game.stage.story.reading import load_story, stories_of

    try:
        if word.endswith(".toml"):
            return load_story(word, scene_type)
        stories = stories_of(scene_type)
    except LevelError as error:
        raise MistakeError(str(error)) from None
    names = ", ".join(story.name for story in stories)
    if not stories:
        raise MistakeError(f"--story: {scene_type.name} has no story (see: stories)")
    found = [story for story in stories if story.name == word] if word else stories
    if not found:
        raise MistakeError(f"--story {word}: {scene_type.name} has no such story; it has {names}")
    return found[0]
