"""From a study's table to the overlay's data: orders and costs of a made-up study with a known law."""

from __future__ import annotations

import dataclasses
import math
from itertools import pairwise

import pytest

from game.lab import Knob, Method, Row, Setting, Study, StudyTable, Workload
from game.lab.studies.animation.skinning import skinning_study
from game.lab.studies.springs import spring_study
from game.ui.charts.accuracy_study import round_error, setting_words, study_data

STEPS = [2.0**-i for i in range(4, 14)]
METHODS = (
    Method("first", "first order", 1.0),
    Method("second", "second order", 2.0),
    Method("unused", "unused"),
)
ORDERS = {"first": 1.0, "second": 2.0}


def error_of(method, step):
    return 0.5 * step ** ORDERS[method]


def settings(steps=STEPS):
    return [Setting(m, step, {}, {"step_length": step}) for m in ORDERS for step in steps]


def study(**options):
    values = {
        "name": "law", "title": "A power law", "error": "distance", "error_unit": "m", "counter": "steps",
        "knob": Knob("step_length", "step", "s"),
        "methods": METHODS, "settings": settings, "trial": lambda setting: None, "reference": "the law.",
        "expectation": "It falls.",
    }  # fmt: skip
    return Study(**{**values, **options})


def row(method, step, failure=""):
    return Row(
        method, step, error_of(method, step), 1e-6 / step, round(1 / step), failure, {}, {"step_length": step}
    )


def table_of(made, rows):
    return StudyTable(made, rows, False)


def test_orders_costs_and_lines():
    made = study()
    data = study_data(table_of(made, [row(s.method, s.knob) for s in made.settings()]), "A scene")
    assert [one.name for one in data.series] == ["First order", "Second order"]
    assert [r.order for r in data.rows] == pytest.approx([1.0, 2.0])
    assert [r.expected for r in data.rows] == [1.0, 2.0]
    assert math.log10(data.target) == round(math.log10(data.target))
    for r, order in zip(data.rows, (1.0, 2.0), strict=True):
        step = (data.target / 0.5) ** (1.0 / order)
        assert r.cost_s == pytest.approx(1e-6 / step, rel=1e-6)
    for one in data.series:
        costs = [point.x for point in one.points]
        assert all(a < b for a, b in pairwise(costs)) and not one.cloud
    assert data.series[0].points[0].parameters == {"step_length": STEPS[0]}
    assert data.sentence.startswith("For ") and "second order" in data.sentence.lower()
    assert data.present is None


def test_a_lesson_is_said_in_place_of_who_is_cheapest():
    made = dataclasses.replace(study(), lesson=True)
    data = study_data(table_of(made, [row(s.method, s.knob) for s in made.settings()]), "A scene")
    assert data.sentence == "It falls."
    assert skinning_study.lesson and spring_study.lesson


def test_runs_to_come_lie_on_the_line_of_those_there_are():
    made = study()
    rows = [row(s.method, s.knob) for s in made.settings() if s.knob > STEPS[6]]
    data = study_data(table_of(made, rows), "A scene")
    for one, method in zip(data.series, ORDERS, strict=True):
        coming = [point for point in one.points if point.pending]
        assert len(coming) == len(STEPS) - 6
        for point, step in zip(coming, STEPS[6:], strict=True):
            assert point.y == pytest.approx(error_of(method, step), rel=1e-6)
            assert point.x == pytest.approx(1e-6 / step, rel=1e-6)
    assert any("Hollow" in note for note in data.notes)


def test_nothing_measured_yet():
    data = study_data(table_of(study(), []), "A scene")
    assert len(data.series) == 2 and not any(one.points for one in data.series)
    assert math.isnan(data.target) and data.sentence == "It falls."


def test_failed_runs_are_marked_and_take_no_part():
    made = study()
    rows = [row(s.method, s.knob, "missed a contact" if s.knob > 0.05 else "") for s in made.settings()]
    data = study_data(table_of(made, rows), "A scene")
    failed = [point for point in data.series[0].points if point.diverged]
    assert len(failed) == 1 and failed[0].words.endswith("missed a contact")
    assert data.rows[0].order == pytest.approx(1.0)


def test_very_many_points_become_a_cloud_about_their_envelope():
    steps = [2.0 ** (-4 - i / 20) for i in range(200)]
    made = study(settings=lambda: settings(steps), envelope=True)
    rows = [
        row(s.method, s.knob)._replace(error=error_of(s.method, s.knob) * (0.2 + 0.8 * (i % 3) / 2))
        for i, s in enumerate(made.settings())
    ]
    one = study_data(table_of(made, rows), "A scene").series[0]
    assert len(one.points) <= 16 and len(one.points) + len(one.cloud) == 200
    assert len(one.runs) == 200


def test_the_present_setting_and_its_words():
    made = study()
    rows = [row(s.method, s.knob) for s in made.settings()]
    data = study_data(table_of(made, rows), "A scene", row("second", 0.01))
    assert data.present.series == 1 and data.present.words == "Second order, step 10.0 ms"
    data = study_data(table_of(made, rows), "A scene", row("first", 0.01)._replace(method="present"))
    assert data.present.series == -1 and data.present.words == "step 10.0 ms"  # of none, however near a line
    assert data.present.head == "your settings"
    same = study(workload=Workload("a law", lambda parameters: ""))
    assert study_data(table_of(same, rows), "A scene", row("first", 0.01)).present.head == "you are here"
    assert setting_words(made.knob, 0.5, (("passes", 5.0),)) == "step 500 ms, passes 5"


def test_the_round_error_is_one_that_all_methods_reach():
    made = study()
    rows = [row(s.method, s.knob) for s in made.settings()]
    least = {m: min(r.error for r in rows if r.method == m) for m in ORDERS}
    assert round_error(table_of(made, rows)) == pytest.approx(
        10.0 ** math.ceil(math.log10(max(least.values())))
    )


def test_a_scene_without_a_place_among_the_points_is_told_why():
    made = study()
    rows = [row(s.method, s.knob) for s in made.settings()]
    data = study_data(table_of(made, rows), "A scene", place="No mark: nothing is turned.")
    assert data.present is None and data.notes[0] == "No mark: nothing is turned."


def test_no_costs_are_compared_where_no_round_error_is_reached():
    """Such as of errors that are all nothing but rounding: "For - m, ..." was said of them."""
    made = study(floor=1.0)
    data = study_data(table_of(made, [row(s.method, s.knob) for s in made.settings()]), "A scene")
    assert math.isnan(data.target) and data.sentence == "It falls."
    assert all(math.isnan(one.cost_s) for one in data.rows)
