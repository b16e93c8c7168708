"""Teaching levels in the window: read, answered by mouse and keys, locked, folded, and made."""

from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from game.levels import load_level
from game.stage import SetParameter
from tests.app.tests_app import Driver

LEVEL = """scene = "example"
title = "A task"
[parameters]
gravity = 5.0
[teaching]
task = "Let the ball fall, and measure."
locked = ["gravity"]
locked_effects = ["test-gravity"]
hidden = ["levels"]
hidden_parameters = ["restitution"]
hidden_readouts = ["energy"]
[[teaching.questions]]
kind = "number"
ask = "How high is it now?"
readout = "height"
unit = "m"
tolerance = 0.005
[[teaching.questions]]
kind = "choice"
ask = "Which way does it fall?"
options = ["up", "down"]
right = 2
[[teaching.questions]]
kind = "goal"
ask = "Lift it above 1.5 m."
readout = "height"
least = 1.5
"""


@pytest.fixture
def said(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What messages have said."""
    lines: list[str] = []
    monkeypatch.setattr(driver.app, "tell", lambda *words: lines.append(" ".join(words[:2])))
    return lines


def begin(driver: Driver, tmp_path: Path, text: str = LEVEL):
    """The scene with the level in play, paused; the sheet."""
    path = tmp_path / "task.toml"
    path.write_text(text)
    driver.open("example")
    driver.top.play.open_file(path)
    driver.frames(40)
    driver.key(pygame.K_SPACE)
    return driver.top.shell.lesson


def press(driver: Driver, sheet, name: str) -> None:
    driver.click(*sheet.spots.find(name).rect.center)


def type_number(driver: Driver, text: str) -> None:
    for letter in text:
        code = ord(letter)
        scan = pygame.K_SPACE if letter == " " else code
        driver.post(
            pygame.Event(pygame.KEYDOWN, key=scan, scancode=0, mod=0, unicode=letter),
            pygame.Event(pygame.TEXTINPUT, text=letter),
        )


def test_the_task_has_a_part_of_the_window_of_its_own(driver, tmp_path):
    sheet = begin(driver, tmp_path)
    layout = driver.top.shell.layout
    assert sheet.rect.right == layout.stage.x and sheet.rect.w == 300
    assert driver.top.play.view.rect.x == layout.stage.x
    width = layout.stage.w
    press(driver, sheet, "fold")
    driver.frames(2)
    assert driver.top.shell.layout.stage.w == width + 260 and sheet.is_folded
    press(driver, sheet, "fold")
    assert driver.top.shell.layout.stage.w == width


def test_a_number_is_typed_and_checked_against_what_is_measured(driver, tmp_path):
    sheet = begin(driver, tmp_path)
    height = driver.stage.readouts()[1].value
    press(driver, sheet, "check-0")
    assert sheet.verdicts[0] == (False, "Type a number first.")
    press(driver, sheet, "field-0")
    type_number(driver, "9 k")  # letters that are keys of the program or of the scene are letters here
    assert sheet.answers[0] == "9 k" and driver.stage.paused
    driver.key(pygame.K_RETURN)
    assert sheet.verdicts[0].words == "This is no number."
    for _ in range(3):
        driver.key(pygame.K_BACKSPACE)
    type_number(driver, f"{height + 1.0:.3f}")
    driver.key(pygame.K_RETURN)
    assert sheet.verdicts[0] == (False, "Not yet.")
    for _ in range(8):
        driver.key(pygame.K_BACKSPACE)
    type_number(driver, f"{height:.3f}".replace(".", ","))
    driver.key(pygame.K_RETURN)
    assert sheet.verdicts[0].right and sheet.verdicts[0].words.startswith("Right: ")
    driver.key(pygame.K_ESCAPE)
    assert not sheet.typing and driver.top.called == "The scene"


def test_all_right_is_told_once(driver, tmp_path, said):
    sheet = begin(driver, tmp_path)
    sheet.answers[0] = f"{driver.stage.readouts()[1].value:.4f}"
    press(driver, sheet, "check-0")
    press(driver, sheet, "option-1-1")
    press(driver, sheet, "check-1")
    assert sheet.verdicts[1] == (False, "Not yet.")
    press(driver, sheet, "option-1-2")
    assert 1 not in sheet.verdicts
    press(driver, sheet, "check-1")
    press(driver, sheet, "check-2")
    assert not sheet.verdicts[2].right and sheet.right == 2
    x, y = driver.top.play.view.camera.to_screen(0.5, 1.9)
    driver.move(round(x), round(y))
    driver.button(True, round(x), round(y))  # the hand lifts the ball
    driver.button(False, round(x), round(y))
    press(driver, sheet, "check-2")
    assert sheet.verdicts[2] == (True, "Reached.") and sheet.right == 3
    assert [line for line in said if line == "All is answered. 3 of 3 right."] == [
        "All is answered. 3 of 3 right."
    ]


def test_what_is_hidden_is_nowhere_in_the_window(driver, tmp_path):
    begin(driver, tmp_path)
    driver.frames(30)
    shell = driver.top.shell
    names = {row.follows for row in shell.panel._sheet.rows}
    assert "gravity" in names and "restitution" not in names and not shell.panel._sheet.menus
    assert "energy" not in [name for name, _, _ in shell.bar.state.readouts]
    assert shell.strips.strips == () and not shell.layout.charts
    assert [one.name for one in driver.top.play.charts.readouts()] == ["height"]


def test_panel_keys_and_defaults_cannot_change_what_is_locked(driver, tmp_path, said):
    begin(driver, tmp_path)
    driver.frames(30)
    rows = driver.top.shell.panel._sheet.rows
    slider = next(row for row in rows if row.follows == "gravity")
    assert slider.idle == "Locked by this level."
    panel = driver.top.shell.panel
    at = panel.rect.x + panel.rect.w // 2, panel.rect.y + slider.rect.bottom - 12 - panel.scroll
    driver.click(*at)
    driver.top.play.post(SetParameter("gravity", 9.0))
    driver.app.perform("defaults")
    assert driver.stage.scene.values["gravity"] == 5.0
    assert "Not taken. Gravity: locked by this level" in said
    effect = next(row for row in rows if row.follows == "effect test-gravity")
    assert effect.idle == "Locked by this level."


def test_nothing_is_judged_without_a_task_or_while_the_scene_is_being_changed(driver, tmp_path, monkeypatch):
    sheet = begin(driver, tmp_path)
    play = driver.top.play
    play.lesson.check(1)
    assert set(sheet.verdicts) == {1}
    sheet.verdicts.clear()
    with monkeypatch.context() as patch:
        patch.setattr(type(play.record.errands), "inside", True)
        play.lesson.check(1)
    assert not sheet.verdicts
    path = tmp_path / "plain.toml"
    path.write_text('scene = "example"\ntitle = "No task"\n')
    play.open_file(path)
    driver.frames(40)
    assert sheet.teaching is None
    play.lesson.check(0)
    assert not sheet.verdicts


def test_another_level_has_another_task_and_shows_all_again(driver, tmp_path):
    sheet = begin(driver, tmp_path)
    sheet.answers[0] = "3"
    (tmp_path / "plain.toml").write_text('scene = "example"\n')
    driver.top.play.open_file(tmp_path / "plain.toml")
    driver.frames(30)
    assert sheet.teaching is None and sheet.rect.w == 0
    assert [strip.title for strip in driver.top.shell.strips.strips] == ["Energy"]
    assert "restitution" in {row.follows for row in driver.top.shell.panel._sheet.rows}


def test_a_task_that_is_begun_again_begins_with_no_tries(driver, tmp_path, said):
    sheet = begin(driver, tmp_path)
    for words in ("Not yet.", "Not yet (2 tries)."):
        press(driver, sheet, "option-1-1")
        press(driver, sheet, "check-1")
        assert sheet.verdicts[1].words == words
    driver.top.play.open_file(tmp_path / "task.toml")
    driver.frames(30)
    assert not sheet.answers and not sheet.verdicts
    press(driver, sheet, "option-1-1")
    press(driver, sheet, "check-1")
    assert sheet.verdicts[1].words == "Not yet."


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (900, 520)])
@pytest.mark.parametrize("theme", ["dark", "light"])
def test_places_lie_in_the_sheet_and_apart(start, tmp_path, size, theme):
    driver = start(size=size, theme=theme)
    sheet = begin(driver, tmp_path)
    driver.frames(2)
    if sheet.is_folded:
        press(driver, sheet, "fold")
    rects = [spot.rect for spot in sheet.spots.spots if spot.rect.h]
    assert len(rects) >= 4 and all(sheet.rect.contains(rect) for rect in rects)
    assert not any(a.colliderect(b) for i, a in enumerate(rects) for b in rects[:i])
    layout = driver.top.shell.layout
    for other in (layout.free_stage, layout.strips, layout.hint_bar, layout.top_bar):
        assert not sheet.rect.colliderect(other) or not other.h


def test_a_long_task_is_scrolled_by_the_wheel(start, tmp_path):
    driver = start(size=(1000, 400))
    sheet = begin(driver, tmp_path, LEVEL.replace("and measure.", "and measure. " * 30))
    if sheet.is_folded:
        press(driver, sheet, "fold")
    assert not sheet.spots.find("check-2").rect.h
    middle = sheet.rect.center
    for _ in range(40):
        driver.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=-1, precise_y=-1.0, pos=middle))
    assert sheet.spots.find("check-2").rect.h > 20


def test_a_saved_scene_keeps_its_task(driver, tmp_path):
    begin(driver, tmp_path)
    driver.top.play.shelf.save("Mine")
    driver.frames(20)
    (path,) = (Path(driver.app.folder) / "levels" / "example").glob("saved-*.toml")
    assert load_level(path, "example", None).teaching == driver.stage.level.teaching


# -- making one -----------------------------------------------------------------------------------


def test_a_teaching_level_is_made_in_the_window_and_opened(driver, said):
    driver.open("example")
    driver.frames(20)
    driver.stage.post(SetParameter("gravity", 3.0))
    driver.key(pygame.K_t, mod=pygame.KMOD_CTRL)
    driver.frames(20)
    card = driver.top
    assert card.called == "The card of a teaching level"
    driver.click(*card.spots.find("save").rect.center)
    assert driver.top is card and card.trouble == "task: expected words"
    driver.type("Moon")
    driver.key(pygame.K_RETURN)
    driver.type("How strong is gravity?")
    driver.click(*card.spots.find("row-0").rect.center)  # gravity: locked
    for _ in range(2):
        driver.click(*card.spots.find("row-1").rect.center)  # restitution: hidden
    driver.click(*card.spots.find("add-number").rect.center)
    driver.frames(20)
    driver.click(*driver.top.spots.find("row-1").rect.center)  # of the height
    driver.frames(30)
    assert driver.top.called == "The card for a name"
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    driver.click(*card.spots.find("add-choice").rect.center)
    driver.frames(20)
    driver.type("Which? | b | a")
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    driver.click(*card.spots.find("save").rect.center)
    driver.frames(30)
    (line,) = [one for one in said if one.startswith("Teaching level saved ")]
    level = load_level(Path(line.removeprefix("Teaching level saved ")), "example", None)
    teaching = level.teaching
    assert (level.title, teaching.task) == ("Moon", "How strong is gravity?")
    assert (teaching.locked, teaching.hidden_parameters) == (["gravity"], ["restitution"])
    number, choice = teaching.questions
    assert (number.ask, number.readout, number.percent) == ("What is the height?", "height", 5.0)
    assert (choice.options, choice.right) == (["a", "b"], 2)
    driver.top.play.open_file(level.path)
    driver.frames(20)
    assert driver.top.shell.lesson.teaching == teaching and driver.stage.scene.values["gravity"] == 3.0


def test_a_question_that_cannot_be_is_told_on_the_card_and_one_is_left_out_by_a_press(driver):
    driver.open("example")
    driver.app.perform("teach")
    driver.frames(20)
    card = driver.top
    for words in ("Which? | only", "Which? | b | a"):
        driver.click(*card.spots.find("add-choice").rect.center)
        driver.frames(20)
        driver.type(words)
        driver.key(pygame.K_RETURN)
        driver.frames(30)
        if words.endswith("only"):
            assert card.trouble.startswith("options: expected the question") and not card.draft.questions
    assert len(card.draft.questions) == 1 and not card.trouble
    driver.click(*card.spots.find("drop-0").rect.center)
    assert not card.draft.questions
