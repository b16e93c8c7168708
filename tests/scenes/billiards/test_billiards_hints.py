"""Hints of the puzzles: all that a stroke is made of, in words and on the table."""

import math

import pytest

from game.billiards.table.rack import BALL_RADIUS
from game.levels import level_files
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.billiards.view.words import line_of, stroke_words
from game.stage import Action
from tests.scenes.billiards.billiards_stages import open_level, seconds

PUZZLES = [p.stem for p in level_files("billiards") if p.stem.startswith(("trick-", "drill-"))]


def line_in(scene):
    """The line below the table."""
    return line_of(scene.play, scene.view.hint)


@pytest.mark.parametrize("name", PUZZLES)
def test_a_hint_says_all_that_a_stroke_is_made_of(name):
    """Whoever sets the instruments as the hint says plays the stroke that solves the puzzle."""
    stroke = open_level(name).scene.model.content.solution.stroke()
    power, aimed = stroke_words(stroke)
    assert float(power.split(" m/s, ")[0]) == pytest.approx(power_of(stroke.cue_speed), abs=0.05)
    said = {"above": 0.0, "below": 0.0, "left": 0.0, "right": 0.0}
    for part in power.split(" m/s, ")[1].split(" and "):
        if part != "in the middle":
            size, _, side = part.split()
            said[side] = 0.001 * float(size) / BALL_RADIUS
    assert said["above"] - said["below"] == pytest.approx(stroke.tip_up, abs=0.0051)
    assert said["left"] - said["right"] == pytest.approx(stroke.tip_left, abs=0.0051)
    aim_part, _, raised = aimed.partition(", cue raised by ")
    degrees = float(aim_part.removeprefix("aim ").rstrip("°").replace("\u2212", "-"))
    assert math.remainder(math.degrees(stroke.azimuth) - 90.0 - degrees, 360.0) == pytest.approx(
        0.0, abs=0.0051
    )
    assert float(raised.rstrip("°") or 0.0) == pytest.approx(math.degrees(stroke.elevation), abs=0.51)


def test_the_line_below_the_table_says_the_hint_while_it_is_shown():
    stage = open_level("trick-08-around-the-corner")
    goal = line_in(stage.scene)
    stage.post(Action("hint"))
    seconds(stage, 0.1)
    said = "Hint: 6.2 m/s, 0.8 mm below and 14.3 mm right, aim 30.14°, cue raised by 70°."
    assert line_in(stage.scene) == (said, "", False)
    stage.post(Action("hint"))
    seconds(stage, 0.1)
    assert line_in(stage.scene) == goal
