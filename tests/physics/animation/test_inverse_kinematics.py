"""Inverse kinematics: closed forms, the gradient by another way, invariants of methods, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from game.physics.animation.ik.chain import ANGLE, PULL, chain_of, place_points, pull_joints
from game.physics.animation.ik.inverse_kinematics import Solver, solve_ik
from game.physics.animation.ik.solver import METHODS
from game.physics.animation.ik.two_links import two_link_angles
from game.physics.animation.skeleton import Skeleton, SkeletonError, chain_skeleton

EPS = 2.0**-52
SOUND = METHODS[:-1]  # all but damping that is fixed
MONOTONE = ("armijo", "buss", "damped", "ccd")
turns = st.floats(-3.0, 3.0)
every = pytest.mark.parametrize("method", SOUND)


def arm():
    return chain_skeleton([1.0, 0.8, 0.6], [0.3, 0.4, 0.5])


@given(
    st.lists(st.tuples(st.floats(0.0, 2.0), turns), min_size=1, max_size=9),
    st.floats(-3, 3),
    st.floats(-3, 3),
)
def test_pull_is_the_gradient_by_complex_steps(bones, x, y):
    """(Jᵀe)_i = -d(|e|²/2)/dθ_i, which a complex step gives without any difference."""
    lengths = [b[0] + 0.01 for b in bones]
    skeleton = chain_skeleton(lengths, [b[1] for b in bones])
    chain = chain_of(skeleton, 0, len(bones) - 1)
    chain.links[ANGLE] = skeleton.angles
    place_points(chain.base, chain.links, ANGLE, chain.points)
    pull_joints(chain.points, np.array([x, y]), chain.links)
    size = (sum(lengths) + 5.0) ** 2
    for i in range(len(bones)):
        angles = skeleton.angles.astype(complex)
        angles[i] += 1e-30j
        ahead = np.cumsum(angles)
        ex = x - (np.array(lengths) * np.cos(ahead)).sum()
        ey = y - (np.array(lengths) * np.sin(ahead)).sum()
        slope = (0.5 * (ex * ex + ey * ey)).imag / 1e-30
        assert abs(chain.links[PULL, i] + slope) <= 1e-12 * size


@every
def test_two_links_come_to_one_of_their_two_solutions(method):
    """(1.2, 0.7) by links of 1 and 0.8: -0.0739531788805313, 1.38853897167577 rad with the elbow down."""
    exact = two_link_angles(1.0, 0.8, (1.2, 0.7))
    assert np.allclose(exact, (-0.0739531788805313, 1.38853897167577), rtol=0, atol=1e-13)
    skeleton = chain_skeleton([1.0, 0.8], [0.1, 1.0])
    found = solve_ik(skeleton, (0, 1), (1.2, 0.7), method, 1e-10, 5_000)
    assert found.ending == "reached"
    assert np.allclose(skeleton.angles, exact, rtol=0, atol=1e-9)


@given(st.floats(0.1, 3.0), st.floats(0.1, 3.0), st.floats(-4, 4), st.floats(-4, 4))
def test_the_closed_form_reaches_what_can_be_reached(first, second, x, y):
    distance = math.sqrt(x * x + y * y)
    best = max(0.0, distance - first - second, abs(first - second) - distance)
    for elbow_down in (True, False):
        skeleton = chain_skeleton([first, second], two_link_angles(first, second, (x, y), elbow_down))
        assert math.dist(skeleton.ends[1], (x, y)) == pytest.approx(best, abs=3e-8 * (1 + distance))


@every
@settings(max_examples=25)
@given(radius=st.floats(0.1, 2.2), angle=turns, start=st.lists(st.floats(-1.5, 1.5), min_size=3, max_size=3))
def test_what_can_be_reached_is_reached(method, radius, angle, start):
    skeleton = chain_skeleton([1.0, 0.8, 0.6], start)
    target = (radius * math.cos(angle), radius * math.sin(angle))
    found = solve_ik(skeleton, (0, 2), target, method, 1e-5, 20_000)
    assert found.error <= 1e-5
    assert math.dist(skeleton.ends[2], target) == pytest.approx(found.error, abs=1e-12)
    joints = np.vstack([skeleton.bases, skeleton.ends[-1:]])
    lengths = np.linalg.norm(np.diff(joints, axis=0), axis=1)
    assert np.allclose(lengths, [1.0, 0.8, 0.6], rtol=0, atol=8 * 3 * EPS * 2.4)
    skeleton.check()


@pytest.mark.parametrize("method", MONOTONE)
@settings(max_examples=25)
@given(
    x=st.floats(-2.4, 2.4), y=st.floats(-2.4, 2.4), start=st.lists(st.floats(-2, 2), min_size=5, max_size=5)
)
def test_errors_never_grow(method, x, y, start):
    """Within a quarter beyond the reach, where the target itself is aimed at, and off dead points."""
    assume(math.hypot(x, y) < 2.5 and abs(y) > 0.01)
    skeleton = Skeleton(np.arange(5) - 1, [0.6, 0.5, 0.4, 0.3, 0.2], np.array(start) / 2,
                        lower=np.full(5, -1.0), upper=np.full(5, 1.0))  # fmt: skip
    for limited in (True, False):
        skeleton.pose(np.array(start) / 2)
        solver = Solver(skeleton, 0, 4, remembered=60)
        solver.solve((x, y), method, 1e-6, 30, limited=limited)
        changes = np.diff(solver.history[: solver.count])
        at_rest = np.flatnonzero(np.abs(changes) <= 16 * EPS * 6)  # from there on it may be kicked
        assert np.all(changes[: at_rest[0] if len(at_rest) else 20] <= 0.0)


def test_the_largest_stable_step_of_a_straight_chain():
    """Σ r² = 8.08 for links 1, 0.8, 0.6: a step of 2 / 8.08 is the largest; 2.1 swings, 1.9 converges."""
    errors = {}
    for step in (1.9, 2.1):
        skeleton = chain_skeleton([1.0, 0.8, 0.6], [0.01, 0.0, 0.0])
        solver = Solver(skeleton, 0, 2, remembered=400)
        solver.solve((2.4, 0.0), "gradient", 1e-12, 399, step=step, keep_best=False)
        assert solver.chain.numbers[3] == pytest.approx(8.08, rel=1e-15)
        errors[step] = solver.history[: solver.count]
    assert errors[1.9][-1] < 1e-3
    assert errors[2.1][-50:].min() > 1e-2


def test_buss_needs_ten_times_fewer_iterations_than_the_fixed_step():
    rng = np.random.default_rng(4)
    skeleton = chain_skeleton(np.full(10, 0.1), rng.uniform(-0.5, 0.5, 10))
    solver = Solver(skeleton, 0, 9)
    radii, angles = 0.9 * np.sqrt(rng.random(60)), rng.uniform(-3, 3, 60)
    targets = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    median = {m: np.median(solver.solve_each(targets, m, 1e-6, 20_000).iterations) for m in SOUND}
    assert median["buss"] * 4 < median["gradient"]
    assert median["damped"] <= 15
    assert median["fabrik"] <= 15
    assert median["damped"] < median["buss"]


def test_many_targets_at_once_are_those_one_by_one():
    skeleton = arm()
    solver = Solver(skeleton, 0, 2)
    targets = np.array([(1.0, 1.0), (0.2, -0.3), (5.0, 1.0)])
    together = solver.solve_each(targets, "damped")
    for k, target in enumerate(targets):
        skeleton.pose([0.3, 0.4, 0.5])
        one = solver.solve(target, "damped")
        assert np.array_equal(skeleton.angles, together.angles[k])
        assert one.error == together.errors[k]
        assert one.iterations == together.iterations[k]


@every
def test_a_chain_within_a_tree_moves_only_its_own_bones(method):
    """Bones beside each other's ends, a bent frame below the chain, and children that follow."""
    skeleton = Skeleton(
        [-1, 0, 1, 2, 3, 1],
        [0.5, 0.6, 0.5, 0.4, 0.2, 0.3],
        [1.2, -0.4, 0.5, 0.5, 0.1, 0.9],
        [(0.3, -0.2), (0.5, 0.0), (0.55, 0.12), (0.5, 0.0), (0.4, 0.0), (0.6, 0.0)],
    )
    target = 0.6 * skeleton.ends[3] + 0.4 * skeleton.bases[1] + (0.1, 0.05)
    found = solve_ik(skeleton, (1, 3), target, method, 1e-8, 10_000)
    assert found.ending == "reached"
    assert np.allclose(skeleton.ends[3], target, rtol=0, atol=1.1e-8)
    assert skeleton.angles[[0, 4, 5]].tolist() == [1.2, 0.1, 0.9]
    assert np.array_equal(skeleton.bases[4], skeleton.ends[3])
    skeleton.check()


def test_targets_and_settings_that_make_no_sense_are_refused():
    skeleton = arm()
    for target in ((math.nan, 0.0), (0.0, math.inf), (1e300, 0.0)):
        with pytest.raises(SkeletonError, match="target"):
            solve_ik(skeleton, (0, 2), target)
    for change, words in (
        ({"method": "newton"}, "method"),
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": math.nan}, "tolerance"),
        ({"iterations": 0}, "iterations"),
        ({"step": 0.0}, "step"),
        ({"damping": math.nan}, "damping"),
    ):
        with pytest.raises(SkeletonError, match=words):
            solve_ik(skeleton, (0, 2), (1.0, 1.0), **change)
    with pytest.raises(SkeletonError, match="does not hang"):
        solve_ik(skeleton, (2, 0), (1.0, 1.0))
    with pytest.raises(SkeletonError, match="no length"):
        solve_ik(chain_skeleton([0.0, 0.0]), (0, 1), (1.0, 1.0))
    with pytest.raises(SkeletonError, match="targets"):
        Solver(skeleton, 0, 2).solve_each([1.0, 2.0])
    with pytest.raises(SkeletonError, match="links"):
        two_link_angles(0.0, 1.0, (1.0, 0.0))
    assert np.array_equal(skeleton.angles, [0.3, 0.4, 0.5])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_joint_at_its_limit_and_pulled_beyond_takes_no_part(side):
    """The other joint turns by j·e / (λ² + j·j), as if it were alone; pulled back, both turn."""
    for bent, alone in ((0.5, True), (0.5 - 1e-9, False)):
        skeleton = Skeleton(
            [-1, 0], [1.0, 0.8], [0.2 * side, bent * side], lower=[-3.0, -0.5], upper=[3.0, 0.5]
        )
        end, target = skeleton.ends[1].copy(), np.array([0.9, 1.3 * side])
        e, j = target - end, np.array([-end[1], end[0]])
        solve_ik(skeleton, (0, 1), target, METHODS[-1], 1e-12, 1, damping=0.4)
        turn = float(j @ e) / ((0.4 * 1.8) ** 2 + float(j @ j))  # the damping is over the reach
        assert skeleton.angles[1] == 0.5 * side
        assert (abs(skeleton.angles[0] - 0.2 * side - turn) < 1e-12) == alone


@pytest.mark.parametrize("seed", range(6))
def test_reaching_within_limits_never_ends_farther_away(seed):
    """Where a limit holds a link back, a pass may lead away from the target: then another way is taken."""
    rng = np.random.default_rng(seed)
    for _ in range(12):
        skeleton = Skeleton(
            [-1, 0, 1], [1.0, 0.8, 0.6], rng.uniform(-0.4, 0.4, 3), lower=[-0.5] * 3, upper=[0.5] * 3
        )
        target = rng.uniform(-2.0, 2.0, 2)
        for _ in range(3):
            before = math.dist(skeleton.ends[2], target)
            solve_ik(skeleton, (0, 2), target, "fabrik", 1e-12, 1)
            assert math.dist(skeleton.ends[2], target) <= before + 1e-12
            assert np.abs(skeleton.angles).max() <= 0.5
