"""What the points of a study say: order of convergence, cost of an accuracy, points out of order."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.lab.study import Method, Row, Study, StudyTable
from game.physics.kernels import elementary, elementwise

ENVELOPE_BINS = 20
TARGETS = (1e-2, 1e-4, 1e-6)
SPAN = 6.0  # of the knob, that an order may be fitted over
FIXED = 4.0  # times the least cost, from which on the fixed part of it does not count
LARGER = 1.5  # an error must be so many times larger, at so many times the cost, to be out of order


def usable(rows: Sequence[Row], floor: float) -> list[Row]:
    """Rows that did not fail and whose error is above rounding, by falling knob."""
    return sorted((row for row in rows if not row.failed and row.error > floor), key=lambda row: -row.knob)


def upper_envelope(rows: Sequence[Row], bins: int = ENVELOPE_BINS, over: str = "knob") -> list[Row]:
    """The row with the largest error in each of so many bins, evenly spaced in the logarithm of the knob.

    over: `knob` or `counter`, what the bins are of. What counted nothing stands with the least that counts.
    """
    if len(rows) <= 1:
        return list(rows)
    places = np.array([float(getattr(row, over)) for row in rows])
    counted = places[places > 0.0]
    logs = elementwise.log(np.maximum(places, counted.min() if len(counted) else 1.0))
    width = (logs.max() - logs.min()) / bins
    if width == 0.0:
        return [max(rows, key=lambda row: row.error)]
    bin_of = np.minimum((logs - logs.min()) / width, bins - 1).astype(int)
    chosen = []
    for place in range(bins - 1, -1, -1):
        inside = [row for row, at in zip(rows, bin_of.tolist(), strict=True) if at == place]
        if inside:
            chosen.append(max(inside, key=lambda row: row.error))
    return chosen


def fit_order(
    rows: Sequence[Row],
    floor: float = 0.0,
    envelope: bool = False,
    over: str = "knob",
    ceiling: float = math.inf,
) -> float:
    """Least-squares slope of log(error) over log(knob); nan with fewer than three usable points.

    floor, ceiling: errors outside take no part. over: `knob`; or `parts` or `counter`, when the slope is that
    over 1 / knob or 1 / counter: above 0 as long as what is finer errs less. What counted nothing has no
    place on its axis, and takes no part.
    """
    axis = "counter" if over == "counter" else "knob"
    points = usable(rows, floor)
    if envelope:
        points = upper_envelope(points, over=axis)
    points = [row for row in points if row.error <= ceiling and float(getattr(row, axis)) > 0.0]
    places = [float(getattr(row, axis)) for row in points]
    if len(set(places)) < 3:
        return math.nan
    slope = float(np.polyfit(elementwise.log(places), elementwise.log([row.error for row in points]), 1)[0])
    return slope if over == "knob" else -slope


def fit_exponent(rows: Sequence[Row]) -> float:
    """Least-squares slope of log(cost) over log(knob); nan with fewer than three points to fit.

    Only points that cost FIXED times the cheapest are fitted: below them the cost of a call hides the law.
    """
    paid = [row for row in rows if not row.failed and row.cpu_s > 0.0 and row.knob > 0.0]
    least = min((row.cpu_s for row in paid), default=0.0)
    points = [row for row in paid if row.cpu_s >= FIXED * least]
    if len({row.knob for row in points}) < 3:
        return math.nan
    return float(
        np.polyfit(elementwise.log([r.knob for r in points]), elementwise.log([r.cpu_s for r in points]), 1)[
            0
        ]
    )


def slope_of(study: Study, method: Method, rows: Sequence[Row]) -> float:
    """The slope that the study's picture tells of one method: order of the error, or exponent of the cost.

    Where none is expected there is none: a cost may be a U, an error zero, or fall geometrically.
    """
    if method.order is None:
        return math.nan
    if study.axes.up == "cpu":
        return fit_exponent(rows)
    return fit_order(rows, study.floor, study.envelope, study.refined_over, study.ceiling)


def settled(rows: Sequence[Row], failures: Sequence[Row], parts: bool = False) -> list[Row]:
    """Rows finer than the last failure, if they span a factor SPAN of the knob; else all.

    Among failures only the lucky points are left to fit, which flattens a curve. parts: see `Knob`.
    """
    sign = -1.0 if parts else 1.0
    beyond = min((sign * row.knob for row in failures), default=math.inf)
    finer = [row for row in rows if sign * row.knob < beyond]
    if finer and max(row.knob for row in finer) >= SPAN * min(row.knob for row in finer):
        return finer
    return list(rows)


def fitted(table: StudyTable, method: str) -> list[Row]:
    """The rows of a method that its slope is fitted to."""
    return settled(table.of(method), table.of(method, failed=True), table.study.knob.parts)


def cost_to_reach(rows: Sequence[Row], target: float, envelope: bool = False) -> float:
    """CPU seconds a simulated second from which on the error stays at or below the target; nan if never.

    The most expensive point that still misses the target and the next one are joined by a straight line in
    the logarithms. With `envelope` only the upper envelope counts, so that a lucky point does not.
    """
    points = [row for row in rows if not row.failed]
    if envelope:
        points = upper_envelope(points, over="counter")
    points.sort(key=lambda row: row.cpu_s)
    misses = [i for i, row in enumerate(points) if row.error > target]
    last = misses[-1] if misses else -1
    if last + 1 >= len(points):
        return math.nan
    after = points[last + 1]
    if last < 0 or after.error <= 0.0 or points[last].cpu_s <= 0.0:
        return after.cpu_s
    before = points[last]
    part = elementary.log(before.error / target) / elementary.log(before.error / after.error)
    return before.cpu_s * elementary.pow(after.cpu_s / before.cpu_s, part)


def out_of_order(rows: Sequence[Row], floor: float = 0.0, envelope: bool = False) -> list[tuple[Row, Row]]:
    """Pairs (cheaper, dearer) of one method where the dearer setting has the larger error.

    Cost is the counter, which is free of noise. Each pair is a defect of the method or needs a reason.
    """
    points = usable(rows, floor)
    if envelope:
        points = upper_envelope(points, over="counter")
    points.sort(key=lambda row: row.counter)
    pairs = []
    for i, cheaper in enumerate(points):
        for dearer in points[i + 1 :]:
            if dearer.counter > LARGER * cheaper.counter and dearer.error > LARGER * cheaper.error:
                pairs.append((cheaper, dearer))
                break
    return pairs


class MethodSummary(NamedTuple):
    """One line of a report: order fitted and expected, cost of the targets, what failed, what is odd."""

    method: str
    label: str
    order: float
    expected: float | None
    costs: tuple[float, ...]
    points: int
    failed: int
    out_of_order: int


def summarise(table: StudyTable, targets: Sequence[float] = TARGETS) -> list[MethodSummary]:
    """A summary of each method. Rows that differ in further knobs are fitted together."""
    study = table.study
    lines = []
    for method in study.methods:
        rows = table.of(method.name)
        lines.append(
            MethodSummary(
                method.name,
                method.label,
                slope_of(study, method, fitted(table, method.name)),
                method.order,
                tuple(cost_to_reach(rows, target, study.envelope) for target in targets),
                len(rows),
                len(table.of(method.name, failed=True)),
                len(out_of_order(rows, study.floor, study.envelope)),
            )
        )
    return lines
