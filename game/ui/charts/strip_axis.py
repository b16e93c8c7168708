"""The axis of a strip chart: round ends that stay put, numbers in its precision, labels pushed apart."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from game.ui.look.numerals import MINUS, format_number, quantity

TRACE = 1e-9  # of the axis' end: what is less is rounding, and may read zero
_TOPS = (1.0, 1.2, 1.6, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0)
_FACTORS = {"G": 1e9, "M": 1e6, "k": 1e3, "": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}


class Axis(NamedTuple):
    """Lower and upper end of a chart, in the series' unit."""

    low: float
    high: float


def round_top(value: float) -> float:
    """A round number a little above ``value``, whose half is neat as well; 1 for nothing."""
    if not (math.isfinite(value) and value > 0.0):
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    for factor in _TOPS:
        if factor * power >= value * 1.04:
            return factor * power
    return 12.0 * power


def axis_for(low: float, high: float, before: Axis | None) -> Axis:
    """Ends that hold the values; the old ones stay while they fit and are not far too wide."""
    if not (math.isfinite(low) and math.isfinite(high)):
        return before or Axis(0.0, 1.0)
    if before is not None and before.low <= low and high <= before.high:
        space = before.high - before.low
        used = max(high, 0.0) - min(low, 0.0)
        if used > 0.3 * space:
            return before
    top = round_top(max(high, 0.0)) if high > 0.0 or low >= 0.0 else 0.0
    bottom = -round_top(-low) if low < 0.0 else 0.0
    if bottom < 0.0 < top:  # the middle rule is zero
        top = max(top, -bottom)
        bottom = -top
    return Axis(bottom, top)


def spread(places: Sequence[float], apart: float, low: float, high: float) -> list[float]:
    """Heights near the wanted ones, in the same order, ``apart`` from each other, within the ends."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    put = [min(max(places[i], low), high) for i in order]
    for _ in range(2):
        for n in range(1, len(put)):
            put[n] = max(put[n], put[n - 1] + apart)
        if put and put[-1] > high:
            put[-1] = high
            for n in range(len(put) - 2, -1, -1):
                put[n] = min(put[n], put[n + 1] - apart)
    found = [0.0] * len(places)
    for n, i in enumerate(order):
        found[i] = put[n]
    return found


def unit_of(axis: Axis, unit: str) -> tuple[str, float]:
    """Unit with an SI prefix for the axis, and what a shown 1 is worth."""
    shown = quantity(max(abs(axis.low), abs(axis.high)), unit).unit
    prefix = shown.removesuffix(unit) if unit and shown.endswith(unit) else ""
    return (shown, _FACTORS[prefix]) if prefix in _FACTORS and prefix else (unit, 1.0)


def end_text(value: float, axis: Axis, unit: str) -> str:
    """The last value of a series in the unit of its axis; one that would read zero there in its own."""
    factor = unit_of(axis, unit)[1]
    most = max(abs(axis.low), abs(axis.high))
    text = value_text(value / factor, most / factor)
    if unit and TRACE * most < abs(value) and not any(c in "123456789" for c in text):
        return " ".join(quantity(value, unit))
    return text


def value_text(value: float, most: float) -> str:
    """A value with as many decimals as three digits of the axis' end have."""
    if not (math.isfinite(value) and 1e-4 < most < 1e7):
        return format_number(value)
    decimals = max(0, 2 - math.floor(math.log10(most)))
    if decimals == 0:
        return format_number(round(value))
    number = f"{abs(value):.{decimals}f}"
    return (MINUS if value < 0.0 and float(number) > 0.0 else "") + number


def rule_text(value: float) -> str:
    """A round number at a rule."""
    if abs(value) >= 1e3 and value == round(value):
        return format_number(int(value))
    return (
        f"{value:.3g}".replace("-", MINUS) if 1e-3 < abs(value) < 1e3 else format_number(round(value, 9), 2)
    )
