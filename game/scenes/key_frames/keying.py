"""Keys made at the present time, and joints made corners: edits that need to know the curve."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.key_frames import editing
from game.scenes.key_frames.level import FASTEST, KeyEntry, Motion, Point
from game.scenes.key_frames.model import KeyFrameModel

SAME_TIME = 0.004  # s: a key so near to the present time is meant by "now"


def key_now(model: KeyFrameModel) -> int:
    """The key at the time that is shown, made if there is none; -1 if there is no space."""
    part = model.player.shown_part()
    time, pose = model.animation().key_time(part), model.animation().pose(part)
    for i, key in enumerate(model.motion.keys):
        if abs(key.time - time) <= SAME_TIME:
            return i
    return _insert(model, time, (float(pose[0]), float(pose[1])), math.degrees(pose[2]), True)


def insert_here(model: KeyFrameModel) -> None:
    """A key here and now, as one edit."""
    document = model.document
    before = document.edit()
    document.choose(key_now(model))
    if document.motion is not before.motion:
        document.note(before)


def new_key(model: KeyFrameModel, point: Point) -> None:
    """The box is at a point now; if this time has a key already, there at the end."""
    document, part = model.document, model.player.shown_part()
    time, angle = model.animation().key_time(part), math.degrees(model.animation().pose(part)[2])
    if all(abs(key.time - time) > SAME_TIME for key in model.motion.keys):
        _insert(model, time, point, angle, False)
        return
    last = model.motion.keys[-1]
    try:
        motion, index = editing.with_key_at_end(model.motion, point, last.angle, model.parameters.closed)
    except ValueError as error:
        document.refuse(error)
        return
    document.motion = motion
    document.choose(index)


def _insert(model: KeyFrameModel, time: float, point: Point, angle: float, on_curve: bool) -> int:
    """A key at a time; one on a Bezier curve gets the curve's velocity, so that the curve stays as it is."""
    document, velocity = model.document, None
    if on_curve and model.parameters.interpolation == "bezier":
        rate = model.animation().track.rate(model.motion.start + time)
        velocity = editing.limited((float(rate[0]), float(rate[1])), FASTEST)
        document.motion = _with_velocities(model)
    before = min(model.motion.keys, key=lambda key: abs(key.time - time))
    entry = KeyEntry(
        time=time,
        position=editing.limited(point),
        angle=editing.nearest_angle(angle, before.angle),
        velocity=velocity,
    )
    try:
        document.motion, index = editing.with_key(model.motion, entry)
    except ValueError as error:
        document.refuse(error)
        return -1
    document.choose(index)
    return index


def _with_velocities(model: KeyFrameModel) -> Motion:
    """The motion with the velocities of all keys said, that were found from their neighbours before."""
    motion, animation = model.motion, model.animation()
    handles = animation.handles()
    for i, key in enumerate(motion.keys):
        sides = [side for side in (1, 0) if np.isfinite(handles[i, side]).all()]
        if key.velocity is None and sides:
            arm = handles[i, sides[0]] - key.position
            scale = (3.0 if sides[0] else -3.0) / animation.gap(i, not sides[0])
            velocity = editing.limited((float(arm[0]) * scale, float(arm[1]) * scale), FASTEST)
            motion = editing.with_change(motion, i, velocity=velocity)
    return motion


def toggle_corner(model: KeyFrameModel) -> None:
    """Make the joint of the chosen key a corner, or smooth again."""
    document, chosen = model.document, model.document.chosen
    if chosen < 0:
        return
    key = model.motion.keys[chosen]
    if key.velocity_before is not None:
        document.change(editing.with_change(model.motion, chosen, velocity_before=None))
        return
    animation = model.animation()
    after = animation.handles()[chosen, 1] - key.position
    gap = animation.gap(chosen, before=False)
    velocity = key.velocity
    if velocity is None and gap > 0.0 and np.isfinite(after).all():
        x, y = (after * (3.0 / gap)).tolist()
        velocity = editing.limited((x, y), FASTEST)
    if velocity is not None:
        change = {"velocity": velocity, "velocity_before": velocity}
        document.change(editing.with_change(model.motion, chosen, **change))
