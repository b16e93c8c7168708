"""A story in the window: it plays, is taken over, gone on with, and goes to any moment of its time bar."""

from __future__ import annotations

import io
import itertools
import time

import pygame
import pytest

from game.app.scene.story import filming, journey
from game.stage import Pointer
from game.stage.catalogue import Catalogue, Entry
from game.stage.story.rehearsal import rehearse, stage_of
from game.stage.story.runner import Runner
from tests.stage.story.bouncing import StoryBall, story

STORIES = Catalogue(
    (
        Entry(
            "story-ball", "A00", "A ball", "one ball", "Stories", "tests.stage.story.bouncing", "StoryBall",
            roomy=True,
        ),
    )
)  # fmt: skip
StoryBall.task, StoryBall.title = "A00", "A ball"


@pytest.fixture
def told(start):
    """A program that plays the story; it has come 2.5 s far."""
    driver = start(catalogue=STORIES, volume=0.0)
    driver.open("story-ball")
    driver.frames(150)
    return driver


def play_of(driver):
    return driver.top.play.story


def story_stage():
    """The story headless, with its script."""
    stage = stage_of(story(), StoryBall)
    Runner(story(), stage)
    return stage


def middle(driver):
    return driver.top.shell.layout.free_stage.center


def wait(driver):
    """Until a jump has ended."""
    driver.top.play.record.errands.wait(600.0)
    driver.frames(2)


def test_a_scene_of_the_category_opens_with_its_story_playing(told):
    assert play_of(told).runner.playing and told.stage.step_number > 200
    assert play_of(told).bar.state.now_s == pytest.approx(play_of(told).runner.film_s, abs=0.05)


def test_it_is_the_same_as_headless(told):
    while not play_of(told).runner.finished:
        told.frames(10)
    found = rehearse(story(), StoryBall)
    told.stage.run(max(found.steps - told.stage.step_number, 0))
    other = rehearse(story(), StoryBall)
    assert [one.step for one in other.moments] == [
        one.step for one in play_of(told).runner.course.reached.values()
    ]


def test_a_hand_that_only_moves_is_no_touch(told):
    told.move(*middle(told))
    told.move(middle(told)[0] + 40, middle(told)[1])
    assert play_of(told).runner.playing
    assert not any(isinstance(e.event, Pointer) for e in told.stage.recording.events)


def test_the_first_touch_takes_over_from_that_very_state(told):
    before = told.stage.digest()
    told.stage.pause()
    told.button(True, *middle(told))
    runner = play_of(told).runner
    assert runner.stopped_at == told.stage.step_number and not runner.playing
    assert any(isinstance(e.event, Pointer) for e in told.stage.recording.events)
    assert told.stage.digest() != before  # the ball is in the hand
    told.button(False, *middle(told))
    lines = len(runner.course.begun)
    told.stage.resume()
    told.frames(300)
    assert len(runner.course.begun) == lines


def test_go_on_returns_to_the_script_from_the_last_chapter(told):
    told.frames(400)
    runner = play_of(told).runner
    chapter = max(one.step for one in runner.course.reached.values())
    told.key(pygame.K_F6)
    assert not runner.playing
    told.click(*middle(told))
    told.key(pygame.K_F6)
    wait(told)
    assert runner.playing and chapter <= told.stage.step_number <= chapter + 20
    while not runner.finished:
        told.frames(10)
    assert [one.step for one in runner.course.reached.values()] == [
        one.step for one in rehearse(story(), StoryBall).moments
    ]


def test_a_click_on_the_time_bar_goes_there_and_back(told):
    play = play_of(told)
    play.rehearsal.found = rehearse(story(), StoryBall)
    told.frames(2)
    track = play.bar.track
    x = track.x + round(track.w * 7.0 / play.rehearsal.found.film_s)
    told.click(x, track.centery)
    wait(told)
    assert play.runner.film_s == pytest.approx(7.0, abs=0.3) and play.runner.playing
    told.click(track.x + 1, track.centery)
    wait(told)
    assert play.runner.film_s < 0.3
    while not play.runner.finished:
        told.frames(10)
    assert [one.step for one in play.runner.course.reached.values()] == [
        one.step for one in play.rehearsal.found.moments
    ]


def jump_ahead(told, monkeypatch, film_s):
    """Click on a moment ahead; threads work, and each look of theirs is shown."""
    play = play_of(told)
    play.rehearsal.found = rehearse(story(), StoryBall)
    told.frames(2)
    told.top.play.record.errands.in_background = True
    monkeypatch.setattr(journey, "PICTURE_EVERY_S", 0.0)
    track = play.bar.track
    told.click(track.x + round(track.w * film_s / play.rehearsal.found.film_s), track.centery)
    return play


def frames_until(told, reached, most=5000):
    """Frames until something is so."""
    for _ in range(most):
        told.frames(1)
        if reached():
            return
        time.sleep(0.001)
    raise AssertionError("it has not come")


def test_a_jump_ahead_shows_pictures_on_the_way(told, monkeypatch):
    shown, play = [], play_of(told)
    draw_words = play.draw_words

    def see(surface):
        if play.journey.share is not None:
            picture = pygame.image.tobytes(surface.subsurface(play.view.rect), "RGB")
            shown.append((play.runner.film_s, play.bar.state.now_s, hash(picture)))
        draw_words(surface)

    monkeypatch.setattr(play, "draw_words", see)
    begun = play.runner.film_s
    jump_ahead(told, monkeypatch, 9.0)
    frames_until(told, lambda: play.journey.share is None)
    films, bars, _ = zip(*shown, strict=True)
    assert len(films) >= 30 and begun < films[0] and films[-1] < 9.1
    assert all(a < b for a, b in itertools.pairwise(films))
    assert all(abs(bar - film) < 0.1 for bar, film in zip(bars, films, strict=True))
    pictures = [picture for film_s, _, picture in shown if film_s > 3.0]  # before, the ball is not in sight
    assert len(pictures) > 30 and len(set(pictures)) > 0.9 * len(pictures)  # a ball also comes back
    here = play.runner.film_s
    assert here == pytest.approx(9.0, abs=0.3) and play.runner.playing
    headless = story_stage()
    headless.run(told.stage.step_number)
    assert told.stage.digest() == headless.digest()


@pytest.mark.parametrize("how", ["escape", "click"])
def test_escape_or_a_click_stops_a_jump_where_it_has_come(told, monkeypatch, how):
    begun = play_of(told).runner.film_s
    play = jump_ahead(told, monkeypatch, 11.0)
    frames_until(told, lambda: play.runner.film_s > begun + 1.0)
    if how == "escape":
        told.key(pygame.K_ESCAPE)
    else:
        told.click(*middle(told))
    frames_until(told, lambda: play.journey.share is None)
    assert begun + 1.0 < play.runner.film_s < 9.0
    assert play.runner.playing and play_of(told) is play  # neither taken over nor left
    here = play.runner.film_s
    told.frames(30)
    assert play.runner.film_s > here + 0.05


def test_a_scene_is_left_in_the_midst_of_a_jump(told, monkeypatch):
    play = jump_ahead(told, monkeypatch, 11.0)
    thread = told.top.play.record.errands._thread
    told.top.play.close()
    thread.join(600.0)
    assert not thread.is_alive() and play.runner.film_s < 11.0


def test_a_chapter_snaps(told):
    play = play_of(told)
    play.rehearsal.found = rehearse(story(), StoryBall)
    told.key(pygame.K_SPACE)
    track, begins = play.bar.track, play.rehearsal.found.chapters[1].film_s
    told.click(track.x + round(track.w * begins / play.rehearsal.found.film_s) + 6, track.centery)
    wait(told)
    assert told.stage.step_number == play.rehearsal.found.chapters[1].step


def test_steps_back_and_forth_keep_the_script(told):
    told.key(pygame.K_SPACE)
    step = told.stage.step_number
    for _ in range(5):
        told.key(pygame.K_COMMA)
    assert told.stage.step_number == step - 5 and play_of(told).runner.playing
    for _ in range(5):
        told.key(pygame.K_PERIOD)
    assert told.stage.step_number == step


def test_reset_begins_the_story_again(told):
    told.key(pygame.K_F6)
    told.key(pygame.K_BACKSPACE)
    wait(told)
    assert play_of(told).runner.playing and told.stage.step_number < 30


def test_the_camera_can_be_freed_and_given_back(told):
    play, view = play_of(told), told.top.play.view
    told.frames(60)
    told.wheel(3)
    told.frames(60)
    assert play.free and play.runner.playing
    here = view.camera.scale
    told.frames(30)
    assert view.camera.scale == pytest.approx(here, rel=1e-3)
    told.key(pygame.K_HOME)
    told.frames(2)
    assert not play.free
    wanted = play.runner.view(play.runner.shown_s)
    assert view.camera.center == (pytest.approx(wanted.x), pytest.approx(wanted.y))


def test_slow_motion_is_the_speed_of_the_stage(told):
    runner = play_of(told).runner
    while runner.course.speed == 1.0:
        told.frames(5)
    told.frames(1)
    assert told.stage.speed == 0.25
    told.key(pygame.K_F6)
    told.frames(1)
    assert told.stage.speed == 1.0


def test_the_picture_ends_above_the_time_bar(told):
    story = play_of(told)
    stage = pygame.Rect(10, 20, 800, 500)
    picture = story.picture_place(stage)
    assert stage.contains(picture) and not picture.colliderect(story.bar.rect)
    assert picture.bottom == story.bar.rect.top and picture.w == stage.w


def test_messages_stand_above_the_time_bar(told):
    row = told.top.message_row()
    assert row.h > 0 and not row.colliderect(play_of(told).bar.rect)


def test_marks_are_laid_over_by_a_key(told):
    view = told.top.play.view
    assert not view.teaching
    told.key(pygame.K_F7)
    assert view.teaching


def test_another_level_ends_the_story(told, tmp_path):
    path = tmp_path / "plain.toml"
    path.write_text('scene = "story-ball"\ntitle = "Plain"\n', encoding="utf-8")
    told.top.play.open_file(path)
    told.frames(3)
    assert play_of(told) is None and told.stage.cue is None


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (640, 400)])
def test_bar_and_words_lie_within_the_stage(start, size):
    driver = start(catalogue=STORIES, size=size, name="A name", volume=0.0)
    driver.open("story-ball")
    driver.frames(240)
    play, stage = play_of(driver), driver.top.shell.layout.free_stage
    assert stage.contains(play.bar.rect) and play.bar.rect.contains(play.bar.track)
    assert all(play.bar.rect.contains(spot.rect) for spot in play.bar.spots.spots)


def press(told, name):
    """Click a control of the bar."""
    told.click(*play_of(told).bar.controls.find(name).rect.center)
    told.frames(2)


def test_the_bar_stops_the_story_and_lets_it_go_on(told):
    press(told, "pause")
    assert told.stage.paused and play_of(told).runner.playing and play_of(told).bar.state.paused
    press(told, "pause")
    assert not told.stage.paused


def test_the_bar_sets_the_speed_beside_that_of_the_script(told):
    press(told, "story-speed")
    for key in (pygame.K_UP, pygame.K_UP, pygame.K_RETURN):  # from 1 to 1/4
        told.key(key)
    told.frames(30)
    story = play_of(told)
    assert told.stage.speed == 0.25 and story.bar.state.speed == "1/4×" and story.runner.playing
    while story.runner.course.speed == 1.0:
        told.frames(10)
    told.frames(2)
    assert told.stage.speed == 0.25 * story.runner.course.speed and story.bar.state.speed == "1/4×"


def test_a_chapter_is_gone_to_by_its_name(told):
    play = play_of(told)
    play.rehearsal.found = rehearse(story(), StoryBall)
    told.frames(2)
    press(told, "story-chapters")
    for key in (pygame.K_DOWN, pygame.K_RETURN):
        told.key(key)
    told.frames(30)
    wait(told)
    begins = dict(play.bar.state.chapters)["Three bounces"]
    assert begins <= play.runner.film_s < begins + 1.0


def test_the_bar_shows_a_small_picture_of_what_was_seen(told):
    story = play_of(told)
    track = story.bar.track
    told.move(track.x + round(track.w * 1.5 / story.bar.state.length_s), track.centery)
    told.frames(2)
    assert story.bar.state.picture is not None and story.bar.state.picture.get_size() == (240, 135)
    told.move(track.right - 2, track.centery)
    told.frames(2)
    assert story.bar.state.picture is None  # not seen yet


class Process:
    """Stands for the second process: what it was told, and how it ended."""

    def __init__(self, status=0, said=""):
        self.status, self.said, self.command = status, said, []

    def __call__(self, command, **_):
        self.command, self.returncode = command, None
        self.stderr = io.StringIO(self.said)
        return self

    def poll(self):
        return self.returncode


@pytest.mark.parametrize(
    ("status", "said", "told_so"), [(0, "", "Film saved"), (1, "carom: no room", "No film.")]
)
def test_the_story_is_filmed_by_another_process(told, monkeypatch, status, said, told_so):
    process, said_so = Process(status, said), []
    monkeypatch.setattr(told.app, "tell", lambda cause, *_: said_so.append(cause))
    monkeypatch.setattr(filming.subprocess, "Popen", process)
    now = play_of(told).runner.film_s
    told.key(pygame.K_F9)
    told.frames(2)
    told.key(pygame.K_DOWN)
    told.key(pygame.K_RETURN)
    told.frames(30)
    options = dict(itertools.pairwise(process.command))
    assert options["record"] == "story-ball" and options["--story"] == "story"
    assert options["--out"].endswith(".mp4") and options["--theme"] == "dark"
    assert float(options["--from"]) == 0.0 and float(options["--seconds"]) == pytest.approx(now, abs=0.5)
    assert play_of(told).filming.process is process
    process.returncode = status
    told.frames(2)
    assert play_of(told).filming.process is None
    assert said_so == ["Filming", told_so]
