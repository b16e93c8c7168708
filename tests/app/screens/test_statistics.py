"""Strokes of a match are counted for ever, shown as charts, and written as CSV by button and command."""

import csv
import json
import math

import msgspec
import pytest

from game.app.commands import run_command_line
from game.app.screens.statistics_card import CSV_NAME, StatisticsCard
from game.app.stagehand.career_file import keep_career
from game.app.stagehand.opening import Opening
from game.app.stagehand.stroke_file import keep_stroke, read_strokes, strokes_path
from game.billiards.career.career import Career, Player
from game.billiards.career.strokes import BREAK, POT, StrokeFact
from game.scenes import CATALOGUE
from game.stage import Action
from tests.app.tests_app import Driver

FACT = StrokeFact("2026-01-01T10:00:00", "eight-ball", "tom", POT, 0.5, 10.0, True, 0.6, 0.1, 2.0)


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, catalogue=CATALOGUE)
    made.frames(3)
    yield made
    made.close()


def test_a_stroke_in_a_match_is_kept(driver):
    keep_career(Career((Player("Mia"),)))
    parameters = {"game": "nine-ball", "second_player": "tom", "power": 6.0}
    driver.app.open_scene("billiards", opening=Opening(parameters=parameters, players=("Mia", "Tom Hale")))
    driver.frames(5)
    while driver.top.loader is not None:
        driver.top.loader.wait(300.0)
        driver.frames(2)
    scene = driver.stage.scene
    driver.stage.post(Action("strike"))
    for _ in range(80):
        driver.frames(1)
        if scene.play.phase == "rolling":
            driver.stage.post(Action("strike"))  # on to the end
        if scene.model.frame.strokes:
            break
    driver.frames(5)
    assert scene.model.frame.strokes == 1
    (kept,) = read_strokes()["Mia"]
    assert (kept.game, kept.opponent, kept.kind) == ("nine-ball", "tom", BREAK)
    assert kept.speed > 3.0
    assert kept.distance > 0.5
    assert math.isfinite(kept.cut)


def test_the_card_shows_them_and_its_button_writes_them(driver, tmp_path):
    for k in range(6):
        keep_stroke("Mia", FACT if k % 2 else FACT.__class__(**{**_fields(), "made": False, "distance": 1.0}))
    driver.app.cards.open_statistics("Mia")
    driver.frames(30)
    assert isinstance(driver.top, StatisticsCard)
    assert len(driver.top.facts) == 6
    driver.click(*driver.top.spots.find("csv").rect.center)
    driver.frames(3)
    rows = list(csv.DictReader((tmp_path / CSV_NAME).read_text().splitlines()))
    assert [row["made"] for row in rows] == ["0", "1"] * 3


def _fields():
    return {name: getattr(FACT, name) for name in FACT.__struct_fields__}


def test_the_command_writes_them(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    keep_career(Career((Player("Mia"),)))
    keep_stroke("Mia", FACT)
    target = tmp_path / "out.csv"
    assert run_command_line(["statistics", "--csv", str(target)]) == 0
    assert "Mia: 1 of 1 pots" in capsys.readouterr().out
    assert len(target.read_text().splitlines()) == 2
    assert run_command_line(["statistics", "--player", "Jo"]) == 2


def test_a_damaged_file_is_kept_aside_and_a_later_one_left(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    strokes_path().write_text("{")
    assert "strokes.broken.json" in keep_stroke("Mia", FACT)
    assert read_strokes() == {"Mia": [FACT]}
    assert (tmp_path / "strokes.broken.json").read_text() == "{"
    strokes_path().write_text('{"format": 9}')
    assert "format 9" in keep_stroke("Mia", FACT)
    assert strokes_path().read_text() == '{"format": 9}'


def test_strokes_that_were_kept_before_cushions_were_counted_are_read(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    older = msgspec.to_builtins(FACT)
    del older["cushions"]
    strokes_path().write_text(json.dumps({"format": 1, "strokes": {"Mia": [older]}}))
    assert read_strokes() == {"Mia": [FACT]} and FACT.cushions == 0
    keep_stroke("Mia", FACT)
    assert json.loads(strokes_path().read_text())["format"] == 2 and read_strokes() == {"Mia": [FACT, FACT]}
