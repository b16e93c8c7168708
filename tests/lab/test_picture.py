"""Pictures of studies: marks in words, what stands at the foot and at the top, who is in the list."""

from __future__ import annotations

import math

import pytest

from game.lab import Axes, Knob, Method, Row, Study, StudyTable
from game.lab import picture as drawn
from game.lab.picture import SERIES, in_words, write_png


def study(**more) -> Study:
    values = {
        "name": "made-up", "title": "Made up", "error": "distance", "error_unit": "m", "counter": "steps",
        "knob": Knob("step", "step", "s"), "settings": list, "trial": None, "reference": "",
        "methods": (
            Method("first", "n steps", 1.0), Method("exact", "a closed form"), Method("idle", "idle")
        ),
        "floor": 1e-12,
    }  # fmt: skip
    return Study(**{**values, **more})


def row(method: str, knob: float, error: float, failure: str = "") -> Row:
    return Row(method, knob, error, 1e-3 / knob, round(1 / knob), failure, {}, {})


@pytest.fixture
def axes(tmp_path, monkeypatch):
    """Draws a table and gives its axes."""
    kept = []

    def draw(table: StudyTable):
        real = drawn._matplotlib()

        class Figure(real[0]):
            def add_subplot(self, *arguments, **more):
                kept.append(super().add_subplot(*arguments, **more))
                return kept[-1]

        monkeypatch.setattr(drawn, "_matplotlib", lambda: (Figure, *real[1:]))
        assert write_png(table, tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
        monkeypatch.undo()
        return kept[-1]

    return draw


@pytest.mark.parametrize(
    ("value", "unit", "plain", "words"),
    [
        (1.0, "m", True, "1 m"), (0.02, "s", True, "20 ms"), (1e-6, "s", True, "1 µs"),
        (1e-15, "m", True, "1 fm"), (200.0, "", True, "200"), (1e4, "", True, "10 000"),
        (0.01, "", True, "0.01"), (0.01, "", False, "10⁻²"), (1e-10, "", True, "10⁻¹⁰"),
        (5e-4, "", True, "5·10⁻⁴"), (1e6, "", True, "10⁶"), (30.0, "°", True, "30"),
    ],
)  # fmt: skip
def test_marks_in_words(value: float, unit: str, plain: bool, words: str):
    assert in_words(value, unit, plain).replace("\u202f", " ") == words


def labels(axis) -> list[str]:
    return [axis.get_major_formatter()(place) for place in axis.get_majorticklocs()]


def test_rounding_stands_at_the_foot_and_what_is_beyond_measure_at_the_top(axes):
    rows = [row("first", h, h) for h in (0.1, 0.01, 0.001, 0.0001)]
    rows += [row("exact", 0.1, 1e-16), row("exact", 0.01, 0.0), row("first", 0.5, 1e30, "diverged")]
    made = axes(StudyTable(study(), rows))
    assert labels(made.yaxis)[0] == "rounding"
    assert len(made.xaxis.get_minorticklocs()) == len(made.yaxis.get_minorticklocs()) == 0
    heights = [y for line in made.lines for y in line.get_ydata()]
    assert min(heights) == pytest.approx(1e-4 / 3.0) and max(heights) == pytest.approx(3.0)


def test_errors_of_nought_are_none_at_all(axes):
    rows = [row("first", h, h) for h in (0.1, 0.01, 0.001)] + [row("exact", 0.1, 0.0)]
    made = axes(StudyTable(study(), rows))
    assert labels(made.yaxis)[0] == "none"
    assert made.get_xlabel() == "CPU time for one simulated second"


def test_failures_are_seen_where_nothing_else_is(axes):
    rows = [row("first", h, 2.0 + h, "passes through") for h in (0.1, 0.01)] + [row("exact", 0.1, 0.0)]
    heights = [y for line in axes(StudyTable(study(), rows)).lines for y in line.get_ydata()]
    assert {2.1, 2.01} < set(heights)
    rows = [row("first", h, math.inf, "diverged") for h in (0.1, 0.01)]
    heights = [y for line in axes(StudyTable(study(), rows)).lines for y in line.get_ydata()]
    assert len(heights) == 2 and all(math.isfinite(y) for y in heights)


def test_the_list_tells_order_and_failures_of_those_that_ran(axes):
    rows = [row("first", h, h) for h in (0.1, 0.01, 0.001, 1e-4)] + [row("first", 0.5, 9.0, "diverged")]
    rows.append(row("exact", 0.1, 1e-16))
    words = [text.get_text() for text in axes(StudyTable(study(), rows)).get_legend().get_texts()]
    assert words == ["n steps\norder 1.00 of 1\n× failed at 1 of 5", "A closed form"]


def test_a_cost_against_a_knob(axes):
    rows = [row("first", h, 1.0) for h in (1.0, 2.0, 4.0, 8.0)]
    made = axes(StudyTable(study(axes=Axes("knob", "cpu"), cost="CPU time for one query"), rows))
    assert made.texts[0].get_text() == "CPU time for one query"
    assert [word.replace("\u202f", " ") for word in labels(made.xaxis)] == ["1 s", "2 s", "5 s"]


def test_lines_are_told_apart_by_more_than_colour():
    assert len({colour for colour, _ in SERIES}) == len({shape for _, shape in SERIES}) == len(SERIES)
