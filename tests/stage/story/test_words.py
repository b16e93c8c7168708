"""Numbers and conditions of a story: as people say them, and not what somebody has typed."""

from __future__ import annotations

import math

import pytest

from game.stage.declarations import Readout
from game.stage.script.course import reading_s
from game.stage.script.numbers import number_words
from game.stage.script.readouts import filled, named_in, parse_condition, thresholds_in


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (1.2345, "m", "1.23 m"), (0.0123, "m", "12.3 mm"), (2500.0, "J", "2.5 kJ"), (3.0, "", "3"),
        (-0.5, "m/s²", "−0.5 m/s²"), (math.nan, "m", "–"), (0.0, "m", "0 m"), (426133.0, "", "426\u202f133"),
        (284313.0, "W/m", "284 kW/m"), (7.33e-7, "m", "733 nm"), (1234.4, "K", "1\u202f230 K"),
        (999.6, "m", "1 km"), (999.4, "m", "999 m"), (-0.0, "%", "0 %"), (0.0499, "%", "0.0499 %"),
        (-82.1e-3, "m", "−82.1 mm"), (1445.2, "kg", "1\u202f450 kg"), (-3.0, "", "−3"),
        (9.96e-13, "s", "0.000996 ns"),
    ],
)  # fmt: skip
def test_a_number_has_three_digits_and_a_prefix(value, unit, words):
    assert number_words(value, unit) == words
    assert filled("{a}", [Readout("a", value, unit)]) == words


@pytest.mark.parametrize(
    ("value", "form", "words"),
    [(1.26, ".1f", "1.3"), (-0.04, ".1f", "0.0"), (-0.06, ".1f", "−0.1"), (1.5e-7, ".1e", "1.5e−07")],
)
def test_a_format_of_ones_own(value, form, words):
    assert number_words(value, "m", form) == words


def test_a_sign_that_says_nothing_is_left_out():
    readouts = [Readout("swing", -0.0821, "m")]
    assert filled("{|swing|} and {|swing|:.2f}", readouts) == "82.1 mm and 0.08"
    assert named_in("{|swing|} beside {a b:.1f}") == ["swing", "a b"]
    with pytest.raises(ValueError, match="between braces"):
        named_in("{|swing}")


def test_what_is_not_measured_is_a_dash():
    assert filled("{c}", [Readout("a", 1.0)]) == "–"


def test_conditions():
    values = {"a b": Readout("a b", 2.0)}
    assert parse_condition("a b >= 2").holds(values) and not parse_condition("a b > 2").holds(values)
    assert parse_condition("a b <= 2.0").holds(values) and not parse_condition("c < 1").holds(values)
    assert not parse_condition("a < 1").holds({"a": Readout("a", math.nan)})


@pytest.mark.parametrize(
    ("readout", "condition", "typed"),
    [
        (Readout("wind", 0.92, "m/s"), "wind > 0.9", ["wind"]),
        (Readout("wind", -1.53, "m/s"), "wind < -1.5", ["wind"]),
        (Readout("kept", 99.9, "%"), "kept > 50", []),  # it has jumped: that is a measurement
        (Readout("burning", 8.0), "burning >= 8", []),  # a count is what it is
        (Readout("share", 8.2), "share >= 8", ["share"]),
    ],
)
def test_a_threshold_is_no_measurement(readout, condition, typed):
    conditions, values = [parse_condition(condition)], {readout.name: readout}
    assert thresholds_in(f"It is {{{readout.name}}}.", conditions, values) == typed
    assert thresholds_in("No number.", conditions, values) == []


def test_reading_takes_its_time():
    assert reading_s("x" * 34) == 2.0 and reading_s("") == 1.8
