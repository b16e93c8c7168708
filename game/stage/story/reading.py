"""Reading a story: a TOML file or a few lines of Python, checked by one reader, word by word.

A story's file is that of a level with lines and expectations below it:

    scene = "c04"
    title = "A fountain in the wind"
    about = "One line, shown on the title card."
    level = "foam-in-the-wind"            # a level of the scene to begin with; or [content] as in a level
    [parameters]
    wind = 0.0
    [what_if]
    say = "What if the wind were stronger?"
    at = "the wind rises"                 # a moment
    do = { parameter = "wind", value = 20.0 }
    [[line]]
    title = "A fountain in the wind"
    [[line]]
    do = { parameter = "wind", value = 8.0, over = 3.0 }
    [[line]]
    hand_over = "Drag the stone."
    [[expect]]
    expect = "dropped"
    most = 0.0

Whatever is wrong is answered by one LevelError: file, field, reason.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec

from game.files import FileProblem, read_text
from game.level_checks import LevelError, check_sizes, check_text, convert
from game.levels import MAX_BYTES, level_files, level_of, load_level, story_files
from game.stage.checks.validation import checked_event
from game.stage.parameters import ParameterError
from game.stage.scene import Scene
from game.stage.script.deeds import events_of
from game.stage.script.lines import (
    VERBS,
    WHOLE,
    Deed,
    Do,
    Expect,
    Follow,
    HandOver,
    Line,
    Look,
    Moment,
    Say,
    Story,
    WhatIf,
)  # fmt: skip
from game.stage.script.lines import StoryLine as AnyLine
from game.stage.script.readouts import named_in, parse_condition
from game.stage.story.charts import check_chart, readouts_of

MOST_LINES = 500
MOST_CONDITIONS = 8
PREFIX = "story-"  # of the file beside the scene's levels


def stories_of(scene_type: type[Scene]) -> list[Story]:
    """All stories of a scene: those of its class, then those in files, by name; LevelError."""
    own = [checked_story(story, scene_type) for story in scene_type.stories]
    return own + [load_story(path, scene_type) for path in story_files(scene_type.name)]


def load_story(path: Path | str, scene_type: type[Scene]) -> Story:
    """The story in a file; LevelError."""
    path = Path(path)
    try:
        text = read_text(path, MAX_BYTES)
    except FileProblem as problem:
        raise LevelError(path, "", str(problem)) from None
    return parse_story(text, scene_type, path)


def parse_story(text: str, scene_type: type[Scene], path: Path | None = None) -> Story:
    """The story that a text says; ``path`` is named in a LevelError and gives the story its name."""
    check_text(text, path)
    try:
        raw = tomllib.loads(text)
    except RecursionError:
        raise LevelError(path, "", "nested too deeply") from None
    except ValueError as error:
        raise LevelError(path, "", f"not TOML: {error}") from None
    check_sizes(raw, path)
    return _story(raw, path.stem.removeprefix(PREFIX) if path else "story", scene_type, path)


def written_story(
    name: str,
    scene_type: type[Scene],
    lines: Sequence[AnyLine],
    expectations: Sequence[Expect] = (),
    **level: Any,
) -> Story:
    """A story written in Python; ``level``: as in a file's head (title, about, level, seed, parameters ...).

    It goes through the reader of the files; LevelError.
    """
    raw = {"scene": scene_type.name, **level, "line": [_plain(line) for line in lines]}
    raw["expect"] = [_plain(one) for one in expectations]
    return _story(raw, name, scene_type, None)


def checked_story(story: Story, scene_type: type[Scene]) -> Story:
    """A story that was put together in Python, its lines read once more; LevelError."""
    _check_lines(story.lines, scene_type, Path(story.name))
    return story


def _plain(line: msgspec.Struct) -> dict[str, Any]:
    return {key: value for key, value in msgspec.to_builtins(line).items() if value is not None}


def _story(raw: dict[str, Any], name: str, scene_type: type[Scene], path: Path | None) -> Story:
    head = {key: value for key, value in raw.items() if key not in ("line", "expect", "level", "what_if")}
    level = level_of(head, scene_type.name, scene_type.content_type, path)
    if not level.title:
        raise LevelError(path, "title", "missing")
    if "level" in raw:
        level = _on_level(level, raw, scene_type, path)
    lines = tuple(_line(one, f"line[{i}]", path) for i, one in enumerate(_tables(raw, "line", path)))
    expectations = tuple(
        convert(one, Expect, path, f"expect[{i}]") for i, one in enumerate(_tables(raw, "expect", path))
    )
    _check_lines(lines, scene_type, path)
    _check_expectations(expectations, lines, path)
    what_if = convert(raw["what_if"], WhatIf, path, "what_if") if "what_if" in raw else None
    if what_if is not None:
        _check_what_if(what_if, lines, scene_type, path)
    return Story(name=name, level=level, lines=lines, expectations=expectations, what_if=what_if)


def _tables(raw: dict[str, Any], key: str, path: Path | None) -> list[Any]:
    found = raw.get(key, [])
    if not isinstance(found, list) or not all(isinstance(one, dict) for one in found):
        raise LevelError(path, key, f"expected tables, each under [[{key}]]")
    if len(found) > MOST_LINES:
        raise LevelError(path, key, f"more than {MOST_LINES}")
    return found


def _on_level(level: Any, raw: dict[str, Any], scene_type: type[Scene], path: Path | None) -> Any:
    """The level that a story names, with the story's own words and parameters."""
    files = {file.stem: file for file in level_files(scene_type.name)}
    name = raw["level"]
    if not isinstance(name, str) or name not in files:
        raise LevelError(path, "level", f"{name!r} is no level of {scene_type.name}")
    if level.content is not None:
        raise LevelError(path, "content", f"is said by the level {name!r}")
    base = load_level(files[name], scene_type.name, scene_type.content_type)
    off = tuple(dict.fromkeys((*base.effects_off, *level.effects_off)))
    return msgspec.structs.replace(
        level,
        content=base.content,
        parameters={**base.parameters, **level.parameters},
        effects_off=off,
        seed=level.seed if "seed" in raw else base.seed,
    )


def _line(raw: dict[str, Any], field: str, path: Path | None) -> AnyLine:
    verbs = [verb for verb in VERBS if verb in raw]
    if len(verbs) != 1:
        said = f"has two verbs, {verbs[0]} and {verbs[1]}" if verbs else f"has none of {', '.join(VERBS)}"
        raise LevelError(path, field, said)
    line: AnyLine = convert(raw, VERBS[verbs[0]], path, field)
    return line


def _check_lines(lines: Sequence[AnyLine], scene_type: type[Scene], path: Path | None) -> None:
    """What no single line can know: names, order, and what the scene takes."""
    moments = [line.moment for line in lines if isinstance(line, Moment)]
    for i, line in enumerate(lines):
        field = f"line[{i}]"
        if isinstance(line, HandOver) != (i == len(lines) - 1):
            raise LevelError(path, field, "hand_over is the last line, and no other")
        if line.at and line.at not in moments:
            raise LevelError(path, f"{field}.at", f"no moment is called {line.at!r}")
        if isinstance(line, HandOver) and line.at:
            raise LevelError(path, f"{field}.at", "the last line waits for the one before")
        if isinstance(line, Moment) and moments.count(line.moment) > 1:
            raise LevelError(path, f"{field}.moment", f"two moments are called {line.moment!r}")
        try:
            _check_words(line, moments)
        except ValueError as error:
            raise LevelError(path, f"{field}.{_verb(line)}", str(error)) from None
        if isinstance(line, Do):
            _check_deed(line.do, scene_type, path, f"{field}.do")
    if not lines:
        raise LevelError(path, "line", "a story has at least a hand_over")


def _check_words(line: AnyLine, moments: Sequence[str]) -> None:
    if isinstance(line, Say):
        named_in(line.say)
        if line.until and line.until not in moments:
            raise ValueError(f"until: no moment is called {line.until!r}")
        if line.chart is not None:
            check_chart(line.chart, moments)
    elif isinstance(line, Moment):
        if not 1 <= len(line.conditions) <= MOST_CONDITIONS:
            raise ValueError(f"when: expected 1 to {MOST_CONDITIONS} conditions")
        for words in line.conditions:
            parse_condition(words)


def _check_what_if(
    what_if: WhatIf, lines: Sequence[AnyLine], scene_type: type[Scene], path: Path | None
) -> None:
    if what_if.at and what_if.at not in [line.moment for line in lines if isinstance(line, Moment)]:
        raise LevelError(path, "what_if.at", f"no moment is called {what_if.at!r}")
    if what_if.do.over or isinstance(what_if.do.place, str) or isinstance(what_if.do.to, str):
        raise LevelError(path, "what_if.do", "expected something done at once, at a place in metres")
    _check_deed(what_if.do, scene_type, path, "what_if.do")


def _check_deed(deed: Deed, scene_type: type[Scene], path: Path | None, field: str) -> None:
    said = [name for name in ("action", "parameter", "effect", "pointer") if getattr(deed, name)]
    if len(said) != 1:
        raise LevelError(path, field, "expected one of action, parameter, effect, pointer")
    if deed.pointer and deed.place is None:
        raise LevelError(path, f"{field}.place", "missing")
    if deed.to is not None and deed.pointer not in ("drag", "move"):
        raise LevelError(path, f"{field}.to", "only a drag or a move leads to a place")
    if deed.to is None and deed.pointer == "drag":
        raise LevelError(path, f"{field}.to", "a drag leads to a place")
    if deed.parameter and deed.value is None:
        raise LevelError(path, f"{field}.value", "missing")
    if deed.over and not (deed.parameter or deed.to is not None):
        raise LevelError(path, f"{field}.over", "only a parameter, a drag or a move to a place takes time")
    if deed.over and deed.parameter and (isinstance(deed.value, (bool, str))):
        raise LevelError(path, f"{field}.over", "only a number takes time")
    try:
        for event in events_of(deed, (0.0, 0.0), (0.0, 0.0)):
            checked_event(event, scene_type)
    except ParameterError as error:
        raise LevelError(path, field, str(error)) from None


def _check_expectations(expectations: Sequence[Expect], lines: Sequence[AnyLine], path: Path | None) -> None:
    moments = [line.moment for line in lines if isinstance(line, Moment)]
    for i, one in enumerate(expectations):
        field = f"expect[{i}]"
        low, high = one.least, one.most
        if low is None and high is None:
            raise LevelError(path, field, "expected least, most or both")
        if any(number is not None and not math.isfinite(number) for number in (low, high)):
            raise LevelError(path, field, "expected finite numbers")
        if low is not None and high is not None and low > high:
            raise LevelError(path, field, f"least {low:g} is above most {high:g}")
        if one.at is not None and one.by is not None:
            raise LevelError(path, field, "expected at or by, not both")
        when = one.by if one.at is None else one.at
        if isinstance(when, str) and when not in moments:
            raise LevelError(path, field, f"no moment is called {when!r}")


def check_names(story: Story, scene: Scene) -> None:
    """LevelError for a readout or a target that the scene does not have; ``scene``: as the story begins."""
    path = story.level.path
    readouts = [readout.name for readout in scene.readouts()]
    readouts += [name for strip in scene.strips for name in strip.sometimes]
    targets, charts = {*scene.story_targets(), WHOLE}, sorted(scene.story_charts())
    for i, line in enumerate(story.lines):
        chart = line.chart if isinstance(line, Say) else None
        if chart is not None and chart.shows and chart.shows not in charts:
            raise _unknown(path, f"line[{i}].chart", "chart", chart.shows, charts)
        for name in _readouts_in(line):
            if name not in readouts:
                raise _unknown(path, f"line[{i}]", "readout", name, readouts)
        for name in _targets_in(line):
            if name not in targets:
                raise _unknown(path, f"line[{i}]", "place", name, sorted(targets))
    for i, one in enumerate(story.expectations):
        if one.expect not in readouts:
            raise _unknown(path, f"expect[{i}]", "readout", one.expect, readouts)


def _unknown(path: Path | None, field: str, kind: str, name: str, known: Sequence[str]) -> LevelError:
    return LevelError(path, field, f"{name!r} is no {kind} of this scene; there are {', '.join(known)}")


def _readouts_in(line: Line) -> list[str]:
    if isinstance(line, Say):
        return [*named_in(line.say), *readouts_of(line.chart)]
    return [parse_condition(w).readout for w in line.conditions] if isinstance(line, Moment) else []


def _targets_in(line: Line) -> list[str]:
    if isinstance(line, Follow):
        return [line.follow]
    if isinstance(line, Moment):
        return [line.subject] if line.subject else []
    places = [line.look] if isinstance(line, Look) else []
    if isinstance(line, Do):
        places += [place for place in (line.do.place, line.do.to) if place is not None]
    return [place for place in places if isinstance(place, str)]


def _verb(line: AnyLine) -> str:
    return next(verb for verb, kind in VERBS.items() if type(line) is kind)
