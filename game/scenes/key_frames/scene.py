"""A box that moves by key-frames: twelve ways to go from one to the next, timing, and constant speed."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from operator import attrgetter
from typing import Any, ClassVar

import numpy as np

from game.lab.studies.animation.keyframing import keyframing_study
from game.physics.animation import CONSTANT_SPEED, EASING, CubicBezier, Easing, Keyframes
from game.physics.kernels import elementary
from game.scenes.key_frames import C01
from game.scenes.key_frames.commands import take_action
from game.scenes.key_frames.figure import draw_casteljau
from game.scenes.key_frames.hand import Hand
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.model import KeyFrameModel
from game.scenes.key_frames.parameters import KeyFrameParameters, range_of_slider
from game.scenes.key_frames.readouts import readouts_of
from game.scenes.key_frames.view import KeyFramingView
from game.stage import (
    Equation,
    Frame,
    Hint,
    SceneAction,
    Strip,
    WarmUp,
)
from game.worlds.expectations import Caption, captions_now
from game.worlds.scene import ModelScene, Told


class KeyFraming(ModelScene):
    """Key-frames say where the box is and how it is turned at a few times; an interpolation says the rest.
    Nearest neighbour jumps, lines have corners, cubics differ only in how steep they are at the keys: that
    alone decides between overshoot, loops, jolts and accuracy.

    Grab the box and it gets a key at this very time. Click where it should be now. Drag keys in space, their
    handles to turn them, their diamonds in time. With Bezier curves drag the control points.

    The curve under the stage is the speed. It shows what the path does not: where the box is in a hurry, and
    where its velocity jumps. Constant speed spreads the time by the length of the path, easing by a timing
    curve.

    In the equations: x place at time t, x_i key-frames, u the part of a piece, P control points of a piece,
    Q those of the next, h durations of pieces, d slopes of their chords, m slopes at the keys, k knots of
    Catmull-Rom, s length of the path, ε how far lines may be off, n how many there are.
    """

    name, task, title = C01.names
    effects = EASING | CONSTANT_SPEED
    content_type = Motion
    told = Told(readouts_of, attrgetter("motion"))
    default_content: ClassVar[Motion] = Motion()
    parameters_type = KeyFrameParameters
    parameters: KeyFrameParameters
    model: KeyFrameModel
    study = keyframing_study
    takes = frozenset(("right", "wheel"))

    strips = (
        Strip("Speed", "m/s", ("speed",)),
        Strip("Position", "m", ("x", "y")),
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
        SceneAction("play", "play or pause", "k"),
        SceneAction("method", "next interpolation", "m"),
        SceneAction("earlier", "to the key before", "leftbracket"),
        SceneAction("later", "to the next key", "rightbracket"),
    )
    play_action = "play"
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
            "Smooth joint",
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
            "Constant speed",
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
        "Show the formula: weights and key-frames of this moment, and the x that comes of them.",
        "Switch constant speed on: the curve below becomes flat, the boxes of the onion skin evenly spaced.",
        "Set frames per second to 8, then the second to 1 s: what early films looked like.",
        "Choose Bezier curves and drag a control point; with Shift its joint becomes a corner.",
        "Open the half turn and switch mixed matrices on: the box collapses to a point.",
    )

    # -- building -----------------------------------------------------------------------------------

    def make(self, content: Motion) -> None:
        self.model = KeyFrameModel(self.parameters, self.active, content)
        self.said = self.model.document.messages
        self.hand = Hand(self.model)
        self.view = KeyFramingView(self.model)

    # -- events -------------------------------------------------------------------------------------

    def action(self, name: str) -> None:
        take_action(self.model, name)

    @property
    def resting(self) -> bool:
        return not self.parameters.playing

    def slider_range(self, name: str) -> tuple[float, float] | None:
        return range_of_slider(name, self.model.motion.view)

    # -- remembering --------------------------------------------------------------------------------

    # -- what there is to see -----------------------------------------------------------------------

    def shown(self) -> Frame:
        view = self.model.motion.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def captions(self) -> Sequence[Caption]:
        return captions_now(self, self.model.motion.expected)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas)
        self.draw_expected(canvas)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        times, values = np.arange(3.0), np.eye(3)
        path = CubicBezier(elementary.square(np.arange(8.0).reshape(4, 2)))

        def sample(name: str) -> Any:
            track = Keyframes(times, values, name)
            return track.sample(times), track.rate(times)

        return (
            *(WarmUp(f"keys, {name}", partial(sample, name)) for name in ("spline", "linear", "nearest")),
            WarmUp("lengths", lambda: path.length),
            WarmUp("arc lengths", lambda: path.parameter_at(times)),
            WarmUp("lines", lambda: path.flatten(0.1)),
            WarmUp("directions", lambda: path.direction(times)),
            WarmUp("timing curve", lambda: Easing("ease").slope(times)),
        )
