"""A session as a recording that can be kept and replayed."""

from __future__ import annotations

from game.levels import Level, format_level
from game.stage.records.recording import Recording, RecordingError
from game.stage.session import Session


def recording_of(session: Session, level: Level | None) -> Recording:
    """The session so far, which began with a level; RecordingError if it was not recorded whole."""
    if not session.recorded or not session.timeline.whole:
        raise RecordingError(None, "events", "this session was not recorded from its beginning")
    scene, (values, active, dt) = session.scene, session.start
    return Recording(
        scene=scene.name,
        level=format_level(level) if level is not None else None,
        seed=scene.seed,
        dt=dt,
        parameters=values,
        effects_off=[effect.name for effect in scene.effects if effect not in active],
        events=session.timeline.past(),
        checks=session.checks,
        steps=session.step,
        digest=session.digest(),
    )
