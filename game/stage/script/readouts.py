"""What a story asks of the readouts: comparisons that make a moment, and numbers in a caption."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from game.stage.declarations import Readout
from game.stage.script.numbers import number_words

COMPARISONS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
_CONDITION = re.compile(r"\s*(.+?)\s*(<=|>=|<|>)\s*(\S+)\s*")
_NUMBER = re.compile(r"\{(\|?)([^{}:|]+)\1(:\.\d[feg])?\}")
_NEAR = 0.05  # of a threshold: a measured value so near to it says the threshold


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
    return [found[2] for found in _NUMBER.finditer(caption)]


def filled(caption: str, readouts: Iterable[Readout]) -> str:
    """A caption with its numbers; a dash for what is not measured now. {|READOUT|} leaves the sign out."""
    values = {readout.name: readout for readout in readouts}

    def words(found: re.Match[str]) -> str:
        readout = values.get(found[2])
        value, unit = (readout.value, readout.unit) if readout is not None else (math.nan, "")
        return number_words(abs(value) if found[1] else value, unit, (found[3] or "")[1:])

    return _NUMBER.sub(words, caption)


def thresholds_in(caption: str, conditions: Iterable[Condition], values: Mapping[str, Readout]) -> list[str]:
    """The readouts of a caption of which it would give no more than what its moment waited for.

    As a moment is the step at which a readout passes a number, the readout has that number then. A count is
    what it is.
    """
    named = set(named_in(caption))
    found = []
    for condition in conditions:
        readout = values.get(condition.readout)
        if readout is None or condition.readout not in named:
            continue
        counted = not readout.unit and float(readout.value).is_integer()
        if not counted and abs(readout.value - condition.number) <= _NEAR * abs(condition.number):
            found.append(condition.readout)
    return found
