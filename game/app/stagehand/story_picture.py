"""The picture of a story: the stage seen by its camera, its captions and cards over it."""

from __future__ import annotations

import math

import pygame

from game.app.stagehand.view import StageView
from game.stage.script.camera import MIDDLE, View
from game.stage.script.course import Caption
from game.stage.script.lines import Say, Title
from game.stage.story.runner import Runner, last_words
from game.ui.charts.comparison import chart_rect, draw_comparison
from game.ui.look.look import Look
from game.ui.painters import story_words
from game.ui.painters.story_words import CARD_FADE_S, CardLine, opacity_at

CLEAR = 12  # design px that a caption keeps from what is followed
MOST_UNDER = 0.1  # of what is to be seen: so much may lie under words
LEAST_SHARE = 0.05  # of the picture's height: what is smaller is not seen


def point_camera(view: StageView, runner: Runner, shown_s: float) -> View:
    """Let the camera look where the story says at a moment of the film, and name what its caption names."""
    wanted = runner.view(shown_s)
    caption = caption_at(runner, shown_s)
    line = runner.story.lines[caption.line] if caption is not None else None
    view.named = isinstance(line, Say) and line.names
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
        above = _stands_above(look, view, runner, caption)
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


def _stands_above(look: Look, view: StageView, runner: Runner, caption: Caption) -> bool:
    """Whether a caption stands at the head: the script says so, or it hides less there than at the foot."""
    line = runner.story.lines[caption.line]
    if isinstance(line, Say) and line.above:
        return True
    foot, head = (_hidden_by(look, view, runner, caption.text, above) for above in (False, True))
    return head < foot


def _hidden_by(look: Look, view: StageView, runner: Runner, text: str, above: bool) -> int:
    """px² that a caption, with the space it keeps, hides of what is to be seen and of what is followed."""
    places = [subject_rect(view, runner)]
    target = runner.target()
    if target is not None:
        places.append(pygame.Rect(view.camera.to_screen(*target), (1, 1)))
    clear = 2 * look.px(CLEAR)
    words = story_words.caption_rect(look, view.rect, text, above).inflate(clear, clear)
    shared = [words.clip(place) for place in places if place is not None]
    return sum(rect.w * rect.h for rect in shared)


def subject_rect(view: StageView, runner: Runner) -> pygame.Rect | None:
    """Where the subject of the moment that came last lies, px; None if it has none."""
    scene, name = runner.stage.scene, runner.subject()
    place = scene.story_targets().get(name)
    if not name or place is None:
        return None
    side = max(round(scene.story_sizes().get(name, 0.0) * view.camera.scale), 1)
    rect = pygame.Rect(0, 0, side, side)
    x, y = view.camera.to_screen(*place)
    rect.center = round(x), round(y)
    return rect


def hidden(look: Look, view: StageView, runner: Runner, shown_s: float) -> list[str]:
    """What keeps the subject of the moment that came last from being seen well, in words.

    It is to be in the middle 60 % of the picture, under no words and no chart. If the scene says how large
    it is, that is at least a twentieth of the picture's height.
    """
    subject, name, picture = subject_rect(view, runner), runner.subject(), view.rect
    if subject is None:
        return []
    found = []
    if abs(subject.centerx - picture.centerx) > MIDDLE * picture.w + 1:
        found.append(f"{name} is too far to the side")
    if abs(subject.centery - picture.centery) > MIDDLE * picture.h + 1:
        found.append(f"{name} is too high or too low")
    if name in runner.stage.scene.story_sizes() and subject.h < LEAST_SHARE * picture.h:
        found.append(f"{name} is {subject.h / picture.h:.3f} of the picture's height")
    return found + covered(look, view, runner, shown_s)


def covered(look: Look, view: StageView, runner: Runner, shown_s: float) -> list[str]:
    """Which words and which chart lie over the subject of the moment that came last.

    Words may lie over a tenth of what is seen of it, and not over its middle; a chart over no part of it.
    """
    subject, caption, name = subject_rect(view, runner), caption_at(runner, shown_s), runner.subject()
    if subject is None or caption is None:
        return []
    found, seen, picture = [], subject.clip(view.rect), view.rect
    above = _stands_above(look, view, runner, caption)
    words = story_words.caption_rect(look, picture, caption.text, above)
    under = words.clip(seen)
    if words.collidepoint(subject.center) or under.w * under.h > MOST_UNDER * seen.w * seen.h:
        found.append(f"{name} is under the words {caption.text!r}")
    line = runner.story.lines[caption.line]
    chart = line.chart if isinstance(line, Say) else None
    if chart is not None and chart_rect(look, picture, chart.corner).colliderect(subject):
        found.append(f"{name} is under the chart of {caption.text!r}")
    return found


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
