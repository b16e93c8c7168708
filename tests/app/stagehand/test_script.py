"""Scripts: events at their very steps, in any slices of time."""

import example_scene
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.app.stagehand.script import Script, demo_of, demo_steps
from game.stage import Action, Decision, Pointer, SetParameter, Stage, Stamped, replay_scene

EVENTS = (
    Stamped(0, SetParameter("gravity", 5.0)),
    Stamped(10, Pointer("down", 0.0, 2.0, 1)),
    Stamped(25, Pointer("up", 0.3, 2.0, 1)),
    Stamped(25, Action("kick")),
    Stamped(60, Action("kick")),
)


def straight() -> str:
    """Digest after 100 steps, events posted by hand."""
    stage = Stage(example_scene.BouncingBall)
    for step in range(100):
        for stamped in EVENTS:
            if stamped.step == step:
                stage.post(stamped.event)
        stage.run(1)
    return stage.digest()


@given(frames=st.lists(st.floats(0.0, 0.1), min_size=1, max_size=60), speed=st.sampled_from([0.25, 1.0, 4.0]))
def test_any_frames_give_the_same_state(frames: list[float], speed: float):
    stage = Stage(example_scene.BouncingBall)
    stage.speed = speed
    script = Script(stage, EVENTS)
    for elapsed in frames:
        before = stage.step_number
        assert script.advance(elapsed) == stage.step_number - before <= stage.clock.max_steps + 1
        if stage.step_number >= 80:
            break
    script.run(100 - stage.step_number)
    assert (stage.step_number, stage.digest()) == (100, straight())
    assert [s.step for s in stage.recording.events] == [s.step for s in EVENTS]


def test_paused_stage_stands_still():
    stage = Stage(example_scene.BouncingBall)
    script = Script(stage, EVENTS)
    stage.pause()
    assert script.advance(1.0) == 0
    assert not script.finished


def test_script_ends_where_the_scene_is_stopped():
    stage = Stage(example_scene.BouncingBall)
    script = Script(stage, ())
    stage.scene.ball.position[0] = float("inf")
    script.run(100)
    assert stage.fault is not None
    assert script.advance(0.1) == 0


def test_length_of_a_demo(monkeypatch: pytest.MonkeyPatch):
    scene_type = example_scene.BouncingBall
    assert demo_of(scene_type) == ()
    assert demo_steps(scene_type, 0.01) == 1200
    monkeypatch.setattr(scene_type, "demo", EVENTS, raising=False)
    assert demo_of(scene_type) == EVENTS
    assert demo_steps(scene_type, 0.01) == 60 + 800


class SelfKicker(example_scene.BouncingBall):
    """The ball with a player of its own, who kicks it whenever it comes down."""

    def decisions(self, at_once=False):
        return [Decision("kick", ())] if at_once and self.ball.velocity[1] < -2.0 else []

    def decide(self, event):
        self.ball.velocity[1] = 3.0


def test_players_have_their_say_before_each_step_however_it_is_played():
    digests = set()
    for frames in (1, 7, 90):
        stage = Stage(SelfKicker)
        script = Script(stage, EVENTS[:1], players=True)
        while stage.step_number < 60:
            script.advance(0.0123 * frames / 90)
        script.run(200 - stage.step_number)
        digests.add(stage.digest())
        kicks = [stamped for stamped in stage.recording.events if isinstance(stamped.event, Decision)]
        assert len(kicks) > 1
    assert len(digests) == 1
    assert replay_scene(stage.recording, SelfKicker).digest() == stage.digest()
