"""A motion that is edited: the parameters that shape it, the chosen key, undo and redo."""

from __future__ import annotations

from collections import deque
from typing import Any, ClassVar, NamedTuple

import msgspec
import numpy as np

from game.physics.animation import CONSTANT_SPEED, EASING, EASINGS, INTERPOLATIONS
from game.scenes.key_frames import editing
from game.scenes.key_frames.animation import Animation, Settings
from game.scenes.key_frames.level import Motion
from game.stage import Choice, Param, Parameter, Scene, Toggle

LABELS = (
    "Nearest key", "Linear", "Bezier curves", "Rest at every key", "Catmull-Rom, uniform",
    "Catmull-Rom, centripetal", "Catmull-Rom, chordal", "Secants", "Monotone", "Parabolas", "Natural spline",
    "Spline",
)  # fmt: skip
SHORT = dict(zip(INTERPOLATIONS, LABELS, strict=True))
SHAPING = (
    "interpolation",
    "closed",
    "shortest",
    "turning",
    "easing",
)  # parameters that an undo takes back as well
CHOSEN = ("key_time", "key_x", "key_y", "key_angle")
MOST_UNDO = 200
OWN = "own"
NOTHING = ("", -1)  # what an empty hand holds


class Edit(NamedTuple):
    """What undo and redo go between: the motion, and the parameters that shape it."""

    motion: Motion
    parameters: tuple[Any, ...]


class MotionScene(Scene):
    """Base of the key-framing scene: what is edited, and how it is taken back."""

    effects = EASING | CONSTANT_SPEED
    content_type = Motion

    interpolation = Choice(
        "centripetal", INTERPOLATIONS, labels=LABELS, group="Interpolation",
        help="how the box goes from key to key",
    )  # fmt: skip
    closed = Toggle(False, group="Interpolation", label="Back to the first key", help="at one second")
    shortest = Toggle(
        True,
        group="Interpolation",
        label="Turn the shortest way",
        help="from 350° to 10° by 20°, not by −340°",
    )
    turning = Choice(
        "keys", ("keys", "path"), labels=("By its keys", "Along the path"), group="Interpolation",
        label="The box turns", help="angles of the keys, or the direction of the way",
    )  # fmt: skip
    easing = Choice(
        "ease-in-out", (*EASINGS, OWN), group="Timing curve",
        labels=("Linear", "Ease", "Ease in", "Ease out", "Ease in and out", "Swing", "Rush", "My own"),
        help="drag its two handles at the top right", label="Timing curve",
    )  # fmt: skip
    key_time = Param(0.0, 0.0, 1.0, unit="s", step=0.001, group="Chosen key", label="At the time")
    key_x = Param(0.0, -1000.0, 1000.0, unit="m", group="Chosen key", label="x")
    key_y = Param(0.0, -1000.0, 1000.0, unit="m", group="Chosen key", label="y")
    key_angle = Param(0.0, -36_000.0, 36_000.0, unit="°", group="Chosen key", label="Angle")

    groups: ClassVar[tuple[str, ...]] = ("Interpolation", "Time", "Timing curve", "Chosen key", "Shown")

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group."""
        order = {group: i for i, group in enumerate(cls.groups)}
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: order.get(item[1].group, 0))
        )

    def begin_editing(self, motion: Motion) -> None:
        """Start with a motion that nobody has changed."""
        self.motion = editing.ordered(motion)
        self.past: list[Edit] = []
        self.future: list[Edit] = []
        self.before: Edit | None = None
        self.hand: tuple[str, int] = NOTHING
        self.grip = (0.0, 0.0)
        self.chosen = -1
        self.told: deque[str] = deque(maxlen=8)
        self._kept: dict[str, tuple[Any, Animation]] = {}
        self.shaped = self.shaping()

    def shaping(self) -> tuple[Any, ...]:
        """Values of the parameters that an undo takes back as well."""
        return tuple(self.values[name] for name in SHAPING)

    def animation(self, interpolation: str | None = None) -> Animation:
        """The motion made ready (or the same with another interpolation); made anew when it changes."""
        name = interpolation or self.interpolation
        settings = Settings(name, self.closed, self.shortest, self.turning == "path", self.easing)
        kept = self._kept.get("compared" if interpolation else "")
        if kept is not None and kept[0][0] is self.motion and kept[0][1:] == (settings, self.active):
            return kept[1]
        made = Animation(self.motion, settings, self.active)
        self._kept["compared" if interpolation else ""] = ((self.motion, settings, self.active), made)
        return made

    # -- edits --------------------------------------------------------------------------------------

    def edit(self) -> Edit:
        """What there is now, for an undo."""
        return Edit(self.motion, self.shaping())

    def set_edit(self, edit: Edit) -> None:
        """Go to what there was."""
        self.motion = edit.motion
        self.values.update(zip(SHAPING, edit.parameters, strict=True))
        self.shaped = edit.parameters
        self.choose(min(self.chosen, len(self.motion.keys) - 1))

    def note(self, before: Edit, parameters: tuple[Any, ...] | None = None) -> None:
        """Something has been changed; undo leads to ``before``. parameters: those now; else the panel's."""
        if before != Edit(self.motion, self.shaping() if parameters is None else parameters):
            self.past = [*self.past, before][-MOST_UNDO:]
            self.future = []

    def let_go(self) -> None:
        """End a drag here: what it has done so far is one edit."""
        if self.before is not None:
            self.note(self.before, self.shaped)
        self.before, self.hand = None, NOTHING

    def change(self, motion: Motion) -> None:
        """Another motion, in one edit."""
        before = self.edit()
        self.motion = motion
        self.note(before)
        self.choose(min(self.chosen, len(motion.keys) - 1))

    def go_between(self, source: list[Edit], target: list[Edit], words: str) -> None:
        if not source:
            self.told.append(words)
            return
        now = self.edit()
        edit = source[-1]
        source[:] = source[:-1]
        target.append(now)
        self.set_edit(edit)

    def delete_key(self, index: int) -> None:
        """Take a key away."""
        try:
            motion = editing.without_key(self.motion, index)
        except ValueError as error:
            self.told.append(f"{str(error).capitalize()}.")
            return
        if self.chosen >= index:
            self.chosen -= 1
        self.change(motion)

    def choose(self, index: int) -> None:
        """Let a key be the chosen one (-1: none), and the panel say what it is."""
        self.chosen = index
        self.show_chosen()

    def show_chosen(self) -> None:
        """The panel's numbers are those of the chosen key."""
        if not 0 <= self.chosen < len(self.motion.keys):
            return
        key = self.motion.keys[self.chosen]
        self.values["key_time"], self.values["key_angle"] = key.time, key.angle
        self.values["key_x"], self.values["key_y"] = key.position

    def timing(self) -> tuple[float, float, float, float]:
        """Handles of the present timing curve."""
        return self.motion.timing if self.easing == OWN else EASINGS[self.easing]

    def set_timing(self, four: list[float]) -> None:
        """A timing curve of one's own."""
        self.motion = msgspec.structs.replace(self.motion, timing=tuple(four))
        self.values["easing"] = OWN
        self.shaped = self.shaping()

    def take_chosen(self, name: str) -> None:
        """Give the chosen key what the panel says."""
        index, motion = self.chosen, self.motion
        if name == "key_time":
            motion, self.chosen = editing.with_time(motion, index, self.key_time)
        elif name == "key_angle":
            motion = editing.with_change(motion, index, angle=self.key_angle)
        else:
            motion = editing.with_change(motion, index, position=(self.key_x, self.key_y))
        self.change(motion)

    def toggle_corner(self) -> None:
        """Make the joint of the chosen key a corner, or smooth again."""
        if self.chosen < 0:
            return
        key = self.motion.keys[self.chosen]
        if key.velocity_before is not None:
            self.change(editing.with_change(self.motion, self.chosen, velocity_before=None))
            return
        animation = self.animation()
        after = animation.handles()[self.chosen, 1] - key.position
        gap = animation.gap(self.chosen, before=False)
        velocity = key.velocity
        if velocity is None and gap > 0.0 and np.isfinite(after).all():
            x, y = (after * (3.0 / gap)).tolist()
            velocity = editing.limited((x, y), editing.FASTEST)
        if velocity is not None:
            change = {"velocity": velocity, "velocity_before": velocity}
            self.change(editing.with_change(self.motion, self.chosen, **change))
