"""A hard case waits under its caption; lists, tool tip and help say all of it; a replay has a sign."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from game.app.scene.help_card import HelpCard
from game.app.screens.choices import ChoiceCard
from game.levels import Level, save_level
from game.stage import SetParameter
from game.ui.widgets.list_row import ListRow
from tests.app.tests_app import Driver

LONG = "The ball is dropped from where nobody has dropped it before, again and again. " * 2
LONG = LONG + "It is found."


def kept_level(folder: Path, hard_case: str) -> Path:
    path = folder / "home" / "levels" / "example" / "a-level.toml"
    save_level(Level(scene="example", title="Hard: a level", about=LONG, hard_case=hard_case), path)
    return path


@pytest.fixture
def hard(driver: Driver, tmp_path: Path) -> Driver:
    """A scene in which a hard case has just been opened."""
    driver.open()
    driver.frames(5)
    driver.top.play.open_file(kept_level(tmp_path, "E.H1"))
    driver.frames(3)
    return driver


def test_a_hard_case_waits_under_its_caption_until_it_is_let_run(hard: Driver):
    play = hard.top.play
    assert hard.stage.paused and hard.stage.step_number == 0
    assert play.caption.words == LONG and hard.app.toasts.shown is None
    hard.key(pygame.K_SPACE)
    hard.frames(5)
    assert not hard.stage.paused and hard.stage.step_number > 0 and play.caption.words == ""
    hard.key(pygame.K_SPACE)
    hard.frames(2)
    assert play.caption.words == "", "it has begun"


def test_a_press_on_the_caption_lets_it_run_and_is_not_the_scenes(hard: Driver):
    hard.click(*hard.top.play.caption.rect.center)
    hard.frames(5)
    kinds = {stamped.event.kind for stamped in hard.stage.recording.events}
    assert hard.stage.step_number > 0 and not kinds & {"down", "up"}


def test_a_hard_case_that_a_scene_is_opened_with_waits_as_well(driver: Driver, tmp_path: Path):
    driver.app.open_scene("example", kept_level(tmp_path, "E.H1"))
    driver.frames(40)
    assert driver.stage.paused and driver.stage.step_number == 0 and driver.top.play.caption.words == LONG


def test_any_other_level_runs_at_once(driver: Driver, tmp_path: Path):
    driver.open()
    driver.top.play.open_file(kept_level(tmp_path, ""))
    driver.frames(5)
    assert not driver.stage.paused and driver.top.play.caption.words == ""
    assert driver.app.toasts.shown.consequence == LONG


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (640, 480), (300, 200)])
def test_the_caption_lies_within_the_stage_or_is_not_shown(hard: Driver, size: tuple[int, int]):
    hard.resize(*size)
    hard.frames(3)
    caption, stage = hard.top.play.caption, hard.top.shell.layout.free_stage
    assert (stage.contains(caption.rect) and caption.words == LONG) or caption.words == ""
    assert caption.words or size == (300, 200)


def test_help_begins_with_the_level_and_its_box_says_all_of_it(hard: Driver):
    panel = hard.top.shell.panel
    hard.move(panel.view.centerx, panel.view.y + 30)
    hard.frames(2)
    assert panel.tip()[0] == f"Hard: a level\n{LONG}"
    hard.key(pygame.K_F1)
    assert isinstance(hard.top, HelpCard) and hard.top.page.level == ("Hard: a level", LONG)


def test_a_row_of_a_list_says_all_its_words_in_two_lines(driver: Driver):
    rows = [ListRow("Hard: a level", LONG, "E.H1", True, 1), ListRow("Short", "Few words.", "", False, 2)]
    driver.app.cards.open_choices("Levels", rows, lambda value: None)
    driver.frames(3)
    card = driver.top
    assert isinstance(card, ChoiceCard)
    lines = card.lines(rows[0])
    assert len(lines) == 2 and " ".join(lines) == LONG and card.lines(rows[1]) == ["Few words."]
    space = card.places()[0].rect.w
    assert all(driver.app.look.fonts.size(line, 12, "medium")[0] < space for line in lines)


def test_a_replay_has_a_sign_until_its_end(driver: Driver, tmp_path: Path):
    driver.open()
    driver.frames(20)
    driver.top.play.post(SetParameter("gravity", 3.0))
    driver.frames(20)
    path, steps = tmp_path / "session.json", driver.stage.step_number
    driver.stage.recording.save(path)
    assert driver.top.play.record.watched == ""
    driver.top.play.open_file(path)
    driver.frames(2)
    assert driver.top.play.record.watched.startswith("Replay, step ")
    assert driver.top.play.record.watched.endswith(f" of {steps}")
    driver.frames(60)
    assert driver.stage.step_number > steps and driver.top.play.record.watched == ""


def test_a_level_is_played_as_fast_as_it_says(driver: Driver, tmp_path: Path):
    path = tmp_path / "home" / "levels" / "example" / "slow.toml"
    save_level(Level(scene="example", title="Slow", about="Slow.", hard_case="E.H2", pace=0.125), path)
    driver.app.open_scene("example", path)
    driver.frames(40)
    assert driver.stage.speed == 0.125
    driver.top.play.open_file(kept_level(tmp_path, "E.H1"))
    driver.frames(3)
    assert driver.stage.speed == 1.0
    driver.stage.speed = 2.0
    driver.top.play.open_file(kept_level(tmp_path, ""))
    driver.frames(3)
    assert driver.stage.speed == 2.0, "what a user has set is kept"
