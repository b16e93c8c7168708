"""Stars of puzzles: won by a person, kept whole, shown in the lists; a broken file costs a line."""

from __future__ import annotations

import math

import pytest

from game.app.stagehand.level_index import level_heads
from game.app.stagehand.stars import BROKEN_NAME, Stars, keep_stars, kept_stars, stars_path
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Decision
from tests.app.tests_app import Driver

PUZZLE = "trick-02-plant"


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))


def test_the_best_of_each_level_is_kept():
    assert kept_stars("billiards") == {}
    assert keep_stars("billiards", "one", Stars(2, 3)) == ""
    assert keep_stars("billiards", "one", Stars(1, 3)) == ""
    assert keep_stars("billiards", "two", Stars(1, 1)) == keep_stars("other", "one", Stars(3, 3)) == ""
    assert kept_stars("billiards") == {"one": Stars(2, 3), "two": Stars(1, 1)}
    assert Stars(2, 3).words == "★★☆" and Stars(1, 1).words == "★"


@pytest.mark.parametrize(
    "text", ["[billiards", "billiards = 3", "[billiards]\none = [-1, 3]", "[billiards]\none = ['a', 3]", " "]
)
def test_a_broken_file_costs_a_line_and_is_kept_aside(text):
    stars_path().write_text(text)
    assert kept_stars("billiards") == {}
    complaint = keep_stars("billiards", "one", Stars(1, 3))
    assert "stars.toml" in complaint and BROKEN_NAME in complaint and "\n" not in complaint
    assert stars_path().with_name(BROKEN_NAME).read_text() == text
    assert kept_stars("billiards") == {"one": Stars(1, 3)}
    assert keep_stars("billiards", "one", Stars(2, 3)) == ""


def test_what_cannot_be_written_costs_a_line():
    stars_path().mkdir()
    assert "stars.toml" in keep_stars("billiards", "one", Stars(1, 3))


def solve(driver: Driver) -> None:
    """Play the puzzle as its level says that it is solved."""
    stroke = driver.stage.scene.model.content.solution.stroke()
    assert math.isfinite(stroke.azimuth)
    driver.stage.post(Decision("stroke", (*stroke, -1.0, -1.0, 0.0, 0.0)))
    driver.frames(400, 0.1)


def test_stars_won_in_the_window_stay(tmp_path):
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    path = next(file for file in level_files("billiards") if file.stem == PUZZLE)
    driver.app.open_scene("billiards", level=path)
    driver.top.loader.wait(300.0)
    driver.frames(2)
    assert kept_stars("billiards") == {}
    solve(driver)
    won, most = driver.stage.scene.stars
    assert won >= 1 and kept_stars("billiards") == {PUZZLE: Stars(won, most)}
    row = next(row for row in driver.top.play.shelf.levels() if row.value == path)
    assert row.chip == Stars(won, most).words
    head = next(head for head in level_heads("billiards") if head.path == path)
    assert head.stars == row.chip
    driver.close()


def test_a_table_that_plays_itself_wins_no_stars(tmp_path):
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    path = next(file for file in level_files("billiards") if file.stem == PUZZLE)
    driver.app.open_scene("billiards", level=path)
    driver.top.loader.wait(300.0)
    driver.frames(2)
    driver.stage.scene.play.plays_itself = True
    solve(driver)
    assert driver.stage.scene.model.frame.game.made >= 1 and kept_stars("billiards") == {}
    driver.close()
