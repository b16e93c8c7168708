"""The controlled fall: what is cut, what breaks, what is kept, what is measured."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.levels import level_files, load_level, parse_level
from game.physics.accretion import strike_times
from game.physics.solids import Material, SolidWorld, box
from game.scenes.tower.breaking import apart, break_up, cuts_of, middle_of, shocks_of
from game.scenes.tower.building import COLUMN, RUBBLE, SHARD, SLAB, floor_height
from game.scenes.tower.hand import REACH
from game.scenes.tower.level import TowerContent
from game.scenes.tower.scene import Tower
from game.stage import Action, Pointer, Stage
from game.worlds.members.dust import DVX, DX, advance_dust, puffs
from tests.scenes.listening import heard_in

LEVELS = {path.stem: path for path in level_files("a08")}
SMALL = 'scene = "a08"\n{more}\n[content]\nstoreys = 5\nbays = 2\nfirst = 4\n'


def small(more: str = "", **parameters: Any) -> Stage:
    return Stage(
        Tower, level=parse_level(SMALL.format(more=more), "a08", TowerContent), parameters=parameters
    )


def read(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def momentum(stage: Stage) -> np.ndarray:
    rows = stage.scene.model.world.bodies
    moving = rows.inverse_masses > 0.0
    return (rows.velocities[moving] / rows.inverse_masses[moving, None]).sum(axis=0)


def test_it_stands_and_sleeps() -> None:
    stage = small()
    tall = read(stage)["roof"]
    stage.run(90)
    found = read(stage)
    assert found["storeys standing"] == 5
    assert found["awake"] == 0
    assert found["roof"] == pytest.approx(tall, abs=0.01)


def test_the_front_falls_as_the_law_says_and_mass_is_kept() -> None:
    stage = small(tier="teach", delay=0.0)
    stage.run(5)
    stage.post(Action("fire"))
    stage.run(180)
    found = read(stage)
    assert found["floors struck"] == 3
    assert found["storeys standing"] == 0
    assert abs(found["law error"]) < 1.0
    assert found["front"] == pytest.approx(found["front by law"] * (found["law"] / found["fall"]) ** 2)
    assert found["mass lost"] < 1e-12
    assert found["pieces"] > 60


def test_charges_go_off_one_after_the_other_and_push_nothing() -> None:
    stage = small(delay=0.1, gravity=0.5)
    stage.post(Action("fire"))
    stage.run(2)
    frame = stage.scene.model.frame
    assert len(frame.rows((COLUMN,), (4,))) == 2
    rubble = frame.bodies((RUBBLE,))
    bodies = stage.scene.model.world.bodies
    thrown = bodies.velocities[rubble, 0]
    assert thrown.max() > 1.0
    assert thrown.min() < -1.0
    stage.run(14)
    assert len(frame.rows((COLUMN,), (4,))) == 0


def test_another_storey_may_be_first() -> None:
    stage = small(first=2)
    stage.post(Action("fire"))
    stage.run(90)
    assert read(stage)["floors struck"] == 1


def test_columns_may_hold() -> None:
    stage = small(gives_way=False)
    stage.post(Action("fire"))
    stage.run(240)
    assert read(stage)["storeys standing"] >= 3
    assert read(stage)["floors struck"] == 0


def test_a_click_cuts_a_column_and_a_right_click_breaks_a_floor() -> None:
    stage = small()
    model = stage.scene.model
    stage.post(Pointer("down", -4.75, 1.0, 1))
    stage.run(1)
    assert read(stage)["storeys standing"] == 4
    before = read(stage)["pieces"]
    stage.post(Pointer("down", -2.5, floor_height(model.content, 5) - 0.2, 3))
    stage.run(1)
    assert (model.frame.parts.kind == SHARD).sum() == 3
    assert read(stage)["pieces"] == before + 2
    stage.post(Pointer("down", 300.0, 10.0, 1))
    stage.run(1)
    assert read(stage)["pieces"] == before + 2


def test_floors_that_are_stopped_slowly_stay_whole() -> None:
    counts = []
    for strength in (1.0, 100.0):
        stage = small(strength=strength)
        stage.post(Action("fire"))
        stage.run(180)
        counts.append(int((stage.scene.model.frame.parts.kind == SHARD).sum()))
    assert counts[0] > 6
    assert counts[1] == 0


@pytest.mark.parametrize(("wide", "tall"), [(5.0, 0.4), (0.5, 2.6)])
def test_pieces_fill_what_broke_and_move_with_it(wide: float, tall: float) -> None:
    random = np.random.default_rng(1)
    pieces = cuts_of(wide, tall, 4, random)
    areas = [middle_of(piece)[2] for piece in pieces]
    assert min(areas) > 0.0
    assert math.fsum(areas) == pytest.approx(wide * tall, rel=1e-14)
    world = SolidWorld()
    stuff = Material(100.0, 0.5)
    body = world.add_body(box(wide, tall, material=stuff), (3.0, 2.0), 0.3, (1.0, -2.0), 1.5)
    inertia, mass = 1.0 / float(world.bodies.inverse_inertias[body]), 100.0 * wide * tall
    spin = 3.0 * mass * -2.0 - 2.0 * mass * 1.0 + inertia * 1.5
    thrown = random.uniform(-3.0, 3.0, (4, 2))
    made = [row[0] for row in break_up(world, body, pieces, stuff)]
    rows = world.bodies
    masses = 1.0 / rows.inverse_masses[made]
    assert (masses[:, None] * rows.velocities[made]).sum(axis=0) == pytest.approx([mass, -2.0 * mass])
    x, v = rows.positions[made], rows.velocities[made]
    found = (masses * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0])).sum()
    assert found + (rows.spins[made] / rows.inverse_inertias[made]).sum() == pytest.approx(spin)
    again = world.add_body(box(wide, tall, material=stuff), (9.0, 2.0))
    made = [row[0] for row in break_up(world, again, pieces, stuff, thrown)]
    masses = 1.0 / world.bodies.inverse_masses[made]
    assert np.abs((masses[:, None] * world.bodies.velocities[made]).sum(axis=0)).max() < 1e-9 * mass
    assert np.abs(world.bodies.velocities[made]).max() > 1.0


def test_dust_slows_settles_and_is_bounded() -> None:
    random = np.random.default_rng(2)
    dust = puffs(np.tile((0.0, 5.0), (5, 1)), np.full((5, 2), (8.0, 0.0)), 1.0, 1.0, random)
    start = dust.copy()
    for _ in range(30):
        dust = advance_dust(dust, 1.0 / 60.0)
    assert (np.abs(dust[:, DVX]) < np.abs(start[:, DVX])).all()
    assert (dust[:, DX] > start[:, DX]).all()
    for _ in range(90):
        dust = advance_dust(dust, 1.0 / 60.0)
    assert len(dust) == 0
    assert len(advance_dust(puffs(np.zeros((2_000, 2)), np.zeros((2_000, 2)), 1.0, 9.0, random), 0.01)) == 900


def test_a_step_back_and_again_is_the_same() -> None:
    stage = small()
    stage.post(Action("fire"))
    stage.run(70)
    digest = stage.digest()
    stage.step_back()
    stage.run(1)
    assert stage.digest() == digest


def test_what_falls_is_heard() -> None:
    stage = small()
    stage.post(Action("fire"))
    kinds = {kind for kind, _ in heard_in(stage, [10] * 12)}
    assert kinds >= {"thud", "stone"}


def test_a_saved_tower_is_the_tower() -> None:
    stage = small(first=3)
    content = stage.scene.save_content()
    assert content.first == 3
    assert content.storeys == 5


def test_a_storey_that_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match="first = 9"):
        text = 'scene = "a08"\n[content]\nstoreys = 5\nfirst = 9\n'
        Stage(Tower, level=parse_level(text, "a08", TowerContent))


@pytest.mark.parametrize("name", [name for name in LEVELS if name.startswith("hard")])
def test_hard_levels_come_out_as_expected(name: str) -> None:
    stage = Stage(Tower, level=load_level(LEVELS[name], "a08", TowerContent))
    stage.run(400)
    found = read(stage)
    for entry in stage.scene.model.content.expected:
        value = found[entry.readout]
        good = abs(value) <= entry.value if entry.at_most else abs(value - entry.value) <= entry.within
        assert good, (entry, value)
    stage.scene.check()


def test_a_restored_model_breaks_as_it_would_have() -> None:
    stage = small()
    stage.post(Action("fire"))
    stage.run(20)
    model = stage.scene.model
    state, steps, fired = model.state(), model.course.steps, model.course.fired
    stage.run(30)
    model.restore(state)
    assert (model.course.steps, model.course.fired) == (steps, fired)


def test_the_hand_takes_what_has_turned_where_it_lies() -> None:
    stage = small()
    frame = stage.scene.model.frame
    row = int(frame.rows((SLAB,))[0])
    frame.world.set_pose(int(frame.parts.body[row]), (40.0, 10.0), 0.5 * math.pi)
    assert frame.nearest((40.0, 12.3), (SLAB,), REACH) == row
    assert frame.nearest((42.3, 10.0), (SLAB,), REACH) == -1


@pytest.mark.parametrize("delay", [0.04, 0.1])
def test_clock_and_law_begin_when_nothing_carries_what_falls(delay: float) -> None:
    """The columns that go first let it sink before: whatever the schedule, it falls as the law says."""
    level = load_level(LEVELS["default"], "a08", TowerContent)
    stage = Stage(Tower, level=level, parameters={"tier": "teach", "delay": delay})
    stage.post(Action("fire"))
    stage.run(100)
    model, found = stage.scene.model, read(stage)
    assert found["floors struck"] >= 1
    assert model.course.freed.time - model.course.fired == pytest.approx(3.0 * delay, abs=stage.dt)
    assert model.course.freed.speed > 0.1 and model.course.freed.way > 0.0
    assert abs(found["law error"]) < 2.5  # begun at rest it would be 4 and more
    assert found["free fall"] <= found["law"]


def test_law_begins_with_a_speed_and_a_way() -> None:
    """From 2 m/s and 0.6 m on it is struck as if it had fallen from rest before that."""
    rest = strike_times(2.0, [1.0, 1.0], 2.6)
    speed = 2.0 * math.sqrt(1.0)
    fallen = speed * speed / (2.0 * 9.81)
    later = strike_times(2.0, [1.0, 1.0], 2.6, speed=speed, fallen=fallen)
    assert later == pytest.approx([time - speed / 9.81 for time in rest])
    with pytest.raises(ValueError, match="fallen"):
        strike_times(1.0, [1.0], 2.6, fallen=2.6)


def test_dust_is_taken_from_what_it_comes_from() -> None:
    stage = small()
    model = stage.scene.model
    built = read(stage)["mass"]
    stage.post(Action("fire"))
    stage.run(200)
    found = read(stage)
    assert found["dust raised"] > 100.0
    assert found["mass"] + 1e-3 * found["dust raised"] == pytest.approx(built, rel=1e-12)
    own = model.world.bodies.inverse_masses[model.frame.bodies()]
    assert model.frame.parts.mass[model.frame.rows()] == pytest.approx(1.0 / own)
    assert found["mass lost"] < 1e-12


@pytest.mark.parametrize("steps", [1, 5])
def test_a_stop_counts_as_one_whether_it_takes_one_step_or_more(steps: int) -> None:
    shocks, speed, dt = np.zeros(1), 9.0, 0.001
    for k in range(steps):
        before = np.array([[0.0, -speed * (1.0 - k / steps)]])
        shocks = shocks_of(shocks, before, np.array([[0.0, -speed * (1.0 - (k + 1) / steps)]]), dt)
    assert shocks[0] == pytest.approx(9.0, rel=0.06)
    falling = shocks_of(np.zeros(1), np.array([[0.0, -3.0]]), np.array([[0.0, -3.1]]), dt)
    assert falling[0] == 0.0


def test_pieces_of_a_stop_fly_apart_with_less_energy_than_was_lost() -> None:
    pieces = cuts_of(5.0, 0.4, 3, np.random.default_rng(3))
    thrown = apart(pieces, 8.0, np.random.default_rng(4))
    assert thrown[0, 0] < 0.0 < thrown[2, 0] and (thrown[:, 1] > 0.0).all()
    assert (thrown**2).sum(axis=1).max() < 0.16 * 8.0**2
    assert not apart(pieces, 0.0, np.random.default_rng(4)).any()


def test_nothing_stands_whole_on_the_heap() -> None:
    stage = Stage(Tower, level=load_level(LEVELS["default"], "a08", TowerContent))
    stage.post(Action("fire"))
    stage.run(360)
    found = read(stage)
    assert found["whole columns"] == 0.0 and found["storeys standing"] == 0.0
    assert found["roof"] < 8.0 and found["faster floors"] >= 9.0
    assert not len(stage.scene.model.frame.rows((SLAB,), (13,)))


def test_it_is_built_again_and_falls_again() -> None:
    stage = small(tier="teach")
    stage.run(6)
    stage.post(Action("fire"))
    stage.run(90)
    first = read(stage)
    stage.post(Action("build"))
    stage.run(1)
    again = read(stage)
    assert again["storeys standing"] == 5 and again["dust raised"] == 0.0 and math.isnan(again["fall"])
    stage.run(5)
    stage.post(Action("fire"))
    stage.run(90)
    assert read(stage)["fall"] == pytest.approx(first["fall"], rel=0.02)


def test_charges_and_the_air_are_heard() -> None:
    stage = small()
    stage.post(Action("fire"))
    kinds = [kind for kind, _ in heard_in(stage, [10] * 12)]
    assert kinds.count("burst") >= 3 and "wind" in kinds
