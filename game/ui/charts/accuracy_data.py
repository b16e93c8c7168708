"""What the accuracy overlay shows of a study: series, table, present setting, words, progress."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from game.ui.charts.plot_data import PlotAxes, PlotSeries, Present
from game.ui.look.numerals import format_number


class TableRow(NamedTuple):
    """One method: its fitted order and the expected one (nan if unknown), the cost of the round error."""

    name: str
    order: float
    expected: float
    cost_s: float


class AccuracyData(NamedTuple):
    """All that the overlay shows of a study. ``target``: the round error that the costs are for."""

    title: str  # scene and level
    subtitle: str  # what error, against what
    axes: PlotAxes
    series: tuple[PlotSeries, ...] = ()
    rows: tuple[TableRow, ...] = ()  # one for each series
    present: Present | None = None
    target: float = math.nan
    sentence: str = ""
    notes: tuple[str, ...] = ()
    cost_words: str = ""  # over the costs in the table, where they are not for the round error
    slope_words: str = "order"  # over the slopes in the table
    studies: tuple[str, ...] = ()  # short names of all studies of the scene, if there are several
    study: int = 0  # the one shown
    floor: float = 0.0  # errors up to it are rounding and lie at the foot of the plot


class Progress(NamedTuple):
    """How far the runs are."""

    done: int = 0
    total: int = 0
    label: str = ""
    left_s: float = math.nan
    running: bool = False


def sentence_for(rows: Sequence[TableRow], target: str) -> str:
    """A sentence about the cheapest and the most expensive method to reach an error; empty unless two do."""
    reached = sorted(
        (row for row in rows if math.isfinite(row.cost_s) and row.cost_s > 0.0), key=lambda row: row.cost_s
    )
    if len(reached) < 2:
        return ""
    best, worst = reached[0], reached[-1]
    times = worst.cost_s / best.cost_s
    if times < 1.2:
        return f"For {target}, {best.name} and {worst.name} cost about the same."
    return f"For {target}, {best.name} is {format_number(times, 2)} times cheaper than {worst.name}."
