"""What a hand does to a cloth, place by place: written, washed, wetted, held; how it is laid and counted."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.cloth import Cloth, Fabric, Hanging
from game.physics.cloth.cloth import LEAST_MESHES, MOST_MESHES, WAVES
from game.physics.cloth.layout import BEGAN, FUEL, HOT, INVERSE, NOT_YET, SALT, THERE, WATER, X, Y, Z
from game.physics.heat.nodes import WATER_HEAT

FLAT = Hanging(width=0.8, height=0.4, span=0.8, top=1.0)


@pytest.fixture
def cloth() -> Cloth:
    return Cloth(8, None, FLAT)


def middles(cloth: Cloth) -> tuple[np.ndarray, np.ndarray]:
    """m from the upper left corner to the right and down, of each patch."""
    rows, columns = cloth.patches.shape[1:]
    return np.meshgrid((np.arange(columns) + 0.5) * cloth.size, (np.arange(rows) + 0.5) * cloth.size)


def test_it_is_laid_flat_between_its_hooks_cold_and_dry(cloth):
    assert cloth.nodes.shape[1:] == (5, 9) and cloth.patches.shape[1:] == (8, 16)
    assert cloth.nodes[X, 2] == pytest.approx(np.linspace(-0.4, 0.4, 9))
    assert cloth.nodes[Y, :, 3] == pytest.approx(1.0 - 0.1 * np.arange(5))
    assert not cloth.nodes[Z].any() and cloth.size == 0.05
    for row, value in ((HOT, 293.15), (FUEL, 0.25), (SALT, 0.0), (WATER, 0.0), (BEGAN, NOT_YET)):
        assert np.all(cloth.patches[row] == value)
    assert cloth.pieces == 1 and cloth.hanging_pieces() == {0} and cloth.held is None
    assert (cloth.holes(), cloth.fallen(), cloth.time, cloth.poured) == (0.0, 0, 0.0, 0.0)


def test_a_span_less_than_its_width_makes_waves_whose_way_is_as_long():
    cloth = Cloth(200, None, Hanging(width=0.8, height=0.04, span=0.796, top=1.0))
    x, z = cloth.nodes[X, 1], cloth.nodes[Z, 1]
    assert np.hypot(np.diff(x), np.diff(z)).sum() == pytest.approx(0.8, rel=1e-3)
    wave = np.sin(2.0 * math.pi * WAVES * (x / 0.796 + 0.5))
    assert z == pytest.approx((z @ wave) / (wave @ wave) * wave, abs=1e-12) and z.max() > 0.0
    assert cloth.nodes[Z, 0, 0] == cloth.nodes[Z, 0, -1] == 0.0


@pytest.mark.parametrize("meshes", [LEAST_MESHES - 1, MOST_MESHES + 1, 8.0, True, "8"])
def test_a_number_of_meshes_that_is_none_is_refused(meshes):
    with pytest.raises(ValueError, match=rf"^meshes = .*: expected a whole number, {LEAST_MESHES} to"):
        Cloth(meshes, None, FLAT)
    assert Cloth(LEAST_MESHES, None, FLAT).whole.shape[1] == LEAST_MESHES


def test_a_mesh_weighs_what_its_nodes_carry_and_hooks_carry_the_corners(cloth):
    inverse = cloth.nodes[INVERSE]
    assert inverse[0, 0] == inverse[0, -1] == 0.0
    mesh = 0.25 * 0.01
    assert 1.0 / inverse[2, 2] == pytest.approx(mesh) and 1.0 / inverse[0, 3] == pytest.approx(0.5 * mesh)
    assert 1.0 / inverse[-1, -1] == pytest.approx(0.25 * mesh)


def test_what_is_written_is_of_its_shape_and_between_none_and_full(cloth):
    share = np.linspace(0.0, 1.0, 128).reshape(8, 16)
    cloth.write(share)
    assert np.array_equal(cloth.patches[SALT], share)
    for bad in (share[:-1], share.T, share + 1e-9, share - 1e-9, np.full((8, 16), math.nan)):
        with pytest.raises(ValueError, match=r"^share: expected \(8, 16\) numbers from 0 to 1$"):
            cloth.write(bad)
        assert np.array_equal(cloth.patches[SALT], share)


def test_a_round_brush_with_a_soft_edge_writes_and_washes_out(cloth):
    right, down = middles(cloth)
    on, radius = (0.33, 0.21), 0.12
    share = np.clip(0.5 + (radius - np.hypot(right - on[0], down - on[1])) / (2.0 * 0.05), 0.0, 1.0)
    assert set(np.unique(share)) > {0.0, 1.0}
    cloth.write(np.full((8, 16), 0.3))
    cloth.dab(on, radius)
    assert cloth.patches[SALT] == pytest.approx(np.maximum(0.3, share))
    cloth.write(np.full((8, 16), 0.3))
    cloth.dab(on, radius, 0.5)
    assert cloth.patches[SALT] == pytest.approx(np.minimum(0.3, 1.0 - share))
    for place, wide in (((math.nan, 0.0), 0.1), (on, 0.0), (on, math.inf), (on, math.nan), (on, -0.1)):
        with pytest.raises(ValueError, match=r"above 0 m$"):
            cloth.dab(place, wide)


def test_water_lies_as_a_dome_cools_and_keeps_the_heat_there_is():
    cloth = Cloth(8, Fabric(capacity=400.0), FLAT)
    cloth.patches[HOT] = 393.15
    cloth.whole[1, 2] = 0.0
    right, down = middles(cloth)
    x, y = right - 0.4, 1.0 - down
    point, radius, most = (0.05, 0.8), 0.15, 0.6
    near = ((x - point[0]) ** 2 + (y - point[1]) ** 2) / radius**2
    more = np.where(near < 1.0, most * (1.0 - near), 0.0)
    more[2:4, 4:6] = 0.0
    assert cloth.pour(point, radius, most) == pytest.approx(more.sum() * 0.05**2)
    assert cloth.patches[WATER] == pytest.approx(more)
    assert cloth.patches[HOT] == pytest.approx(293.15 + 400.0 * 100.0 / (400.0 + WATER_HEAT * more))
    cloth.pour(point, radius, most)
    assert cloth.patches[WATER] == pytest.approx(2.0 * more)
    assert cloth.poured == pytest.approx(2.0 * more.sum() * 0.05**2)
    for bad in (((math.inf, 0.0), 0.1, 1.0), (point, 0.0, 1.0), (point, math.inf, 1.0), (point, 0.1, -0.1),
                (point, 0.1, 1000.1), (point, 0.1, math.nan)):  # fmt: skip
        with pytest.raises(ValueError, match=r"expected a place, m, kg/m²$"):
            cloth.pour(*bad)
    assert cloth.pour((9.0, 9.0), 0.1, 1000.0) == 0.0


def test_a_place_of_the_picture_is_a_point_of_the_cloth_where_that_now_is(cloth):
    assert cloth.point_on((-0.4, 1.0)) == pytest.approx((0.0, 0.0))
    assert cloth.point_on((0.13, 0.66)) == pytest.approx((0.53, 0.34))
    cloth.nodes[X] += 0.5
    assert cloth.point_on((0.63, 0.66)) == pytest.approx((0.53, 0.34))
    assert cloth.point_on((0.1 - 0.1 + 1e-9, 1.0)) is not None and cloth.point_on((-0.0001, 1.0)) is None
    cloth.nodes[THERE, 0, 0] = 0.0
    assert cloth.point_on((0.1, 1.0), 0.05) is None


def test_a_hand_takes_the_nearest_node_within_reach_but_no_hook(cloth):
    assert not cloth.grab((-0.4, 1.0)) and cloth.held is None
    assert not cloth.grab((0.0, 0.6 - 0.1501)) and cloth.grab((0.0, 0.6 - 0.1499))
    assert cloth.held == (4, 4) and cloth.nodes[INVERSE, 4, 4] == 0.0
    assert cloth.others[5:8] == pytest.approx((0.0, 0.6, 0.0))
    cloth.nodes[Z, 2, 1] = 0.07
    assert cloth.grab((-0.29, 0.81))
    assert cloth.held == (2, 1) and cloth.nodes[INVERSE, 4, 4] > 0.0
    cloth.drag((0.3, 0.5))
    assert cloth.others[5:8] == pytest.approx((0.3, 0.5, 0.07))
    cloth.release()
    assert cloth.held is None and cloth.nodes[INVERSE, 2, 1] > 0.0


def test_pieces_that_hang_on_no_hook_have_fallen(cloth):
    cloth.patches[FUEL, :, 6:8] = 0.0  # a cut down through the fourth column of meshes
    cloth.patches[FUEL, 2:4, 8:] = 0.0  # and one to the right from it, in the second row
    assert cloth._lose()
    assert cloth.pieces == 3 and cloth.hanging_pieces() == {0, 1}
    assert cloth.holes() == pytest.approx(0.01 * (4 + 4)) and cloth.fallen() == 2 * 4
    cloth.hooked[0] = 0.0
    assert cloth.hanging_pieces() == {1} and cloth.fallen() == 2 * 4 + 3 * 4
    assert not cloth._lose()
