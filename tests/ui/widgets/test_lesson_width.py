"""How much of a stage a lesson takes: all of it from a width on, its edge below that, never above half."""

import pygame
import pytest

from game.teaching import NumberQuestion, Teaching
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.widgets.lesson import FOLDED, UNFOLDED_FROM, WIDTH, LessonSheet


@pytest.fixture(params=[1.0, 2.0])
def look(request):
    return Look(DARK, request.param)


def sheet(look):
    made = LessonSheet(look)
    made.show(Teaching(task="Look."))
    return made


def stage(width):
    return pygame.Rect(0, 0, width, 600)


def test_it_unfolds_at_its_width_and_not_a_pixel_before(look):
    lesson, least = sheet(look), look.px(UNFOLDED_FROM)
    assert lesson.width_in(stage(least), look) == look.px(WIDTH)
    assert lesson.width_in(stage(least - 1), look) == look.px(FOLDED)


def test_what_the_person_chose_holds_at_any_width(look):
    lesson, least = sheet(look), look.px(UNFOLDED_FROM)
    lesson.folded = True
    assert lesson.width_in(stage(3 * least), look) == look.px(FOLDED)
    lesson.folded = False
    assert lesson.width_in(stage(least - 1), look) == look.px(WIDTH)
    assert lesson.width_in(stage(look.px(WIDTH)), look) == look.px(WIDTH) // 2


def test_without_a_task_it_takes_nothing(look):
    lesson = sheet(look)
    lesson.show(None)
    assert lesson.width_in(stage(2000), look) == 0


def test_it_is_folded_up_to_its_edges_width(look):
    lesson = sheet(look)
    for width, folded in ((look.px(FOLDED), True), (look.px(FOLDED) + 1, False)):
        lesson.place(pygame.Rect(0, 0, width, 400), look)
        assert lesson.is_folded == folded


def test_a_press_elsewhere_ends_the_typing_and_one_on_the_field_begins_it(look):
    lesson = LessonSheet(look)
    lesson.show(Teaching(task="Look.", questions=[NumberQuestion(ask="How many?", value=3.0)]))
    lesson.place(pygame.Rect(100, 0, look.px(WIDTH), 600), look)
    lesson.draw(pygame.Surface((1200, 600)))
    spot = next(spot.rect for spot in lesson.spots.spots if spot.name == "field-0")
    for at, typing in ((spot.center, True), ((50, 300), False), (spot.center, True)):
        for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            lesson.handle(pygame.Event(kind, pos=at, button=1))
        assert lesson.typing == typing
