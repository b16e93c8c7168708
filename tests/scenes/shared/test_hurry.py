"""Strokes of a computer player are shown as fast as the person at the table has chosen."""

from __future__ import annotations

import pytest

from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.minds.hurry import AS_PLAYED, FAST, TO_THE_END, patience, times
from game.stage import SetParameter
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.snooker import snooker_stages as snooker

TABLES = {"billiards": (pool, "play"), "snooker": (snooker, "course")}


def rolled(table: str, player: str, chosen: str) -> tuple[int, object, list]:
    """Steps in which a stroke of the first player rolls; the stroke; where the balls then lie."""
    stages, part = TABLES[table]
    stage = stages.open_level()
    for name, value in (("first_player", player), ("second_player", "person"), ("their_strokes", chosen)):
        stage.post(SetParameter(name, value))
    stage.run(1)
    scene = stage.scene
    course = getattr(scene, part)
    stroke = course.aiming.stroke if table == "billiards" else course.stroke
    if table == "billiards":
        course.begin_stroke(stroke, course.aiming.call)
    else:
        course.swing(stroke)
    count = 0
    while course.phase != AIMING:
        count += course.phase == "rolling"
        stage.run(1)
        assert count < 20_000
    return count, scene.model.frame.strokes, list(scene.model.frame.layout.places)


@pytest.mark.parametrize("table", TABLES)
def test_three_times_as_fast_takes_a_third_and_ends_alike(table: str):
    plain, fast, ended = (rolled(table, "novice", chosen) for chosen in (AS_PLAYED, FAST, TO_THE_END))
    assert fast[0] == pytest.approx(plain[0] / 3.0, abs=2.0) and plain[0] > 100
    assert ended[0] <= 2
    assert plain[1:] == fast[1:] == ended[1:]
    assert rolled(table, "person", TO_THE_END) == plain, "a person's own stroke is shown as it is"


class Course:
    """What `times` knows of a course."""

    def __init__(self, chosen: str, **flags: bool) -> None:
        self.person_plays = self.plays_itself = self.plays_alone = False
        self.__dict__.update(flags)
        self.parameters = type("Parameters", (), {"their_strokes": chosen})


def test_who_is_waited_for_and_how_long():
    assert times(Course(FAST)) == 3.0 and patience(Course(FAST), 3.0) == 1.0
    assert patience(Course(TO_THE_END), 3.0) == 0.0 and patience(Course(AS_PLAYED), 3.0) == 3.0
    for flag in ("person_plays", "plays_itself", "plays_alone"):
        assert times(Course(TO_THE_END, **{flag: True})) == 1.0
