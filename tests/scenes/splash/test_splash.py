"""The splash: touch, crater, crown, jet beside theory; ripples by dispersion, pockets of air, the hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.lab.studies.water.drop import DropTrial, exact_axis
from game.lab.study import Setting
from game.levels import level_files, load_level
from game.scenes.splash.measures import find_pockets, surface_length
from game.scenes.splash.parameters import HIGH, WIDE, SplashContent
from game.scenes.splash.scene import Splash
from game.scenes.splash.world import MINNAERT, octave
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.ui.sound import BUBBLE_TONES
from game.worlds.expectations import captions_of
from tests.scenes.listening import heard_in

LEVELS = {path.stem: path for path in level_files("splash")}
HARD = sorted(name for name in LEVELS if name.startswith("hard-"))
FEW_CELLS = 96


def opened(**parameters: Any) -> Stage:
    """Still water."""
    return Stage(Splash, parameters={"cells": FEW_CELLS, **parameters})


def read(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def run(stage: Stage, seconds: float) -> dict[str, float]:
    stage.run(round(seconds / stage.dt))
    return read(stage)


def dropped(name: str = "drop", **parameters: Any) -> Stage:
    """A drop, or two, that meets the water in the next step."""
    stage = opened(**parameters)
    stage.run(1)
    stage.post(Action(name))
    stage.run(1)
    while not read(stage)["touched"]:
        assert read(stage)["falls"] and stage.time_s < 3.0
        stage.run(1)
    return stage


@pytest.fixture(scope="module")
def fallen() -> Stage:
    """A drop, and all that comes of it."""
    stage = dropped(cells=192)
    run(stage, 0.8)
    return stage


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name: str) -> None:
    stage = Stage(Splash, level=load_level(LEVELS[name], "splash", SplashContent))
    energies = []
    for _ in range(3):
        for _ in range(12):
            stage.run(5)
            now = stage.scene.model.measures
            energies.append(sum(now.energies()))
        captions = captions_of(stage.scene.model.content.expected, stage.readouts())
        assert captions and all(caption.met for caption in captions), captions
    assert np.diff(energies).max() < 0.01 * energies[0]  # none comes from nowhere
    places = stage.scene.model.liquid.places
    assert (places > 0.0).all() and (places < (WIDE, HIGH)).all()


@pytest.mark.parametrize(("angle", "speed"), [(0.0, 3.2), (40.0, 4.0), (0.0, 1.0)])
def test_a_drop_comes_as_fast_and_as_slanted_as_it_is_told(angle: float, speed: float) -> None:
    """But for the last step before the level; its momentum is that of its area."""
    stage = dropped(angle=angle, speed=speed)
    found, now = read(stage), stage.scene.model.measures
    assert found["speed"] == pytest.approx(speed, abs=9.81 * 4.0 * stage.dt)
    area = math.pi * 0.09**2
    assert found["drop's energy"] == pytest.approx(500.0 * area * found["speed"] ** 2, rel=0.04)
    sideways = 1000.0 * area * speed * math.sin(math.radians(angle))
    assert found["momentum brought"] == pytest.approx(sideways, rel=0.04, abs=0.01)
    assert now.at == pytest.approx(0.5 * WIDE, abs=0.05)


def test_the_limit_is_a_half_round_crater_with_the_energy_of_the_drop(fallen: Stage) -> None:
    """Counted by stripes: what a half disc of water weighs, times how deep it lies."""
    now = fallen.scene.model.measures
    radius, count = now.limit(), 4000
    depth = (np.arange(count) + 0.5) * radius / count
    width = 2.0 * np.sqrt(radius**2 - depth**2)
    assert 1000.0 * 9.81 * float((width * depth).sum()) * radius / count == pytest.approx(now.own, rel=1e-3)
    found = read(fallen)
    assert 50.0 < found["of the limit"] < 65.0


def test_the_crater_hardly_depends_on_the_cells() -> None:
    deepest = [run(dropped(cells=cells), 0.4)["deepest"] for cells in (96, 144, 192)]
    assert max(deepest) < 1.08 * min(deepest)


def test_water_makes_way_at_nearly_half_the_speed(fallen: Stage) -> None:
    assert 38.0 < read(fallen)["sinks"] < 50.0


def test_the_crown_flies_as_high_as_its_speed_says(fallen: Stage) -> None:
    found = read(fallen)
    assert found["highest water"] == pytest.approx(found["can fly"], rel=0.02)
    assert found["highest water"] > 30.0


def test_a_jet_rises_after_the_crater_has_closed() -> None:
    stage = dropped(cells=192)
    found = run(stage, 0.2)
    assert found["closes"] == 0 and found["jet"] < -10.0
    found = run(stage, 0.45)
    assert found["closes"] == 1 and found["jet"] > 12.0 and found["crater"] < found["deepest"]


def test_the_energy_is_counted_from_still_water(fallen: Stage) -> None:
    """Still: none. Else the sum over particles, beside that of the same water at rest."""
    found = run(opened(), 0.1)
    assert found["kinetic energy"] < 1e-6 and abs(found["potential energy"]) < 0.05
    liquid = fallen.scene.model.liquid
    mass = 1000.0 * liquid.area
    moving = 0.5 * mass * float((liquid.speeds**2).sum())
    height = mass * 9.81 * float((liquid.places[:, 1] - 0.5 * liquid.count * liquid.area / WIDE).sum())
    found = read(fallen)
    assert found["kinetic energy"] == pytest.approx(moving, rel=1e-9)
    assert found["potential energy"] == pytest.approx(height, rel=1e-6)
    assert found["lost"] == pytest.approx(100.0 * (1.0 - (moving + height) / found["energy"]), rel=1e-6)
    assert 10.0 < found["lost at once"] < found["lost"]


def test_the_volume_stays(fallen: Stage) -> None:
    assert read(fallen)["worst volume error"] < 0.5


@pytest.mark.parametrize("turn", [0.0, 0.5, 1.1])
def test_the_length_of_a_surface_is_found_at_any_slant(turn: float) -> None:
    stage = opened()
    liquid = stage.scene.model.liquid
    rows, columns = liquid.cells.phi.shape
    y, x = np.mgrid[:rows, :columns]
    away = (y - 0.5 * rows) * math.cos(turn) - (x - 0.5 * columns) * math.sin(turn)
    liquid.cells.phi[:] = np.clip(away, -1.0, 1.0)
    box = (columns - 1) * liquid.grid.cell, (rows - 1) * liquid.grid.cell
    length = min(box[0] / math.cos(turn), box[1] / max(math.sin(turn), 1e-9))
    assert surface_length(liquid) == pytest.approx(length, rel=0.05)


def test_the_surface_has_little_energy(fallen: Stage) -> None:
    assert read(fallen)["surface energy"] < 0.002 * read(fallen)["drop's energy"]


def test_faster_drops_dig_deeper_by_the_same_share() -> None:
    points = []
    for speed in (1.5, 3.0, 5.0):
        stage = dropped(speed=speed, size=0.07, cells=144)
        run(stage, 0.5)
        points.append(stage.scene.story_charts()["craters"].measured[0])
    froude, depth = np.array(points).T
    assert froude == pytest.approx(np.array((1.5, 3.0, 5.0)) ** 2 / (9.81 * 0.07), rel=0.2)
    share = depth / np.cbrt(0.75 * math.pi * froude)
    assert (share > 0.5).all() and (share < 0.7).all()


# -- ripples ----------------------------------------------------------------------------------------------


def test_a_single_wave_is_led_on_by_its_own_rate() -> None:
    """w^2 = g k tanh(k h): after half a period the crest is a trough."""
    stage = opened()
    now, k = stage.scene.model.measures, 6.0 * math.pi / WIDE
    rate = math.sqrt(9.81 * k * math.tanh(0.45 * k))
    for frame in range(len(now.last)):
        time = (frame - len(now.last) + 1) * stage.dt
        now.last[frame] = 0.45 + 0.01 * np.cos(k * now.x) * math.cos(rate * time)
    now.foresee(stage.dt)
    assert now.foreseen() == pytest.approx(0.45 + 0.01 * np.cos(k * now.x), abs=1e-5)
    now.time += math.pi / rate
    assert now.foreseen() == pytest.approx(0.45 - 0.01 * np.cos(k * now.x), abs=1e-4)
    assert now.likeness() == pytest.approx(-1.0, abs=1e-3)


def test_ripples_of_the_pool_go_on_by_dispersion() -> None:
    stage = dropped(size=0.06, speed=1.2, cells=192)
    run(stage, 0.5)
    assert math.isnan(read(stage)["likeness"])
    stage.post(Action("foresee"))
    assert run(stage, 0.3)["likeness"] > 94.0
    assert run(stage, 0.3)["likeness"] > 86.0


# -- air --------------------------------------------------------------------------------------------------


def test_pockets_are_those_from_which_no_way_leads_out() -> None:
    rank = np.ones((8, 9), dtype=np.int64)
    rank[5:] = 0  # the open air
    rank[3:5, 1] = 0  # a chimney into it
    rank[1:3, 4:6] = 0  # a pocket of four cells
    rank[3, 6] = 0  # one that only touches it by a corner
    found = np.zeros((8, 3))
    count = find_pockets(rank, np.zeros_like(rank), np.zeros((72, 2), np.int64), found)
    assert count == 2
    assert sorted(found[:2].tolist()) == [[4.5, 1.5, 4.0], [6.0, 3.0, 1.0]]


def test_a_bubble_rings_by_minnaert() -> None:
    """f = sqrt(3 gamma p / rho) / (2 pi r): 3.26 m/s over the radius at 101.3 kPa."""
    law = math.sqrt(3.0 * 1.4 * 101325.0 / 1000.0) / math.tau
    assert law == pytest.approx(MINNAERT, rel=0.01)
    assert [BUBBLE_TONES[octave(MINNAERT / r)] for r in (0.04, 0.02, 0.01, 0.0051, 0.001)] == [
        160, 160, 320, 640, 1280,
    ]  # fmt: skip


def test_a_cave_in_the_water_is_heard_once_as_it_closes() -> None:
    stage = opened(cells=192)
    stage.run(2)
    places = stage.scene.model.liquid.places
    away = places - (1.35, 0.2)
    stage.scene.model.liquid.keep_only((away * away).sum(axis=1) > 0.05**2)
    stage.run(1)
    found = read(stage)
    assert found["pockets"] == 1 and found["bubble"] == pytest.approx(50.0, abs=8.0)
    assert found["tone"] == pytest.approx(1000.0 * MINNAERT / found["bubble"], rel=1e-9)
    rows = stage.scene.model.heard.rows
    assert np.count_nonzero(rows[:, 1] >= 1) == 1
    stage.run(1)
    assert np.count_nonzero(stage.scene.model.heard.rows[:, 1] >= 1) == 1


def test_it_is_heard_as_it_meets_the_water() -> None:
    stage = opened()
    stage.post(Action("drop"))
    assert not heard_in(stage, [1] * 10)
    kinds = [kind for kind, _ in heard_in(stage, [1] * 40)]
    assert "splash" in kinds
    assert {one.kind for one in stage.scene.hearing().steady} >= {"room", "water"}


# -- the hand ---------------------------------------------------------------------------------------------


def test_a_hand_drops_stirs_and_calms() -> None:
    stage = opened()
    before = stage.scene.model.liquid.count
    stage.post(Pointer("down", 0.8, 1.0, 1))
    stage.post(Pointer("up", 0.8, 1.0, 1))
    found = run(stage, 0.5)
    assert found["drop"] == 1 and found["touched"] == 1
    assert stage.scene.model.measures.at == pytest.approx(0.8, abs=0.01)
    assert found["speed"] == pytest.approx(3.2, abs=0.15)
    stage.post(Action("calm"))
    found = run(stage, 0.02)
    assert stage.scene.model.liquid.count == before and found["kinetic energy"] < 1e-6
    stage.post(SetParameter("tool", "stir"))
    stage.post(Pointer("down", 1.0, 0.3, 1))
    stage.post(Pointer("move", 1.1, 0.3, 1))
    assert run(stage, 0.02)["kinetic energy"] > 1.0


def test_another_depth_is_still_water_of_that_depth() -> None:
    stage = dropped()
    stage.post(SetParameter("depth", 0.2))
    found = run(stage, 0.05)
    liquid = stage.scene.model.liquid
    assert liquid.count * liquid.area / WIDE == pytest.approx(0.2, abs=liquid.grid.cell)
    assert found["touched"] == 0 and found["kinetic energy"] < 1e-6


def test_two_drops_are_alike_and_throw_a_sheet_between_them() -> None:
    one, two = dropped(size=0.07, cells=144), dropped("two", size=0.07, cells=144)
    alone = run(one, 0.4)["highest water"]
    assert run(two, 0.4)["highest water"] > 1.3 * alone
    assert two.scene.model.measures.at == pytest.approx(0.5 * WIDE, abs=1e-3)


def test_a_drop_without_room_is_refused() -> None:
    stage = opened(depth=0.9, size=0.2)
    stage.post(Action("drop"))
    stage.run(1)
    assert tuple(stage.scene.messages()) == ("There is no space above the water.",)


def test_without_gravity_a_drop_flies_straight() -> None:
    stage = opened(speed=2.0)
    stage.post(SetEffect("gravity", False))
    stage.run(1)
    stage.post(Action("drop"))
    found = run(stage, 0.5)
    assert found["speed"] == pytest.approx(2.0, rel=1e-9) and math.isnan(found["limit"])


def test_a_step_back_leads_on_the_same() -> None:
    stage = dropped()
    for steps in (5, 60):
        stage.run(steps)
        digest = stage.digest()
        stage.step_back()
        stage.run(1)
        assert stage.digest() == digest


# -- the study --------------------------------------------------------------------------------------------


def test_the_ellipse_is_the_known_one() -> None:
    """2.275516 m after a second, by two other routes."""
    assert exact_axis() == pytest.approx(2.275516, abs=1e-5)


def test_finer_cells_and_less_pic_come_nearer_to_it() -> None:
    def error(method: str, cells: int) -> float:
        trial = DropTrial(Setting(method, 5.0 / cells))
        trial.reset()
        trial.run()
        return trial.outcome().error

    assert error("apic", 56) < 0.5 * error("apic", 20)
    assert error("flip-half", 40) > error("flip-95", 40)


def test_a_drop_is_thrown_as_far_as_it_is_dragged() -> None:
    stage = opened(gravity=0.0)
    stage.post(Pointer("down", 0.6, 1.0, 1))
    stage.post(Pointer("move", 0.8, 0.9, 1))
    stage.post(Pointer("up", 0.8, 0.9, 1))
    stage.run(20)
    model = stage.scene.model
    places = model.liquid.places[model.measures.first :].mean(axis=0)
    assert places == pytest.approx((0.6 + 2.0 * stage.time_s, 1.0 - stage.time_s), abs=0.02)


def test_five_drops_are_larger_in_the_middle() -> None:
    stage = opened(size=0.06)
    before = stage.scene.model.liquid.count
    stage.post(Action("five"))
    stage.run(1)
    model = stage.scene.model
    x = model.liquid.places[before:, 0]
    one, middle = ((np.abs(x - at) < 0.08).sum() for at in (1.35 - 2.2 * 3.3 * 0.06, 1.35))
    assert 0 < one < 0.5 * middle
