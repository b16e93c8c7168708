"""The lecture's table is heard: each impact once, in its place, whatever the frames' lengths."""

from game.app.stagehand.opening import Opening
from game.scenes.lecture_table.scene import LectureTable
from game.stage import Stage
from tests.scenes.listening import heard_in


def make_stage() -> Stage:
    return Opening().make_stage(LectureTable)


def test_every_impact_is_heard_once_at_any_frame_rate():
    slow, fast = heard_in(make_stage(), [6] * 60), heard_in(make_stage(), [1] * 360)
    assert slow == fast
    kinds = {kind for kind, _ in fast}
    assert {"tip", "ball", "cushion"} <= kinds
    assert sum(kind == "tip" for kind, _ in fast) == 1


def test_an_impact_is_as_loud_as_it_was_fast():
    stage = make_stage()
    heard = heard_in(stage, [1] * 360)
    white = max(speed for kind, speed in heard if kind == "tip")
    first = max(speed for kind, speed in heard if kind == "ball")
    assert 0.8 * white < first < 2.0 * white  # the impulse of a head-on impact is the mass times the speed
    assert all(0.0 < speed <= 2.0 * white for _, speed in heard)
