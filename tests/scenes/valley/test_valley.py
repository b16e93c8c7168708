"""The valley: its wall, its blast, its flood beside theory, model and experiment, what a hand does."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.physics.grid.layout import Grid
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids.mass import polygon_mass
from game.physics.waves.experiments import COLUMN_TWICE_AS_HIGH, filmed_front
from game.scenes.valley import dam as dams
from game.scenes.valley.parameters import ValleyContent
from game.scenes.valley.scene import Valley
from game.scenes.valley.world import RUNS_OUT
from game.stage import Action, Pointer, SetParameter, Stage
from game.worlds.hands.hand import NOBODY
from game.worlds.shards import shards_of
from tests.scenes.listening import heard_in

LEVELS = {path.stem: path for path in level_files("valley")}
COARSE = {"cells": 160}


def open_level(name: str = "default", **parameters: Any) -> Stage:
    level = load_level(LEVELS[name], "valley", ValleyContent)
    return Stage(Valley, level=level, parameters=parameters)


def read(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def strike(stage: Stage, seconds: float = 0.0) -> dict[str, float]:
    """Fire, wait for the blow, and go on."""
    before = stage.scene.model.fired
    stage.post(Action("fire"))
    stage.run(1)
    while stage.scene.model.rocket.body != NOBODY:
        stage.run(1)
    assert stage.fault is None and stage.scene.model.fired == before + 1
    stage.run(round(seconds / stage.dt))
    assert stage.fault is None
    return read(stage)


# -- the wall -------------------------------------------------------------------------------------------


def test_the_wall_holds_still_water() -> None:
    stage = open_level()
    stage.run(20)
    found = read(stage)
    assert found["left behind"] == 100.0 and found["depth behind"] == pytest.approx(10.0, abs=0.3)
    assert found["push on the wall"] == pytest.approx(50.0, rel=0.01)  # rho h²/2, by pressures in cells
    assert found["push by depth"] == pytest.approx(0.5 * found["depth behind"] ** 2)
    places = stage.scene.model.liquid.places
    assert places[:, 0].max() < 0.0


def test_shards_fill_the_wall() -> None:
    sites = np.random.default_rng(3).uniform((0.1, 0.2), (1.5, 11.8), (30, 2))
    shards = shards_of(dams.OUTLINE, sites, 0.16)
    total = sum(polygon_mass(one).mass for one in shards)
    assert total == pytest.approx(polygon_mass(dams.OUTLINE).mass, rel=0.02)
    for one, site in zip(shards, sites, strict=False):
        assert polygon_mass(one).mass > 0.0 and len(one) >= 3 and np.isfinite(site).all()


def test_a_shard_is_what_is_nearest_to_its_site() -> None:
    sites = np.array([(0.5, 2.0), (0.5, 6.0), (0.5, 10.0)])
    shards = shards_of(dams.OUTLINE, sites, 0.16)
    assert [float(one[:, 1].min()) for one in shards] == pytest.approx([0.0, 4.0, 8.0])
    assert [float(one[:, 1].max()) for one in shards] == pytest.approx([4.0, 8.0, 12.0])


def test_the_breach_goes_with_the_cube_root_of_the_charge() -> None:
    """FM 5-250: P = R³ K C in pounds and feet; 10 ft of thick concrete, in water: 540 lb."""
    assert dams.breach_radius(540.0 * 0.45359237) == pytest.approx(10.0 * 0.3048, rel=1e-3)
    assert dams.breach_radius(800.0) == pytest.approx(2.0 * dams.breach_radius(100.0), rel=1e-12)


def test_the_blast_is_that_of_cole() -> None:
    """5760 w (w / r)^0.89 N s/m²: of 1 kg at 2 m 3108, of 1000 kg at 10 m 57,600."""
    assert dams.specific_impulse(1.0, 2.0) == pytest.approx(5760.0 / 2.0**0.89, rel=1e-12)
    assert dams.specific_impulse(1000.0, 10.0) == pytest.approx(57600.0, rel=1e-12)
    assert dams.specific_impulse(8.0, 0.1) == dams.specific_impulse(8.0, dams.NEAREST)


def test_a_piece_under_water_gets_what_the_blast_gives_on_its_breadth() -> None:
    stage = open_level(**COARSE)
    model = stage.scene.model
    model.dam.explode((-0.2, 4.0), 200.0, False, 9.0)
    rows, free = model.solids.world.bodies, model.dam.free()
    wet = [body for body in free.tolist() if rows.positions[body, 1] < 9.0]
    assert 5 < len(wet) < len(free)
    for body in wet:
        away = rows.positions[body] - (-0.2, 4.0)
        mass = 1.0 / rows.inverse_masses[body]
        wanted = dams.specific_impulse(200.0, float(np.hypot(*away))) * math.sqrt(mass / 2400.0)
        got = mass * rows.velocities[body]
        assert np.hypot(*got) == pytest.approx(wanted, rel=1e-9)
        assert got @ away == pytest.approx(wanted * np.hypot(*away), rel=1e-9)
    assert not rows.velocities[[body for body in free.tolist() if body not in wet]].any()


@pytest.mark.parametrize("share", [0.9, 1.1])
def test_a_breach_goes_through_where_its_radius_is_more_than_the_wall_s_thickness(share: float) -> None:
    """2.53 m thick, 4 m above its foot, by its outline. What stands above a breach is free, else it holds."""
    stage = open_level(**COARSE)
    dam = stage.scene.model.dam
    radius = share * (3.2 - 2.0 * 4.0 / 12.0)
    dam.explode((-0.1, 4.0), 16.02 * 0.54 * radius**3, False, 10.0)
    free = np.isin(dam.bodies, dam.free())
    away = dam.solids.world.bodies.positions[dam.bodies] - (-0.1, 4.0)
    near = np.hypot(*away.T) <= radius
    assert np.array_equal(free, near | (away[:, 1] > 0.0) if share > 1.0 else near)
    assert 0 < near.sum() < free.sum() or share < 1.0


# -- the rocket -----------------------------------------------------------------------------------------


def test_the_rocket_is_where_its_curve_is_and_strikes_where_it_is_aimed() -> None:
    stage = open_level(aim=6.0, **COARSE)
    stage.post(Action("fire"))
    stage.run(100)
    rocket = stage.scene.model.rocket
    place = stage.scene.model.solids.world.bodies.positions[rocket.body]
    assert place == pytest.approx(rocket.at(rocket.since)[:2], abs=1e-6)
    while rocket.body != NOBODY:
        stage.run(1)
    assert read(stage)["struck"] == 1
    assert read(stage)["struck at"] == pytest.approx(6.0, abs=1.5)


def test_a_second_rocket_waits_for_the_first() -> None:
    stage = open_level(**COARSE)
    stage.post(Action("fire"))
    stage.run(2)
    stage.post(Action("fire"))
    stage.run(1)
    assert "It is on its way." in tuple(stage.scene.messages())
    assert read(stage)["fired"] == 1


# -- the flood ------------------------------------------------------------------------------------------


def test_the_filmed_front_is_that_of_the_table() -> None:
    """A column 1 m wide and 2 m high, at the times of the table."""
    for scaled, front in COLUMN_TWICE_AS_HIGH:
        assert filmed_front(2.0, scaled / math.sqrt(2.0 * 9.81)) == pytest.approx(front - 1.0)
    assert math.isnan(filmed_front(2.0, 0.0)) and math.isnan(filmed_front(2.0, 3.0))


def short_fronts(cell: float, times: list[float]) -> list[float]:
    """m from the gate at times (s), of a column of 5 m x 10 m; its fourth particle from the front."""
    liquid = Liquid(
        Grid(round(35.0 / cell), round(14.0 / cell), cell, (-5.0, 0.0)), LiquidSettings(), most=4000
    )
    liquid.add(liquid.lattice((-5.0, 0.0), (0.0, 10.0)))
    found, now = [], 0.0
    for time in times:
        parts = math.ceil(60.0 * (time - now))
        for _ in range(parts):
            liquid.advance((time - now) / parts)
        now = time
        found.append(float(np.sort(liquid.places[:, 0])[-4]))
    return found


def test_a_short_column_on_cells_of_this_size_follows_a_particle_code() -> None:
    """Front over width of PySPH with 3,938 particles at t sqrt(2 g / width) = 1.997 and 2.547."""
    times = [scaled / math.sqrt(2.0 * 9.81 / 5.0) for scaled in (1.997, 2.547)]
    fronts = [1.0 + front / 5.0 for front in short_fronts(0.5, times)]
    assert fronts == pytest.approx([2.60, 3.34], rel=0.03)


def test_without_a_wall_the_front_is_between_that_of_a_short_column_and_ritter_s() -> None:
    """A long reservoir is ahead of a column 5 m wide, which its wall holds back; nothing is ahead of Ritter.

    And that column is ahead of the film of it, in which a gate took its time.
    """
    stage = open_level("hard-gone")
    strike(stage)
    since, long, film, ritter = [], list[float](), list[float](), list[float]()
    while not stage.scene.model.since > 1.2:
        stage.run(6)
        found = read(stage)
        if found["since it broke"] > 0.5:
            since.append(found["since it broke"])
            long.append(float(np.sort(stage.scene.model.liquid.places[:, 0])[-4]))
            film.append(found["front, experiment"])
            ritter.append(found["front, Ritter"])
            assert abs(found["front"] - long[-1]) < 2.0 * stage.scene.model.liquid.grid.cell
    short = short_fronts(0.5, since)
    assert len(since) > 5
    for one in zip(film, short, long, ritter, strict=True):
        assert list(one) == sorted(one)


def test_without_a_wall_shallow_water_and_what_runs_out_follow_ritter() -> None:
    """8/27 h sqrt(g h), 29.35 m²/s of 10 m: what passes the dam in a second, after two for it to turn."""
    stage = open_level("hard-gone")
    found = strike(stage, 1.5)
    theory, water = stage.scene.model.theory, stage.scene.model.shallow
    x = stage.scene.model.columns
    here = (x > -8.0) & (x < 20.0)
    exact = theory.at(x[here], found["since it broke"])[0]
    assert np.abs(water.depth[0][here] - exact).mean() < 0.12
    assert 0.7 * found["front, Ritter"] < found["front, shallow"] < found["front, Ritter"]
    stage.run(30)
    before = read(stage)
    stage.run(60)
    after = read(stage)
    assert before["flow, Ritter"] == pytest.approx(29.35, abs=0.01)
    assert after["run out"] - before["run out"] == pytest.approx(29.35, rel=0.04)
    assert after["flow"] == pytest.approx(29.35, rel=0.06)


def test_the_flood_takes_pieces_and_trunks_along_and_no_water_is_lost() -> None:
    stage = open_level(**COARSE)
    found = strike(stage, 7.0)
    assert found["torn out"] > 10 and found["logs"] > 3.0 and found["farthest piece"] > 20.0
    assert found["left behind"] < 75.0 and found["slowed"] < 100
    liquid = stage.scene.model.liquid
    put_in, gone, refused = liquid.account.tolist()
    assert liquid.count == put_in - gone and refused == 0.0
    assert liquid.places[:, 0].max() < RUNS_OUT + 1.0


# -- hard levels -----------------------------------------------------------------------------------------


def test_full_to_the_brim_nothing_leaks() -> None:
    stage = open_level("hard-brim", **COARSE)
    stage.run(120)
    assert read(stage)["left behind"] == pytest.approx(100.0, abs=0.5)


def test_a_small_charge_leaves_the_wall_standing() -> None:
    """By the formula it breaks 0.83 m; the wall is three times as thick where it is struck."""
    stage = open_level("hard-spark")
    found = strike(stage, 1.0)
    assert found["breach radius"] < 0.4 * found["wall's thickness"]
    assert found["torn out"] == 0 and 98.0 < found["left behind"] <= 100.0
    assert 0 < len(stage.scene.model.dam.free()) < found["pieces"]


def test_a_thousand_kilograms_are_borne() -> None:
    """All is free, and all but what lies on the ground below the blast is torn out."""
    stage = open_level("hard-thousand", **COARSE)
    strike(stage)
    dam, rows = stage.scene.model.dam, stage.scene.model.solids.world.bodies
    assert len(dam.free()) == len(dam.bodies)
    assert np.hypot(*rows.velocities[dam.bodies].T).max() > 150.0
    stage.run(150)
    assert stage.fault is None
    found = read(stage)
    assert abs(found["volume error"]) < 10.0
    kept = dam.moved() < 1.0
    assert (dam.homes[kept, 1] < 1.0).all() and found["torn out"] == found["pieces"] - kept.sum()
    liquid = stage.scene.model.liquid
    put_in, gone, refused = liquid.account.tolist()
    assert liquid.count == put_in - gone and refused == 0.0


def test_a_metre_of_water_is_let_out_too() -> None:
    found = strike(open_level("hard-shallow"), 2.0)
    assert found["left behind"] < 99.0 and found["front"] > 3.0


# -- the hand, the ear, the clock ------------------------------------------------------------------------


def test_a_hand_pours_water_and_drags_a_trunk() -> None:
    stage = open_level(**COARSE)
    before = read(stage)["poured in"]
    stage.post(Pointer("down", -10.0, 14.0, 1))
    stage.run(30)
    stage.post(Pointer("up", -10.0, 14.0, 1))
    stage.run(1)
    assert read(stage)["poured in"] - before == pytest.approx(10.0 * 31.0 / 60.0, rel=0.1)
    model = stage.scene.model
    x, y = model.solids.world.bodies.positions[model.logs[-1]].tolist()
    stage.post(Pointer("down", x, y, 3))
    for k in range(30):
        stage.post(Pointer("move", x + 0.05 * k, y + 0.05 * k, 3))
        stage.run(2)
    assert model.solids.world.bodies.positions[model.logs[-1], 1] > y + 0.5


def test_the_level_is_the_water_s() -> None:
    stage = open_level(**COARSE)
    stage.post(SetParameter("level", 6.0))
    stage.run(2)
    assert read(stage)["depth behind"] == pytest.approx(6.0, abs=0.4)


def test_what_happens_is_heard() -> None:
    stage = open_level(**COARSE)
    stage.post(Action("fire"))
    stage.run(60)
    kinds = {one.kind: one.level for one in stage.scene.hearing().steady}
    assert kinds["flame"] > 0.05 and kinds["hiss"] > 0.02
    heard = {kind for kind, _ in heard_in(stage, [2] * 190)}
    assert {"burst", "splash"} <= heard and heard & {"stone", "ground"}
    levels = {one.kind: one.level for one in stage.scene.hearing().steady}
    assert levels["water"] > 0.0


@pytest.mark.parametrize("name", sorted(name for name in LEVELS if not name.startswith("story")))
def test_a_step_back_leads_on_the_same(name: str) -> None:
    stage = open_level(name, **COARSE)
    strike(stage, 0.5)
    digest = stage.digest()
    stage.step_back()
    stage.run(1)
    assert stage.digest() == digest
