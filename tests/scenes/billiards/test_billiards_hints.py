"""Hints of the puzzles: all that a stroke is made of, in words and on the table."""

import math

import pytest

from game.levels import level_files
from game.scenes.billiards import play as moves
from game.scenes.billiards.prediction import stroke_words
from game.scenes.billiards.score_board import line_of
from game.stage import Action
from tests.scenes.billiards.billiards_stages import open_level, seconds

PUZZLES = [p.stem for p in level_files("billiards") if p.stem.startswith(("trick-", "drill-"))]


@pytest.mark.parametrize("name", PUZZLES)
def test_a_hint_says_all_that_a_stroke_is_made_of(name):
    """Whoever sets the instruments as the hint says plays the stroke that solves the puzzle."""
    stroke = open_level(name).scene.content.solution.stroke()
    power, aimed = stroke_words(stroke)
    assert float(power.split(" m/s, ")[0]) == pytest.approx(stroke.cue_speed * moves.speed_ratio(), abs=0.05)
    told = {"above": 0.0, "below": 0.0, "left": 0.0, "right": 0.0}
    for part in power.split(" m/s, ")[1].split(" and "):
        if part != "in the middle":
            size, _, way = part.split()
            told[way] = float(size)
    assert told["above"] - told["below"] == pytest.approx(stroke.tip_up, abs=0.0051)
    assert told["left"] - told["right"] == pytest.approx(stroke.tip_left, abs=0.0051)
    aim_part, _, raised = aimed.partition(", cue raised by ")
    degrees = float(aim_part.removeprefix("aim ").rstrip("°").replace("\u2212", "-"))
    assert math.remainder(math.degrees(stroke.azimuth) - 90.0 - degrees, 360.0) == pytest.approx(
        0.0, abs=0.0051
    )
    assert float(raised.rstrip("°") or 0.0) == pytest.approx(math.degrees(stroke.elevation), abs=0.51)


def test_the_line_below_the_table_tells_the_hint_while_it_is_shown():
    stage = open_level("trick-08-around-the-corner")
    goal = line_of(stage.scene)
    stage.post(Action("hint"))
    seconds(stage, 0.1)
    assert line_of(stage.scene) == (
        "Hint: 6.2 m/s, 0.03 R below and 0.50 R right, aim 30.14°, cue raised by 70°.",
        False,
    )
    stage.post(Action("hint"))
    seconds(stage, 0.1)
    assert line_of(stage.scene) == goal
