"""The crossover of the race: where curves cross, what is said of it, one colour for a method everywhere."""

from __future__ import annotations

import math

import pytest

from game.lab.studies.broadphase.count import METHOD_COLORS, count_study, work_study
from game.scenes.boxes.hierarchical_grids import HierarchicalGridScene
from game.scenes.boxes.model.crossover import COUNTS, CostCurves, crossing, overtakings
from game.scenes.boxes.parameters import CONTESTANTS
from game.scenes.boxes.race import BroadPhaseRace
from game.scenes.boxes.sweep_and_prune import SweepAndPruneScene
from game.scenes.boxes.view.race import PHASES
from game.scenes.boxes.view.race_plot import ABOVE, area_below, crossover_words
from game.scenes.boxes.view.race_table import times_text
from game.stage import Action, SetParameter, Stage
from game.ui.charts.strips import color_of

SQUARE = {n: 1e-9 * n * n for n in COUNTS}
STRAIGHT = {n: 1e-7 * n for n in COUNTS}


def test_laws_cross_where_they_are_equal():
    assert crossing(SQUARE, STRAIGHT) == pytest.approx(100.0)
    assert math.isnan(crossing(STRAIGHT, SQUARE)), "it never stays below"
    assert crossing(SQUARE, {n: 0.5 * seconds for n, seconds in SQUARE.items()}) == COUNTS[0]
    assert math.isnan(crossing({}, STRAIGHT))


def test_the_last_crossing_counts():
    there_and_back = {**STRAIGHT, 16: 1e-12}  # one lucky measurement
    assert crossing(SQUARE, there_and_back) == pytest.approx(100.0)


def test_what_was_found_is_said_the_first_to_overtake_first():
    curves = CostCurves()
    assert crossover_words(curves).startswith("X looks for")
    for n in COUNTS:
        curves.note_swept("naive", n, SQUARE[n])
        curves.note_swept("sweep", n, 3.0 * STRAIGHT[n])
        curves.note_swept("uniform", n, STRAIGHT[n])
        curves.note_swept("covering", n, 2.0 * SQUARE[n])
    assert crossover_words(curves) == "Naive falls behind: grid from 100, sweep from 300"
    found = overtakings(curves.swept, "naive", CONTESTANTS[1:])
    assert math.isnan(found["covering"]) and "hierarchical" not in found


def test_the_search_measures_all_contestants_and_changes_nothing():
    stage, other = (Stage(BroadPhaseRace, parameters={"count": 50}) for _ in range(2))
    stage.post(Action("crossover"))
    for one in (stage, other):
        one.run(10)
    assert stage.digest() == other.digest()
    swept = stage.scene.model.curves.swept
    assert set(swept) == set(CONTESTANTS)
    assert all(tuple(curve) == COUNTS and min(curve.values()) > 0.0 for curve in swept.values())
    assert swept["naive"][2048] > 20.0 * swept["naive"][64], "it grows with the square"
    assert stage.scene.takes_long(Action("crossover")) and not stage.scene.takes_long(Action("more"))


def test_what_was_seen_is_kept_by_number_and_forgotten_with_the_workload():
    stage = Stage(BroadPhaseRace, parameters={"count": 50})
    stage.run(10)
    stage.post(SetParameter("count", 80))
    stage.run(10)
    assert {50, 80} <= set(stage.scene.model.curves.seen["uniform"])
    stage.post(SetParameter("speed", 1.0))
    assert stage.scene.model.curves.seen == {}


def test_a_method_has_one_colour_everywhere():
    assert {row.name: row.color for row in PHASES} == METHOD_COLORS
    for study in (count_study, work_study):
        assert all(method.color == METHOD_COLORS[method.name] for method in study.methods)
    for scene in (BroadPhaseRace, HierarchicalGridScene, SweepAndPruneScene):
        strip = next(strip for strip in scene.strips if strip.title == "Update and all pairs")
        assert [color_of(strip, name) for name in strip.series] == [METHOD_COLORS[n] for n in strip.series]


def test_factors_are_those_of_the_fastest():
    assert times_text(2e-3, 1e-3) == "2.0 times" and times_text(1e-3, 1e-3) == "fastest"
    assert times_text(math.nan, 1e-3) == "" and times_text(1e-3, math.nan) == ""


def test_the_plot_stands_below_the_table_where_there_is_space():
    assert area_below(2.0) == ABOVE
    below = area_below(5.0)
    assert below.bottom < below.top < 5.0 and below.left > 12.0
    assert below.place(5.0, 1e-6) == (below.left, below.bottom)
    assert below.place(1e5, 1.0) == pytest.approx((below.right, below.top))
    assert below.place(1e9, 10.0) == pytest.approx((below.right, below.top)), "kept within"
