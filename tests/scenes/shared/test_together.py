"""A match of two tables far apart: a stroke travels as a text, and proves itself before it is played."""

from __future__ import annotations

import re

import pytest

from game.scenes.shared.tables.together.stroke_text import (
    StrokeText,
    looks_like_a_stroke,
    packed_stroke,
    read_stroke,
)
from game.stage import Action, Decision
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.carom import carom_stages as carom
from tests.scenes.snooker import snooker_stages as snooker

TABLES = {
    "billiards": (lambda: pool.open_level("nine-ball"), pool.until_aiming),
    "snooker": (snooker.open_level, snooker.until_aiming),
    "carom": (lambda: carom.open_level(map=False, second_player="person"), None),
}


def settled(stage):
    """The stroke is over."""
    stage.run(30)
    for _ in range(400):
        if stage.scene.course.phase == "aiming":
            return stage
        stage.run(10)
    raise AssertionError("the shot does not end")


def struck(stage, power=3.0, aim=1.5):
    """A stroke by hand, played to its end."""
    stage.scene.parameters.power = power
    stage.scene.course.cue.point_to(aim)
    stage.post(Action("strike"))
    return settled(stage)


def play(stage, text):
    """The stroke of a text, played to its end."""
    for decision in stage.scene.take_text(text):
        stage.post(decision)
    return settled(stage)


@pytest.mark.parametrize("table", TABLES)
def test_two_tables_stay_the_same_by_texts_alone(table):
    mine, theirs = (TABLES[table][0]() for _ in range(2))
    for turn in range(4):
        sender, receiver = (mine, theirs) if turn % 2 == 0 else (theirs, mine)
        for stage in (mine, theirs):
            if stage.scene.model.frame.game.options:
                stage.post(Action("first"))
                stage.run(2)
        struck(sender, 2.0 + turn, 1.2 + 0.15 * turn)
        text = sender.scene.given_text()
        assert looks_like_a_stroke(text) and len(text) < 400
        play(receiver, text)
        frames = mine.scene.model.frame, theirs.scene.model.frame
        assert frames[0].game == frames[1].game and frames[0].strokes == frames[1].strokes == turn + 1
        assert mine.scene.model.places.tolist() == theirs.scene.model.places.tolist()


def test_a_cue_ball_in_hand_travels_with_the_stroke():
    mine, theirs = (pool.open_level("nine-ball") for _ in range(2))
    mine.post(Decision("white", (0.45, 0.3)))
    mine.run(1)
    struck(mine, 7.0)
    play(theirs, mine.scene.given_text())
    assert theirs.scene.model.frame.last.frame.cue_ball == (0.45, 0.3)
    assert mine.scene.model.places.tolist() == theirs.scene.model.places.tolist()


@pytest.fixture(scope="module")
def text():
    return struck(pool.open_level("nine-ball"), 7.0).scene.given_text()


def test_white_space_and_signs_of_mail_do_no_harm(text):
    wrapped = "> " + "\n> ".join(re.findall(".{1,40}", text))
    assert read_stroke(wrapped, "billiards") == read_stroke(text, "billiards")


@pytest.mark.parametrize("place", range(0, 400, 7))
def test_a_wrong_letter_anywhere_is_noticed(text, place):
    place = len("stroke1.") + place % (len(text) - len("stroke1."))
    wrong = text[:place] + ("a" if text[place] != "a" else "b") + text[place + 1 :]
    stage = pool.open_level("nine-ball")
    with pytest.raises(ValueError, match=r"^(check|scene|text): "):
        stage.scene.take_text(wrong)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        (lambda t: t.replace("stroke1", "stroke2"), "format"),
        (lambda t: t[: len(t) // 2], "check"),
        (lambda t: "stroke1.billiards", "text"),
        (lambda t: packed_stroke("snooker", read_stroke(t, "billiards")), "scene"),
        (lambda t: with_fields(t, after="0" * 16), "after"),
        (lambda t: with_fields(t, before="0" * 16), "before"),
        (lambda t: with_fields(t, steps=(("stroke", (1.0,)),)), "steps"),
        (lambda t: with_fields(t, steps=(("white", (0.1, 0.1)),)), "steps"),
    ],
)
def test_each_wrong_field_is_named_in_one_line_and_nothing_changes(text, change, field):
    stage = pool.open_level("nine-ball")
    stage.run(2)
    digest = stage.digest()
    with pytest.raises(ValueError, match=rf"^{field}: ") as told:
        stage.scene.take_text(change(text))
    assert "\n" not in str(told.value)
    assert stage.digest() == digest and stage.scene.model.frame.strokes == 0


def with_fields(text, **changes):
    """A text with other fields and a check that fits."""
    told = read_stroke(text, "billiards")
    fields = {name: changes.get(name, getattr(told, name)) for name in told.__struct_fields__}
    return packed_stroke("billiards", StrokeText(**fields))


def test_a_text_from_another_position_is_refused(text):
    stage = struck(pool.open_level("nine-ball"), 5.0)
    with pytest.raises(ValueError, match=r"^before: "):
        stage.scene.take_text(text)


def test_while_balls_roll_no_stroke_is_taken(text):
    stage = pool.open_level("nine-ball")
    stage.post(Action("strike"))
    stage.run(80)
    with pytest.raises(ValueError, match=r"^table: "):
        stage.scene.take_text(text)


def test_what_is_no_stroke_is_for_others():
    stage = pool.open_level("nine-ball")
    assert stage.scene.take_text("carom1.billiards.00.AA") is None
    with pytest.raises(ValueError, match="none has been played"):
        stage.scene.given_text()
