"""What a level expects of a readout, beside what is measured: one line each, for as long as one looks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, NamedTuple

import msgspec

from game.scenes.shared.entry import LevelEntry
from game.stage import Readout
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

Number = Annotated[float, msgspec.Meta(ge=-1e12, le=1e12)]


class Expectation(LevelEntry, frozen=True, kw_only=True):
    """What a readout should be, or become (SI), give or take ``within``."""

    readout: Annotated[str, msgspec.Meta(max_length=40)]
    value: Number
    within: Annotated[float, msgspec.Meta(ge=0.0, le=1e12)] = 0.0


Expectations = Annotated[tuple[Expectation, ...], msgspec.Meta(max_length=4)]


class Caption(NamedTuple):
    """Words, and whether what is measured is as expected."""

    words: str
    met: bool


def captions_of(expected: Sequence[Expectation], readouts: Sequence[Readout]) -> list[Caption]:
    """One caption for each expectation. ValueError, naming it, if there is no such readout."""
    measured = {readout.name: readout for readout in readouts}
    found = []
    for i, entry in enumerate(expected):
        if entry.readout not in measured:
            known = ", ".join(measured)
            raise ValueError(f"expected[{i}].readout: no readout {entry.readout!r}; there are {known}")
        _, value, unit = measured[entry.readout]
        met = abs(value - entry.value) <= entry.within
        counted = isinstance(value, int) and float(entry.value).is_integer()
        aim = int(entry.value) if counted else entry.value
        shown = aim if met else value  # no figures of rounding
        words = f"{entry.readout}: expected {format_si(aim, unit)}, measured {format_si(shown, unit)}"
        found.append(Caption(words, met))
    return found


def draw_captions(canvas: Canvas, top: tuple[float, float], captions: Sequence[Caption]) -> None:
    """Line by line from a place (m) downwards: green where it is as expected, amber where not, or not yet."""
    for line, (words, met) in enumerate(captions):
        offset = (0.0, 14.0 + 20.0 * line)
        canvas.label(top, words, "green" if met else "amber", 13, "semibold", "top", offset)
