"""What a story asks of the readouts: comparisons that make a moment, and numbers in a caption."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from game.stage.declarations import Readout

COMPARISONS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
_CONDITION = re.compile(r"\s*(.+?)\s*(<=|>=|<|>)\s*(\S+)\s*")
_NUMBER = re.compile(r"\{([^{}:]+)(:\.\d[feg])?\}")
_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
_SCALED = frozenset(("m", "s", "J", "W", "N", "Hz", "Pa", "m/s"))  # units that take a prefix


class Condition(NamedTuple):
    """A readout beside a number."""

    readout: str
    comparison: str
    number: float

    def holds(self, values: Mapping[str, Readout]) -> bool:
        """Whether it is so; not for a readout that is not measured now, or that is not a number."""
        found = values.get(self.readout)
        if found is None or math.isnan(found.value):
            return False
        return bool(COMPARISONS[self.comparison](found.value, self.number))


def parse_condition(words: str) -> Condition:
    """The condition that "READOUT > NUMBER" says; ValueError for other words."""
    found = _CONDITION.fullmatch(words)
    try:
        number = float(found[3]) if found is not None else math.nan
    except ValueError:
        number = math.nan
    if found is None or not math.isfinite(number):
        raise ValueError(f"{words!r}: expected READOUT < NUMBER, or with <=, > or >=")
    return Condition(found[1], found[2], number)


def named_in(caption: str) -> list[str]:
    """The readouts whose numbers a caption gives; ValueError for a brace that stands for none."""
    rest = _NUMBER.sub("", caption)
    if "{" in rest or "}" in rest:
        raise ValueError(f"{caption!r}: expected {{READOUT}} or {{READOUT:.1f}} between braces")
    return [found[1] for found in _NUMBER.finditer(caption)]


def filled(caption: str, readouts: Iterable[Readout]) -> str:
    """A caption with its numbers; a dash for what is not measured now."""
    values = {readout.name: readout for readout in readouts}

    def words(found: re.Match[str]) -> str:
        readout = values.get(found[1])
        if readout is None or not math.isfinite(readout.value):
            return "–"
        if found[2]:
            return format(readout.value, found[2][1:]).replace("-", "−")
        return _with_unit(readout.value, readout.unit)

    return _NUMBER.sub(words, caption)


def _with_unit(value: float, unit: str) -> str:
    """Three digits and the unit."""
    prefix = ""
    if unit in _SCALED and value:
        rows = (row for row in _PREFIXES if abs(value) >= 0.9995 * row[0])
        factor, prefix = next(rows, _PREFIXES[-1])
        value /= factor
    whole = float(value).is_integer() and abs(value) < 1e7
    number = f"{value:,.0f}".replace(",", "\u202f") if whole or abs(value) >= 1000.0 else f"{value:.3g}"
    return f"{number} {prefix}{unit}".strip().replace("-", "−")
