"""The timeline: events keep their numbers when earlier ones are dropped."""

from __future__ import annotations

from game.physics.effects import EffectSet
from game.stage import Action, SetEffect, Stage
from game.stage.events import Stamped
from game.stage.timeline import Timeline
from tests.stage.example_scene import BouncingBall


def names(stamped: list[Stamped]) -> list[str]:
    return [one.event.name for one in stamped if isinstance(one.event, Action)]


def test_what_is_dropped_several_at_a_time_counts_on():
    timeline = Timeline()
    for step in range(10):
        timeline.add(step, Action(str(step)))
    for number in (3, 7, 5, 7):  # what is dropped already is not dropped again
        timeline.drop_before(number)
    assert len(timeline) == timeline.acted == 10
    assert names(timeline.past()) == ["7", "8", "9"]
    assert not timeline.whole and not timeline.has_future
    timeline.acted = 8
    assert timeline.has_future and names(timeline.past()) == ["7"]
    assert [timeline.due(step) for step in (7, 8, 9)] == [None, Action("8"), Action("9")]
    timeline.add(9, Action("last"))
    assert len(timeline) == 11 and names(timeline.past()) == ["7", "8", "9", "last"]


def test_a_new_event_ends_the_future_where_earlier_events_were_dropped():
    timeline = Timeline()
    for step in range(6):
        timeline.add(step, Action(str(step)))
    timeline.drop_before(2)
    timeline.acted = 4
    timeline.add(4, Action("other"))
    assert len(timeline) == timeline.acted == 5 and not timeline.has_future
    assert names(timeline.past()) == ["2", "3", "other"]


def test_what_is_dropped_from_a_number_on_is_gone_whether_it_has_acted_or_not():
    timeline = Timeline()
    for step in range(6):
        timeline.add(step, Action(str(step)))
    timeline.drop_before(2)
    timeline.acted = 5
    timeline.drop_from(4)
    assert len(timeline) == timeline.acted == 4 and names(timeline.past()) == ["2", "3"]
    timeline.acted = 3
    timeline.drop_from(4)
    assert timeline.has_future and len(timeline) == 4


class Listening(BouncingBall):
    """Keeps what its effects were when it was last told of a change, as a scene set up by them does."""

    set_up: EffectSet | None = None
    times = 0

    def effects_changed(self) -> None:
        Listening.set_up, Listening.times = self.active, Listening.times + 1


def test_a_scene_is_told_of_effects_that_a_step_back_restores():
    stage = Stage(Listening)
    stage.run(2)
    before = stage.scene.active
    stage.post(SetEffect("test-ground", False))
    stage.run(1)
    assert Listening.times == 1 and Listening.set_up == stage.scene.active != before
    stage.step_back()
    stage.step_back()
    assert stage.scene.active == before
    assert Listening.times > 1 and Listening.set_up == before
