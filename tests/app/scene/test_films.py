"""Films from the window: begun by key or button, made while play goes on, saved where it is told."""

from __future__ import annotations

import struct
import sys
import time
from pathlib import Path

import numpy as np
import pygame
import pytest

from game.app.scene.film import writers
from game.app.scene.film.again import FilmAgain
from game.stage.replays.rerun import Rerun
from tests.app.tests_app import Driver
from tests.stage.example_scene import KICK


@pytest.fixture
def said(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What messages have said."""
    lines: list[str] = []
    monkeypatch.setattr(driver.app, "tell", lambda *words: lines.append(" ".join(words[:2])))
    return lines


@pytest.fixture
def no_av(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine without PyAV."""
    monkeypatch.setitem(sys.modules, "av", None)


def choose(driver: Driver, key: int, title: str) -> None:
    """Open the card by its key and click a row."""
    driver.key(key)
    driver.frames(20)
    row = next(i for i, one in enumerate(driver.top.rows) if one.title == title)
    driver.click(*driver.top.spots.find(f"row-{row}").rect.center)
    driver.frames(20)


def film_of(driver: Driver, said: list[str]) -> Path:
    """Wait until the film is there; its path, as the message says it."""
    for _ in range(3000):
        driver.app.pictures.wait()
        driver.frames()
        told = next((line for line in said if line.startswith("Film saved ")), None)
        if told is not None:
            return Path(told.removeprefix("Film saved "))
    raise AssertionError(said)


def gif_times(path: Path) -> list[int]:
    """Delays of a GIF's pictures, in hundredths of a second."""
    data, times, at = path.read_bytes(), [], 0
    while (at := data.find(b"\x21\xf9\x04", at)) >= 0:
        times.append(struct.unpack("<H", data[at + 4 : at + 6])[0])
        at += 8
    return times


def test_a_film_is_begun_and_ended_by_the_key_and_lasts_as_long_as_what_it_shows(driver, said):
    driver.open("example")
    choose(driver, pygame.K_F9, "Film this, small")
    assert driver.top.play.films.words.startswith("Filming")
    before, film = driver.stage.step_number, driver.top.play.films.live
    begun = film.seconds
    for _ in range(120):
        while film.writer.full:  # on a slow machine, pictures would be shown longer
            time.sleep(0.001)
        driver.frames(1)
    assert driver.stage.step_number > before + 200  # play goes on
    assert film.seconds - begun == pytest.approx(2.0, abs=0.06)
    driver.key(pygame.K_F9)
    path = film_of(driver, said)
    assert path.parent == Path(driver.app.folder) / "pictures" and path.name.startswith("carom-example-")
    shown = pygame.image.load(str(path))
    place = driver.top.play.view.rect
    assert shown.get_width() / shown.get_height() == pytest.approx(place.w / place.h, rel=0.02)
    assert sum(gif_times(path)) / 100 == pytest.approx(film.seconds)


def test_the_button_of_the_bar_asks_as_well_and_is_lit_while_a_film_is_taken(driver, said):
    driver.open("example")
    spot = driver.top.shell.bar.spots.find("film")
    driver.click(*spot.rect.center)
    driver.frames(20)
    assert driver.top.rows[0].title == "Film this"
    driver.key(pygame.K_ESCAPE)
    driver.frames(30)
    driver.top.play.films.begin("this", "gif")
    driver.frames(5)
    assert driver.top.shell.bar.state.filming
    driver.click(*spot.rect.center)
    film_of(driver, said)
    driver.frames(5)
    assert not driver.top.shell.bar.state.filming


def test_the_last_seconds_are_gone_through_again_beside_the_play(driver, said):
    driver.open("example")
    driver.frames(200)
    driver.stage.post(KICK)
    driver.frames(200)
    choose(driver, pygame.K_F9, "Film the last ten seconds, small")
    film = driver.top.play.films.again
    assert film is not None
    step, digest = film.rerun.kept.last, film.rerun.kept.digest
    driver.frames(40)
    assert driver.stage.step_number > step + 60 and 0.0 < film.share < 1.0
    path = film_of(driver, said)
    assert film.rerun.same and film.rerun.step == step and film.rerun.scene is not driver.stage.scene
    assert digest == film.rerun.kept.digest
    assert sum(gif_times(path)) / 100 == pytest.approx(step / 120, abs=0.1)
    assert not [line for line in said if "differ" in line]


@pytest.mark.parametrize("speed", [0.25, 1.0, 2.0])
def test_its_pictures_are_even_in_time_whatever_the_speed(driver, tmp_path, speed):
    driver.open("example")
    driver.frames(120)
    rerun = Rerun(driver.stage.kept_from(40))
    writer = writers.make_writer("gif", tmp_path / "a.gif", (640, 400), False)
    film = FilmAgain(rerun, writer, speed, "dark", driver.top.play.view.camera)
    places = []
    while not film.finished:
        film.step()
        before, now = rerun.scene.previous.position[0], rerun.scene.ball.position[0]
        places.append(before + rerun.alpha * (now - before))
        film.draw()
    writer.drop()
    steps = np.diff(places[:-1])  # the ball goes 1 m/s to the right; the last picture is the present
    assert steps == pytest.approx(np.full(len(steps), speed / writers.GIF_HZ), rel=1e-6)
    assert len(places) == film.count and rerun.same


def test_the_play_is_the_same_with_a_film_and_without(start, tmp_path):
    digests = []
    for filmed in (False, True):
        driver = start()
        driver.open("example")
        driver.frames(100)
        if filmed:
            driver.top.play.films.begin("last", "gif")
        driver.frames(150)
        driver.app.perform("pause")
        digests.append((driver.stage.step_number, driver.stage.digest()))
    assert digests[0] == digests[1]


def test_with_mp4_the_film_has_the_rate_and_the_length(driver, said):
    av = pytest.importorskip("av")
    driver.open("example")
    driver.frames(120)
    choose(driver, pygame.K_F9, "Film the last ten seconds")
    path = film_of(driver, said)
    with av.open(str(path)) as film:
        stream = film.streams.video[0]
        assert stream.average_rate == 30 and (stream.width, stream.height) == (960, 512)
        count = sum(1 for _ in film.decode(stream))
    assert count == pytest.approx(122 / 60 * 30, abs=12)


def test_without_pyav_only_gif_is_offered_and_it_says_why(driver, said, no_av):
    driver.open("example")
    driver.frames(30)
    driver.key(pygame.K_F9)
    driver.frames(20)
    assert {row.chip for row in driver.top.rows} == {"gif"}
    assert any("PyAV" in row.about and "not installed" in row.about for row in driver.top.rows)
    driver.key(pygame.K_ESCAPE)
    driver.frames(30)
    driver.top.play.films.begin("last", "gif")
    assert film_of(driver, said).read_bytes()[:6] == b"GIF89a"


def test_a_film_that_is_under_way_when_the_scene_is_left_is_saved(driver, said):
    driver.open("example")
    driver.top.play.films.begin("this", "gif")
    driver.frames(60)
    driver.app.open_menu()
    assert film_of(driver, said).exists()


def test_nothing_to_go_through_and_no_place_are_told_in_a_line(driver, said, monkeypatch):
    driver.open("example")
    driver.stage.reset()
    driver.app.perform("pause")
    driver.stage.return_to(0)
    driver.top.play.films.begin("last", "gif")
    driver.frames(3)
    assert "No film. There is nothing yet: no step has been made." in said
    (Path(driver.app.folder)).mkdir(exist_ok=True)
    (Path(driver.app.folder) / "pictures").write_text("in the way")
    driver.top.play.films.begin("this", "gif")
    assert [line for line in said if line.startswith("No film.") and "pictures" in line]
    assert not driver.top.play.films.busy


def test_a_slow_encoder_is_not_waited_for(driver, said, monkeypatch):
    driver.open("example")
    monkeypatch.setattr(writers.Gif, "full", True)
    driver.top.play.films.begin("this", "gif")
    driver.frames(60)
    assert driver.top.play.films.live.pictures == 0
    monkeypatch.setattr(writers.Gif, "full", False)
    driver.frames(2)
    assert driver.top.play.films.live.pictures >= 19  # the one picture stands for all that came late
    driver.key(pygame.K_F9)
    film_of(driver, said)
