"""The hand in the key-framing scene: keys, handles, the box itself, the timeline, the timing curve."""

from __future__ import annotations

import math

from game.physics.animation import EASING
from game.physics.kernels import elementary
from game.scenes.key_frames import editing
from game.scenes.key_frames.box import is_inside, turning_handle
from game.scenes.key_frames.document import NOTHING
from game.scenes.key_frames.keying import key_now, new_key
from game.scenes.key_frames.level import Point
from game.scenes.key_frames.model import KeyFrameModel
from game.scenes.key_frames.timeline import Places, places_of, time_at, x_of
from game.stage import Pointer
from game.stage.part import Part

SNAP = 15.0  # degrees, with Ctrl


class Hand(Part):
    """Edits the document by the pointer. grip: from the pointer to what is held, m."""

    def __init__(self, model: KeyFrameModel) -> None:
        self.model = model
        self.grip = (0.0, 0.0)

    @property
    def _places(self) -> Places:
        return places_of(self.model.motion.view)

    def take(self, event: Pointer) -> None:
        """A pointer event in world coordinates."""
        point, document = editing.limited((event.x, event.y)), self.model.document
        if event.kind == "down":
            document.forget_reason()
            document.let_go()
        if event.kind == "down" and event.button == 1:
            self._press(point)
        elif event.kind == "down" and event.button == 3:
            self._delete_at(point)
        elif event.kind == "wheel" and document.held == NOTHING:
            self._turn(event.wheel)
        elif event.kind == "move" and document.held != NOTHING:
            self._drag(point, event.shift, event.control)
        elif event.kind == "cancel":
            document.cancel()
        elif event.kind == "up":
            document.let_go()
        self.model.place_box()

    # -- what is there ------------------------------------------------------------------------------

    def what_is_at(self, point: Point) -> tuple[str, int]:
        """What the pointer would take there: handle, turn, key, box, move, time, ease, or nothing."""
        model, places = self.model, self._places
        if places.timing.holds(point, places.reach) and EASING in model.active:
            ends = [places.timing.at(*model.document.timing()[i : i + 2]) for i in (0, 2)]
            return "ease", min((0, 1), key=lambda i: elementary.dist(point, ends[i]))
        if places.band.holds(point):
            return self._on_timeline(point)
        near = [spot for spot in self._spots(point) if spot[0] <= places.reach]
        if near:
            return min(near, key=lambda spot: spot[0])[1:]
        return ("box", -1) if is_inside(point, model.pose.tolist(), model.motion.box) else NOTHING

    def _spots(self, point: Point) -> list[tuple[float, str, int]]:
        """How far it is (m) to each thing that can be taken on the stage."""
        model, motion = self.model, self.model.motion
        spots: list[tuple[float, str, int]] = []
        for i, pair in enumerate(model.animation().handles().tolist()):
            spots += [
                (elementary.dist(point, spot), "handle", 2 * i + side) for side, spot in enumerate(pair)
            ]
        spots += [(elementary.dist(point, key.position), "key", i) for i, key in enumerate(motion.keys)]
        if model.parameters.turning == "keys":
            spots.append(
                (elementary.dist(point, turning_handle(motion.box, *model.pose.tolist())), "turn", -1)
            )
            for i, key in enumerate(motion.keys):
                spot = turning_handle(motion.box, *key.position, math.radians(key.angle))
                spots.append((elementary.dist(point, spot), "turn", i))
        return spots

    def _on_timeline(self, point: Point) -> tuple[str, int]:
        document, places = self.model.document, self._places
        marks = [
            elementary.hypot(x_of(places, key.time) - point[0], places.axis - point[1])
            for key in document.motion.keys
        ]
        nearest = min(range(len(marks)), key=lambda i: (marks[i], i != document.chosen))
        return ("move", nearest) if marks[nearest] <= places.reach else ("time", -1)

    # -- a drag -------------------------------------------------------------------------------------

    def _press(self, point: Point) -> None:
        what, index = self.what_is_at(point)
        document = self.model.document
        document.before = document.edit()
        if what == "":
            new_key(self.model, point)
            what, index = "key", document.chosen
        elif what in ("box", "turn") and index < 0:
            index = key_now(self.model)
            what = "key" if what == "box" else what
        if index < 0 and what != "time":
            document.before = None
            return
        document.take_hold(what, index)
        self.grip = (0.0, 0.0)
        if what in ("key", "turn", "move"):
            document.choose(index)
        if what == "handle":
            document.choose(index // 2)
        if what == "key":
            x, y = document.motion.keys[index].position
            self.grip = (x - point[0], y - point[1])
        elif what == "time":
            self._drag(point, False, False)
        elif what == "move":
            self.grip = (x_of(self._places, document.motion.keys[index].time) - point[0], 0.0)

    def _drag(self, point: Point, shift: bool, control: bool) -> None:
        document, places = self.model.document, self._places
        what, index = document.held
        motion = document.motion
        x, y = editing.limited((point[0] + self.grip[0], point[1] + self.grip[1]))
        if what == "time":
            self.model.player.set_time(time_at(places, point[0]))
        elif what == "move":
            document.motion, now = editing.with_time(motion, index, time_at(places, x))
            document.take_hold(what, now)
            document.choose(now)
        elif what == "key":
            document.motion = editing.with_change(motion, index, position=(x, y))
        elif what == "turn":
            key = motion.keys[index]
            angle = editing.angle_at(key.position, point)
            angle = SNAP * round(angle / SNAP) if control else angle
            document.motion = editing.with_change(
                motion, index, angle=editing.nearest_angle(angle, key.angle)
            )
        elif what == "handle":
            self._bend(point, index // 2, index % 2 == 0, shift)
        elif what == "ease":
            self._shape_timing(point, index)
        if what in ("key", "turn", "move"):
            document.show_chosen()

    def _bend(self, point: Point, index: int, before: bool, corner: bool) -> None:
        """Drag a control point: the velocity at its key is three times the displacement to it by the piece's
        duration."""
        gap = self.model.animation().gap(index, before)
        if gap <= 0.0:
            return
        document = self.model.document
        x, y = document.motion.keys[index].position
        scale = (-3.0 if before else 3.0) / gap
        velocity = ((point[0] - x) * scale, (point[1] - y) * scale)
        document.motion = editing.with_velocity(document.motion, index, velocity, before, corner)

    def _shape_timing(self, point: Point, index: int) -> None:
        x, y = self._places.timing.shares(point)
        four = list(self.model.document.timing())
        four[2 * index], four[2 * index + 1] = min(max(x, 0.0), 1.0) + 0.0, min(max(y, -3.0), 4.0) + 0.0
        self.model.document.set_timing(four)

    # -- other buttons ------------------------------------------------------------------------------

    def _turn(self, notches: float) -> None:
        """Pause, so many frames later or earlier; past the end begin again."""
        player = self.model.player
        frame = math.floor(player.present() * player.frames + 0.5) + notches
        time = frame / player.frames
        player.pause_at(time if 0.0 <= time <= 1.0 else time % 1.0)

    def _delete_at(self, point: Point) -> None:
        what, index = self.what_is_at(point)
        document = self.model.document
        if what in ("key", "move", "turn") and index >= 0:
            document.delete_key(index)
        elif what == "handle":
            document.change(
                editing.with_change(document.motion, index // 2, velocity=None, velocity_before=None)
            )
