"""The picture of a story: the stage seen by its camera, its captions and cards over it."""

from __future__ import annotations

import math

import pygame

from game.app.stagehand.view import StageView
from game.stage.script.camera import View
from game.stage.script.course import Caption
from game.stage.script.lines import Say, Title
from game.stage.story.runner import Runner, last_words
from game.ui.charts.comparison import chart_rect, draw_comparison
from game.ui.look.look import Look
from game.ui.painters import story_words
from game.ui.painters.story_words import CARD_FADE_S, CardLine, opacity_at

CLEAR = 12  # design px that a caption keeps from what is followed


def point_camera(view: StageView, runner: Runner, shown_s: float) -> View:
    """Let the camera look where the story says at a moment of the film."""
    wanted = runner.view(shown_s)
    view.camera.show(wanted.frame(runner.turned))
    return wanted


def caption_at(runner: Runner, shown_s: float) -> Caption | None:
    """The caption that stands at a moment of the film."""
    for caption in reversed(runner.course.captions()):
        if caption.begins <= shown_s:
            return caption if shown_s < caption.ends else None
    return None


def draw_words(
    surface: pygame.Surface, look: Look, view: StageView, runner: Runner, shown_s: float, player: str = "",
    leaves: bool = False,
) -> None:  # fmt: skip
    """Caption or card of a moment of the film. ``player``: whose name the title card bears.

    ``leaves``: the end card goes when its time is up.
    """
    caption = caption_at(runner, shown_s)
    if caption is not None:
        opacity = opacity_at(shown_s, caption.begins, caption.ends)
        draw_chart(surface, look, view, runner, caption, opacity)
        above = _hides_target(look, view, runner, caption.text)
        story_words.draw_caption(surface, look, view.rect, caption.text, opacity, above)
    for number, begins, ends in runner.course.cards():
        stays = not leaves and number == len(runner.story.lines) - 1
        if begins <= shown_s and (shown_s < ends or stays):
            opacity = opacity_at(shown_s, begins, math.inf if stays else ends, CARD_FADE_S)
            rise = 16.0 * (1.0 - opacity)
            story_words.draw_card(surface, look, view.rect, _card(runner, number, player), opacity, rise)


def draw_chart(
    surface: pygame.Surface, look: Look, view: StageView, runner: Runner, caption: Caption, opacity: float
) -> None:
    """What a caption shows in a corner, measured over expected."""
    line = runner.story.lines[caption.line]
    if not isinstance(line, Say) or line.chart is None:
        return
    shown = runner.charts.comparison(caption.line)
    if shown is not None:
        draw_comparison(surface, look, chart_rect(look, view.rect, line.chart.corner), shown, opacity)


def _hides_target(look: Look, view: StageView, runner: Runner, text: str) -> bool:
    """Whether a caption at the foot would lie over what the camera follows."""
    target = runner.target()
    if target is None:
        return False
    place = story_words.caption_rect(look, view.rect, text).inflate(2 * look.px(CLEAR), 2 * look.px(CLEAR))
    return place.collidepoint(view.camera.to_screen(*target))


def _card(runner: Runner, number: int, player: str) -> list[CardLine]:
    """The lines of a title card or of the end card."""
    line, story = runner.story.lines[number], runner.story
    if isinstance(line, Title):
        lines: list[CardLine] = [(line.title, 44, "display-bold", "text1")]
        if line.line:
            lines.append((line.line, 19, "medium", "text2"))
        if player and number == runner.course.cards()[0][0]:
            lines.append((player, 20, "display", "accent"))
        return lines
    return [
        (story.title, 36, "display-bold", "text1"),
        (last_words(story), 19, "medium", "text2"),
        *([(player, 20, "display", "accent")] if player else []),
    ]
