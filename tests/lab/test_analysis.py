"""Orders, costs and order of points on made-up tables whose answers are known."""

import math

import numpy as np
import pytest

from game.lab.analysis import (
    cost_to_reach,
    fit_exponent,
    fit_order,
    out_of_order,
    settled,
    slope_of,
    summarise,
    upper_envelope,
)
from game.lab.study import Axes, Knob, Method, Row, Study, StudyTable


def row(knob, error, cost, failure="", method="m"):
    return Row(method, knob, error, cost, max(1, int(1e6 * cost)), failure, {}, {})


def power_law(order, constant=2.0, saw=0.0):
    """Error constant h^order, times a saw-tooth in [1 - saw, 1]; cost 1e-3 / h."""
    rows = []
    for i, h in enumerate(np.geomspace(1.0, 1e-3, 300).tolist()):
        tooth = 1.0 - saw * ((7 * i) % 11) / 10.0
        rows.append(row(h, constant * h**order * tooth, 1e-3 / h))
    return rows


@pytest.mark.parametrize("order", [1.0, 2.0, 4.0])
def test_order_of_a_power_law(order):
    assert fit_order(power_law(order)) == pytest.approx(order, abs=1e-12)
    assert fit_order(power_law(order), over="counter") == pytest.approx(order, abs=0.01)


def test_pairs_out_of_order_are_found_in_whatever_order_rows_come():
    rows = [row(2.0, 0.2, 2.0), row(1.0, 0.1, 1.0), row(4.0, 0.01, 4.0)]  # the knob counts what is done
    for shuffled in (rows, rows[::-1], [rows[2], rows[0], rows[1]]):
        assert out_of_order(shuffled) == [(rows[1], rows[0])]


def test_order_of_the_upper_envelope_is_not_misled_by_lucky_points():
    rows = power_law(1.0, saw=0.999)
    assert fit_order(rows, envelope=True) == pytest.approx(1.0, abs=0.15)
    assert len(upper_envelope(rows)) <= 20
    assert upper_envelope([]) == []
    assert len(upper_envelope([row(1.0, 1.0, 1.0), row(1.0, 2.0, 1.0)])) == 1


def test_rounding_and_failures_take_no_part_in_fits():
    rows = [
        *power_law(2.0),
        row(1e-4, 1e-14, 10.0),
        row(2.0, 1e9, 1e-4, "diverged"),
        row(3.0, math.inf, 1e-4, "diverged"),
    ]
    assert fit_order(rows, floor=1e-13) == pytest.approx(2.0, abs=1e-12)
    assert math.isnan(fit_order(rows[:2]))


def test_points_beyond_the_last_failure():
    rows = power_law(1.0)
    assert settled(rows, []) == rows
    finer = settled(rows, [row(0.1, 1.0, 1.0, "missed")])
    assert max(r.knob for r in finer) < 0.1
    assert settled(rows, [row(0.002, 1.0, 1.0, "missed")]) == rows  # too few left to fit


def test_what_counts_parts_is_finer_beyond_its_last_failure():
    rows = [row(1.0 / r.knob, r.error, r.cpu_s) for r in power_law(1.0)]
    finer = settled(rows, [row(10.0, 1.0, 1.0, "missed")], parts=True)
    assert min(r.knob for r in finer) > 10.0
    assert settled(rows, [row(500.0, 1.0, 1.0, "missed")], parts=True) == rows  # too few left to fit


@pytest.mark.parametrize("parts", [False, True])
def test_an_order_is_above_nothing_where_what_is_finer_errs_less(parts: bool):
    """Whether the knob is a length that shrinks or a number of parts that grows."""
    rows = [row(1.0 / r.knob if parts else r.knob, r.error, r.cpu_s) for r in power_law(2.0)]
    study = Study(
        "s", "S", "e", "m", "c", Knob("n", "number", parts=parts), (Method("m", "m", 2.0),), list, None, ""
    )
    failed = row(0.5 if parts else 2.0, 1.0, 1e-4, "thrown out")
    table = StudyTable(study, [failed, *rows])
    assert summarise(table)[0].order == pytest.approx(2.0)


def test_cost_to_reach_an_error():
    rows = power_law(1.0)
    for target in (1e-1, 1e-2):
        assert cost_to_reach(rows, target) == pytest.approx(1e-3 * 2.0 / target, rel=1e-9)
    assert math.isnan(cost_to_reach(rows, 1e-9))
    assert cost_to_reach(rows, 10.0) == rows[0].cpu_s
    assert math.isnan(cost_to_reach([], 1.0))
    assert cost_to_reach([row(1.0, 0.0, 0.5)], 1e-6) == 0.5


def test_a_lucky_cheap_point_does_not_count_as_reached():
    rows = [row(1.0, 1e-9, 1.0), row(0.5, 1e-1, 2.0), row(0.25, 1e-3, 4.0)]
    assert 2.0 < cost_to_reach(rows, 1e-2) < 4.0


def test_points_out_of_order_are_found():
    assert out_of_order(power_law(1.0)) == []
    rows = [row(1.0, 1e-3, 1.0), row(0.5, 1e-2, 2.0), row(0.25, 1e-4, 4.0)]
    assert out_of_order(rows) == [(rows[0], rows[1])]


def test_summary_has_a_line_for_each_method():
    study = Study(
        "s",
        "S",
        "error",
        "m",
        "steps",
        Knob("h", "step"),
        (Method("m", "M", 2.0), Method("n", "N")),
        list,
        lambda s: None,
        "",
    )
    table = StudyTable(study, [*power_law(2.0), row(2.0, math.nan, 1.0, "diverged")])
    first, second = summarise(table)
    assert (first.points, first.failed, first.expected) == (300, 1, 2.0)
    assert first.order == pytest.approx(2.0)
    assert (second.points, second.failed) == (0, 0)
    assert math.isnan(second.order)


def test_an_exponent_of_cost_is_fitted_beyond_the_fixed_part():
    rows = [row(n, 1.0, 1e-5 + 1e-8 * n * n) for n in (10.0 * 2.0**i for i in range(12))]
    assert fit_exponent(rows) == pytest.approx(2.0, abs=0.05)
    assert math.isnan(fit_exponent(rows[:2])) and math.isnan(fit_exponent([]))


def test_only_what_an_order_is_expected_of_has_a_slope():
    rows = [row(2.0**i, 2.0**-i, 1e-6 * 4.0**i) for i in range(8)]
    made = {
        "name": "s", "title": "S", "error": "e", "error_unit": "m", "counter": "c",
        "knob": Knob("n", "number"),
        "methods": (Method("m", "m"),), "settings": list, "trial": None, "reference": "",
    }  # fmt: skip
    study = Study(**made, axes=Axes("knob", "cpu"))
    assert slope_of(study, Method("m", "m", 2.0), rows) == pytest.approx(2.0)
    assert math.isnan(slope_of(study, Method("m", "m"), rows))
    made["knob"] = Knob("n", "number", parts=True)
    assert slope_of(Study(**made), Method("m", "m", 1.0), rows) == pytest.approx(1.0)
    assert math.isnan(slope_of(Study(**made), Method("m", "m"), rows))
    assert math.isnan(slope_of(Study(**made, ceiling=0.02), Method("m", "m", 1.0), rows))  # too few are left
    assert (study.across(rows[3]), study.up(rows[3])) == (8.0, 64e-6)
    with pytest.raises(ValueError, match="axes"):
        Study(**made, axes=Axes("time", "cpu"))


def counted(error: float, counter: int, knob: float = 1.0) -> Row:
    return Row("m", knob, error, 1e-3 * (counter + 1), counter, "", {}, {})


def test_what_counted_nothing_stands_with_the_least_that_counts():
    rows = [counted(0.5, 0), counted(0.2, 1), counted(0.1, 1000)]
    assert upper_envelope(rows, over="counter") == [rows[2], rows[0]]
    assert upper_envelope([counted(0.5, 0), counted(0.7, 0)], over="counter") == [counted(0.7, 0)]
    part = math.log(0.5 / 0.15) / math.log(0.5 / 0.1)
    assert cost_to_reach(rows, 0.15, envelope=True) == pytest.approx(1e-3 * 1001.0**part)


def test_what_counted_nothing_takes_no_part_in_an_order_over_the_counter():
    rows = [counted(1.0 / n, n) for n in (10, 100, 1000)]
    assert fit_order([counted(3.0, 0), *rows], over="counter") == pytest.approx(1.0, abs=1e-12)
