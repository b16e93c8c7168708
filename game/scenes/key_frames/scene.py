"""A box that moves by key-frames: twelve ways to go from one to the next, timing, and constant speed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.animation.keyframing import keyframing_study
from game.levels import Level
from game.physics.animation import EASING, INTERPOLATIONS, CubicBezier, Easing, Keyframes
from game.scenes.key_frames import C01, editing, hand
from game.scenes.key_frames.clock import frame_of
from game.scenes.key_frames.document import CHOSEN, LABELS, SHAPING, Edit
from game.scenes.key_frames.figure import draw_casteljau
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.playing import PlayedScene
from game.scenes.key_frames.view import KeyFramingView
from game.stage import (
    Choice,
    Equation,
    Frame,
    Hint,
    Param,
    Pointer,
    Readout,
    SceneAction,
    Strip,
    Toggle,
    WarmUp,
)

Array = NDArray[np.float64]


class KeyFrameState(NamedTuple):
    """The box and what it moves by. pose: x, y m, angle rad. clock: see c01_clock. timing: x1, y1, x2, y2."""

    pose: Array

    clock: Array
    keys: Array
    timing: Array


class KeyFraming(PlayedScene):
    """Key-frames say where the box is and how it is turned at a few times; an interpolation says the rest.
    Nearest neighbour jumps, lines have corners, cubics differ only in how steep they are at the keys: that
    alone decides between overshoot, loops, jolts and accuracy.

    Grab the box and it gets a key at this very time. Click where it should be now. Drag keys in space, their
    handles to turn them, their diamonds in time. With Bezier curves drag the control points.

    The curve under the stage is the speed. It shows what the path does not: where the box is in a hurry, and
    where it is jolted. Even speed spreads the time by the length of the path, easing by a timing curve.
    """

    name, task, title = C01.names
    study = keyframing_study
    takes = frozenset(("right", "wheel"))

    onion = Param(
        16, 0, 120, whole=True, group="Shown", label="Onion skin", help="boxes at as many equal steps of time"
    )
    compare = Choice(
        "none", ("none", *(name for name in INTERPOLATIONS if name != "bezier")), group="Shown",
        labels=("Nothing", *(label for label in LABELS if label != "Bezier curves")), label="Compared with",
    )  # fmt: skip
    velocity = Toggle(True, group="Shown", label="Velocity")
    corners = Toggle(
        False, group="Shown", label="Lines it is drawn by", help="found by halving pieces until flat"
    )
    tolerance = Param(
        0.005, 0.0005, 0.5, unit="m", log=True, group="Shown", label="Lines are off by", help="at most"
    )
    matrices = Toggle(
        False, group="Shown", label="Rotation matrices mixed", help="what becomes of the box without angles"
    )

    strips = (
        Strip("Speed", "m/s", ("speed",)),
        Strip("Place", "m", ("x", "y")),
        Strip("Angle", "°", ("angle",)),
    )
    hints = (
        Hint(("Drag",), "box, keys, handles, time"),
        Hint(("Click",), "new key"),
        Hint(("Right click",), "delete"),
        Hint(("Wheel",), "frame by frame"),
    )
    actions = (
        SceneAction("undo", "undo", "ctrl+z"),
        SceneAction("redo", "redo", "ctrl+y"),
        SceneAction("insert", "key here and now", "i"),
        SceneAction("delete", "delete the chosen key", "delete"),
        SceneAction("corner", "corner or smooth joint", "c"),
        SceneAction("play", "play or rest", "k"),
        SceneAction("method", "next interpolation", "m"),
        SceneAction("earlier", "to the key before", "leftbracket"),
        SceneAction("later", "to the next key", "rightbracket"),
    )
    figure = staticmethod(draw_casteljau)
    equations = (
        Equation(
            "Nearest, linear", r"x = x_i,  x = x_i + u (x_{i+1} - x_i),  u = \frac{t - t_i}{t_{i+1} - t_i}"
        ),
        Equation(
            "Bezier curve",
            r"B(u) = (1-u)^3 P_0 + 3u(1-u)^2 P_1 + 3u^2(1-u) P_2 + u^3 P_3",
            "Bernstein weights; Bézier 1966",
        ),
        Equation(
            "Joint without a jolt",
            r"\frac{P_3 - P_2}{h_i} = \frac{Q_1 - Q_0}{h_{i+1}}",
            "C1: equal velocities",
        ),
        Equation(
            "Catmull-Rom knots",
            r"k_{i+1} = k_i + \abs{P_{i+1} - P_i}^a,  a = 0, \frac{1}{2}, 1",
            "Yuksel and others 2011",
        ),
        Equation("Parabola's slope", r"m_i = \frac{h_i d_{i-1} + h_{i-1} d_i}{h_{i-1} + h_i}", "third order"),
        Equation(
            "Spline",
            r"h_i m_{i-1} + 2(h_{i-1} + h_i) m_i + h_{i-1} m_{i+1} = 3(h_i d_{i-1} + h_{i-1} d_i)",
            "de Boor 1978",
        ),
        Equation(
            "Even speed",
            r"s(u) = \int_0^u \abs{B'(v)} dv,  u_{n+1} = u_n - \frac{s(u_n) - s}{\abs{B'(u_n)}}",
            "Guenter and Parent 1990",
        ),
        Equation("Timing curve", r"x(s) = t,  y = y(s)", "W3C 2023, CSS easing functions"),
        Equation(
            "Lines to draw it by",
            r"n = \sqrt{\frac{3}{4\epsilon} \max \abs{P_{i+2} - 2P_{i+1} + P_i}}",
            "Wang 1984; here halved until flat",
        ),
    )
    try_this = (
        "Grab the flying box and pull it aside: it has a key there now. Ctrl+Z takes it back.",
        "Change the interpolation and watch the speed below: linear has steps, a spline has none.",
        "Switch even speed on: the curve below becomes flat, the boxes of the onion skin evenly spaced.",
        "Set frames per second to 8, then the second to 1 s: what early films looked like.",
        "Choose Bezier curves and drag a control point; with Shift its joint becomes a corner.",
        "Open the half turn and switch mixed matrices on: the box collapses to a point.",
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        content = level.content if level is not None and level.content is not None else Motion()
        self.begin_editing(content)
        self.reason = ""  # told last, why a parameter does nothing
        self.clock = np.array([self.values["time"], 0.0, self.dt, float(self.playing)])
        self.pose = np.zeros(3)
        self._timing = np.array(self.motion.timing)
        self.view = KeyFramingView()
        self.place_box()

    # -- parameters and actions --------------------------------------------------------------------------

    def parameter_changed(self, name: str) -> None:
        if name in SHAPING or name in CHOSEN:
            self.let_go()
        if name == "time":
            self.values["playing"] = False
            self.set_time(self.values["time"])
        elif name in ("duration", "repeat"):
            self.clock[:2] = self.values["time"], 0.0
        elif name == "playing":
            ended = self.playing and self.repeat == "once" and self.present() >= 1.0
            self.clock[:2] = 0.0 if ended else self.phase(), 0.0
            self.clock[3] = float(self.playing)
        elif name in SHAPING:
            self.note(Edit(self.motion, self.shaped))
            self.shaped = self.shaping()
            if name == "easing" and EASING not in self.active:
                self._tell_once("The timing curve counts while easing is on: see the effects.")
        elif name in CHOSEN and self.chosen >= 0:
            self.take_chosen(name)
        elif name in CHOSEN:
            self._tell_once("No key is chosen: click one first.")
        self.place_box()

    def _tell_once(self, words: str) -> None:
        """Say why a parameter does nothing, but not again with each pixel of its slider."""
        if words != self.reason:
            self.reason = words
            self.told.append(words)

    def effects_changed(self) -> None:
        self.place_box()

    def action(self, name: str) -> None:
        self.let_go()
        if name == "undo":
            self.go_between(self.past, self.future, "There is nothing to undo.")
        elif name == "redo":
            self.go_between(self.future, self.past, "There is nothing to do again.")
        elif name == "delete":
            if self.chosen >= 0:
                self.delete_key(self.chosen)
        elif name == "insert":
            before = self.edit()
            self.choose(hand.key_now(self))
            if self.motion is not before.motion:
                self.note(before)
        elif name == "corner":
            self.toggle_corner()
        elif name == "play":
            self.values["playing"] = not self.playing
            self.parameter_changed("playing")
        elif name == "method":
            place = INTERPOLATIONS.index(self.interpolation)
            self.values["interpolation"] = INTERPOLATIONS[(place + 1) % len(INTERPOLATIONS)]
            self.parameter_changed("interpolation")
        else:
            self._to_key(-1 if name == "earlier" else 1)
        self.place_box()

    def _to_key(self, way: int) -> None:
        """Rest at the key before or after the present time."""
        times = sorted({key.time for key in self.motion.keys})
        now = self.present()
        if way > 0:
            target = next((t for t in times if t > now + 1e-9), times[0])
        else:
            target = next((t for t in reversed(times) if t < now - 1e-9), times[-1])
        self.values["playing"] = False
        self.set_time(target)
        self.choose(max(i for i, key in enumerate(self.motion.keys) if key.time == target))

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down":
            self.reason = ""
        hand.take_pointer(self, event)
        self.place_box()

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> KeyFrameState:
        animation = self.animation()
        if tuple(self._timing) != self.motion.timing:
            self._timing = np.array(self.motion.timing)
        return KeyFrameState(self.pose, self.clock, animation.rows, self._timing)

    def restore(self, state: KeyFrameState) -> None:
        self.clock[:] = state.clock
        self.values["playing"] = bool(state.clock[3])
        self.values["time"] = self.present()
        same = np.array_equal(state.keys, editing.as_rows(self.motion))
        if not same or tuple(state.timing) != self.motion.timing:
            self.motion = editing.from_rows(self.motion, state.keys, state.timing)
        self.shaped = self.shaping()
        self.pose[:] = state.pose

    def save_content(self) -> Motion:
        return self.motion

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        animation, part = self.animation(), self.shown_part()
        x, y, angle = self.pose.tolist()
        turned = math.degrees(angle)
        frames = self.fps * self.duration
        return [
            Readout("speed", float(np.minimum(animation.playback.speed(part), 1e6)), "m/s"),
            Readout("on the slider", self.present(), "s"),
            Readout("angle", turned - 360.0 * math.ceil(turned / 360.0 - 0.5), "°"),
            Readout("frame", frame_of(self.phase(), frames)),
            Readout("x", x, "m"),
            Readout("y", y, "m"),
            Readout("keys", len(self.motion.keys)),
            Readout("way", animation.length, "m"),
            Readout("jolt", animation.jolt, "m/s"),
            Readout("lines", sum(len(chain) - 1 for chain in animation.chains(self.tolerance))),
        ]

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend(self)

    def frame(self) -> Frame:
        view = self.motion.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        times, values = np.arange(3.0), np.eye(3)
        path = CubicBezier(np.arange(8.0).reshape(4, 2) ** 2)

        def sample(name: str) -> Any:
            track = Keyframes(times, values, name)
            return track.sample(times), track.rate(times)

        return (
            *(WarmUp(f"keys, {name}", partial(sample, name)) for name in ("spline", "linear", "nearest")),
            WarmUp("lengths", lambda: path.length),
            WarmUp("equal ways", lambda: path.parameter_at(times)),
            WarmUp("lines", lambda: path.flatten(0.1)),
            WarmUp("directions", lambda: path.direction(times)),
            WarmUp("timing curve", lambda: Easing("ease").slope(times)),
        )
