"""Stepping back and forward again: whatever happened, the same states come back."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.stage import Action, Param, Pointer, Scene, SetEffect, SetParameter, Stage
from game.stage.records.recording import CHECK_INTERVAL
from game.stage.states import snapshots
from tests.stage.example_scene import KICK, BouncingBall
from tests.stage.odd_scenes import BURST, Cloud

CLOUD_EVENTS = [
    SetParameter("births", 0.9),
    Pointer("down", 0.5, 0.5, 1),
    Pointer("move", 0.7, 0.1, 1),
    BURST,
    SetParameter("step_length", 0.02),
    Pointer("up", 0.7, 0.1, 1),
    SetParameter("first", 20),
    Action("clear"),
    BURST,
    SetParameter("step_length", 0.005),
]
BALL_EVENTS = [
    SetParameter("gravity", 2.0),
    KICK,
    SetEffect("test-ground", False),
    Pointer("down", 0.0, 3.0, 1),
    Pointer("move", 1.0, 3.0, 1),
    Pointer("up", 1.0, 3.0, 1),
    SetParameter("height", 7.0),
    SetEffect("test-ground", True),
    SetParameter("frozen", True),
    SetParameter("frozen", False),
]


class Ticks(NamedTuple):
    """ticks (1,)."""

    ticks: np.ndarray


class Shaded(Scene):
    """Keeps something of its own that is made from a parameter, beside the state."""

    name, title = "shaded", "Shaded"
    shade = Param(0.25, 0.0, 1.0)

    def build(self, level) -> None:
        self.ticks, self.shades = np.zeros(1), np.zeros(2)
        self.parameter_changed("shade")

    def parameter_changed(self, name: str) -> None:
        if name == "shade":
            self.shades[:] = self.shade, 1.0 - self.shade

    def advance(self, dt: float) -> None:
        self.ticks += 1.0

    def state(self) -> Ticks:
        return Ticks(self.ticks)


def test_what_is_made_from_a_parameter_goes_back_with_it():
    stage = Stage(Shaded)
    stage.run(5)
    stage.post(SetParameter("shade", 0.75))
    stage.run(5)
    assert stage.scene.shades.tolist() == [0.75, 0.25]
    scene = stage.scene
    for step in range(9, 2, -1):
        assert stage.step_back()
        shade = 0.75 if step >= 5 else 0.25  # at once, not a step later
        assert (stage.scene.shade, stage.scene.shades.tolist()) == (shade, [shade, 1.0 - shade])
    assert stage.scene is scene  # no parameter has changed for which it is built again


@pytest.mark.parametrize(("scene", "events"), [(BouncingBall, BALL_EVENTS), (Cloud, CLOUD_EVENTS)])
@pytest.mark.parametrize("gap", [1, 7, 45])
class TestThereAndBack:
    def play(self, scene, events, gap: int) -> tuple[Stage, list[tuple[str, float, dict]]]:
        stage = Stage(scene)
        seen = []
        for event in events:
            stage.post(event)
            for _ in range(gap):
                stage.step()
                seen.append((stage.digest(), stage.time_s, dict(stage.scene.values)))
        return stage, seen

    def test_each_step_back_undoes_one_step_and_its_events(self, scene, events, gap) -> None:
        stage, seen = self.play(scene, events, gap)
        stage.post(events[0])  # undone by the first step back
        for step in range(len(seen) - 1, 0, -1):
            assert stage.step_back()
            assert stage.step_number == step
            digest, time_s, values = seen[step - 1]
            if step % gap == 0:
                continue  # the events of this step have acted again, as they had before the step after it
            assert (stage.digest(), stage.time_s, stage.scene.values) == (digest, time_s, values)

    def test_forward_again_repeats_everything(self, scene, events, gap) -> None:
        stage, seen = self.play(scene, events, gap)
        end, recording = stage.digest(), stage.recording
        for _ in range(min(len(seen), 100)):
            stage.step_back()
        stage.run(len(seen) - stage.step_number)
        assert stage.digest() == end
        assert stage.recording == recording
        assert stage.time_s == seen[-1][1]

    def test_it_ends_at_the_beginning(self, scene, events, gap) -> None:
        stage, _ = self.play(scene, events[:3], gap)
        begin = Stage(scene)
        begin.post(events[0])
        while stage.step_back():
            pass
        assert stage.step_number == 0
        assert stage.digest() == begin.digest()
        assert not stage.step_back()


class TestAnotherWay:
    def test_a_new_event_drops_what_was_to_come(self) -> None:
        stage, twin = Stage(BouncingBall), Stage(BouncingBall)
        stage.run(50)
        stage.post(KICK)
        stage.run(300)
        for _ in range(320):
            stage.step_back()
        stage.post(SetParameter("gravity", 1.0))
        stage.run(400)
        twin.run(30)
        twin.post(SetParameter("gravity", 1.0))
        twin.run(400)
        assert stage.digest() == twin.digest()
        assert stage.recording == twin.recording

    @pytest.mark.parametrize("interval", [30, 1000])  # snapshots of later steps, or digests alone
    def test_without_later_events_it_drops_the_states_that_were_to_come(self, interval, monkeypatch) -> None:
        monkeypatch.setattr(snapshots, "INTERVAL", interval)
        stage, twin = Stage(BouncingBall), Stage(BouncingBall)
        stage.run(3 * CHECK_INTERVAL)
        while stage.step_number > CHECK_INTERVAL - 20:
            stage.step_back()
        twin.run(CHECK_INTERVAL - 20)
        for each in (stage, twin):
            each.post(SetParameter("gravity", 1.0))
            each.run(4 * CHECK_INTERVAL)
        assert stage.recording == twin.recording
        for _ in range(4 * CHECK_INTERVAL - 1):
            assert stage.step_back() and twin.step_back()
            assert stage.digest() == twin.digest()

    def test_a_drag_whose_end_is_dropped_is_cancelled(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(Pointer("down", 0.0, 1.0, 1))
        stage.run(5)
        stage.post(Pointer("up", 0.0, 1.0, 1))
        stage.run(5)
        for _ in range(8):
            stage.step_back()
        assert stage.scene.held
        stage.post(SetParameter("gravity", 1.0))
        assert not stage.scene.held
        kinds = [getattr(stamped.event, "kind", "knob") for stamped in stage.recording.events]
        assert kinds == ["down", "cancel", "knob"]

    def test_a_drag_that_goes_on_is_not(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(Pointer("down", 0.0, 1.0, 1))
        stage.run(5)
        stage.post(Pointer("move", 0.5, 1.0, 1))
        stage.run(5)
        stage.step_back()
        for _ in range(6):
            stage.step_back()
        stage.post(Pointer("move", 0.9, 1.0, 1))
        assert stage.scene.held

    def test_a_refused_event_changes_nothing_but_the_future(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(20)
        stage.step_back()
        digest = stage.digest()
        with pytest.raises(ValueError, match="gravity"):
            stage.post(SetParameter("gravity", -1.0))
        assert stage.digest() == digest
        assert stage.recording.events == []


class TestMemory:
    def test_what_the_scene_keeps_beside_its_state_goes_back_as_well(self) -> None:
        stage = Stage(Cloud)
        stage.run(40)
        log, trail, time_s = list(stage.scene.log), list(stage.scene.trail), stage.time_s
        stage.post(BURST)
        stage.run(35)
        for _ in range(36):
            stage.step_back()
        stage.step()
        assert (stage.scene.log[: len(log)], list(stage.scene.trail)) == (log, trail)
        assert stage.time_s == time_s

    def test_without_a_recording_it_still_goes_back(self) -> None:
        stage = Stage(Cloud, record=False)
        digests = []
        for _ in range(200):
            stage.post(BURST)
            stage.step()
            digests.append(stage.digest())
        for step in range(199, 100, -1):
            stage.step_back()
            assert stage.step_number == step
        stage.run(99)
        assert stage.digest() == digests[-1]
