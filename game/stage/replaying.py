"""Playing a recording again, and finding out whether it goes the same way."""

from __future__ import annotations

from game.levels import LevelError, parse_level
from game.stage.catalogue import Catalogue
from game.stage.parameters import ParameterError
from game.stage.records.excerpt import Excerpt
from game.stage.records.recording import Recording, RecordingError
from game.stage.scene import Scene
from game.stage.stage import Stage


def replay(recording: Recording, catalogue: Catalogue, *, check: bool = True, record: bool = True) -> Stage:
    """A stage that has gone through a recorded session, standing at its end.

    RecordingError if the scene is unknown or refuses what the recording says; or, with ``check``, at the
    first step whose digest differs.
    """
    try:
        scene_type = catalogue[recording.scene].load()
    except KeyError as error:
        raise RecordingError(None, "scene", str(error.args[0])) from None
    return replay_scene(recording, scene_type, check=check, record=record)


def replay_scene(
    recording: Recording, scene_type: type[Scene], *, check: bool = True, record: bool = True
) -> Stage:
    """The same, RecordingError included, for a scene class at hand."""
    stage = begin(recording, scene_type, record=record)
    checks = {item.step: item.digest for item in recording.checks} if check else {}
    events = iter(recording.events)
    coming = next(events, None)
    for step in range(recording.steps + 1):
        if step:
            stage.run(1)
            if stage.fault is not None:
                raise RecordingError(None, f"step {step}", stage.fault.message)
        if step in checks and stage.digest() != checks[step]:
            raise RecordingError(None, f"step {step}", "the replay went another way (digests differ)")
        while coming is not None and coming.step == step:
            try:
                stage.post(coming.event)
            except ParameterError as error:
                raise RecordingError(None, f"event at step {step}", str(error)) from None
            coming = next(events, None)
    if check and stage.digest() != recording.digest:
        raise RecordingError(None, f"step {recording.steps}", "the replay ended otherwise (digests differ)")
    return stage


def begin(recording: Recording, scene_type: type[Scene], *, record: bool = True) -> Stage:
    """A stage at the beginning of a recorded session, nothing played yet; RecordingError."""
    try:
        level = None
        if recording.level is not None:
            level = parse_level(recording.level, scene_type.name, scene_type.content_type)
        active = scene_type.effects
        for name in recording.effects_off:
            active = active.without(scene_type.effect(name))
        return Stage(
            scene_type,
            level=level,
            parameters=recording.parameters,
            effects=active,
            seed=recording.seed,
            dt=None if "step_length" in recording.parameters else recording.dt,
            record=record,
        )
    except LevelError as error:
        raise RecordingError(None, f"level.{error.field}".rstrip("."), error.reason) from None
    except ParameterError as error:
        raise RecordingError(None, "parameters", str(error)) from None
    except ValueError as error:
        raise RecordingError(None, "", str(error)) from None


def recording_of_excerpt(scene_type: type[Scene], excerpt: Excerpt) -> Recording:
    """The excerpt played from its level and recorded; RecordingError if it cannot be."""
    try:
        stage = Stage(scene_type, level=excerpt.level, effects=excerpt.active, seed=excerpt.seed)
        for event in excerpt.events:
            stage.post(event)
    except ValueError as error:
        raise RecordingError(None, excerpt.name, str(error)) from None
    stage.run(excerpt.steps)
    if stage.fault is not None:
        raise RecordingError(None, excerpt.name, stage.fault.message)
    return stage.recording
