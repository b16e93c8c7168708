"""Measured beside expected, as captions of a story show it: readouts are noted step by step, and drawn."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from game.arrays import Floats
from game.stage.declarations import Comparison, Readout
from game.stage.script.course import Course
from game.stage.script.lines import Chart, Say, Story
from game.stage.script.readouts import named_in

if TYPE_CHECKING:
    from game.stage.stage import Stage

TIME = "time"  # of the simulation, s, where no readout is called so
NO_PLACE = 0.0  # of a mark


class _Note(NamedTuple):
    """What the readouts of a chart were at a step: place along the axis below, measured, expected."""

    step: int
    place: float
    measured: float
    expected: float


class ChartWatch:
    """Notes for each chart of a story what its readouts say, from the step on at which it is to begin."""

    def __init__(self, story: Story, stage: Stage, course: Course) -> None:
        self._stage, self._course = stage, course
        self._charts = {
            i: line.chart
            for i, line in enumerate(story.lines)
            if isinstance(line, Say) and line.chart is not None
        }
        # marks beside a number of the caption are of the caption's moment, as the number is
        self._held = {
            i
            for i, line in enumerate(story.lines)
            if isinstance(line, Say) and i in self._charts and not self._charts[i].over
            and set(named_in(line.say)) & set(readouts_of(line.chart))
        }  # fmt: skip
        self._notes: dict[int, list[_Note]] = {}
        self._units: dict[str, str] = {}
        self.restart()

    def restart(self) -> None:
        """Nothing was noted yet."""
        self._notes = {i: [] for i, chart in self._charts.items() if not chart.shows}

    def forget_after(self, step: int) -> None:
        """Drop what was noted after a step."""
        for notes in self._notes.values():
            while notes and notes[-1].step > step:
                notes.pop()

    @property
    def waiting(self) -> bool:
        """Whether there is anything to note."""
        return bool(self._notes)

    def look(self, values: Mapping[str, Readout]) -> None:
        """Note what has changed since the last look; values that are not numbers are left out."""
        self._units = {name: readout.unit for name, readout in values.items()}
        for number, notes in self._notes.items():
            chart = self._charts[number]
            if chart.since and chart.since not in self._course.reached:
                continue
            begun = self._course.begun.get(number) if number in self._held else None
            if begun is not None and notes and self._stage.step_number > begun.step:
                continue
            note = self._note(chart, values)
            if all(map(math.isfinite, note[1:])) and (not notes or note[1:] != notes[-1][1:]):
                notes.append(note)

    def _note(self, chart: Chart, values: Mapping[str, Readout]) -> _Note:
        place = NO_PLACE if not chart.over else _value(chart.over, values)
        if chart.over == TIME and TIME not in values:
            place = self._stage.time_s
        expected = chart.expected
        return _Note(
            self._stage.step_number,
            place,
            _value(chart.measured, values),
            float(expected) if not isinstance(expected, str) else _value(expected, values),
        )

    def comparison(self, line: int) -> Comparison | None:
        """What the chart of a line shows now; None if it has none, or if nothing was measured yet."""
        chart = self._charts.get(line)
        if chart is None:
            return None
        if chart.shows:
            found = self._stage.scene.story_charts()[chart.shows]
            return found if len(found.measured) else None
        notes = self._notes[line]
        if not notes:
            return None
        table = np.array([note[1:] for note in notes])
        if not chart.over:
            table = table[-1:]
        falls = np.flatnonzero(np.diff(table[:, 0]) < 0.0)
        table = table[falls[-1] + 1 :] if len(falls) else table
        if chart.mean:
            table = _trailing_mean(table, chart.mean)
        expected = "expected" if not isinstance(chart.expected, str) else chart.expected
        return Comparison(
            table[:, [0, 1]],
            table[:, [0, 2]],
            chart.names or (chart.measured, expected),
            self._units.get(chart.measured, ""),
            chart.over,
            self._units.get(chart.over, "s" if chart.over == TIME else ""),
            limit=(chart.limited, chart.limit) if chart.limit is not None else None,
        )


def _trailing_mean(table: Floats, reach: float) -> Floats:
    """Rows (n, 3) of place, measured and expected, each the mean of those not farther back than ``reach``."""
    sums = np.concatenate([np.zeros((1, 2)), np.cumsum(table[:, 1:], axis=0)])
    first = np.searchsorted(table[:, 0], table[:, 0] - reach, side="left")
    ends = np.arange(1, len(table) + 1)
    return np.column_stack([table[:, 0], (sums[ends] - sums[first]) / (ends - first)[:, None]])


def _value(name: str, values: Mapping[str, Readout]) -> float:
    readout = values.get(name)
    return readout.value if readout is not None else math.nan


def readouts_of(chart: Chart | None) -> list[str]:
    """The readouts that a chart draws."""
    if chart is None or chart.shows:
        return []
    named = [chart.measured, *([chart.expected] if isinstance(chart.expected, str) else [])]
    return [*named, *([chart.over] if chart.over not in ("", TIME) else [])]


def check_chart(chart: Chart, moments: Sequence[str]) -> None:
    """ValueError for one that says too little, or two things."""
    if chart.shows and (chart.measured or chart.expected != "" or chart.over or chart.since or chart.names):
        raise ValueError("chart.shows: names everything that is drawn")
    if not chart.shows and not (chart.measured and chart.expected != ""):
        raise ValueError("chart: expected measured and expected, or shows")
    if chart.mean and not chart.over:
        raise ValueError("chart.mean: along what is not said (over)")
    if chart.limit is not None and not (chart.over and math.isfinite(chart.limit)):
        raise ValueError("chart.limit: expected a finite number, across a curve (over)")
    if isinstance(chart.expected, float) and not math.isfinite(chart.expected):
        raise ValueError("chart.expected: not a finite number")
    if chart.since and chart.since not in moments:
        raise ValueError(f"chart.since: no moment is called {chart.since!r}")
