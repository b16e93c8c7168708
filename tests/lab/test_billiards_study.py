"""Studies of the three tables: first order where the game is the same, the formula for missed hits."""

import dataclasses
import math
from types import SimpleNamespace

import pytest

from game.lab.analysis import fit_order, summarise
from game.lab.runner import measure, run_study
from game.lab.studies.billiards import chances
from game.lab.studies.billiards.effects import EFFECTS, effects_study
from game.lab.studies.billiards.flights import LEVEL, flights_study, stroke_at
from game.lab.studies.billiards.hits import missed_hits_study, overlap_study
from game.lab.studies.billiards.missed_hits import HIT_SHOTS
from game.lab.studies.billiards.tables import billiards_study, lossless_study
from game.lab.study import Setting

RANGES = {"stepped_step": (1 / 20000, 1 / 20), "lecture_step": (1 / 2000, 1 / 20), "passes": (1, 50)}


def part_of(study, wanted):
    """The study with some of its settings."""
    settings = [setting for setting in study.settings() if wanted(setting)]
    return dataclasses.replace(study, settings=lambda: settings, related=())


@pytest.mark.parametrize(("method", "below"), [("stepped", 1 / 240), ("lecture", 1 / 200)])
def test_without_loss_both_stepped_tables_are_of_first_order(method, below):
    table = run_study(part_of(lossless_study, lambda s: s.method == method and s.knob < below), repeats=1)
    rows = table.of(method)
    assert not table.of(method, failed=True)
    assert fit_order(rows, lossless_study.floor, envelope=True) == pytest.approx(1.0, abs=0.15)


def test_with_spin_the_stepped_table_is_of_first_order():
    table = run_study(part_of(billiards_study, lambda s: s.others.get("passes") == 4), repeats=1)
    (line, *_) = summarise(table)
    assert line.method == "stepped"
    assert line.order == pytest.approx(1.0, abs=0.15)


def test_with_spin_the_lecture_plays_another_game_at_any_step():
    chosen = part_of(billiards_study, lambda s: s.method == "lecture" and s.knob > 1 / 300)
    table = run_study(chosen, repeats=1)
    assert {row.failure for row in table} == {"makes other contacts"}


def test_long_steps_make_other_contacts_and_are_marked():
    table = run_study(
        part_of(billiards_study, lambda s: s.method == "stepped" and s.knob > 1 / 40), repeats=1
    )
    assert table.of("stepped", failed=True)


def test_the_exact_table_is_its_own_reference():
    row = measure(billiards_study, Setting("exact", 1e-3), repeats=1)
    assert row.error == 0.0
    assert row.counter > 0


@pytest.mark.parametrize("model", ["stepped", "lecture"])
def test_hits_are_missed_as_often_as_the_formula_says(model):
    table = run_study(part_of(missed_hits_study, lambda s: s.method == model and s.knob > 1 / 70), repeats=1)
    assert len(table) >= 4
    for row in table:
        share = row.others["formula"]
        assert abs(row.error - share) <= 4.0 * math.sqrt(share * (1.0 - share) / HIT_SHOTS)


def test_overlap_falls_with_passes():
    table = run_study(part_of(overlap_study, lambda s: s.knob == 1 / 240), repeats=1)
    one, four, twenty = (row.error for row in table)
    assert one > 2.0 * four > 20.0 * twenty > 0.0
    assert not any(row.failed for row in table)


def test_without_an_effect_balls_go_elsewhere_and_the_cloth_is_half_of_the_events():
    table = run_study(effects_study, repeats=1)
    rows = {row.key: row for row in table}
    assert {row.error for row in table.of("all")} == {0.0}
    assert all(row.error > 1e-3 for row in table if row.method in EFFECTS)
    assert rows["cloth", 16.0].counter < 0.7 * rows["all", 16.0].counter


def test_settings_open_the_scene_where_they_were_measured():
    for study in (billiards_study, lossless_study, missed_hits_study, overlap_study):
        for setting in study.settings():
            assert set(setting.scene) <= set(RANGES)
            for name, value in setting.scene.items():
                least, most = RANGES[name]
                assert least * (1 - 1e-9) <= value <= most * (1 + 1e-9)


def test_the_scenes_setting_is_placed():
    setting = billiards_study.present({"stepped_step": 1 / 240, "passes": 4.0, "lecture_step": 1 / 60})
    assert setting.key == ("stepped", 1 / 240, ("passes", 4))
    assert math.isfinite(measure(billiards_study, setting, repeats=1).error)


def test_a_level_cue_costs_no_flight_and_a_raised_one_its_bounces():
    """The same events with and without the effect where nothing leaves the slate; then the landings more."""
    for airborne in (True, False):
        level = measure(flights_study, Setting("air" if airborne else "slate", LEVEL), repeats=1)
        assert level.error == 0.0 and level.counter > 0
    assert not stroke_at(LEVEL, True).flies and stroke_at(30.0, True).flies
    raised = measure(flights_study, Setting("air", 30.0), repeats=1)
    grounded = measure(flights_study, Setting("slate", 30.0), repeats=1)
    assert raised.error == 0.0 and grounded.error > 0.1 and raised.counter != grounded.counter


def test_a_chance_is_counted_from_nothing_each_time(monkeypatch):
    """Three of four strokes score; a new trial stands at its start, and a reset one stands there again."""
    played = []

    def summarize(trajectory, cue):
        played.append(trajectory)
        scored = SimpleNamespace(cushions=chances.WANTED.cushions)
        return SimpleNamespace(scoring=lambda ball: scored if len(played) % 4 else None)

    monkeypatch.setattr(chances, "simulate", lambda shot, model: shot)
    monkeypatch.setattr(chances, "summarize_carom", summarize)
    monkeypatch.setattr(chances, "true_chance", lambda: 0.5)
    trial = chances.Chance(Setting("stepped", 4.0))
    trial.run()
    assert trial.outcome()[:2] == (0.25, 4)
    trial.reset()
    trial.run()
    assert trial.outcome()[:2] == (0.25, 4)
