"""Edits of a motion, each giving another one: keys made, moved, bent, deleted. And a motion as arrays."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary
from game.scenes.key_frames import level
from game.scenes.key_frames.level import KeyEntry, Motion, Point

AUTOMATIC, SMOOTH, CORNER = 0.0, 1.0, 2.0  # how a key's velocities come about
COLUMNS = 9  # time, x, y, angle, velocity after, velocity before, kind


def ordered(motion: Motion) -> Motion:
    """The same with its keys sorted by time; of equal times the order is kept."""
    return _with_keys(motion, sorted(motion.keys, key=lambda key: key.time))


def limited(point: Point, most: float = level.FARTHEST) -> Point:
    """A point or velocity within what a level file may hold."""
    return min(max(point[0], -most), most) + 0.0, min(max(point[1], -most), most) + 0.0


def with_key(motion: Motion, key: KeyEntry) -> tuple[Motion, int]:
    """A key more, behind those of its time; its number. ValueError if there is no space."""
    if len(motion.keys) >= level.MOST_KEYS:
        raise ValueError(f"at most {level.MOST_KEYS} key-frames")
    place = sum(other.time <= key.time for other in motion.keys)
    return _with_keys(motion, [*motion.keys[:place], key, *motion.keys[place:]]), place


def with_key_at_end(motion: Motion, point: Point, angle: float, closed: bool) -> tuple[Motion, int]:
    """A key after the last one; all are moved together so that it fits into the second.

    A closed curve keeps the time of one piece to go back to the first key.
    """
    if len(motion.keys) >= level.MOST_KEYS:
        raise ValueError(f"at most {level.MOST_KEYS} key-frames")
    count = len(motion.keys)
    pieces = count + closed
    last = motion.keys[-1].time
    squeeze = (count - 1) / pieces / last if last > 0.0 else 0.0
    keys = [msgspec.structs.replace(key, time=min(key.time * squeeze, 1.0)) for key in motion.keys]
    keys.append(KeyEntry(time=count / pieces, position=limited(point), angle=angle))
    return _with_keys(motion, keys), count


def without_key(motion: Motion, index: int) -> Motion:
    """A key less. ValueError if it is the only one."""
    if len(motion.keys) == 1:
        raise ValueError("one key-frame has to stay")
    return _with_keys(motion, [*motion.keys[:index], *motion.keys[index + 1 :]])


def with_change(motion: Motion, index: int, **changes: object) -> Motion:
    """A key with other values, at the time that it has."""
    keys = list(motion.keys)
    keys[index] = msgspec.structs.replace(keys[index], **changes)
    return _with_keys(motion, keys)


def with_time(motion: Motion, index: int, time: float) -> tuple[Motion, int]:
    """A key at another time, and its number then."""
    keys = list(motion.keys)
    keys[index] = msgspec.structs.replace(keys[index], time=min(max(time, 0.0), 1.0) + 0.0)
    order = sorted(range(len(keys)), key=lambda i: keys[i].time)
    return _with_keys(motion, [keys[i] for i in order]), order.index(index)


def with_velocity(motion: Motion, index: int, velocity: Point, before: bool, corner: bool) -> Motion:
    """A key with a velocity dragged at one side; a corner keeps the one at the other side."""
    key, velocity = motion.keys[index], limited(velocity, level.FASTEST)
    if not corner and key.velocity_before is None:
        return with_change(motion, index, velocity=velocity)
    after = key.velocity if key.velocity is not None else velocity
    other = key.velocity_before if key.velocity_before is not None else after
    if before:
        return with_change(motion, index, velocity=after, velocity_before=velocity)
    return with_change(motion, index, velocity=velocity, velocity_before=other)


def nearest_angle(angle: float, to: float) -> float:
    """The angle (degrees) plus whole turns that is nearest to another one, within what a file may hold."""
    turned = angle + 360.0 * round((to - angle) / 360.0)
    return min(max(turned, -level.MOST_TURNED), level.MOST_TURNED) + 0.0


# -- as arrays ------------------------------------------------------------------------------------------


def as_rows(motion: Motion) -> Floats:
    """Keys (n, 9): time, position, angle (degrees), velocity after, velocity before, how they come about."""
    rows = np.zeros((len(motion.keys), COLUMNS))
    for row, key in zip(rows, motion.keys, strict=True):
        kind = AUTOMATIC if key.velocity is None else SMOOTH if key.velocity_before is None else CORNER
        after = key.velocity or (0.0, 0.0)
        row[:] = (key.time, *key.position, key.angle, *after, *(key.velocity_before or after), kind)
    return rows


def from_rows(motion: Motion, rows: Floats, timing: Floats) -> Motion:
    """The motion with the keys that `as_rows` gave, and another timing curve."""
    keys = []
    for time, x, y, angle, vx, vy, ux, uy, kind in rows.tolist():
        keys.append(
            KeyEntry(
                time=time,
                position=(x, y),
                angle=angle,
                velocity=None if kind == AUTOMATIC else (vx, vy),
                velocity_before=(ux, uy) if kind == CORNER else None,
            )
        )
    four = tuple(timing.tolist())
    return msgspec.structs.replace(_with_keys(motion, keys), timing=four)


def angle_at(center: Point, point: Point) -> float:
    """Angle (degrees) of the direction from one point to another."""
    return math.degrees(elementary.atan2(point[1] - center[1], point[0] - center[0]))


def _with_keys(motion: Motion, keys: list[KeyEntry]) -> Motion:
    return msgspec.structs.replace(motion, keys=tuple(keys))
