"""How a story begins and ends for the viewer: its own tour, the next one, and what if."""

from __future__ import annotations

import pygame
import pytest

from game.app.scene.screen import TOUR_AFTER_S
from game.app.scene.story.offers import AGAIN, NEXT, WHAT_IF, Offers
from game.app.scene.tour import STORY_STOPS, TourScreen
from game.app.window.settings import load_settings
from game.stage import SetParameter
from game.stage.catalogue import Catalogue, Entry
from game.stage.story.reading import parse_story
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.app.tests_app import Driver, example_entry
from tests.stage.story.bouncing import TEXT, StoryBall

WHAT = (
    '[what_if]\nsay = "What if it were lighter?"\nat = "three"\ndo = { parameter = "gravity", value = 2.0 }\n'
)
LIGHTER = parse_story(TEXT.replace("[[line]]", f"{WHAT}[[line]]", 1), StoryBall)
BALL = Entry(
    "story-ball",
    "A00",
    "A ball",
    "one ball",
    "Stories",
    "tests.stage.story.bouncing",
    "StoryBall",
    roomy=True,
)
STORIES = Catalogue((BALL, example_entry("example")._replace(category="Stories", title="Another")))
StoryBall.task, StoryBall.title = "A00", "A ball"


@pytest.fixture
def told(start, monkeypatch) -> Driver:
    """A program that plays the story, which says what if."""
    monkeypatch.setattr(StoryBall, "stories", (LIGHTER,))
    driver = start(catalogue=STORIES, volume=0.0)
    driver.open("story-ball")
    return driver


@pytest.fixture
def ended(told: Driver) -> Driver:
    """Its end card stands."""
    while not play_of(told).runner.course.handed_over:
        told.frames(10)
    told.frames(3)
    return told


def play_of(driver):
    return driver.top.play.story


def press(driver, name):
    driver.click(*play_of(driver).offers.spots.find(name).rect.center)


def test_the_end_offers_the_next_story_what_if_and_once_more(ended: Driver):
    offers = play_of(ended).offers
    assert [spot.name for spot in offers.spots.spots] == [NEXT, WHAT_IF, AGAIN]
    assert [spot.tip for spot in offers.spots.spots] == [
        "Next: Another",
        "What if it were lighter?",
        "Once more",
    ]
    place = ended.top.play.view.rect
    assert all(place.contains(spot.rect) for spot in offers.spots.spots)


def test_nothing_is_offered_before_the_end(told: Driver):
    told.frames(60)
    assert not play_of(told).offers.spots.spots
    told.click(*told.top.play.view.rect.center)  # which takes over
    while play_of(told).runner.film_s < 20.0:
        told.frames(60)
    assert not play_of(told).offers.spots.spots


def test_the_next_story_is_opened(ended: Driver, monkeypatch):
    opened = []
    monkeypatch.setattr(ended.app, "open_scene", lambda name, opening: opened.append((name, opening.story)))
    press(ended, NEXT)
    assert opened == [("example", "")]  # as a story, its only one


def test_what_if_goes_back_changes_one_thing_and_plays_on(ended: Driver):
    runner = play_of(ended).runner
    three = runner.course.reached["three"].step
    lines = [number for number, entry in runner.course.begun.items() if entry.step <= three]
    press(ended, WHAT_IF)
    ended.top.play.record.errands.wait(600.0)
    ended.frames(2)
    stage = ended.stage
    assert three <= stage.step_number <= three + 30 and runner.stopped_at == three
    assert stage.scene.values["gravity"] == 2.0
    assert SetParameter("gravity", 2.0) in [one.event for one in stage.recording.events]
    ended.frames(120)
    assert stage.step_number > three + 60 and sorted(runner.course.begun) == sorted(lines)
    assert not play_of(ended).offers.spots.spots  # and the story can be gone on with
    ended.key(pygame.K_F6)
    ended.top.play.record.errands.wait(600.0)
    ended.frames(2)
    assert runner.playing and stage.scene.values["gravity"] != 2.0


def test_once_more_begins_again(ended: Driver):
    press(ended, AGAIN)
    ended.top.play.record.errands.wait(600.0)
    ended.frames(2)
    assert play_of(ended).runner.film_s < 1.0 and play_of(ended).runner.playing


def test_a_touch_of_the_scene_takes_the_offers_away(ended: Driver):
    place = ended.top.play.view.rect
    ended.move(place.centerx, place.y + 60)
    ended.frames(2)
    assert play_of(ended).offers.spots.spots  # a hand that only moves is no touch
    ended.click(place.centerx, place.y + 60)
    ended.frames(2)
    assert not play_of(ended).offers.spots.spots


@pytest.mark.parametrize("width", [300, 700, 1280])
def test_offers_lie_within_the_picture_and_apart(width):
    offers = Offers(
        Look(DARK, 1.0), ((NEXT, "Next: Great fireworks"), (WHAT_IF, "What if it stormed?"), (AGAIN, "On"))
    )
    rect = pygame.Rect(0, 0, width, 500)
    offers.place(rect, offers.look)
    offers.show(True)
    places = [spot.rect for spot in offers.spots.spots]
    assert len(places) == 3 and all(rect.contains(place) for place in places)
    assert not any(a.colliderect(b) for i, a in enumerate(places) for b in places[i + 1 :])


# -- the tour --------------------------------------------------------------------------------------


def test_the_first_story_explains_its_bar_and_not_the_ordinary_window(told: Driver):
    told.app.story_tour_due = told.app.tour_due = True
    told.frames(int(60 * TOUR_AFTER_S) + 2)
    assert isinstance(told.top, TourScreen)
    assert [stop.title for stop in told.top.stops] == [stop.title for stop in STORY_STOPS]
    settings = load_settings(told.app.folder).settings
    assert settings.story_toured and not settings.toured and told.app.tour_due
    bar = told.app.screens._screens[-2].play.story.bar
    for stop in told.top.stops:
        if stop.part:
            assert bar.rect.contains(told.top._place(told.top._layout(), stop.part))
            assert not told.top.card.colliderect(bar.rect)
        told.key(pygame.K_RETURN)
    assert not isinstance(told.top, TourScreen)


# -- what lies over the picture ---------------------------------------------------------------------


def test_the_legend_leaves_the_way_back_free(told: Driver, monkeypatch):
    monkeypatch.setattr(StoryBall, "legend", lambda self: [("disc:amber", "the ball", "")])
    told.key(pygame.K_F7)
    told.frames(3)
    shell = told.top.shell
    assert shell.legend.rect.w > 0 and not shell.legend.rect.colliderect(shell.layout.top_bar)


def test_work_is_not_told_of_over_the_bar(told: Driver):
    seen = []
    told.top.play.picture.standstill.tell = lambda surface, look, stage, seconds: seen.append(stage)
    told.frames(2)
    assert seen and not any(rect.colliderect(play_of(told).bar.rect) for rect in seen)
    seen.clear()
    play_of(told).journey.share = 0.5
    told.top.play.draw(pygame.Surface((1280, 720), 0, 32))
    assert seen == []


def test_stories_follow_one_another_as_in_the_menu():
    assert STORIES.after_in_category("story-ball", "Stories").name == "example"
    assert STORIES.after_in_category("example", "Stories").name == "story-ball"
    assert STORIES.after_in_category("none", "Stories").name == "story-ball"
    assert Catalogue((BALL,)).after_in_category("story-ball", "Stories") is None
