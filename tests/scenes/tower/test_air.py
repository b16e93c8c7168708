"""The air about the tower: what falls drives it out, it carries the dust, and the dust's mass is kept."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import parse_level
from game.physics.fields import GRAVITY
from game.physics.gas.ledger import CARRIED_THROUGH
from game.scenes.tower.air import AIR, FLOOR_WIDTH, QUICKEST, Floors, TowerAir, drag_along, weigh
from game.scenes.tower.building import SHARD
from game.scenes.tower.level import TowerContent
from game.scenes.tower.scene import Tower
from game.stage import Action, Pointer, SetEffect, Stage
from game.worlds.members.dust import DVX, DX, advance_dust, puffs

SMALL = TowerContent(storeys=3, bays=2, first=3)
LEVEL = 'scene = "a08"\n[content]\nstoreys = 4\nbays = 2\nfirst = 3\n'


def floor(y: float, speed: float, half: float = 5.0, thick: float = 0.51) -> np.ndarray:
    return np.array([[0.0, y, 1.0, 0.0, half, thick, 0.0, speed, 0.0, half, thick]])


def built() -> Stage:
    return Stage(Tower, level=parse_level(LEVEL, "a08", TowerContent))


def read(stage: Stage, name: str) -> float:
    return next(one.value for one in stage.scene.readouts() if one.name == name)


def test_a_falling_floor_drives_out_the_air_below_it():
    """What leaves at both ends of the gap is what the floor sweeps: 10 m at 6 m/s."""
    air = TowerAir(SMALL, GRAVITY | AIR)
    for step in range(4):
        air.advance(floor(4.0 - 0.1 * step, -6.0), np.zeros((0, 5)), 9.81, 1.0 / 60.0)
    h, low = air.grid.cell, round(3.0 / air.grid.cell)
    left, right = (round((x - air.grid.lower[0]) / h) for x in (-5.0, 5.0))
    out = float(np.sum(air.gas.u[:low, right]) - np.sum(air.gas.u[:low, left])) * h
    down = -float(np.sum(air.gas.v[low, left:right])) * h
    assert out == pytest.approx(down, rel=0.02) and 0.7 * 60.0 < out < 60.0
    assert np.allclose(air.gas.u[:low, left], -air.gas.u[:low, right], atol=0.05 * out)
    assert float(np.min(air.gas.v)) == pytest.approx(-6.0, abs=1.5)


def test_dust_stays_but_for_what_leaves_at_the_sides():
    air = TowerAir(SMALL, GRAVITY | AIR)
    air.gas.keep_books()
    air.raise_dust(np.array([[-2.0, 1.0], [2.0, 1.0], [0.0, 2.0], [900.0, 1.0]]), 30.0)
    assert air.in_the_air() == pytest.approx(30.0) and float(air.dust[0]) == 30.0
    gone = 0.0
    for step in range(120):
        y = max(8.0 - 0.1 * step, 0.6)
        air.advance(floor(y, -6.0 if y > 0.6 else 0.0), np.zeros((0, 5)), 9.81, 1.0 / 60.0)
        gone -= float(air.gas.ledger.fields.rows[CARRIED_THROUGH, 0])
    assert air.in_the_air() + gone == pytest.approx(30.0, rel=1e-9)
    assert float(np.min(air.density)) > -1e-9 and air.fastest() <= 1.5 * QUICKEST


def test_dust_is_not_raised_inside_a_floor():
    air = TowerAir(SMALL, GRAVITY | AIR)
    air.advance(floor(5.5, 0.0, thick=1.6), np.zeros((0, 5)), 9.81, 1.0 / 60.0)
    air.raise_dust(np.array([[0.0, 5.5]]), 5.0)
    assert air.in_the_air() == 0.0 and float(air.dust[0]) == 0.0
    air.raise_dust(np.array([[0.0, 5.5], [0.0, 9.5]]), 5.0)
    assert air.in_the_air() == pytest.approx(5.0)


def test_dusty_air_sinks_and_spreads_on_the_ground():
    air = TowerAir(SMALL, GRAVITY | AIR)
    x, y = air.grid.centres()
    air.density[(np.abs(x) < 3.0) & (y < 8.0)] = 1.0
    tall = float(np.sum(air.density * y) / np.sum(air.density))
    for _ in range(90):
        air.advance(np.zeros((0, FLOOR_WIDTH)), np.zeros((0, 5)), 9.81, 1.0 / 60.0)
    after = air.density
    assert float(np.sum(after * y) / np.sum(after)) < 0.8 * tall
    wide = float(np.sqrt(np.sum(after * x * x) / np.sum(after)))
    assert wide > 2.3 and abs(float(np.sum(after * x) / np.sum(after))) < 1e-3
    assert not air.is_still() and 0.2 < float(np.max(air.veil()[..., 0])) < 0.95
    assert float(np.max(air.veil()[:, 0])) == 0.0


def test_weight_of_dust_has_a_bound_and_whirls_die_down():
    """g c / (rho + c): never more than gravity, half of it where dust weighs as much as the air."""
    density, out = np.array([[0.0, 1.2, 1e9]]), np.zeros((1, 3, 2))
    weigh(density, np.full((1, 4), 2.0), np.full((2, 3), -4.0), 10.0, out)
    assert out[0, :, 1] == pytest.approx([1.2, -5.0 + 1.2, -10.0 + 1.2])
    assert out[0, :, 0] == pytest.approx([-0.6] * 3)


def test_pieces_drag_the_air_and_never_past_their_own_speed():
    u, v, force = np.zeros((3, 4)), np.zeros((4, 3)), np.zeros((3, 3, 2))
    lower = np.array([0.0, 0.0])
    drag_along(np.array([[1.5, 0.5, 3.0, -4.0, 0.5]]), u, v, lower, 1.0, 0.01, force)
    rate = 0.5 * 1.2 * 0.5 * 5.0
    assert force[0, 1] == pytest.approx(rate / (1.0 + 0.01 * rate) * np.array([3.0, -4.0]))
    assert np.count_nonzero(force) == 2
    force[:] = 0.0
    outside = [[-0.5, 0.5, 1, 1, 1], [3.5, 0.5, 1, 1, 1], [0.5, -0.1, 1, 1, 1], [0.5, 3.5, 1, 1, 1]]
    drag_along(np.array(outside, dtype=float), u, v, lower, 1.0, 0.01, force)
    assert not force.any()
    drag_along(np.array([[0.5, 0.5, 0.0, -900.0, 9.0]]), u, v, lower, 1.0, 0.5, force)
    assert -900.0 < force[0, 0, 1] * 0.5 < -800.0


def test_a_floor_answers_for_where_it_is_and_how_it_moves():
    """A box turned by a quarter, 4 m by 1 m, that sinks and spins."""
    floors = Floors()
    floors.rows = np.array([[1.0, 2.0, 0.0, 1.0, 2.0, 0.5, 3.0, -1.0, 0.5, 0.5, 2.0]])
    found = floors.sample(np.array([[1.0, 2.0], [1.0, 5.0], [2.5, 2.0], [4.5, 8.0]]))
    assert found.distance == pytest.approx([-0.5, 1.0, 1.0, 5.0])
    assert found.velocity[1] == pytest.approx([3.0 - 0.5 * 3.0, -1.0])
    assert found.velocity[2] == pytest.approx([3.0, -1.0 + 0.5 * 1.5])
    two = np.concatenate([floors.rows, floor(20.0, 7.0)])
    floors.rows = two
    found = floors.sample(np.array([[0.0, 18.0], [1.0, 2.0]]))
    assert found.body.tolist() == [1, 0] and found.velocity[0] == pytest.approx([0.0, 7.0])


def test_puffs_go_with_the_wind():
    random = np.random.default_rng(5)
    dust = puffs(np.array([[0.0, 5.0]]), np.zeros((1, 2)), 1.0, 60.0, random)
    dust[:, DVX] = 0.0
    for _ in range(300):
        dust = advance_dust(dust, 1.0 / 60.0, lambda places: np.tile((4.0, 0.0), (len(places), 1)))
    assert dust[0, DVX] == pytest.approx(4.0, rel=0.02) and dust[0, DX] > 14.0


def test_the_fall_is_the_same_with_and_without_the_air():
    """The air does not slow floors; without it dust is drawn in still air, and nothing is computed."""
    one, other = built(), built()
    other.post(SetEffect("air", False))
    for stage in (one, other):
        stage.post(Action("fire"))
        stage.run(100)
    assert np.array_equal(one.scene.model.world.bodies.positions, other.scene.model.world.bodies.positions)
    assert read(one, "dust in the air") > 10.0 and read(one, "fastest air") > 3.0
    assert read(other, "dust in the air") == 0.0 == read(other, "fastest air")
    assert read(other, "dust raised") == read(one, "dust raised") > 0.0  # what falls is lighter by it
    assert len(other.scene.model.dust.rows) > 30
    other.post(SetEffect("air", True))
    other.run(20)
    assert read(other, "fastest air") > 0.5


def test_still_air_is_not_computed_and_a_state_is_taken_up_again():
    stage = built()
    stage.run(90)
    assert stage.scene.model.solids.awake() == 0 and stage.scene.model.air.gas.time < 80.0 / 60.0
    stage.post(Action("fire"))
    stage.run(30)
    stage.post(Pointer("down", -2.5, 2.8, 3))  # a floor breaks between two steps
    digest = stage.digest()
    assert (stage.scene.model.frame.parts.kind == SHARD).any()
    stage.run(30)
    after = stage.digest()
    for _ in range(30):
        stage.step_back()
    assert stage.digest() == digest
    stage.run(30)
    assert stage.digest() == after
