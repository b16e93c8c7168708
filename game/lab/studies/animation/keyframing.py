"""What accuracy costs between key-frames: how many keys each method needs.

A smooth motion, exp(sin 2 pi t), is known at so many keys; the error is the worst difference between them. A
sample costs about the same by every method, so what counts is the number of keys. Evenly spaced keys flatter:
with spacings of 1 to 3 in turn some methods lose one order or two.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from game.arrays import Floats
from game.lab.studies.animation.keyframing_paths import line_study, spread_study
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.animation import Keyframes
from game.physics.kernels import elementwise

SAMPLES = 100_001
COUNTS = (8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024)
METHODS: dict[str, tuple[str, float, float]] = {  # label, order over even keys, over uneven ones
    "nearest": ("nearest key", 1.0, 1.0),
    "linear": ("linear", 2.0, 2.0),
    "flat": ("rest at every key", 1.0, 1.0),
    "monotone": ("monotone", 2.0, 2.0),
    "catmull-rom": ("Catmull-Rom", 3.0, 1.0),
    "secant": ("secants", 3.0, 2.0),
    "parabolic": ("parabolas", 3.0, 3.0),
    "natural-spline": ("natural spline", 2.0, 2.0),
    "spline": ("spline", 4.0, 4.0),
    "bezier": ("exact Bezier", 4.0, 4.0),
}


def wave(t: Floats) -> Floats:
    """The motion, m."""
    return np.asarray(elementwise.exp(elementwise.sin(2.0 * np.pi * t)))


def wave_slope(t: Floats) -> Floats:
    """Its velocity, m/s."""
    return np.asarray(2.0 * np.pi * elementwise.cos(2.0 * np.pi * t) * wave(t))


def key_times(keys: int, uneven: bool) -> Floats:
    """Times (keys + 1,) s from 0 to 1, even or 1 : 3 : 1 : 3 ... apart."""
    if not uneven:
        return np.linspace(0.0, 1.0, keys + 1)
    times = np.concatenate(([0.0], np.cumsum(np.where(np.arange(keys) % 2 == 0, 1.0, 3.0))))
    return np.asarray(times / times[-1])


def wave_track(name: str, times: Floats) -> Keyframes:
    """The motion at keys; Bezier handles from the exact velocities."""
    handles = None
    if name == "bezier":
        h, slope = np.diff(times), wave_slope(times)
        handles = np.zeros((len(times), 2, 1))
        handles[1:, 0, 0], handles[:-1, 1, 0] = -slope[1:] * h / 3.0, slope[:-1] * h / 3.0
    return Keyframes(times, wave(times)[:, None], name, handles=handles)


def _samples(name: str, keys: int, uneven: bool) -> Trial:
    """A second of the motion at 100 001 times: the largest error."""
    track, at = wave_track(name, key_times(keys, uneven)), np.linspace(0.0, 1.0, SAMPLES)
    found = np.empty((SAMPLES, 1))

    def judge(_: object) -> Outcome:
        return Outcome(float(np.abs(found[:, 0] - wave(at)).max()), keys)

    return computation(1.0, lambda: track.sample(at, found), judge)


def key_settings(names: Sequence[str]) -> list[Setting]:
    """These methods at 8 to 1024 keys; every fourth number first, so the whole soon shows."""
    counts = [count for first in range(4) for count in COUNTS[first::4]]
    return [Setting(name, float(n), {}, {"interpolation": name}) for n in counts for name in names]


def even_trial(setting: Setting) -> Trial:
    """Keys at even times."""
    return _samples(setting.method, int(setting.knob), False)


def uneven_trial(setting: Setting) -> Trial:
    """Keys 1 : 3 apart."""
    return _samples(setting.method, int(setting.knob), True)


EVEN = ("nearest", "linear", "flat", "natural-spline", "catmull-rom", "spline", "bezier")
UNEVEN = ("linear", "monotone", "catmull-rom", "secant", "parabolic", "spline", "bezier")


def key_study(
    name: str, title: str, names: Sequence[str], uneven: bool, trial: Callable[[Setting], Trial],
    expectation: str, short: str,
    related: tuple[Study, ...] = (),
) -> Study:  # fmt: skip
    """A study of errors against numbers of keys."""
    return Study(
        name=name,
        title=title,
        error="error of exp(sin 2πt), the largest",
        error_unit="m",
        counter="key-frames",
        knob=Knob("keys", "key-frames", parts=True),
        methods=tuple(
            Method(key, label, second if uneven else first)
            for key, (label, first, second) in ((key, METHODS[key]) for key in names)
        ),
        settings=partial(key_settings, names),
        trial=trial,
        reference=f"the function itself at {SAMPLES:,} times.".replace(",", " "),
        expectation=expectation,
        order_over="counter",
        ceiling=0.02,  # m, a hundredth of the motion: with fewer keys its shape is not yet seen
        workload=Workload("exp(sin 2πt)"),
        no_place="No mark: measured on exp(sin 2πt); your scene has paths of its own.",
        axes=Axes("knob", "error"),
        short=short,
        related=related,
    )


uneven_study = key_study(
    "c01-uneven",
    "Key-frames: keys 1 : 3 apart",
    UNEVEN,
    True,
    uneven_trial,
    "Keys that are not evenly spaced cost Catmull-Rom two orders if their times are ignored, and one with "
    "plain secants. Parabolas keep three, splines and exact handles four.",
    "Uneven keys",
)
keyframing_study = key_study(
    "c01",
    "Key-frames: evenly spaced keys",
    EVEN,
    False,
    even_trial,
    "Orders 1, 2, 3 and 4. To rest at every key is of first order like nearest neighbour. Natural ends "
    "make a spline one of second order, however smooth they look.",
    "Even keys",
    (uneven_study, line_study, spread_study),
)
