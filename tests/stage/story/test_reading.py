"""A story's file: strict, and each mistake one line that names file, field and reason."""

from __future__ import annotations

from pathlib import Path

import pytest

from game.levels import LevelError
from game.stage import Stage
from game.stage.script.lines import Deed, Do, Expect, Follow, HandOver, Look, Moment, Say, Slow, Title
from game.stage.story.reading import parse_story, written_story
from game.stage.story.rehearsal import rehearse
from game.stage.story.runner import Runner
from tests.stage.story.bouncing import TEXT, StoryBall, story

LAST = '[[line]]\nhand_over = "Go."\n'
HEAD = 'scene = "story-ball"\ntitle = "T"\n'


def test_every_verb_is_read():
    kinds = [type(line) for line in story().lines]
    assert set(kinds) == {Title, Look, Follow, Do, Say, Moment, Slow, HandOver}
    assert story().level.parameters == {"height": 12.0}
    assert story().expectations[0] == Expect("bounces", least=5.0, at="five")


@pytest.mark.parametrize(
    ("body", "field", "reason"),
    [
        ('[[line]]\nsay = "a"\nlook = "whole"\n' + LAST, "line[0]", "two verbs"),
        ("[[line]]\nsay_ = 1\n" + LAST, "line[0]", "none of title"),
        ('[[line]]\nsay = "a"\ncolour = 1\n' + LAST, "line[0].colour", "unknown key"),
        ('[[line]]\nsay = "a {b"\n' + LAST, "line[0].say", "between braces"),
        ('[[line]]\nsay = "a"\nuntil = "x"\n' + LAST, "line[0].say", "no moment is called 'x'"),
        ('[[line]]\nsay = "a"\nat = "x"\n' + LAST, "line[0].at", "no moment is called 'x'"),
        ('[[line]]\nsay = "a"\n', "line[0]", "hand_over is the last line"),
        (LAST + LAST, "line[0]", "hand_over is the last line"),
        ("", "line", "at least a hand_over"),
        (
            '[[line]]\nmoment = "m"\nwhen = "bounces"\ndeadline = 1\n' + LAST,
            "line[0].moment",
            "expected READOUT",
        ),
        ('[[line]]\nmoment = "m"\nwhen = "bounces > 1"\n' + LAST, "line[0].deadline", "missing"),
        ('[[line]]\nmoment = "m"\nwhen = []\ndeadline = 1\n' + LAST, "line[0].moment", "1 to 8"),
        ("[[line]]\nslow = 0.01\n" + LAST, "line[0].slow", ">= 0.0625"),
        ('[[line]]\ndo = { action = "fly" }\n' + LAST, "line[0].do", "no such action"),
        ('[[line]]\ndo = { parameter = "gravity" }\n' + LAST, "line[0].do.value", "missing"),
        ('[[line]]\ndo = { parameter = "gravity", value = -1.0 }\n' + LAST, "line[0].do", "gravity"),
        ('[[line]]\ndo = { action = "kick", effect = "x" }\n' + LAST, "line[0].do", "expected one of"),
        ('[[line]]\ndo = { pointer = "drag", place = [0, 0] }\n' + LAST, "line[0].do.to", "leads to a place"),
        ('[[line]]\ndo = { pointer = "click" }\n' + LAST, "line[0].do.place", "missing"),
        (
            '[[line]]\ndo = { pointer = "down", place = [0, 0], to = [1, 0] }\n' + LAST,
            "line[0].do.to",
            "only a drag or a move",
        ),
        (
            '[[line]]\ndo = { pointer = "move", place = [0, 0], over = 1 }\n' + LAST,
            "line[0].do.over",
            "takes time",
        ),
        ('[[line]]\ndo = { action = "kick", over = 1 }\n' + LAST, "line[0].do.over", "takes time"),
        (LAST + '[[expect]]\nexpect = "height"\n', "expect[0]", "least, most or both"),
        (LAST + '[[expect]]\nexpect = "height"\nleast = 2\nmost = 1\n', "expect[0]", "above most"),
        (LAST + '[[expect]]\nexpect = "height"\nleast = nan\n', "expect[0]", "finite"),
        (LAST + '[[expect]]\nexpect = "height"\nleast = 2\nat = "x"\n', "expect[0]", "no moment"),
        (LAST + '[[expect]]\nexpect = "height"\nleast = 2\nat = 1\nby = 2\n', "expect[0]", "not both"),
    ],
)
def test_a_mistake_is_one_line_that_names_its_field(body, field, reason):
    with pytest.raises(LevelError) as found:
        parse_story(HEAD + body, StoryBall, Path("story-x.toml"))
    assert str(found.value).startswith(f"story-x.toml: {field}: ")
    assert reason in str(found.value) and "\n" not in str(found.value)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ('say = "{speed}"', "'speed' is no readout"),
        ('moment = "m"\nwhen = "speed > 1"\ndeadline = 1', "'speed' is no readout"),
        ('follow = "cat"', "'cat' is no place"),
        ('do = { pointer = "click", place = "cat" }', "'cat' is no place"),
    ],
)
def test_what_the_scene_does_not_have_is_named(line, reason):
    told = parse_story(f"{HEAD}[[line]]\n{line}\n{LAST}", StoryBall)
    with pytest.raises(LevelError, match=reason):
        Runner(told, Stage(StoryBall, level=told.level))


def test_python_and_file_are_one_reader():
    lines = (
        Look("whole", cut=True),
        Moment("three", when=("bounces > 2.5",), deadline=8.0),
        Do(Deed(parameter="restitution", value=0.4, over=1.0)),
        HandOver("Kick it.", seconds=3.0),
    )
    told = written_story("ball", StoryBall, lines, [Expect("height", most=99.0)], title="A ball")
    assert told.lines == lines
    with pytest.raises(LevelError, match=r"slow"):
        written_story("ball", StoryBall, [Slow(0.0), HandOver("x")], title="A ball")
    assert rehearse(told, StoryBall).failures == []


def test_a_story_without_a_title_is_refused():
    with pytest.raises(LevelError, match="title: missing"):
        parse_story(TEXT.replace('title = "A ball"\nabout', "about", 1), StoryBall)
