"""What a moment is about is seen: where it lies in the picture, how large, and under which words."""

from __future__ import annotations

import pygame
import pytest

from game.app.stagehand import story_picture
from game.app.stagehand.headless import prepare
from game.app.stagehand.story_picture import hidden, point_camera
from game.app.stagehand.view import StageView
from game.stage.story.rehearsal import stage_of
from game.stage.story.runner import Runner
from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from tests.stage.story.bouncing import StoryBall, story

SIZE = 0.4  # m
LOOK = Look(theme_named("dark"), 0.5)


class SizedBall(StoryBall):
    """It says how large its ball is."""

    def story_sizes(self):
        return {"ball": SIZE}


def seen(camera: str, chart: str = "") -> list[str]:
    """What hides a ball that has just begun to fall from 12 m; camera: of the look before it."""
    prepare()
    told = story(
        'scene = "story-ball"\ntitle = "A ball"\n[parameters]\nheight = 12.0\n'
        f"[[line]]\nlook = {camera}\ncut = true\n"
        '[[line]]\nmoment = "it falls"\nwhen = "height < 11.9"\ndeadline = 3.0\nsubject = "ball"\n'
        f'[[line]]\nsay = "It is {{height}} up, and falls."\n{chart}\n[[line]]\nhand_over = "Go."\n'
    )
    stage = stage_of(told, SizedBall)
    runner, view = Runner(told, stage), StageView(stage, LOOK)
    view.place(pygame.Rect(0, 0, 640, 360), LOOK)
    while "it falls" not in runner.course.reached:
        stage.run(1)
    stage.run(1)
    point_camera(view, runner, runner.shown_s)
    return hidden(LOOK, view, runner, runner.shown_s)


def test_a_ball_in_the_middle_is_seen():
    assert seen("[0.0, 12.0]\nwidth = 8.0") == []


@pytest.mark.parametrize(
    ("camera", "why"),
    [
        ("[5.0, 12.0]\nwidth = 12.0", "ball is too far to the side"),
        ("[0.0, 14.2]\nwidth = 12.0", "ball is too high or too low"),
        ("[0.0, 12.0]\nwidth = 16.0", "ball is 0.044 of the picture's height"),
    ],
)
def test_a_ball_elsewhere_or_too_small_is_not(camera: str, why: str):
    assert seen(camera) == [why]


def test_words_keep_out_of_the_way_and_are_found_where_they_do_not(monkeypatch):
    """Where a caption at the foot would lie over the ball it goes above; moved there, it is found."""
    camera = "[0.0, 14.65]\nwidth = 12.0"
    assert not any("under" in words for words in seen(camera))
    monkeypatch.setattr(story_picture, "_hidden_by", lambda *arguments: 0)
    assert any(words.startswith("ball is under the words 'It is ") for words in seen(camera))


def test_words_stand_at_the_head_where_the_script_says_so():
    """There they lie over what is high in the picture, and that is found; at the foot they do not."""
    camera = "[0.0, 9.15]\nwidth = 12.0"
    assert not any("under" in words for words in seen(camera))
    assert any(words.startswith("ball is under the words 'It is ") for words in seen(camera, "above = true"))


def test_a_chart_over_it_is_found():
    chart = 'chart = { measured = "height", expected = 3 }'
    camera = "[-4.6, 9.8]\nwidth = 12.0"
    assert not any("chart" in words for words in seen(camera))
    assert any("under the chart" in words for words in seen(camera, chart))
