"""The file of careers: whole or not at all, of its format, and a damaged one is kept aside."""

import json

import pytest

from game.app.stagehand import career_file
from game.app.stagehand.career_file import career_path, keep_career, load_career, read_career
from game.billiards.career.career import Career, Match, Player, Result
from game.billiards.career.matches import new_cup

RESULT = Result(Match("nine-ball", "greta", 1), "2026-01-02T03:04:05", 3, 2, True, 4)


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    return tmp_path


def career() -> Career:
    mia = new_cup(Player("Mia", (RESULT,)), "snooker", 5).replace(pending=Match("eight-ball", "tom"))
    return Career((mia, Player("Jo")), 1)


def test_what_is_kept_comes_back():
    assert load_career() == (Career(), "")
    assert keep_career(career()) == ""
    assert load_career() == (career(), "")
    assert json.loads(career_path().read_text())["format"] == career_file.FORMAT


DAMAGED = (
    "",
    "{",
    '{"format": 0}',
    '{"format": 1, "career": {"current": -1}}',
    '{"format": 1, "career": {"players": [{"name": ""}]}}',
    '{"format": 1, "career": {"players": [{"name": "a"}], "current": 3}}',
    '{"format": 3, "career": {"players": [{"name": "a", "choices": {"billiards": {"hand": 3}}}]}}',
)


@pytest.mark.parametrize("text", DAMAGED)
def test_a_damaged_file_gives_one_line_and_is_kept_aside(home, text):
    keep_career(career())
    career_path().write_text(text)
    found, complaint = load_career()
    assert found == Career()
    assert complaint.count("\n") == 0
    assert "kept as career.broken.json" in complaint
    assert (home / "career.broken.json").read_text() == text
    assert keep_career(career()) == ""
    career_path().write_text("nonsense")
    assert "career.broken2.json" in keep_career(career())
    assert read_career() == career()
    assert (home / "career.broken.json").read_text() == text


def test_a_file_of_a_later_version_is_left_alone():
    career_path().write_text('{"format": 99, "more": true}')
    found, complaint = load_career()
    assert found == Career()
    assert "format 99" in complaint
    assert "nothing is written over it" in keep_career(career())
    assert "99" in career_path().read_text()


def test_a_write_that_fails_leaves_the_old_file(home, monkeypatch):
    keep_career(career())
    before = career_path().read_text()

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    assert "no space" in keep_career(Career())
    monkeypatch.undo()
    monkeypatch.setenv("CAROM_HOME", str(home))
    assert career_path().read_text() == before


def test_a_file_of_the_first_format_is_read_and_written_in_the_present_one():
    career_path().write_text('{"format": 1, "career": {"players": [{"name": "Mia"}]}}')
    assert load_career() == (Career((Player("Mia"),)), "")
    keep_career(Career((Player("Mia", unlocked=("blue cloth",)),)))
    assert json.loads(career_path().read_text())["format"] == career_file.FORMAT
    assert read_career().player.unlocked == ("blue cloth",)
