"""What a study of cost against accuracy consists of, and what it gives.

A study names methods and settings, builds a trial for each setting, and says when a trial has failed. A
setting that fails stays in the table and is marked, as where a method breaks is half of what a study tells.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol

COST = "CPU time for one simulated second"
PRESENT = "present"  # the method of a scene's own setting that is none of the study's


@dataclass(frozen=True)
class Method:
    """A way to compute: name for tables, label for pictures, the order of convergence expected of it.

    color: by its name in the theme, where a scene shows the method as well; else the series' own.
    """

    name: str
    label: str
    order: float | None = None
    note: str = ""
    color: str = ""


@dataclass(frozen=True)
class Knob:
    """What is turned: name, label and unit.

    parts: it counts what the whole is divided into, such as cells or substeps, or how much is taken into
    account: more of it is finer, where a step or a tolerance is finer as it shrinks.
    """

    name: str
    label: str
    unit: str = ""
    parts: bool = False


@dataclass(frozen=True)
class Setting:
    """One point to be measured.

    knob: value of the study's knob. others: further knobs that tell points of one method apart. scene: the
    scene's parameters at this point, and its effects as true and false, so that it can be opened there.
    weight: expected cost, any unit.
    """

    method: str
    knob: float
    others: Mapping[str, float] = field(default_factory=dict)
    scene: Mapping[str, Any] = field(default_factory=dict)
    weight: float = 1.0

    @property
    def key(self) -> tuple[Any, ...]:
        """What tells this point from others of its study."""
        return self.method, self.knob, *sorted(self.others.items())


class Outcome(NamedTuple):
    """What a trial led to. failure: empty, or in a few words what went wrong."""

    error: float
    counter: int
    failure: str = ""


class Trial(Protocol):
    """One computation that can be repeated from the same start."""

    simulated_s: float

    def reset(self) -> None:
        """Back to the start; not timed."""

    def run(self) -> None:
        """The computation; timed."""

    def outcome(self) -> Outcome:
        """Error and counter of the last run; not timed."""


class Axes(NamedTuple):
    """What the picture of a study shows: ``across``: "cpu" or "knob"; ``up``: "error" or "cpu"."""

    across: str = "cpu"
    up: str = "error"


ACCURACY = Axes()  # what accuracy costs


class Row(NamedTuple):
    """One measured point: method, value of the knob, error, CPU seconds for one simulated second, ..."""

    method: str
    knob: float
    error: float
    cpu_s: float
    counter: int
    failure: str
    others: dict[str, float]
    scene: dict[str, Any]

    @property
    def failed(self) -> bool:
        return bool(self.failure)

    @property
    def key(self) -> tuple[Any, ...]:
        return self.method, self.knob, *sorted(self.others.items())


@dataclass(frozen=True)
class Workload:
    """What the trials of a study compute, and whether a scene computes that as well.

    words: after "measured on". own: a scene's parameters, effects and `standing` to its own workload, after
    "your scene has", empty where it is that of the study; None: the trials are a problem of the study's own,
    on which a scene's settings can be measured, but not the scene.
    """

    words: str = ""
    own: Callable[[Mapping[str, Any]], str] | None = None


@dataclass(frozen=True)
class Study:
    """Cost against accuracy of one scene.

    error, error_unit: what is on the vertical axis. counter: what `Outcome.counter` counts. reference: where
    the exact values come from. settings(): the points, in the order in which they are measured. trial:
    setting to trial. envelope: collisions make the error saw-toothed, so orders are fitted to its upper
    envelope. floor: errors below it are rounding and take no part in fits. ceiling: errors above it are not
    yet those of small steps and take no part either. expectation: what the curves should show, in a sentence
    or two. present: the scene's parameters, effects and `standing` to the setting they amount to, if to any.
    no_place: why a scene has no place among the points, for where it has none. workload: what all this is
    measured on; a scene that has another one has no place either.
    axes: what its picture shows; accuracy against cost, unless what is bought is no accuracy. short: its name
    among the studies of its scene. related: further studies of the same scene. cost: what the CPU time is
    for, where the seconds that its trials simulate stand for something else. mark: a word beside the point of
    a row, such as the quality that scenes call it; empty for most. lesson: its expectation is said
    below the plot, as it tells more than which method is cheapest.
    """

    name: str
    title: str
    error: str
    error_unit: str
    counter: str
    knob: Knob
    methods: tuple[Method, ...]
    settings: Callable[[], Sequence[Setting]]
    trial: Callable[[Setting], Trial]
    reference: str
    expectation: str = ""
    order_over: str = "knob"
    envelope: bool = False
    floor: float = 1e-13
    ceiling: float = math.inf
    present: Callable[[Mapping[str, Any]], Setting | None] | None = None
    no_place: str = ""
    workload: Workload = Workload()
    axes: Axes = ACCURACY
    short: str = ""
    cost: str = COST
    lesson: bool = False
    mark: Callable[[Row], str] | None = None
    related: tuple[Study, ...] = ()

    def __post_init__(self) -> None:
        names = [method.name for method in self.methods]
        if not names or len(set(names)) != len(names):
            raise ValueError(f"study {self.name}: needs methods with different names, got {names}")
        if self.order_over not in ("knob", "counter"):
            raise ValueError(
                f"study {self.name}: order_over must be knob or counter, got {self.order_over!r}"
            )

        if self.axes.across not in ("cpu", "knob") or self.axes.up not in ("error", "cpu"):
            raise ValueError(f"study {self.name}: axes must be cpu or knob, error or cpu, got {self.axes}")

    @property
    def family(self) -> tuple[Study, ...]:
        """This study and those related to it, the way a scene offers them."""
        return (self, *self.related)

    def place(self, parameters: Mapping[str, Any]) -> tuple[Setting | None, str]:
        """Where a scene stands among the points, or None and why it has no place; all in words.

        parameters: the scene's parameters, effects and `standing`.
        """
        setting = self.present(parameters) if self.present is not None else None
        if setting is None:
            return None, self.no_place
        if self.workload.own is None:
            return setting, f"Measured on {self.workload.words}, with your settings."
        own = self.workload.own(parameters)
        if own:
            return None, f"No mark: measured on {self.workload.words}; your scene has {own}."
        return setting, f"Measured on {self.workload.words}, as your scene has them."

    @property
    def refined_over(self) -> str:
        """What an order is that of: of the error over the "knob", over 1 / knob ("parts"), or 1 / counter."""
        return "parts" if self.order_over == "knob" and self.knob.parts else self.order_over

    @property
    def slope_name(self) -> str:
        """What the slope of a curve is called."""
        return "order" if self.axes.up == "error" else "exponent"

    def across(self, row: Row) -> float:
        """Where a row stands in the picture, from left to right."""
        return row.cpu_s if self.axes.across == "cpu" else row.knob

    def up(self, row: Row) -> float:
        """How high a row stands in the picture."""
        return row.error if self.axes.up == "error" else row.cpu_s

    def across_words(self) -> tuple[str, str]:
        """What runs from left to right, and its unit."""
        return (self.cost, "s") if self.axes.across == "cpu" else (self.knob.label, self.knob.unit)

    def up_words(self) -> tuple[str, str]:
        """What runs upwards, and its unit."""
        return (self.error, self.error_unit) if self.axes.up == "error" else (self.cost, "s")

    def method(self, name: str) -> Method:
        """The method of that name; ValueError if there is none."""
        for method in self.methods:
            if method.name == name:
                return method
        raise ValueError(f"study {self.name}: no method {name!r}")


@dataclass
class StudyTable:
    """Rows measured so far; `complete` when none is missing. Iterates over its rows."""

    study: Study
    rows: list[Row] = field(default_factory=list)
    complete: bool = False

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def of(self, method: str, failed: bool | None = False) -> list[Row]:
        """Rows of a method: those that did not fail, those that did (True), or all (None)."""
        return [row for row in self.rows if row.method == method and failed in (None, row.failed)]

    def to_dict(self) -> dict[str, Any]:
        """Plain values, as for a JSON file; `from_dict` takes them back."""
        return {
            "study": self.study.name,
            "complete": self.complete,
            "rows": [row._asdict() for row in self.rows],
        }

    @classmethod
    def from_dict(cls, study: Study, values: Mapping[str, Any]) -> StudyTable:
        """The table that `to_dict` gave. ValueError if it belongs to another study or rows lack fields."""
        if values.get("study") != study.name:
            raise ValueError(f"study table: belongs to {values.get('study')!r}, not to {study.name!r}")
        rows = []
        for i, fields in enumerate(values.get("rows", ())):
            if set(fields) != set(Row._fields):
                raise ValueError(f"study table rows[{i}]: must have the fields {', '.join(Row._fields)}")
            rows.append(Row(**fields))
        return cls(study, rows, bool(values.get("complete", False)))
