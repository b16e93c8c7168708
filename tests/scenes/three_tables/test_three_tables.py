"""One stroke on three tables: what agrees, what differs, and by how much."""

import math

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.scenes.shared.tables.view import Balls
from game.scenes.three_tables.chart import span_at
from game.scenes.three_tables.places import ORIGINS, table_at
from game.scenes.three_tables.scene import ThreeTables
from game.scenes.three_tables.view import outlines_of
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.stage.states.memory import remember


def open_level(name: str, **parameters) -> Stage:
    path = next(path for path in level_files("three-tables") if path.stem == name)
    level = load_level(path, "three-tables", ThreeTables.content_type)
    return Stage(ThreeTables, level=level, parameters=parameters)


def seconds(stage: Stage, s: float) -> Stage:
    stage.run(round(s / stage.dt))
    assert stage.fault is None
    return stage


def test_the_draw_comes_back_where_there_is_spin():
    stage = open_level("draw-shot")
    tables = stage.scene.model.played.tables
    hit = next(event.time for event in tables["exact"].events if event.type == "ball-ball")
    later = hit + 1.0
    assert tables["exact"].state_at(later).velocities[0, 1] < -0.05
    assert tables["stepped"].state_at(later).velocities[0, 1] < -0.05
    assert tables["lecture"].state_at(later).velocities[0, 1] >= 0.0


def test_a_finer_step_comes_nearer_to_the_exact_table():
    errors = []
    for step in (1 / 120, 1 / 480, 1 / 1920, 1 / 7680):
        stage = open_level("draw-shot", stepped_step=step)
        errors.append(max(stage.scene.model.differences_until(1.0)["stepped"][:30]))
    assert errors[-1] < 0.2 * errors[0]
    assert errors[-1] < errors[1]


def test_the_masse_bends_on_the_exact_table_only_with_spin():
    def bend(stage: Stage, name: str) -> float:
        places = np.array(
            [
                stage.scene.model.played.tables[name].state_at(t).positions[0]
                for t in np.linspace(0.0, 0.5, 20)
            ]
        )
        chord = places[-1] - places[0]
        off = (places - places[0]) @ np.array((-chord[1], chord[0])) / np.linalg.norm(chord)
        return float(np.abs(off).max())

    stage = open_level("masse")
    assert bend(stage, "exact") > 0.005
    assert bend(stage, "lecture") < 1e-9


def test_chaos_a_picometre_becomes_a_metre():
    stage = open_level("hard-01-chaos")
    curve = np.array(stage.scene.model.differences_until(60.0)["perturbed"])
    assert curve[0] == pytest.approx(1e-12, rel=1e-3)
    assert curve.max() > 0.5
    before = stage.scene.model.played.event_times[:20]
    assert curve[: int(before[5] * 30)].max(initial=0.0) < 1e-6


def test_differences_are_computed_only_as_far_as_they_are_asked_for():
    model = open_level("hard-01-chaos").scene.model
    assert model.played.tables["exact"].end_time > 10.0
    few = model.differences_until(2.0)
    assert {len(curve) for curve in few.values()} == {61}
    assert len(model.played.differences) == 61
    known = {"played", "_shelf"} & remember(model).attributes.keys()
    assert not known  # snapshots do not copy what can be had again
    more = model.differences_until(3.0)
    assert all(more[name][:61] == curve for name, curve in few.items())
    assert all(len(curve) <= 30.0 * 60.0 + 1 for curve in model.differences_until(1e9).values())


LONG = {"stepped_step": 1 / 20000, "lecture_step": 1 / 2000}  # a minute of it takes more than a second


def test_a_stroke_is_computed_as_time_goes_on_and_not_before():
    scene = open_level("hard-01-chaos", **LONG).scene
    for _ in range(10):
        scene.advance(scene.dt)
    assert all(table.end_time < 0.1 and not table.complete for table in scene.model.played.stepping)


def test_time_stands_still_until_a_shorter_step_has_caught_up():
    stage = seconds(open_level("hard-01-chaos"), 3.0)
    stage.post(SetParameter("stepped_step", LONG["stepped_step"]))
    time = float(stage.scene.model.shot[1])
    stage.run(1)
    assert stage.scene.model.shot[1] == time
    slice_s = stage.scene.model.played.steps.slice_s
    assert stage.scene.model.shown_s == pytest.approx(slice_s, abs=0.01)
    stage.run(math.ceil(time / slice_s))
    assert time < stage.scene.model.shot[1] <= time + 2.0 * stage.dt


def test_what_has_been_computed_before_leaves_no_trace():
    def digests(far: bool) -> list[str]:
        stage = seconds(open_level("hard-01-chaos"), 2.5)
        for step in (1 / 4000, 1 / 20000, 1 / 4000):
            stage.post(SetParameter("stepped_step", step))
            if far:
                stage.scene.model.played.compute(4.0)
            stage.run(5)
        for _ in range(12):
            stage.step_back()
        middle = stage.digest()
        stage.run(12)
        return [middle, stage.digest()]

    assert digests(far=True) == digests(far=False)


def test_the_thin_hit_is_found_by_the_exact_table():
    stage = open_level("hard-02-thin-cut", lecture_step=1 / 60, stepped_step=1 / 240)
    assert any(event.type == "ball-ball" for event in stage.scene.model.played.tables["exact"].events)


def test_the_cradle_hands_the_push_through():
    stage = open_level("hard-03-cradle")
    exact = stage.scene.model.played.tables["exact"]
    hits = [event for event in exact.events if event.type == "ball-ball"]
    after = exact.state_at(hits[0].time + 0.01).velocities[:, 1]
    assert after[-1] > 5.0 * np.abs(after[1:-1]).max()


def test_a_stroke_by_hand_on_any_of_the_tables():
    for k, (ox, oy) in enumerate(ORIGINS):
        stage = open_level("your-stroke")
        x, y = stage.scene.model.start[0]
        assert table_at(x + ox, y + oy) == k
        stage.post(Pointer("move", x + ox, y + oy + 0.5))
        assert stage.scene.hand.cue.aim == pytest.approx(0.5 * math.pi)
        stage.post(Pointer("down", x + ox, y + oy + 0.5, button=1))
        stage.post(Pointer("move", x + ox, y + oy + 0.3, button=1))
        stage.post(Pointer("up", x + ox, y + oy + 0.3, button=1))
        seconds(stage, 0.5)
        assert stage.scene.model.shot[0] == 1.0
        tables = stage.scene.model.played.tables.values()
        speeds = [np.linalg.norm(table.state_at(0.0).velocities[0]) for table in tables]
        assert speeds == pytest.approx([stage.scene.model.shot[2]] * len(speeds), rel=1e-9)


def test_a_heavier_cue_ball_gets_the_speed_that_is_shown(tmp_path):
    path = tmp_path / "heavy.toml"
    ball = "{ number = 0, position = [0.6, 0.6], mass = 0.3 }"
    path.write_text(f'scene = "three-tables"\n[content]\nballs = [{ball}]\nspeed = 2.0\n')
    stage = Stage(ThreeTables, level=load_level(path, "three-tables", ThreeTables.content_type))
    for table in stage.scene.model.played.tables.values():
        assert np.linalg.norm(table.state_at(0.0).velocities[0]) == pytest.approx(2.0, rel=1e-12)


def test_after_a_shot_all_go_on_from_the_exact_table():
    stage = open_level("draw-shot")
    end = stage.scene.model.played.tables["exact"].final
    for _ in range(100):
        if not stage.scene.model.shot[0]:
            break
        seconds(stage, 0.5)
    assert not stage.scene.model.shot[0]
    assert stage.scene.model.start[0].tolist() == pytest.approx(list(end["0"]), abs=1e-12)


def test_digests_agree_on_two_runs_and_after_stepping_back():
    def played() -> Stage:
        stage = open_level("default")
        seconds(stage, 2.0)
        stage.post(SetParameter("stepped_step", 1 / 100))
        seconds(stage, 1.0)
        stage.post(SetEffect("throw", False))
        return seconds(stage, 1.0)

    first, second = played(), played()
    assert first.digest() == second.digest()
    for _ in range(40):
        first.step_back()
    first.run(40)
    assert first.digest() == second.digest()


def test_it_plays_itself_until_somebody_takes_the_cue_and_racks_again():
    stage = open_level("default")
    seconds(stage, 4.0)
    assert stage.scene.model.shot[0] == 1.0
    stage.post(Pointer("down", 0.5, 0.5, button=1))
    assert not stage.scene.hand.plays_itself
    stage.post(Action("rack"))
    assert stage.scene.model.in_play.all() and not stage.scene.model.shot[0]


def measured(stage: Stage) -> dict[str, tuple[float, str]]:
    return {row.name: (row.value, row.unit) for row in stage.readouts()}


def test_a_second_exact_table_is_measured_where_there_is_one_and_differences_are_lengths():
    stage = seconds(open_level("draw-shot", perturbation="none"), 1.0)
    rows = measured(stage)
    assert "perturbed" not in rows
    assert rows["stepped"] == (rows["difference"][0], "m") and rows["lecture"][1] == "m"
    assert rows["lecture"][0] > rows["stepped"][0] > 0.0
    rows = measured(seconds(open_level("draw-shot", perturbation="1e-3"), 1.0))
    assert rows["perturbed"][1] == "m" and 1e-4 < rows["perturbed"][0] < 3.0
    (strip,) = (strip for strip in ThreeTables.strips if "perturbed" in strip.series)
    assert strip.unit == "m" and "perturbed" in strip.sometimes


def test_the_chart_spans_little_more_than_what_has_been_played():
    assert span_at(0.0) == 3.0 and span_at(6.0) == 6.0 and span_at(6.1) == 10.0 and span_at(59.0) == 60.0
    times = np.linspace(0.0, 60.0, 200).tolist()
    assert all(time <= span_at(time) <= max(3.0, 2.0 * time) for time in times)


def test_outlines_stand_where_the_exact_table_has_the_ball_and_only_where_that_is_elsewhere():
    def balls(places, opacities):
        count = len(places)
        return Balls(
            np.array(places), np.full(count, 0.028), np.arange(count), np.tile(np.eye(3), (count, 1, 1)),
            np.array(opacities),
        )  # fmt: skip

    exact = balls([(0.1, 0.1), (0.2, 0.2), (0.3, 0.3), (0.4, 0.4)], [1.0, 1.0, 0.0, 1.0])
    other = balls([(0.1, 0.1005), (0.25, 0.2), (0.7, 0.7), (0.4, 0.4)], [1.0, 1.0, 1.0, 0.0])
    shown = outlines_of(other, exact)
    assert [place.tolist() for place, _ in shown] == [[0.2, 0.2], [0.4, 0.4]]  # the last fell on one alone
    assert all(radius == 0.028 for _, radius in shown)
