"""What accuracy costs between key-frames: how many keys a method needs, and what lines and lengths cost.

A smooth motion, exp(sin 2 pi t), is known at so many keys; the error is the worst difference between them. A
sample costs about the same by every method, so what counts is the number of keys. Evenly spaced keys flatter:
with spacings of 1 to 3 in turn some methods lose one order or two.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study
from game.physics.animation import CubicBezier, Keyframes

Array = NDArray[np.float64]
SAMPLES = 100_001
DEFAULT_KEYS = 8  # of the level that the scene opens with
COUNTS = (8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512)
METHODS: dict[str, tuple[str, float, float]] = {  # label, order over even keys, over uneven ones
    "nearest": ("Nearest key", 1.0, 1.0),
    "linear": ("Linear", 2.0, 2.0),
    "flat": ("Rest at every key", 1.0, 1.0),
    "monotone": ("Monotone", 2.0, 2.0),
    "catmull-rom": ("Catmull-Rom", 3.0, 1.0),
    "secant": ("Secants", 3.0, 2.0),
    "parabolic": ("Parabolas", 3.0, 3.0),
    "natural-spline": ("Natural spline", 2.0, 2.0),
    "spline": ("Spline", 4.0, 4.0),
    "bezier": ("Exact Bezier", 4.0, 4.0),
}


def wave(t: Array) -> Array:
    """The motion, m."""
    return np.asarray(np.exp(np.sin(2.0 * np.pi * t)))


def wave_slope(t: Array) -> Array:
    """Its velocity, m/s."""
    return np.asarray(2.0 * np.pi * np.cos(2.0 * np.pi * t) * wave(t))


def key_times(keys: int, uneven: bool) -> Array:
    """Times (keys + 1,) s from 0 to 1, even or 1 : 3 : 1 : 3 ... apart."""
    if not uneven:
        return np.linspace(0.0, 1.0, keys + 1)
    times = np.concatenate(([0.0], np.cumsum(np.where(np.arange(keys) % 2 == 0, 1.0, 3.0))))
    return np.asarray(times / times[-1])


def wave_track(name: str, times: Array) -> Keyframes:
    """The motion at keys; Bezier handles from the exact velocities."""
    handles = None
    if name == "bezier":
        h, slope = np.diff(times), wave_slope(times)
        handles = np.zeros((len(times), 2, 1))
        handles[1:, 0, 0], handles[:-1, 1, 0] = -slope[1:] * h / 3.0, slope[:-1] * h / 3.0
    return Keyframes(times, wave(times)[:, None], name, handles=handles)


class Samples:
    """A second of the motion at 100 001 times."""

    simulated_s = 1.0

    def __init__(self, name: str, keys: int, uneven: bool) -> None:
        self.keys = keys
        self.track = wave_track(name, key_times(keys, uneven))
        self.at = np.linspace(0.0, 1.0, SAMPLES)
        self.found = np.empty((SAMPLES, 1))

    def reset(self) -> None:
        """Nothing is left of a run."""

    def run(self) -> None:
        self.track.sample(self.at, self.found)

    def outcome(self) -> Outcome:
        return Outcome(float(np.abs(self.found[:, 0] - wave(self.at)).max()), self.keys)


def key_settings(names: Sequence[str]) -> list[Setting]:
    """These methods at 8 to 512 keys; every fourth number first, so the whole soon shows."""
    counts = [count for first in range(4) for count in COUNTS[first::4]]
    scenes: dict[str, dict[str, Any]] = {name: {"interpolation": name} for name in names}
    scenes["bezier"] = {}  # the scene does not know the exact velocities
    return [Setting(name, float(n), {}, scenes[name]) for n in counts for name in names]


def even_trial(setting: Setting) -> Samples:
    """Keys at even times."""
    return Samples(setting.method, int(setting.knob), False)


def uneven_trial(setting: Setting) -> Samples:
    """Keys 1 : 3 apart."""
    return Samples(setting.method, int(setting.knob), True)


def present_even(parameters: Mapping[str, Any]) -> Setting:
    """Where the scene with these parameters stands: several methods are one if keys are even."""
    name = present_uneven(parameters).method
    return Setting("catmull-rom" if name in ("parabolic", "secant") else name, float(DEFAULT_KEYS))


def present_uneven(parameters: Mapping[str, Any]) -> Setting:
    """The same for uneven keys. Handles of Bezier curves that nobody has dragged are those of parabolas."""
    name = str(parameters["interpolation"])
    return Setting("parabolic" if name == "bezier" else name, float(DEFAULT_KEYS))


# -- lines that a curve is drawn by ---------------------------------------------------------------------

HOOK = ((0.0, 0.0), (6.0, 0.0), (6.3, 0.6), (0.5, 0.8))  # m; a sharp bend after a long straight part
CURVES_A_RUN = 20
TOLERANCES = tuple(float(x) for x in np.geomspace(0.3, 3e-6, 14))


class Lines:
    """A hook as a chain of lines; error: how far the curve is from them at most."""

    def __init__(self, how: str, tolerance: float) -> None:
        self.simulated_s = float(CURVES_A_RUN)
        self.curve, self.how, self.tolerance = CubicBezier(HOOK), how, tolerance
        self.chain = np.zeros((0, 2))

    def reset(self) -> None:
        """Nothing is left of a run."""

    def run(self) -> None:
        for _ in range(CURVES_A_RUN):
            self.chain = self.curve.flatten(self.tolerance, self.how)  # type: ignore[arg-type]

    def outcome(self) -> Outcome:
        return Outcome(
            distance_to_chain(self.curve.point(np.linspace(0.0, 1.0, 4001)), self.chain), len(self.chain) - 1
        )


def distance_to_chain(points: Array, chain: Array) -> float:
    """The largest distance of points (k, 2) that follow a chain (n, 2) from one of its next few lines."""
    best = np.full(len(points), np.inf)
    way = np.diff(chain, axis=0)
    for a, w in zip(chain[:-1], way, strict=True):
        square = float(w @ w)
        share = np.clip((points - a) @ w / square, 0.0, 1.0) if square > 0.0 else np.zeros(len(points))
        off = points - a - share[:, None] * w
        np.minimum(best, (off * off).sum(axis=1), out=best)
    return math.sqrt(float(best.max()))


def line_settings() -> list[Setting]:
    """Both ways at tolerances of 30 cm to 3 micrometres."""
    return [
        Setting(
            how, tolerance, {}, {"tolerance": min(max(tolerance, 0.0005), 0.5)}, 1.0 / math.sqrt(tolerance)
        )
        for tolerance in TOLERANCES
        for how in ("even", "adaptive")
    ]


def line_trial(setting: Setting) -> Lines:
    """The hook at a tolerance."""
    return Lines(setting.method, setting.knob)


def present_lines(parameters: Mapping[str, Any]) -> Setting:
    """The scene halves pieces to its tolerance."""
    return Setting("adaptive", float(parameters["tolerance"]))


# -- constant speed -------------------------------------------------------------------------------------

BEND = ((0.0, 0.0), (0.3, 2.0), (5.0, 2.0), (5.2, -1.0))  # m; fast in the middle
WAYS = 200
COPIES = 10  # of them in one run, so that what is measured is not the clock
EVALUATIONS = (4, 8, 16, 32, 64, 128, 256, 512, 1024)


class Spread:
    """Parameters of 200 equal ways along a bend; error: how far along it the worst is off."""

    simulated_s = float(COPIES)

    def __init__(self, how: str, evaluations: int) -> None:
        self.how, self.evaluations = how, evaluations
        self.curve = CubicBezier(BEND)
        self.ways = np.linspace(0.0, self.curve.length, WAYS + 1)
        self.found = np.zeros(WAYS + 1)

    def reset(self) -> None:
        """Nothing is left of a run."""

    def run(self) -> None:
        for _ in range(COPIES):
            self.spread()

    def spread(self) -> None:
        """The parameters once."""
        n = self.evaluations
        if self.how == "newton":
            self.found = CubicBezier(BEND).parameter_at(self.ways)
        elif self.how == "even":
            self.found = self.ways / self.ways[-1]
        else:
            u = np.linspace(0.0, 1.0, n + 1)
            way = np.diff(self.curve.point(u), axis=0)
            table = np.concatenate(([0.0], np.cumsum(np.sqrt((way * way).sum(axis=1)))))
            self.found = np.interp(self.ways / self.ways[-1] * table[-1], table, u)

    def outcome(self) -> Outcome:
        off = self.curve.length_to(self.found) - self.ways
        return Outcome(float(np.abs(off).max()), self.evaluations)


def spread_settings() -> list[Setting]:
    """A table of 4 to 1024 chords; what comes without a table, and the solution, once each."""
    once = [Setting("even", 1.0), Setting("newton", 1.0)]
    return once + [Setting("table", float(n)) for n in EVALUATIONS]


def spread_trial(setting: Setting) -> Spread:
    """The bend by one of them."""
    return Spread(setting.method, int(setting.knob))


EVEN = ("nearest", "linear", "flat", "natural-spline", "catmull-rom", "spline", "bezier")
UNEVEN = ("linear", "monotone", "catmull-rom", "secant", "parabolic", "spline", "bezier")
_KEYS = Knob("keys", "key-frames")

spread_study = Study(
    name="c01-speed",
    title="Key-frames: even speed",
    error="distance along the path from equal ways",
    error_unit="m",
    counter="chords in the table",
    knob=Knob("chords", "chords in the table"),
    methods=(
        Method("even", "Even parameter"),
        Method("table", "Table of chords", 2.0),
        Method("newton", "Gauss-Legendre and Newton"),
    ),
    settings=spread_settings,
    trial=spread_trial,
    reference="adaptive Gauss-Legendre quadrature of the speed.",
    expectation="A table of chords is of second order; Newton's method on the integral is exact at once.",
    order_over="counter",
    axes=Axes("cpu", "error"),
    short="Even speed",
)

line_study = Study(
    name="c01-lines",
    title="Key-frames: lines to draw a curve by",
    error="distance of curve and lines",
    error_unit="m",
    counter="lines",
    knob=Knob("tolerance", "tolerance", "m"),
    methods=(Method("even", "Wang's even parts", 2.0), Method("adaptive", "Halved until flat", 2.0)),
    settings=line_settings,
    trial=line_trial,
    reference="4 001 points of the curve.",
    expectation="Both keep the tolerance; where the bend is sharp, halving needs a third fewer lines.",
    order_over="counter",
    floor=1e-9,
    present=present_lines,
    axes=Axes("cpu", "error"),
    short="Lines",
)

uneven_study = Study(
    name="c01-uneven",
    title="Key-frames: keys 1 : 3 apart",
    error="error of exp(sin 2πt), the largest",
    error_unit="m",
    counter="key-frames",
    knob=_KEYS,
    methods=tuple(Method(name, METHODS[name][0], METHODS[name][2]) for name in UNEVEN),
    settings=partial(key_settings, UNEVEN),
    trial=uneven_trial,
    reference="the function itself at 100 001 times.",
    expectation=(
        "Keys that are not evenly spaced cost Catmull-Rom two orders if their times are ignored, and one "
        "with plain secants; parabolas keep three, splines and exact handles four."
    ),
    order_over="counter",
    present=present_uneven,
    axes=Axes("knob", "error"),
    short="Uneven keys",
)

keyframing_study = Study(
    name="c01",
    title="Key-frames: evenly spaced keys",
    error="error of exp(sin 2πt), the largest",
    error_unit="m",
    counter="key-frames",
    knob=_KEYS,
    methods=tuple(Method(name, METHODS[name][0], METHODS[name][1]) for name in EVEN),
    settings=partial(key_settings, EVEN),
    trial=even_trial,
    reference="the function itself at 100 001 times.",
    expectation=(
        "Orders 1, 2, 3 and 4. To rest at every key is of first order like nearest neighbour, and natural "
        "ends make a spline one of second order, however smooth they look."
    ),
    order_over="counter",
    present=present_even,
    axes=Axes("knob", "error"),
    short="Even keys",
    related=(uneven_study, line_study, spread_study),
)
