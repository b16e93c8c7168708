"""What captions show beside their numbers: measured and expected, step by step, and after a step back."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import LevelError
from game.stage import Comparison
from game.stage.story.rehearsal import stage_of
from game.stage.story.runner import Runner
from tests.stage.story.bouncing import StoryBall, story

HEAD = 'scene = "story-ball"\ntitle = "A ball"\n[parameters]\nheight = 12.0\n'
TURN = '[[line]]\nmoment = "one"\nwhen = "bounces >= 1"\ndeadline = 20.0\n'
END = '[[line]]\nhand_over = "Kick it."\nseconds = 3.0\n'


def begun(chart: str, before: str = "") -> Runner:
    """A story whose only caption, in its last line but one, has a chart."""
    text = f'{HEAD}{before}[[line]]\nsay = "It is {{height}} up."\nchart = {{ {chart} }}\n{END}'
    told = story(text)
    return Runner(told, stage_of(told, StoryBall))


def shown(runner: Runner) -> Comparison:
    """What its chart shows now."""
    found = runner.charts.comparison(len(runner.story.lines) - 2)
    assert found is not None
    return found


def test_a_curve_has_the_readout_of_each_step():
    runner = begun('measured = "height", expected = 3, over = "time"')
    heights = []
    for _ in range(90):
        heights.append({one.name: one.value for one in runner.stage.scene.readouts()}["height"])
        runner.stage.run(1)
    found = shown(runner)
    every = max(1, round(1.0 / (60.0 * runner.stage.dt)))
    assert found.measured[:, 1].tolist() == heights[::every]
    assert found.measured[:, 0] == pytest.approx(np.arange(0, 90, every) * runner.stage.dt)
    assert set(found.expected[:, 1]) == {3.0}
    assert (found.names, found.unit, found.over_unit) == (("height", "expected"), "m", "s")


def test_a_curve_begins_at_its_moment():
    runner = begun('measured = "height", expected = "energy", over = "time", since = "one"', TURN)
    assert runner.charts.comparison(1) is None
    while (
        "one" not in runner.course.reached or runner.stage.time_s < runner.course.reached["one"].time_s + 0.2
    ):
        runner.stage.run(1)
    assert shown(runner).measured[0, 0] == runner.course.reached["one"].time_s


def test_a_curve_begins_again_where_its_axis_does():
    """Height falls, then rises from each bounce: along it a curve begins anew at the top of each."""
    runner = begun('measured = "bounces", expected = 1, over = "height"')
    runner.stage.run(round(4.0 / runner.stage.dt))
    places = shown(runner).measured[:, 0]
    assert len(places) < 120 and (np.diff(places) >= 0.0).all()


def test_a_mark_is_what_is_so_now():
    runner = begun('measured = "height", expected = "energy", names = ["up", "by energy"]')
    runner.stage.run(31)
    found = shown(runner)
    assert found.measured.shape == found.expected.shape == (1, 2) and found.over == ""
    assert found.names == ("up", "by energy")
    assert found.measured[0, 1] != found.expected[0, 1]


def test_after_a_step_back_the_curve_is_as_if_nobody_had_touched_it():
    chart = 'measured = "height", expected = 3, over = "time"'
    runner, alone = begun(chart), begun(chart)
    alone.stage.run(120)
    runner.stage.run(110)
    runner.take_over()
    runner.stage.run(40)
    runner.return_to(60)
    assert shown(runner).measured[-1, 0] <= 60.0 * runner.stage.dt + 1e-12
    runner.stage.run(60)
    np.testing.assert_array_equal(shown(runner).measured, shown(alone).measured)


def test_marks_beside_a_number_of_the_caption_stay_as_the_number_does():
    runner = begun('measured = "height", expected = 3')
    runner.stage.run(1)
    (caption,) = runner.course.captions()
    first = shown(runner).measured[0, 1]
    runner.stage.run(40)
    assert shown(runner).measured[:, 1].tolist() == [first]
    assert f"{first:.2g}"[:3] in caption.text
    live = Runner(
        told := story(f'{HEAD}[[line]]\nsay = "a"\nchart = {{ measured = "height", expected = 3 }}\n{END}'),
        stage_of(told, StoryBall),
    )
    live.stage.run(41)
    assert live.charts.comparison(0).measured[0, 1] != first


class Weighed(StoryBall):
    """It gives a comparison of its own."""

    def story_charts(self):
        rows = np.zeros((int(self.ball.bounces[0]), 2))
        return {"weight": Comparison(rows, np.ones((5, 2)), ("a", "b"), over="c", single=True)}


def test_a_scene_gives_a_chart_of_its_own_once_it_has_measured():
    runner = Runner(
        told := story(f'{HEAD}[[line]]\nsay = "a"\nchart = {{ shows = "weight" }}\n{END}'),
        stage_of(told, Weighed),
    )
    assert runner.charts.comparison(0) is None
    runner.stage.run(round(2.0 / runner.stage.dt))
    found = runner.charts.comparison(0)
    assert found is not None and len(found.expected) == 5


@pytest.mark.parametrize(
    ("chart", "reason"),
    [
        ('measured = "height"', "expected measured and expected, or shows"),
        ('shows = "a", measured = "height"', "names everything that is drawn"),
        ('measured = "height", expected = 1, since = "x"', "no moment is called 'x'"),
        ('measured = "height", expected = nan', "not a finite number"),
        ('measured = "height", expected = 1, corner = "middle"', "corner"),
        ('shows = "a"', "'a' is no chart of this scene"),
        ('measured = "hight", expected = 1', "'hight' is no readout"),
        ('measured = "height", expected = "x"', "'x' is no readout"),
        ('measured = "height", expected = 1, over = "x"', "'x' is no readout"),
    ],
)
def test_mistakes_are_answered(chart: str, reason: str):
    with pytest.raises(LevelError, match=reason):
        begun(chart)


def test_a_curve_of_means_goes_back_as_far_as_it_says():
    plain = begun('measured = "height", expected = 3, over = "time"')
    smooth = begun('measured = "height", expected = 3, over = "time", mean = 0.5')
    for runner in (plain, smooth):
        runner.stage.run(round(1.5 / runner.stage.dt))
    (at, heights), means = shown(plain).measured.T, shown(smooth).measured
    assert means[:, 0].tolist() == at.tolist()
    expected = [heights[(at <= end) & (at >= end - 0.5)].mean() for end in at]
    assert means[:, 1] == pytest.approx(expected)
    assert means[0, 1] == heights[0]
    with pytest.raises(LevelError, match=r"chart\.mean"):
        begun('measured = "height", expected = 3, mean = 0.5')
