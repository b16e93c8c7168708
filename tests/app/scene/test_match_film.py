"""The film of a match: one click at the end of a rack, its deciding strokes, and a line without PyAV."""

from __future__ import annotations

import sys
from pathlib import Path

import msgspec
import pygame
import pytest

from game.app.scene.film.strokes import FilmOfStrokes
from game.app.stagehand.opening import Opening
from game.billiards.game.rules import Call
from game.levels import level_files
from game.scenes import CATALOGUE
from game.scenes.billiards.layout import button_box
from game.scenes.billiards.opponents.thinking import decision_of
from game.stage import Stage
from tests.app.tests_app import Driver
from tests.scenes.billiards.billiards_stages import AT_THE_CORNER, aim, open_level, straight_pot

LONGEST_S = 300.0


class Kept:
    """A writer that keeps what it is given."""

    path, size, rate, share, full = Path("film.mp4"), (320, 180), 10, 0.0, False

    def __init__(self) -> None:
        self.pictures: list[pygame.Surface] = []
        self.sounds: list[int] = []

    def add(self, picture, sounds):
        self.pictures.append(picture.copy())
        self.sounds.append(sum(int(abs(one).sum()) for one in sounds))


def potted() -> Stage:
    """A stage at which a ball has just been potted."""
    stage = straight_pot()
    aim(stage, AT_THE_CORNER)
    play = stage.scene.play
    stage.post(decision_of(play.aiming.stroke._replace(cue_speed=2.0), Call()))
    stage.run(30)
    while play.phase != "aiming":
        stage.run(10)
    return stage


def test_the_strokes_are_played_again_with_their_sounds():
    stage = potted()
    excerpts = stage.scene.highlights()
    assert len(excerpts) == 1 and stage.scene.model.played.summary.balls_down
    film = FilmOfStrokes(stage.scene_type, excerpts * 2, Kept(), "dark")
    shares = []
    while not film.finished:
        film.step()
        film.draw()
        shares.append(film.share)
    kept = film.writer
    assert shares == sorted(shares) and shares[-1] == pytest.approx(1.0, abs=0.05)
    seconds = 2 * excerpts[0].steps * stage.dt
    assert len(kept.pictures) == pytest.approx(seconds * kept.rate, abs=4)
    half = len(kept.pictures) // 2
    assert max(kept.sounds[:half]) > 0 and max(kept.sounds[half:]) > 0
    first, last = (pygame.surfarray.array2d(kept.pictures[at]) for at in (0, half - 2))
    assert (first != last).any()
    assert not film.failed


def test_a_button_at_the_end_of_a_rack_asks_for_it():
    stage = open_level("nine-ball")
    scene, frame = stage.scene, stage.scene.model.frame
    assert "film-strokes" not in [row[0] for row in scene.buttons.rows()]
    scene.play.log = potted().scene.play.log
    scene.model.frame = frame.replace(game=msgspec.structs.replace(frame.game, winner=0))
    names = [row[0] for row in scene.buttons.rows()]
    box = button_box(names.index("film-strokes"))
    scene.buttons.press(scene.buttons.at(0.5 * (box.top + box.bottom), 0.5 * (box.left + box.right)))
    assert scene.film_wanted == 1


def test_the_wish_is_answered_and_without_pyav_one_line_says_how_to_install_it(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    monkeypatch.setitem(sys.modules, "av", None)
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    try:
        level = next(path for path in level_files("billiards") if path.stem == "nine-ball")
        driver.app.open_scene("billiards", opening=Opening(level=level))
        driver.frames(5)
        while driver.top.loader is not None:
            driver.top.loader.wait(LONGEST_S)
            driver.frames(2)
        said = []
        monkeypatch.setattr(driver.app, "tell", lambda *words: said.append(" ".join(words[:2])))
        driver.stage.scene.buttons.films += 1
        driver.frames(2)
        assert said == [
            "A film without sound. MP4 needs PyAV, which is not installed: pip install 'carom[video]'",
            "No film. No stroke has decided anything yet.",
        ]
    finally:
        driver.close()
