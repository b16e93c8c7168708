"""The ocean: periods beside hydrostatics, crests beside dispersion, heel, rain, spray, sounds, hard
levels."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.scenes.ocean.boat import HEEL, SPEED, UP
from game.scenes.ocean.parameters import OceanContent
from game.scenes.ocean.scene import Ocean
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from tests.scenes.listening import heard_in

LEVELS = {path.stem: path for path in level_files("a15")}
HARD = sorted(name for name in LEVELS if name.startswith("hard"))
CALM: dict[str, Any] = {"wind": 0.0}


def open_level(name: str = "default", **parameters: Any) -> Any:
    return Stage(Ocean, level=load_level(LEVELS[name], "a15", OceanContent), parameters=parameters)


def read(stage: Any) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def run(stage: Any, seconds: float) -> dict[str, float]:
    stage.run(round(seconds / stage.dt))
    return read(stage)


@pytest.mark.parametrize("ballast", [300.0, 900.0, 1300.0])
def test_periods_are_those_of_the_hull_at_rest(ballast: float) -> None:
    for action, measured, law in (
        ("pull", "roll period", "roll by law"),
        ("press", "heave period", "heave by law"),
    ):
        stage = open_level(ballast=ballast, **CALM)
        stage.run(5)
        stage.post(Action(action))
        found = run(stage, 6.0)
        assert found[measured] == pytest.approx(found[law], rel=0.05)


@pytest.mark.parametrize("length", [30.0, 120.0])
def test_a_crest_runs_as_dispersion_says(length: float) -> None:
    stage = open_level(swell=1.0, length=length, **CALM)
    found = run(stage, 2.0)
    assert found["crest by law"] == pytest.approx(math.sqrt(9.81 * length / (2.0 * math.pi)), rel=1e-12)
    assert found["crest speed"] == pytest.approx(found["crest by law"], rel=0.01)


def test_the_sea_grows_to_what_the_wind_makes_of_it() -> None:
    stage = open_level(wind=12.0)
    found = read(stage)
    assert found["wave height"] == pytest.approx(found["height by law"], rel=0.03)
    stage.post(SetParameter("wind", 6.0))
    found = run(stage, 60.0)
    assert found["wave height"] == pytest.approx(found["height by law"], rel=0.03)


def test_more_sheet_less_heel_and_more_ballast_less_heel() -> None:
    heels = []
    for sheet, ballast in ((20.0, 900.0), (70.0, 900.0), (20.0, 2500.0)):
        stage = open_level(wind=12.0, course=90.0, sheet=sheet, ballast=ballast, gusts=0.0)
        stage.post(SetEffect("sea-waves", False))
        heels.append(run(stage, 25.0)["heel"])
    assert heels[0] > heels[1] + 8.0 and heels[0] > heels[2] + 5.0


def test_at_rest_the_water_rights_what_the_wind_heels() -> None:
    stage = open_level(wind=10.0, course=90.0, sheet=30.0, gusts=0.0)
    stage.post(SetEffect("sea-waves", False))
    found = run(stage, 40.0)
    assert found["righting moment"] == pytest.approx(found["heeling moment"], rel=0.06)
    law = found["mass"] * 9.81 * found["righting arm"]
    assert found["heeling moment"] == pytest.approx(law, rel=0.08)
    assert 5.0 < found["heel"] < 30.0 and found["boat speed"] > 1.0


def test_the_sign_of_the_arm_says_whether_it_comes_back() -> None:
    for heel in (80.0, 110.0, 130.0, 160.0):
        stage = open_level(**CALM)
        boat = stage.scene.model.boat
        arm = boat.hull.arm(math.radians(heel))
        boat.pull_over(math.radians(heel))
        assert (run(stage, 15.0)["upside down"] == 0) == (arm > 0.0)


def test_less_ballast_is_a_lesser_range_of_stability() -> None:
    ranges = []
    for ballast in (0.0, 900.0, 2000.0):
        hull = open_level(ballast=ballast).scene.model.boat.hull
        ranges.append(sum(hull.arm(math.radians(one)) > 0.0 for one in range(1, 180)))
    assert ranges[0] < ranges[1] - 15 and ranges[1] < ranges[2] - 10


def test_ballast_that_is_changed_on_the_way_is_taken_in() -> None:
    stage = open_level(**CALM)
    run(stage, 1.0)
    stage.post(SetParameter("ballast", 2400.0))
    stage.run(1)
    stage.step_back()
    stage.run(2)
    found = run(stage, 12.0)
    assert found["mass"] - read(open_level(**CALM))["mass"] == pytest.approx(1500.0)
    assert abs(found["over the water"]) < 0.03


def test_rain_goes_with_the_wind() -> None:
    stage = open_level(wind=12.0, rain=40.0, gusts=0.0)
    found = run(stage, 8.0)
    assert found["rain slants"] == pytest.approx(math.degrees(math.atan(12.0 / 8.0)), abs=1.0)
    stage.post(SetParameter("wind", 4.0))
    assert run(stage, 10.0)["rain slants"] == pytest.approx(math.degrees(math.atan(0.5)), abs=2.0)
    stage.post(SetEffect("rain", False))
    assert math.isnan(run(stage, 12.0)["rain slants"])


def test_drops_fly_where_the_bow_goes_in_and_only_there() -> None:
    assert run(open_level(**CALM), 4.0)["spray"] == 0
    stage = open_level(wind=14.0, course=60.0, sheet=22.0)
    found = run(stage, 8.0)
    assert found["spray"] > 500
    drops = stage.scene.model.spray.drops
    levels = stage.scene.model.sea.at(np.ascontiguousarray(drops[:, [0, 2]]))[:, 0]
    assert ((drops[:, 1] > levels - 0.5) | (drops[:, 6] < 0.3)).all()


def test_a_sheet_let_go_lets_the_cloth_flap() -> None:
    stage = open_level(wind=12.0, course=60.0, sheet=22.0)
    full = run(stage, 6.0)
    stage.post(SetParameter("sheet", 90.0))
    stage.run(180)
    flapping = [read(stage)["flapping"]]
    for _ in range(60):
        stage.run(2)
        flapping.append(read(stage)["flapping"])
    assert np.mean(flapping) > 5.0 * full["flapping"]
    assert run(stage, 4.0)["heel"] < 0.6 * full["heel"] + 5.0


def test_a_hauled_sheet_takes_the_boom_along_without_a_jump() -> None:
    stage = open_level(sheet=80.0)
    run(stage, 6.0)
    stage.post(SetParameter("sheet", 20.0))
    before = read(stage)["boom"]
    for _ in range(150):
        stage.run(1)
        now = read(stage)["boom"]
        assert abs(now - before) < 4.0
        before = now
    assert before <= 20.001


def test_it_is_heard() -> None:
    stage = open_level(wind=16.0, course=60.0, sheet=22.0, rain=40.0)
    heard = heard_in(stage, [4] * 200)
    assert "ground" in {kind for kind, _ in heard}
    steady = {one.kind: one.level for one in stage.scene.hearing().steady}
    assert steady["hiss"] > 0.1 and steady["wind"] > 0.2 and steady["rubble"] > 0.1
    quiet = open_level(**CALM)
    run(quiet, 3.0)
    calm = {one.kind: one.level for one in quiet.scene.hearing().steady}
    assert calm["wind"] < 0.02 and calm["hiss"] == 0.0


def test_a_hand_lifts_the_boat_and_lets_it_fall() -> None:
    stage = open_level(**CALM)
    run(stage, 0.5)
    pose = stage.scene.model.boat.pose
    stage.post(Pointer("down", 0.0, 0.5, 1))
    for k in range(20):
        stage.post(Pointer("move", 0.0, 0.5 + 0.2 * k, 1))
        stage.run(1)
    high = float(pose[UP])
    assert high > 3.0
    run(stage, 0.5)
    assert float(pose[UP]) == pytest.approx(high, abs=0.2)
    stage.post(Pointer("up", 0.0, 4.3, 1))
    found = run(stage, 12.0)
    assert abs(found["over the water"]) < 0.05 and found["spray"] > 100
    stage.post(Pointer("down", 12.0, 1.0, 1))
    stage.run(1)
    assert tuple(stage.scene.messages()) == ("There is only the boat to be taken.",)
    stage.post(Pointer("down", 0.0, 1.0, 3))
    stage.run(1)
    assert read(stage)["wind"] > 3.0


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name: str) -> None:
    stage = open_level(name)
    found = run(stage, 12.0)
    for expected in stage.scene.model.content.expected:
        bound = expected.value if expected.at_most else expected.within
        aim = 0.0 if expected.at_most else expected.value
        assert abs(found[expected.readout] - aim) <= bound, expected.readout


def test_what_strikes_the_water_from_high_up_loses_energy_there() -> None:
    stage = open_level("hard-03-dropped")
    boat, energies = stage.scene.model.boat, []
    for _ in range(40):
        stage.run(6)
        up, rising = float(boat.pose[UP]), float(boat.pose[4])
        energies.append(9.81 * up + 0.5 * rising * rising)
    assert max(np.diff(energies[:9])) < 0.2  # in the air: kept
    assert energies[-1] < 0.05 * energies[0]


def test_without_gravity_nothing_floats_and_nothing_fails() -> None:
    stage = open_level(wind=8.0)
    run(stage, 2.0)
    stage.post(SetEffect("gravity", False))
    assert math.isfinite(run(stage, 3.0)["heel"])


@pytest.mark.parametrize("name", sorted(name for name in LEVELS if not name.startswith("story")))
def test_a_step_back_leads_on_the_same(name: str) -> None:
    stage = open_level(name)
    stage.run(240)
    digest = stage.digest()
    stage.step_back()
    stage.run(1)
    assert stage.digest() == digest


def test_the_boat_sails_with_the_wind_and_not_without() -> None:
    stage = open_level(wind=9.0, course=150.0, sheet=80.0)
    run(stage, 20.0)
    pose = stage.scene.model.boat.pose
    before = float(pose[SPEED])
    assert before > 1.5 and abs(pose[HEEL]) < 0.4
    stage.post(SetEffect("wind", False))
    assert run(stage, 40.0)["boat speed"] < 0.5 * before
