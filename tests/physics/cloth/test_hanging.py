"""A cloth's motion: it hangs from its hooks, billows, tears, is cut free, falls, and can be taken hold of."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.cloth import Breeze, Cloth, Fabric, GasAt, Hanging
from game.physics.cloth.effects import CLOTH
from game.physics.cloth.layout import CHAR, FUEL, HOT, INVERSE, SALT, THERE, VX, VY, VZ, X, Y, Z
from game.physics.fields import GRAVITY, WIND

DT = 1.0 / 60.0
SMALL = Hanging(width=0.8, height=0.48, span=0.796, top=1.0)


def strains(cloth: Cloth) -> np.ndarray:
    n = cloth.nodes[X : Z + 1]
    across = np.sqrt(((n[:, :, 1:] - n[:, :, :-1]) ** 2).sum(axis=0)) / cloth.spacing - 1.0
    along = np.sqrt(((n[:, 1:] - n[:, :-1]) ** 2).sum(axis=0)) / cloth.spacing - 1.0
    return np.concatenate([(across * cloth.ties.across).ravel(), (along * cloth.ties.along).ravel()])


def lose(cloth: Cloth, meshes: np.ndarray) -> None:
    """Burn these meshes (ny, nx) away, and notice it."""
    patches = np.repeat(np.repeat(meshes, 2, axis=0), 2, axis=1)
    cloth.patches[FUEL][patches] = 0.0
    cells = np.zeros((1, 1, 4))
    cells[..., 0] = 293.15
    gas = GasAt(-1.0, 0.0, 2.0, 1e9, 1e9, 0.27, 1.3, 1e6, 0.0, 0.0, 0.0)
    calm = (np.zeros((1, 2)), np.zeros((2, 1)), Breeze(-1.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0))
    cloth.step(DT, cells, np.zeros((1, 1)), gas, calm)


def ring(cloth: Cloth, low: int, high: int) -> np.ndarray:
    found = np.zeros(cloth.whole.shape, dtype=bool)
    found[low:high, low:high] = True
    found[low + 1 : high - 1, low + 1 : high - 1] = False
    return found


def test_it_hangs_from_its_hooks_without_stretching_far():
    cloth = Cloth(40, None, SMALL)
    cloth.settle(2.0)
    corners = cloth.nodes[X : Z + 1, 0][:, [0, -1]]
    assert pytest.approx(np.array([(-0.398, 1.0, 0.0), (0.398, 1.0, 0.0)]), abs=1e-12) == corners.T
    assert strains(cloth).max() < 0.12 and cloth.pieces == 1
    assert cloth.nodes[Y, -1].mean() == pytest.approx(0.52, abs=0.06)
    cloth.move(DT)
    assert np.abs(cloth.nodes[VX : VZ + 1]).max() < 0.5


def test_a_straight_way_to_a_hook_is_its_reach_and_a_cut_makes_it_longer():
    cloth = Cloth(20, None, SMALL)
    reach = cloth.ties.reach[0]
    assert reach[0, 0] == 0.0 and reach[12, 0] == pytest.approx(12 * cloth.spacing)
    assert reach[6, 8] == pytest.approx(cloth.spacing * 10.0, rel=0.05)
    assert cloth.ties.reach[1][:, ::-1] == pytest.approx(reach, abs=1e-12)
    before = reach[11, 2]
    cut = np.zeros(cloth.whole.shape, dtype=bool)
    cut[6, :15] = True
    lose(cloth, cut)
    assert cloth.ties.reach[0, 11, 2] > 1.8 * before
    assert cloth.ties.reach[0, 3, 2] == pytest.approx(cloth.spacing * math.hypot(3, 2), rel=0.05)


def test_what_is_cut_free_falls_to_the_ground_and_the_rest_stays():
    cloth = Cloth(20, None, SMALL)
    cloth.settle(1.0)
    lose(cloth, ring(cloth, 3, 9))
    assert (
        cloth.pieces == 2 and cloth.fallen() == 16 and cloth.holes() == pytest.approx(20 * cloth.spacing**2)
    )
    assert np.isinf(cloth.ties.reach[:, 6, 6]).all()
    for _ in range(10):
        cloth.move(DT)
    assert cloth.nodes[VY, 6, 6] == pytest.approx(-9.81 / 6.0, rel=0.08)  # it falls freely
    for _ in range(80):
        cloth.move(DT)
    assert (
        cloth.nodes[Y, 4:9, 4:9].max() < 0.15
        and cloth.nodes[Y, 4:9, 4:9].min() >= cloth.hanging.floor - 1e-12
    )
    assert cloth.nodes[Y, 0, 10] > 0.85 and np.isfinite(cloth.nodes).all()


def test_a_mesh_that_is_lost_takes_its_heat_with_it():
    cloth = Cloth(20, None, SMALL)
    cloth.patches[HOT, 10:12, 10:12] = 500.0
    before = cloth.warmth()
    gone = np.zeros(cloth.whole.shape, dtype=bool)
    gone[5, 5] = True
    cloth.patches[CHAR, 10, 10] = 0.01
    lose(cloth, gone)
    lost = before - cloth.warmth()
    assert cloth.ash[0] > 0.5 * lost > 0.0 and cloth.ash[2] == pytest.approx(0.01 * cloth.size**2)
    books = cloth.totals[2] + cloth.totals[1] + cloth.ash[0]  # radiated, to the gas, with the ash
    assert lost == pytest.approx(books, rel=1e-9)
    assert np.all(cloth.patches[HOT, 10:12, 10:12] == 293.15) and cloth.whole[5, 5] == 0.0


def test_a_corner_that_burns_lets_go_of_its_hook():
    cloth = Cloth(20, None, SMALL)
    cloth.settle(0.5)
    gone = np.zeros(cloth.whole.shape, dtype=bool)
    gone[0, 0] = True
    lose(cloth, gone)
    assert cloth.hooked.tolist() == [0.0, 1.0] and np.isinf(cloth.ties.reach[0]).all()
    for _ in range(30):
        cloth.move(DT)
    assert cloth.nodes[Y, 1, 0] < 0.9 and cloth.nodes[Y, 0, -1] == 1.0 and cloth.fallen() == 0


def test_without_gravity_and_wind_it_stays_where_it_is():
    cloth = Cloth(16, None, Hanging(width=0.8, height=0.4, span=0.8, effects=CLOTH.known.without(GRAVITY)))
    before = cloth.nodes[X : Z + 1].copy()
    for _ in range(20):
        cloth.move(DT)
    assert np.abs(cloth.nodes[X : Z + 1] - before).max() < 1e-9


@pytest.mark.parametrize("deep", [2.0, -2.0])
def test_the_wind_takes_it_along_and_no_node_overtakes_it(deep):
    cloth = Cloth(16, Fabric(dry=1e-4), SMALL)
    u, v = np.zeros((1, 2)), np.zeros((2, 1))
    breeze = Breeze(-1.0, 0.0, 2.0, deep, 0.0, 1.0, 0.0, 0.7, 0.1)
    for _ in range(10):
        cloth.move(DT, (u, v, breeze))
    middle = cloth.nodes[:, 8, 8]
    assert middle[Z] * deep > 0.0 and np.abs(cloth.nodes[VZ]).max() < 6.0
    alone = Cloth(16, Fabric(dry=1e-4), Hanging(width=0.8, height=0.48, span=0.796, top=1.0,
                                                effects=CLOTH.known.without(WIND)))  # fmt: skip
    for _ in range(10):
        alone.move(DT, (u, v, breeze))
    assert abs(alone.nodes[Z, 8, 8]) < 0.5 * abs(middle[Z])


def test_wind_along_the_plane_pulls_by_the_brush_of_the_gas():
    cloth = Cloth(16, None, SMALL)
    cloth.settle(0.5)
    start = cloth.nodes[X, -1].mean()
    u, v = np.full((1, 2), 3.0), np.zeros((2, 1))
    breeze = Breeze(-1.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.3)
    for _ in range(40):
        cloth.move(DT, (u, v, breeze))
    assert cloth.nodes[X, -1].mean() > start + 0.004


def test_a_thread_that_is_pulled_too_far_parts():
    cloth = Cloth(16, None, Hanging(width=0.8, height=0.4, span=0.8, top=1.0, strength=0.3))
    cloth.settle(0.5)
    assert cloth.grab((0.0, 0.62)) and cloth.held is not None
    nothing = np.zeros(cloth.whole.shape, dtype=bool)
    for k in range(60):
        cloth.drag((0.0, 0.62 - 0.02 * k))
        lose(cloth, nothing)
    assert cloth.others[8] > 0 and np.any(cloth.whole == 0.0)
    cloth.release()
    assert cloth.held is None


def test_what_is_held_goes_where_the_hand_goes():
    cloth = Cloth(16, None, SMALL)
    cloth.settle(0.5)
    assert not cloth.grab((0.0, 0.05)) and not cloth.grab((-0.398, 1.0), 0.001)
    assert cloth.grab((0.1, 0.55))
    row, column = cloth.held
    cloth.drag((0.15, 0.6))
    for _ in range(5):
        cloth.move(DT)
    assert cloth.nodes[X : Y + 1, row, column] == pytest.approx((0.15, 0.6), abs=1e-9)
    cloth.release()
    assert cloth.nodes[INVERSE, row, column] > 0.0


def test_a_brush_writes_on_the_cloth_itself():
    cloth = Cloth(20, None, SMALL)
    cloth.settle(0.5)
    on = cloth.point_on((0.0, 0.75))
    assert on == pytest.approx((0.4, 0.25), abs=0.03) and cloth.point_on((0.0, 0.1)) is None
    cloth.dab((0.4, 0.24), 0.05)
    salt = cloth.patches[SALT]
    assert salt.sum() * cloth.size**2 == pytest.approx(math.pi * 0.05**2, rel=0.05) and salt.max() == 1.0
    cloth.dab((0.4, 0.24), 0.2, 0.0)
    assert salt.max() == 0.0
    with pytest.raises(ValueError, match="radius"):
        cloth.dab((0.0, 0.0), -1.0)
    with pytest.raises(ValueError, match="share"):
        cloth.write(np.ones((2, 2)))


def test_a_state_brings_everything_back():
    one, other = Cloth(16, None, SMALL), Cloth(16, None, SMALL)
    one.settle(0.3)
    lose(one, ring(one, 2, 6))
    other.restore(one.state())
    for cloth in (one, other):
        for _ in range(10):
            cloth.move(DT)
    assert np.array_equal(one.nodes, other.nodes) and other.pieces == 2
    assert np.array_equal(one.ties.reach, other.ties.reach) and np.array_equal(
        one.nodes[THERE], other.nodes[THERE]
    )


@pytest.mark.parametrize(
    "wrong", [{"width": 0.0}, {"span": 2.0}, {"substeps": 0}, {"strength": math.nan}, {"shear": -1.0}]
)
def test_nonsense_is_refused(wrong):
    with pytest.raises(ValueError, match=next(iter(wrong))):
        Hanging(**wrong)
    with pytest.raises(ValueError, match="meshes"):
        Cloth(3)
    with pytest.raises(ValueError, match="dt"):
        Cloth(4).step(0.0, np.zeros((1, 1, 4)), np.zeros((1, 1)), None, None)
