"""Whatever is thrown at a stage: it refuses or goes on, stays finite, replays, and steps back exactly."""

from __future__ import annotations

import math

from hypothesis import given, settings
from hypothesis import strategies as st

from game.stage import Action, ParameterError, Pointer, SetEffect, SetParameter, Stage, replay_scene
from game.stage.watch import FiniteWatch
from tests.stage.example_scene import BouncingBall
from tests.stage.odd_scenes import Cloud, Fragile

coordinates = st.floats(-1e3, 1e3) | st.sampled_from([0.0, -0.0, 1e300, 5e-324, math.nan, math.inf])
pointers = st.builds(
    Pointer,
    st.sampled_from(["move", "down", "up", "wheel", "cancel"]),
    coordinates,
    coordinates,
    button=st.integers(0, 3),
)
names = st.sampled_from(
    [
        *BouncingBall.declared_parameters(),
        *Cloud.declared_parameters(),
        *Fragile.declared_parameters(),
        "nothing",
        "test-ground",
        "test-gravity",
    ]
)
numbers = st.floats() | st.sampled_from([0.0, 1.0, 0.5, 3.0, 7, 100.0, 1e-4, 0.1, 1e6, 1e9])
events = st.one_of(
    pointers,
    st.builds(SetParameter, names, numbers | st.booleans() | st.text(max_size=3)),
    st.builds(SetEffect, names, st.booleans()),
    st.builds(Action, st.sampled_from(["kick", "burst", "clear", "nan", "raise", "refuse", "fly"])),
)
moves = st.one_of(
    events,
    st.floats(0.0, 0.2),
    st.integers(0, 40),
    st.sampled_from(["back", "step", "pause", "resume", "reset", "slow", "fast"]),
)
scenes = st.sampled_from([BouncingBall, Cloud, Fragile])


def do(stage: Stage, move) -> None:
    """Carry out one move: an event, a frame, a run, or a word for the transport."""
    if isinstance(move, float):
        stage.advance(move)
    elif isinstance(move, int):
        stage.run(move)
    elif isinstance(move, str):
        {
            "back": stage.step_back,
            "step": stage.step,
            "pause": stage.pause,
            "resume": stage.resume,
            "reset": stage.reset,
            "slow": lambda: setattr(stage, "speed", 1 / 16),
            "fast": lambda: setattr(stage, "speed", 4),
        }[move]()
    else:
        before = stage.digest(), dict(stage.scene.values), stage.scene.active
        try:
            stage.post(move)
        except ParameterError as error:
            assert "\n" not in str(error)
            assert (stage.digest(), stage.scene.values, stage.scene.active) == before


@settings(max_examples=120)
@given(scenes, st.lists(moves, max_size=25))
def test_it_stays_finite_and_replays(scene, script) -> None:
    stage = Stage(scene)
    for move in script:
        do(stage, move)
        assert FiniteWatch(scene.may_be_infinite).first_bad(stage.scene.state()) is None
        assert 0.0 <= stage.alpha < 1.0
        assert stage.time_s >= 0.0
    again = replay_scene(stage.recording, scene)
    assert again.digest() == stage.digest()
    assert again.scene.values == stage.scene.values
    assert again.scene.active == stage.scene.active


@settings(max_examples=60)
@given(scenes, st.lists(moves, max_size=12), st.integers(1, 60))
def test_back_and_forth(scene, script, steps) -> None:
    stage = Stage(scene)
    for move in script:
        do(stage, move)
    stage.resume()
    if stage.fault is not None:
        return
    end, digest, recording = stage.step_number, stage.digest(), stage.recording
    for _ in range(steps):
        if not stage.step_back():
            break
    stage.resume()
    stage.run(end - stage.step_number)
    assert stage.digest() == digest
    assert stage.recording == recording


@settings(max_examples=60)
@given(scenes, st.lists(events, max_size=8), st.lists(st.floats(0.0, 0.12), min_size=1, max_size=30))
def test_frames_may_be_split_anyhow(scene, script, frames) -> None:
    """The same events at the same steps, reached by frames of any lengths or by runs."""
    stage = Stage(scene)
    waiting = list(script)
    for frame in frames:
        if waiting:
            do(stage, waiting.pop(0))
        stage.advance(frame)
    again = replay_scene(stage.recording, scene)
    assert again.digest() == stage.digest()
