"""What a work-precision plot shows: runs, methods, the present setting; and axes of whole decades."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

Parameters = Mapping[str, Any]
MOST_DECADES = 16
HIGHEST = 308  # decade of a float


class PlotPoint(NamedTuple):
    """One run: what it is at (``x``, mostly CPU seconds for a simulated one) and what came of it (``y``)."""

    x: float
    y: float
    diverged: bool = False
    pending: bool = False  # still to be measured: the place is an estimate
    parameters: Parameters = {}  # that set the scene to it
    words: str = ""  # what it is, e.g. "240 steps a second"
    mark: str = ""  # a word that stands beside it


class PlotSeries(NamedTuple):
    """A method: its runs from left to right, its fitted order (nan if unknown) and how it is drawn.

    ``cloud`` holds further runs that are small dots without a line, where there are very many.
    """

    name: str
    points: tuple[PlotPoint, ...]
    order: float = math.nan
    color: str = "chalk"
    marker: str = "disc"
    cloud: tuple[PlotPoint, ...] = ()

    @property
    def runs(self) -> tuple[PlotPoint, ...]:
        """All runs; ``WorkPrecisionPlot.hit`` gives a place in this."""
        return self.points + self.cloud


class PlotAxes(NamedTuple):
    """Words and units of both axes, a short word over the vertical one."""

    x: str = "CPU time for one simulated second"
    x_unit: str = "s"
    y: str = "Error"
    y_unit: str = "m"


class Present(NamedTuple):
    """The scene's own setting: its point, its words, and the method it is a point of (-1 if none).

    ``head``: what it is to be called, above its words.
    """

    series: int
    point: PlotPoint
    words: str = ""
    head: str = "you are here"


class Range(NamedTuple):
    """Whole decades of one axis."""

    low: int
    high: int


def decades(values: Sequence[float], least: int = 2) -> Range:
    """Whole decades that hold all positive finite values, at least so many; the highest that is a number."""
    logs = [math.log10(value) for value in values if math.isfinite(value) and value > 0.0]
    if not logs:
        return Range(-least, 0)
    low, high = math.floor(min(logs) + 1e-9), math.ceil(max(logs) - 1e-9)
    while high - low < least:
        low, high = (low, high + 1) if (high - low) % 2 else (low - 1, high)
    over = max(high - HIGHEST, 0)
    low, high = low - over, high - over
    return Range(max(low, high - MOST_DECADES), high)
