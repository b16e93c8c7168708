"""The hand in the key-framing scene: keys, handles, the box itself, the timeline, the timing curve.

The scene keeps ``hand`` (what is held, and its number) and ``grip`` (from the pointer to it, m) as plain
attributes, and ``before``, the edit that a drag began from, so that one drag is one thing to undo.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.physics.animation import EASING
from game.scenes.key_frames import editing
from game.scenes.key_frames.document import NOTHING
from game.scenes.key_frames.level import KeyEntry, Point
from game.scenes.key_frames.timeline import places_of, time_at, x_of
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.key_frames.scene import KeyFraming

SAME_TIME = 0.004  # s: a key so near to the present time is meant by "now"
ARM = 0.45  # m beyond the box's end: where the handle is that turns it
SNAP = 15.0  # degrees, with Ctrl


def turning_handle(scene: KeyFraming, x: float, y: float, angle: float) -> Point:
    """Where the handle is that turns a box with this pose (m, rad)."""
    arm = 0.5 * scene.motion.box[0] + ARM
    return x + arm * math.cos(angle), y + arm * math.sin(angle)


def take_pointer(scene: KeyFraming, event: Pointer) -> None:
    """A pointer event in world coordinates."""
    point = editing.limited((event.x, event.y))
    if event.kind == "down":
        scene.let_go()
    if event.kind == "down" and event.button == 1:
        _press(scene, point)
    elif event.kind == "down" and event.button == 3:
        _delete_at(scene, point)
    elif event.kind == "wheel" and scene.hand == NOTHING:
        _turn(scene, event.wheel)
    elif event.kind == "move" and scene.hand != NOTHING:
        _drag(scene, point, event.shift, event.control)
    elif event.kind in ("up", "cancel"):
        if event.kind == "cancel" and scene.before is not None:
            scene.set_edit(scene.before)
            scene.before = None
        scene.let_go()


def what_is_at(scene: KeyFraming, point: Point) -> tuple[str, int]:
    """What the pointer would take there: handle, turn, key, box, move, time, ease, or nothing."""
    places = places_of(scene.motion.view)
    if places.timing.holds(point, places.reach) and EASING in scene.active:
        ends = [places.timing.at(*scene.timing()[i : i + 2]) for i in (0, 2)]
        return "ease", min((0, 1), key=lambda i: math.dist(point, ends[i]))
    if places.band.holds(point):
        return _on_timeline(scene, point)
    spots: list[tuple[float, str, int]] = []
    animation = scene.animation()
    for i, pair in enumerate(animation.handles().tolist()):
        spots += [(math.dist(point, spot), "handle", 2 * i + side) for side, spot in enumerate(pair)]
    x, y, angle = scene.pose.tolist()
    spots += [(math.dist(point, key.position), "key", i) for i, key in enumerate(scene.motion.keys)]
    if scene.turning == "keys":
        spots.append((math.dist(point, turning_handle(scene, x, y, angle)), "turn", -1))
        for i, key in enumerate(scene.motion.keys):
            spot = turning_handle(scene, *key.position, math.radians(key.angle))
            spots.append((math.dist(point, spot), "turn", i))
    near = [spot for spot in spots if spot[0] <= places.reach]
    if near:
        return min(near, key=lambda spot: spot[0])[1:]
    along = math.cos(angle) * (point[0] - x) + math.sin(angle) * (point[1] - y)
    across = math.cos(angle) * (point[1] - y) - math.sin(angle) * (point[0] - x)
    width, height = scene.motion.box
    return ("box", -1) if abs(along) <= 0.5 * width and abs(across) <= 0.5 * height else NOTHING


def _on_timeline(scene: KeyFraming, point: Point) -> tuple[str, int]:
    places = places_of(scene.motion.view)
    marks = [
        math.hypot(x_of(places, key.time) - point[0], places.axis - point[1]) for key in scene.motion.keys
    ]
    nearest = min(range(len(marks)), key=lambda i: (marks[i], i != scene.chosen))
    return ("move", nearest) if marks[nearest] <= places.reach else ("time", -1)


def _press(scene: KeyFraming, point: Point) -> None:
    what, index = what_is_at(scene, point)
    scene.before = scene.edit()
    if what == "":
        _new_key(scene, point)
        what, index = "key", scene.chosen
    elif what in ("box", "turn") and index < 0:
        index = key_now(scene)
        what = "key" if what == "box" else what
    if index < 0 and what != "time":
        scene.before = None
        return
    scene.hand = (what, index)
    scene.grip = (0.0, 0.0)
    if what in ("key", "turn", "move"):
        scene.choose(index)
    if what == "handle":
        scene.choose(index // 2)
    if what == "key":
        x, y = scene.motion.keys[index].position
        scene.grip = (x - point[0], y - point[1])
    elif what == "time":
        _drag(scene, point, False, False)
    elif what == "move":
        places = places_of(scene.motion.view)
        scene.grip = (x_of(places, scene.motion.keys[index].time) - point[0], 0.0)


def _drag(scene: KeyFraming, point: Point, shift: bool, control: bool) -> None:
    what, index = scene.hand
    x, y = editing.limited((point[0] + scene.grip[0], point[1] + scene.grip[1]))
    motion, places = scene.motion, places_of(scene.motion.view)
    if what == "time":
        scene.set_time(time_at(places, point[0]))
    elif what == "move":
        moved, now = editing.with_time(motion, index, time_at(places, x))
        scene.motion, scene.hand = moved, (what, now)
        scene.choose(now)
    elif what == "key":
        scene.motion = editing.with_change(motion, index, position=(x, y))
    elif what == "turn":
        key = motion.keys[index]
        angle = editing.angle_at(key.position, point)
        angle = SNAP * round(angle / SNAP) if control else angle
        scene.motion = editing.with_change(motion, index, angle=editing.nearest_angle(angle, key.angle))
    elif what == "handle":
        _bend(scene, point, index // 2, index % 2 == 0, shift)
    elif what == "ease":
        _shape_timing(scene, point, index)
    if what in ("key", "turn", "move"):
        scene.show_chosen()


def _bend(scene: KeyFraming, point: Point, index: int, before: bool, corner: bool) -> None:
    """Drag a control point: the velocity at its key is three times the way to it by the piece's duration."""
    gap = scene.animation().gap(index, before)
    if gap <= 0.0:
        return
    x, y = scene.motion.keys[index].position
    scale = (-3.0 if before else 3.0) / gap
    velocity = ((point[0] - x) * scale, (point[1] - y) * scale)
    scene.motion = editing.with_velocity(scene.motion, index, velocity, before, corner)


def _shape_timing(scene: KeyFraming, point: Point, index: int) -> None:
    x, y = places_of(scene.motion.view).timing.shares(point)
    four = list(scene.timing())
    four[2 * index], four[2 * index + 1] = min(max(x, 0.0), 1.0) + 0.0, min(max(y, -3.0), 4.0) + 0.0
    scene.set_timing(four)


def key_now(scene: KeyFraming) -> int:
    """The key at the time that is shown, made if there is none; -1 if there is no room."""
    part = scene.shown_part()
    time, pose = scene.animation().key_time(part), scene.animation().pose(part)
    for i, key in enumerate(scene.motion.keys):
        if abs(key.time - time) <= SAME_TIME:
            return i
    return _insert(scene, time, (float(pose[0]), float(pose[1])), math.degrees(pose[2]), True)


def _insert(scene: KeyFraming, time: float, point: Point, angle: float, on_curve: bool) -> int:
    """A key at a time; one on a Bezier curve gets the curve's velocity, so that the curve stays as it is."""
    velocity = None
    if on_curve and scene.interpolation == "bezier":
        rate = scene.animation().track.rate(scene.motion.start + time)
        velocity = editing.limited((float(rate[0]), float(rate[1])), editing.FASTEST)
        scene.motion = _with_velocities(scene)
    before = min(scene.motion.keys, key=lambda key: abs(key.time - time))
    entry = KeyEntry(
        time=time,
        position=editing.limited(point),
        angle=editing.nearest_angle(angle, before.angle),
        velocity=velocity,
    )
    try:
        scene.motion, index = editing.with_key(scene.motion, entry)
    except ValueError as error:
        scene.told.append(f"{str(error).capitalize()}.")
        return -1
    scene.choose(index)
    return index


def _with_velocities(scene: KeyFraming) -> editing.Motion:
    """The motion with the velocities of all keys said, that were found from their neighbours before."""
    motion, handles, animation = scene.motion, scene.animation().handles(), scene.animation()
    for i, key in enumerate(motion.keys):
        sides = [side for side in (1, 0) if np.isfinite(handles[i, side]).all()]
        if key.velocity is None and sides:
            way = handles[i, sides[0]] - key.position
            scale = (3.0 if sides[0] else -3.0) / animation.gap(i, not sides[0])
            velocity = editing.limited((float(way[0]) * scale, float(way[1]) * scale), editing.FASTEST)
            motion = editing.with_change(motion, i, velocity=velocity)
    return motion


def _turn(scene: KeyFraming, notches: float) -> None:
    """Rest, so many frames later or earlier; past the end begin anew."""
    frames = scene.fps * scene.duration
    frame = math.floor(scene.present() * frames + 0.5) + notches
    time = frame / frames
    scene.values["playing"] = False
    scene.set_time(time if 0.0 <= time <= 1.0 else time % 1.0)


def _new_key(scene: KeyFraming, point: Point) -> None:
    """A click on the stage: the box is there now; if this time has a key already, there at the end."""
    part = scene.shown_part()
    time, angle = scene.animation().key_time(part), math.degrees(scene.animation().pose(part)[2])
    if all(abs(key.time - time) > SAME_TIME for key in scene.motion.keys):
        _insert(scene, time, point, angle, False)
        return
    last = scene.motion.keys[-1]
    try:
        scene.motion, index = editing.with_key_at_end(scene.motion, point, last.angle, scene.closed)
    except ValueError as error:
        scene.told.append(f"{str(error).capitalize()}.")
        return
    scene.choose(index)


def _delete_at(scene: KeyFraming, point: Point) -> None:
    what, index = what_is_at(scene, point)
    if what in ("key", "move", "turn") and index >= 0:
        scene.delete_key(index)
    elif what == "handle":
        scene.change(editing.with_change(scene.motion, index // 2, velocity=None, velocity_before=None))
