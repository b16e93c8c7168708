"""Areas: the gradient by differences, outlines that keep what they enclose."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.constraints import AREAS, LINKS, PositionBasedDynamics, shapes
from game.physics.constraints.areas import (
    AREA,
    AREA_ROWS,
    COMPLIANCE,
    INTACT,
    MULTIPLIER,
    STIFFNESS,
    gradient_weight,
    outline_area,
    project_outline,
    sweep_areas,
)
from game.physics.constraints.links import PBD, XPBD
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, GROUND


@settings(max_examples=30)
@given(st.integers(3, 9), st.integers(0, 10_000))
def test_weight_and_direction_are_those_of_the_gradient(count, seed):
    rng = np.random.default_rng(seed)
    x, y = rng.uniform(-2, 2, (2, count))
    w = rng.uniform(0.1, 2.0, count)
    corners = rng.permutation(count)
    gradient = np.zeros((count, 2))
    step = 1e-6
    for i in range(count):
        for axis, values in enumerate((x, y)):
            kept = values[i]
            values[i] = kept + step
            above = outline_area(x, y, corners)
            values[i] = kept - step
            gradient[i, axis] = (above - outline_area(x, y, corners)) / (2 * step)
            values[i] = kept
    weight = np.sum(w[:, None] * gradient**2)
    assert gradient_weight(x, y, w, corners) == pytest.approx(weight, rel=1e-6, abs=1e-8)
    moved_x, moved_y = x.copy(), y.copy()
    project_outline(moved_x, moved_y, w, corners, 0.25)
    assert np.allclose(moved_x - x, 0.25 * w * gradient[:, 0], rtol=0, atol=1e-7)
    assert np.allclose(moved_y - y, 0.25 * w * gradient[:, 1], rtol=0, atol=1e-7)


def test_a_triangle_alone_gets_its_area_back_and_moves_as_a_whole_nowhere():
    x, y = [0.0, 2.0, 0.5], [0.0, 0.3, 1.0]
    system = PositionBasedDynamics(
        np.stack([x, y], axis=1), [1.0, 0.5, 2.0], areas=[[0, 1, 2]], effects=EffectSet([AREAS]), iterations=1
    )
    system.fields[0, 0] -= 0.8
    before, rest = system.areas()
    assert abs(before[0] - rest[0]) > 0.2
    masses = 1.0 / np.array([[1.0], [0.5], [2.0]])
    centre = (system.positions * masses).sum(axis=0)
    for _ in range(40):
        system.step(1 / 60)
        system.fields[2:4] = 0.0
    after, _ = system.areas()
    assert after[0] == pytest.approx(rest[0], abs=1e-12)
    assert np.allclose((system.positions * masses).sum(axis=0), centre, rtol=0, atol=1e-12)


@pytest.mark.parametrize("model", ["pbd", "xpbd"])
def test_a_ring_that_falls_on_the_ground_keeps_its_area(model):
    ring = shapes.ring((0, 1.2), 0.5, 40)
    system = PositionBasedDynamics(
        *ring[:3], areas=ring.areas, model=model, floor=0.0, effects=GRAVITY | GROUND | LINKS | AREAS,
        substeps=8, iterations=2, damping=1.0, compliances=1e-7,
    )  # fmt: skip
    for _ in range(180):
        system.step(1 / 60)
        now, rest = system.areas()
        assert now[0] == pytest.approx(rest[0], rel=0.06)
    assert system.positions[:, 1].min() == 0.0
    assert system.positions[:, 1].max() > 0.55
    system.change(effects=GRAVITY | GROUND | LINKS)
    for _ in range(300):
        system.step(1 / 60)
    assert system.areas()[0][0] < 0.5 * rest[0]


def test_clockwise_outlines_have_negative_areas_and_keep_them():
    system = PositionBasedDynamics([(0, 0), (0, 1), (1, 0)], areas=[[0, 1, 2]], effects=EffectSet([AREAS]))
    assert system.areas()[1].tolist() == [-0.5]
    system.step(0.1)
    assert np.array_equal(system.positions, [(0, 0), (0, 1), (1, 0)])


@pytest.mark.parametrize("areas", [[[0, 1]], [[0, 1, 1]], [[0, 1, 9]], [[0, 1, -1]]])
def test_absurd_outlines_are_refused(areas):
    with pytest.raises(ValueError, match=r"areas\[0\]"):
        PositionBasedDynamics([(0, 0), (0, 1), (1, 0)], areas=areas)


@pytest.mark.parametrize(("model", "part"), [(PBD, 0.25), (XPBD, 0.5 / (0.5 + 2.0))])
def test_a_model_goes_by_its_own_softness(model, part):
    """Stiffness is of position based dynamics, compliance of XPBD: by Newton's step on the gradient."""
    x, y, w = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, 2.0])
    rows = np.zeros((AREA_ROWS, 1))
    rows[AREA], rows[STIFFNESS], rows[COMPLIANCE], rows[INTACT] = 0.3, 0.25, 0.02, 1.0
    sweep_areas(model, x, y, w, np.arange(3), np.array([0, 3]), rows, 1, 0.1)
    # only (0, 1) can move, and only up and down changes the area: by half as much; w |∂A/∂p|² is 0.5
    assert y.tolist() == pytest.approx([0.0, 0.0, 1.0 - part * 0.4])
    assert rows[MULTIPLIER, 0] == pytest.approx(-part * 0.4 if model == XPBD else 0.0)
