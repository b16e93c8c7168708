"""What accuracy costs along a path: lines to draw it by, and equal ways in equal times."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.animation import CubicBezier

# -- lines that a curve is drawn by ---------------------------------------------------------------------

HOOK = ((0.0, 0.0), (6.0, 0.0), (6.3, 0.6), (0.5, 0.8))  # m; a sharp bend after a long straight part
CURVES_A_RUN = 20
TOLERANCES = tuple(float(x) for x in np.geomspace(0.3, 3e-6, 14))


def distance_to_chain(points: Floats, chain: Floats) -> float:
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


def line_trial(setting: Setting) -> Trial:
    """The hook at a tolerance: the largest distance of the curve from its lines."""
    curve, how = CubicBezier(HOOK), setting.method

    def work() -> Floats:
        for _ in range(CURVES_A_RUN):
            chain = curve.flatten(setting.knob, how)  # type: ignore[arg-type]
        return chain

    def judge(chain: Floats) -> Outcome:
        points = curve.point(np.linspace(0.0, 1.0, 4001))
        return Outcome(distance_to_chain(points, chain), len(chain) - 1)

    return computation(float(CURVES_A_RUN), work, judge)


def present_lines(parameters: Mapping[str, Any]) -> Setting:
    """The scene halves pieces to its tolerance."""
    return Setting("adaptive", float(parameters["tolerance"]))


# -- constant speed -------------------------------------------------------------------------------------

BEND = ((0.0, 0.0), (0.3, 2.0), (5.0, 2.0), (5.2, -1.0))  # m; fast in the middle
WAYS = 200
COPIES = 10  # of them in one run, so that what is measured is not the clock
EVALUATIONS = (4, 8, 16, 32, 64, 128, 256, 512, 1024)


def spread(how: str, evaluations: int, curve: CubicBezier, ways: Floats) -> Floats:
    """Parameters of equal ways along a curve."""
    if how == "newton":
        return CubicBezier(BEND).parameter_at(ways)
    if how == "even":
        return np.asarray(ways / ways[-1])
    u = np.linspace(0.0, 1.0, evaluations + 1)
    way = np.diff(curve.point(u), axis=0)
    table = np.concatenate(([0.0], np.cumsum(np.sqrt((way * way).sum(axis=1)))))
    return np.interp(ways / ways[-1] * table[-1], table, u)


def spread_settings() -> list[Setting]:
    """A table of 4 to 1024 chords; what comes without a table, and the solution, once each."""
    spread = {"constant-speed": True}
    once = [Setting("even", 1.0, {}, {"constant-speed": False}), Setting("newton", 1.0, {}, spread)]
    return once + [Setting("table", float(n), {}, spread) for n in EVALUATIONS]


def present_spread(parameters: Mapping[str, Any]) -> Setting:
    """The scene solves for constant speed if it is to have it."""
    return Setting("newton" if parameters["constant-speed"] else "even", 1.0)


def spread_trial(setting: Setting) -> Trial:
    """Parameters of 200 equal ways along a bend by one of them: how far along it the worst is off."""
    curve, evaluations = CubicBezier(BEND), int(setting.knob)
    ways = np.linspace(0.0, curve.length, WAYS + 1)

    def work() -> Floats:
        for _ in range(COPIES):
            found = spread(setting.method, evaluations, curve, ways)
        return found

    def judge(found: Floats) -> Outcome:
        return Outcome(float(np.abs(curve.length_to(found) - ways).max()), evaluations)

    return computation(float(COPIES), work, judge)


spread_study = Study(
    name="c01-speed",
    title="Key-frames: constant speed",
    error="distance along the path from equal spacing",
    error_unit="m",
    counter="chords in the table",
    knob=Knob("chords", "chords in the table", parts=True),
    methods=(
        Method("even", "uniform parameter"),
        Method("table", "table of chords", 2.0),
        Method("newton", "Gauss-Legendre and Newton"),
    ),
    settings=spread_settings,
    trial=spread_trial,
    present=present_spread,
    workload=Workload("one bend"),
    reference="adaptive Gauss-Legendre quadrature of the speed.",
    expectation="A table of chords is of second order; Newton's method on the integral is exact at once.",
    order_over="counter",
    axes=Axes("cpu", "error"),
    short="Constant speed",
    cost="CPU time for 200 positions",
)

line_study = Study(
    name="c01-lines",
    title="Key-frames: lines to draw a curve by",
    error="distance of curve and lines",
    error_unit="m",
    counter="lines",
    knob=Knob("tolerance", "tolerance", "m"),
    methods=(Method("even", "Wang's even parts", 2.0), Method("adaptive", "halved until flat", 2.0)),
    settings=line_settings,
    trial=line_trial,
    reference="4 001 points of the curve.",
    expectation="Both keep the tolerance; where the bend is sharp, halving needs a third fewer lines.",
    order_over="counter",
    floor=1e-9,
    present=present_lines,
    workload=Workload("one hook"),
    axes=Axes("cpu", "error"),
    short="Lines",
    cost="CPU time for one curve",
)
