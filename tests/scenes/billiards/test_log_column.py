"""The log beside the table: a click plays on from a stroke; it is kept with the level, and checked when
read.
"""

import json

import msgspec
import numpy as np
import pytest

from game.app.stagehand.files import present_level
from game.levels import LevelError, format_level, parse_level
from game.packed_text import pack, unpack
from game.scenes.billiards.beside import LOG
from game.scenes.billiards.level import BilliardsContent
from game.scenes.billiards.practice import columns
from game.scenes.billiards.practice.log_text import MOST_BYTES, log_in, text_of_log
from game.scenes.billiards.practice.side import log_rows
from game.scenes.billiards.scene import Billiards
from game.stage import Action, Decision, Stage, replay_scene
from tests.scenes.billiards.billiards_stages import click, level_of, open_level, point, seconds, until_aiming

NO_CALL = (-1.0, -1.0, 0.0, 0.0)


def strike(stage, speed, azimuth):
    stage.post(Decision("stroke", (speed, azimuth, 0.0, 0.0, 0.0, *NO_CALL)))
    return until_aiming(seconds(stage, 0.25))


@pytest.fixture(scope="module")
def game() -> Stage:
    """Nine-ball with four strokes."""
    stage = open_level("nine-ball", beside=LOG)
    for speed, azimuth in ((7.0, 1.58), (1.5, 0.4), (2.0, 2.0), (1.0, -1.0)):
        strike(stage, speed, azimuth)
    return stage


@pytest.fixture
def stage(game) -> Stage:
    """The same, gone through again."""
    return replay_scene(game.recording, Billiards)


def press_row(stage, words: str) -> None:
    """Click the row of a stroke by its number, or "back"."""
    rows = stage.scene.side.rows_seen()
    wanted = next(
        k
        for k, row in enumerate(rows)
        if (str(row.stroke.number) if row.stroke else "rack" if row.rack else "back") == words
    )
    click(stage, *columns.COLUMN.row_box(wanted).middle)


def test_a_click_on_a_stroke_plays_on_from_there(stage):
    scene = stage.scene
    entry = scene.play.log.find(2)
    before, after = entry.struck.frame, scene.play.log.find(3).struck.frame
    press_row(stage, "2")
    frame = scene.model.frame
    assert frame.layout.places == before.layout.places and frame.game == before.game
    assert scene.aiming.stroke == pytest.approx(entry.struck.stroke) and scene.aiming.locked
    assert tuple(scene.model.places[list(frame.layout.numbers)].ravel()) == tuple(
        frame.layout.positions.ravel()
    )
    strike(stage, *entry.struck.stroke[:2])
    assert scene.model.frame.layout.places == after.layout.places
    assert [one.after for one in scene.play.log.entries] == [0, 1, 2, 3, 1]
    assert scene.play.log.at == 5


def test_the_last_row_leads_back_to_where_one_was(stage):
    scene = stage.scene
    places, game = scene.model.frame.layout.places, scene.model.frame.game
    press_row(stage, "1")
    assert scene.model.frame.game.opening
    strike(stage, 6.0, 1.6)
    press_row(stage, "back")
    assert (scene.model.frame.layout.places, scene.model.frame.game) == (places, game)
    assert scene.play.log.at == 4 and "back" not in [str(row) for row in scene.side.rows_seen()]
    assert len(scene.play.log.entries) == 5


def test_undo_keeps_the_stroke_in_the_log(stage):
    stage.post(Action("undo"))
    stage.post(Action("undo"))
    log = stage.scene.play.log
    assert (len(log.entries), log.at) == (4, 2)
    strike(stage, 1.0, 0.0)
    assert stage.scene.play.log.entries[-1].after == 2
    stage.post(Decision("stroke", (1.0, 0.3, 0.0, 0.0, 0.0, *NO_CALL)))
    while stage.scene.play.phase != "rolling":
        stage.run(1)
    stage.post(Action("undo"))  # in the midst of it: nothing of it is in the log
    assert (len(stage.scene.play.log.entries), stage.scene.play.log.at) == (5, 5)


def test_what_is_done_with_the_log_is_recorded_and_stepped_back_over(stage):
    press_row(stage, "2")
    strike(stage, 1.0, 0.5)
    assert replay_scene(stage.recording, Billiards).digest() == stage.digest()
    assert replay_scene(stage.recording, Billiards).scene.play.log.at == 5
    at = stage.scene.play.log.at
    stage.return_to(stage.step_number - 60)
    assert stage.scene.play.log.at <= at


def test_while_balls_roll_a_click_does_nothing(stage):
    stage.post(Decision("stroke", (3.0, 0.3, 0.0, 0.0, 0.0, *NO_CALL)))
    seconds(stage, 1.0)
    before = stage.scene.play.log
    press_row(stage, "2")
    assert stage.scene.play.log is before and stage.scene.play.phase != "aiming"


def test_the_wheel_shows_the_older_rows(stage):
    side = stage.scene.side
    for _ in range(columns.ROWS // 4 + 1):
        entries = stage.scene.play.log.entries
        stage.scene.play.log = msgspec.structs.replace(
            stage.scene.play.log,
            entries=(
                *entries,
                *(msgspec.structs.replace(e, number=e.number + entries[-1].number) for e in entries),
            ),
        )
    rows = log_rows(stage.scene.play.log)
    assert side.rows_seen() == rows[-columns.ROWS :]
    x, y = columns.COLUMN.box.middle
    point(stage, "wheel", x, y, wheel=3.0)
    assert side.rows_seen() == rows[-columns.ROWS - 3 : -3]
    point(stage, "wheel", x, y, wheel=1000.0)
    assert side.rows_seen() == rows[: columns.ROWS]
    aim = stage.scene.aiming.cue.aim
    point(stage, "wheel", x, y, wheel=-1.0)
    assert stage.scene.aiming.cue.aim == aim


def test_a_counted_rack_is_practised_and_gone_on_with():
    stage = level_of('game = "ghost-nine-ball"', beside=LOG)
    strike(stage, 7.0, 1.58)
    assert not stage.scene.model.frame.game.over
    press_row(stage, "1")
    assert len(stage.scene.model.frame.game.players) == 1
    press_row(stage, "back")
    assert stage.scene.model.frame.game.players == ("Ada", "Ghost") and stage.scene.practised.of == 10
    before = stage.scene.model.frame
    stage.post(Action("undo"))
    assert stage.scene.model.frame is before
    assert "Nothing is taken back. This is counted." in stage.scene.messages()


class TestKept:
    def test_a_level_keeps_the_log(self, stage):
        stage.post(Action("undo"))
        text = format_level(present_level(stage, "kept"))
        again = Stage(Billiards, level=parse_level(text, "billiards", BilliardsContent))
        mine, theirs = stage.scene.play.log, again.scene.play.log
        assert theirs.at == mine.at and len(theirs.entries) == len(mine.entries) == 4
        for one, other in zip(mine.entries, theirs.entries, strict=True):
            assert other.struck.stroke == one.struck.stroke and other.words == one.words
            assert other.struck.frame.game == one.struck.frame.game
            assert other.struck.frame.layout.places == one.struck.frame.layout.places
            assert (other.number, other.after, other.rack, other.down) == (
                one.number,
                one.after,
                one.rack,
                one.down,
            )
        again.scene.side.go_back(2)
        assert again.scene.model.frame.layout.places == mine.find(2).struck.frame.layout.places

    def changed(self, stage, change) -> str:
        """The text of the log after a change of its document."""
        document = json.loads(unpack(text_of_log(stage.scene.play.log)[2:], MOST_BYTES))
        change(document)
        return f"1.{pack(json.dumps(document).encode())}"

    @pytest.mark.parametrize(
        ("change", "why"),
        [
            (lambda d: d.update(at=9), "there is no stroke 9"),
            (lambda d: d.update(more=1), "unknown field"),
            (lambda d: d["strokes"].reverse(), "out of order"),
            (lambda d: d["strokes"][1].update(after=2), "comes after itself"),
            (lambda d: d["strokes"][0]["places"].pop(), "not those of the game"),
            (lambda d: d["strokes"][0]["places"].pop(0), "its balls are not those of a stroke"),
            (lambda d: d["strokes"][0]["places"][1].__setitem__(1, 99.0), "lies outside"),
            (
                lambda d: d["strokes"][0]["places"].__setitem__(2, [2, *d["strokes"][0]["places"][1][1:]]),
                "stroke 1",
            ),
            (lambda d: d["strokes"][2].update(stroke=[1.0, 0.0, 0.0, 3.0, 0.0]), "stroke 3"),
            (lambda d: d["strokes"][2]["game"].update(turn=7), "is no player"),
            (lambda d: d["strokes"][2]["game"].update(winner=0), "over"),
        ],
    )
    def test_what_cannot_be_is_refused_in_one_line(self, stage, change, why):
        with pytest.raises(ValueError, match=why) as caught:
            log_in(self.changed(stage, change), stage.scene.model.frame)
        assert str(caught.value).startswith("log: ") and "\n" not in str(caught.value)

    @pytest.mark.parametrize(
        ("text", "why"),
        [("2.abc", "is of format 2; this Carom reads format 1"), ("abc", "it has no format"),
         ("1.", "damaged"),
         ("1.AAAA", "damaged"), (f"1.{pack(b' ' * (MOST_BYTES + 1))}", "unpacks to more than"),
         (f"1.{pack(b'[' * 100_000)}", "log: ")],
    )  # fmt: skip
    def test_what_is_damaged_later_or_a_bomb_is_a_level_error(self, stage, text, why):
        level = f'scene = "billiards"\n[content]\nlog = "{text}"\n'
        with pytest.raises(LevelError, match=why) as caught:
            Stage(Billiards, level=parse_level(level, "billiards", BilliardsContent))
        assert "\n" not in str(caught.value)

    def test_an_empty_log_is_no_text(self, stage):
        assert text_of_log(open_level("nine-ball").scene.play.log) == ""
        assert len(text_of_log(stage.scene.play.log)) < 3000
        assert np.isfinite(stage.scene.model.places).all()
