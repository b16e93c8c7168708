"""What a person may change about the key-framing scene, group by group as the panel shows it."""

from __future__ import annotations

from game.physics.animation import EASINGS, INTERPOLATIONS
from game.scenes.key_frames.clock import REPEATS
from game.scenes.key_frames.level import FARTHEST, MOST_TURNED, View
from game.stage import Choice, Param, Parameters, Toggle

LABELS = (
    "Nearest key", "Linear", "Bezier curves", "Rest at every key", "Catmull-Rom, uniform",
    "Catmull-Rom, centripetal", "Catmull-Rom, chordal", "Secants", "Monotone", "Parabolas", "Natural spline",
    "Spline",
)  # fmt: skip
SHORT = dict(zip(INTERPOLATIONS, LABELS, strict=True))
OWN = "own"  # the timing curve of the level or of the hand
SHAPING = ("interpolation", "closed", "shortest", "turning", "easing")  # undo takes these back as well
CHOSEN = ("key_time", "key_x", "key_y", "key_angle")


TURNS = (-360.0, 360.0)  # degrees, on the slider


def range_of_slider(name: str, view: View) -> tuple[float, float] | None:
    """What the slider of a parameter of the chosen key spans: the part of the world in view, or a turn."""
    ends = {"key_x": (view.left, view.right), "key_y": (view.bottom, view.top), "key_angle": TURNS}.get(name)
    return ends if ends is not None and ends[0] < ends[1] else None


class KeyFrameParameters(Parameters):
    """How the keys are interpolated and timed, the chosen key in numbers, and what is shown."""

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
        label="The box turns", help="angles of the keys, or the direction of the path",
    )  # fmt: skip

    time = Param(
        0.0, 0.0, 1.0, unit="s", step=0.001, group="Time", help="where in the second the box is shown"
    )
    fps = Param(
        60, 1, 240, unit="1/s", whole=True, group="Time", label="Frames per second",
        help="how often playback looks at the curve",
    )  # fmt: skip
    duration = Param(
        3.0, 0.25, 30.0, unit="s", log=True, group="Time", label="The second lasts", help="1 s is real time"
    )
    repeat = Choice(
        "loop", REPEATS, labels=("Again", "Once", "Back"), group="Time",
        label="At the end",
    )  # fmt: skip
    playing = Toggle(True, group="Time", label="Play", in_panel=False)  # Space plays and pauses

    easing = Choice(
        "ease-in-out", (*EASINGS, OWN), group="Timing curve",
        labels=("Linear", "Ease", "Ease in", "Ease out", "Ease in and out", "Swing", "Rush", "My own"),
        help="drag its two handles at the top right", label="Timing curve",
    )  # fmt: skip

    key_time = Param(0.0, 0.0, 1.0, unit="s", step=0.001, group="Chosen key", label="At the time")
    key_x = Param(0.0, -FARTHEST, FARTHEST, unit="m", group="Chosen key", label="x")
    key_y = Param(0.0, -FARTHEST, FARTHEST, unit="m", group="Chosen key", label="y")
    key_angle = Param(0.0, -MOST_TURNED, MOST_TURNED, unit="°", group="Chosen key", label="Angle")

    onion = Param(
        16, 0, 120, whole=True, group="Shown", label="Onion skin", help="boxes at as many equal steps of time"
    )
    compare = Choice(
        "none", ("none", *(name for name in INTERPOLATIONS if name != "bezier")), group="Shown",
        labels=("Nothing", *(label for label in LABELS if label != "Bezier curves")), label="Compared with",
    )  # fmt: skip
    velocity = Toggle(True, group="Shown", label="Velocity")
    formula = Toggle(
        False, group="Shown", label="Formula", help="of the interpolation, with its present numbers"
    )
    corners = Toggle(
        False, group="Shown", label="Lines it is drawn by", help="found by halving pieces until flat"
    )
    tolerance = Param(
        0.005, 0.0005, 0.5, unit="m", log=True, group="Shown", label="Lines are off by", help="at most"
    )
    matrices = Toggle(
        False, group="Shown", label="Rotation matrices mixed", help="what becomes of the box without angles"
    )
