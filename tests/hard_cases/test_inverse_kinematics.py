"""Hard cases of inverse kinematics (C03 H1 to H9)."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.physics.animation import IK_METHODS, Skeleton, Solver, chain_skeleton, solve_ik
from game.scenes.skeletons.inverse_kinematics import InverseKinematics
from game.scenes.skeletons.level import FigureContent
from tests.scenes.particle_stages import open_level, stage_of

SOUND = IK_METHODS[:-1]
EPS = 2.0**-52
LEVELS = [path for path in level_files("c03") if path.stem.startswith("hard-")]
every = pytest.mark.parametrize("method", SOUND)
UNREACHED = 1.20555127546399  # (3, 2) by links of 1, 0.8 and 0.6 m


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_of_the_gallery_runs(path):
    stage = stage_of(InverseKinematics, path)
    stage.run(60)
    assert stage.fault is None
    assert np.abs(stage.scene.model.methods).max() < 100.0
    stage.scene.model.rig.skeleton.check()


def test_every_level_says_which_case_it_is():
    for path in LEVELS:
        level = load_level(path, "c03", FigureContent)
        assert level.hard_case == f"C03.H{int(path.stem.split('-')[1])}"
    assert {int(path.stem.split("-")[1]) for path in LEVELS} == set(range(1, 10))


@every
def test_out_of_reach_the_chain_is_straight_and_at_rest(method):
    skeleton = chain_skeleton([1.0, 0.8, 0.6], [0.3, 0.4, 0.5])
    solver = Solver(skeleton, 0, 2)
    found = solver.solve((3.0, 2.0), method, 1e-6, 5_000)
    assert found.ending == "no progress"
    assert found.error == pytest.approx(UNREACHED, abs=1e-6)
    assert np.abs(skeleton.angles[1:]).max() < 1e-3
    assert abs(skeleton.angles[0] - math.atan2(2.0, 3.0)) < 1e-3
    before = skeleton.angles.copy()
    solver.solve((3.0, 2.0), method, 1e-6, 5_000)
    assert np.abs(skeleton.angles - before).max() < 1e-3
    assert np.abs(skeleton.angles).max() < 2 * math.pi


def test_fixed_damping_thrashes_but_its_loop_ends():
    skeleton = chain_skeleton([1.0, 0.8, 0.6], [0.3, 0.4, 0.5])
    solver = Solver(skeleton, 0, 2, remembered=400)
    found = solver.solve((3.0, 2.0), "damped-fixed", 1e-6, 5_000, damping=0.01)
    errors = solver.history[: solver.count]
    assert found.ending == "no progress"
    assert errors[20:].max() > UNREACHED + 0.5
    assert solver.solve((3.0, 2.0), "damped", 1e-6, 500).error == pytest.approx(UNREACHED, abs=1e-9)


@every
def test_a_target_in_the_hole_of_what_can_be_reached(method):
    skeleton = chain_skeleton([2.0, 0.5, 0.3], [0.3, 1.0, 1.0])
    found = solve_ik(skeleton, (0, 2), (0.4, 0.0), method, 1e-6, 20_000)
    assert found.ending == "no progress"
    assert found.error == pytest.approx(0.8, abs=1e-6)
    assert Solver(skeleton, 0, 2).chain.hole == pytest.approx(1.2, rel=1e-15)


@pytest.mark.parametrize("method", IK_METHODS)
def test_the_dead_point_is_left_by_a_kick(method):
    skeleton = chain_skeleton([1.0, 0.8, 0.6])
    solver = Solver(skeleton, 0, 2, remembered=4)
    found = solver.solve((1.0, 0.0), method, 1e-6, 2_000)
    assert solver.history[0] == pytest.approx(1.4)
    assert found.ending == "reached"
    again = chain_skeleton([1.0, 0.8, 0.6])
    solve_ik(again, (0, 2), (1.0, 0.0), method, 1e-6, 2_000)
    assert np.array_equal(again.angles, skeleton.angles)


@every
def test_straight_away_from_a_target_out_of_reach(method):
    """The other dead point: the gradient is zero at the worst pose as well as at the best."""
    skeleton = chain_skeleton([1.0, 0.8, 0.6])
    found = solve_ik(skeleton, (0, 2), (-3.0, 0.0), method, 1e-6, 5_000)
    assert found.error == pytest.approx(0.6, abs=1e-6)


@every
def test_at_full_reach_it_comes_nearer_and_ends(method):
    skeleton = chain_skeleton([1.0, 0.8, 0.6], [0.9, -0.7, 0.5])
    found = solve_ik(skeleton, (0, 2), (2.4, 0.0), method, 1e-6, 2_000)
    assert found.error < 8e-3
    assert found.iterations <= 2_000
    loose = solve_ik(
        chain_skeleton([1.0, 0.8, 0.6], [0.9, -0.7, 0.5]), (0, 2), (2.4, 0.0), method, 1e-2, 20_000
    )
    assert loose.ending == "reached"


@every
def test_a_target_on_the_root(method):
    skeleton = chain_skeleton([1.0, 0.8, 0.6], [0.3, 0.4, 0.5])
    found = solve_ik(skeleton, (0, 2), (0.0, 0.0), method, 1e-6, 5_000)
    assert found.ending == "reached"
    far = chain_skeleton([2.0, 0.5, 0.3], [0.3, 0.4, 0.5])
    found = solve_ik(far, (0, 2), (0.0, 0.0), method, 1e-6, 5_000)
    assert found.error == pytest.approx(1.2, abs=1e-6)
    assert np.all(np.isfinite(far.angles))
    folded = chain_skeleton([1.0, 1.0], [0.0, math.pi])
    found = solve_ik(folded, (0, 1), (0.0, 0.0), method, 1e-6, 500)
    assert found.error < 1e-6


@every
def test_no_length_one_link_and_a_hundred(method):
    skeleton = chain_skeleton([1.0, 0.0, 0.8], [0.3, 0.4, 0.5])
    assert solve_ik(skeleton, (0, 2), (0.6, 1.1), method, 1e-6, 20_000).ending == "reached"
    one = chain_skeleton([1.0], [0.3])
    found = solve_ik(one, (0, 0), (0.3, 1.2), method, 1e-9, 20_000)
    assert found.error == pytest.approx(math.hypot(0.3, 1.2) - 1.0, abs=1e-6)
    assert one.angles[0] == pytest.approx(math.atan2(1.2, 0.3), abs=1e-3)
    hundred = chain_skeleton(np.full(100, 0.01), np.full(100, 0.02))
    found = solve_ik(hundred, (0, 99), (0.2, 0.4), method, 1e-4, 20_000)
    assert found.ending == "reached"


def test_a_hundred_links_take_gradients_a_thousand_iterations():
    rng = np.random.default_rng(8)
    taken = {"gradient": [], "fabrik": []}
    for _ in range(9):
        start, turn = rng.uniform(-0.2, 0.2, 100), rng.uniform(-3, 3)
        target = (0.6 * math.cos(turn), 0.6 * math.sin(turn))
        for method, counts in taken.items():
            chain = chain_skeleton(np.full(100, 0.01), start)
            counts.append(solve_ik(chain, (0, 99), target, method, 1e-6, 20_000).iterations)
    assert max(taken["gradient"]) > 1_000
    assert np.median(taken["fabrik"]) < 30


@every
def test_angles_follow_a_running_target_without_a_jump(method):
    skeleton = chain_skeleton([0.6, 0.5, 0.4, 0.3, 0.2], [0.3, 0.4, 0.5, 0.3, 0.2])
    solver = Solver(skeleton, 0, 4)
    solver.solve((1.2, 0.4), method, 1e-4, 2_000)
    for k in range(200):
        before = skeleton.angles.copy()
        turn = 0.01 * k
        solver.solve((0.4 + 0.8 * math.cos(turn), 0.4 + 0.5 * math.sin(2 * turn)), method, 1e-4, 200)
        assert np.abs(skeleton.angles - before).max() < 0.6
    solver.solve((-1.9, 0.2), method, 1e-4, 200)  # a teleport
    assert np.all(np.isfinite(skeleton.angles))


@every
def test_at_both_limits_the_error_only_falls(method):
    skeleton = Skeleton(
        [-1, 0, 1], [1.0, 0.8, 0.6], [0.2, 0.2, 0.2], lower=[-9, 0.0, 0.0], upper=[9, 0.5, 0.5]
    )
    solver = Solver(skeleton, 0, 2, remembered=400)
    found = solver.solve((-0.2, 0.9), method, 1e-6, 300)
    assert np.all(skeleton.angles <= skeleton.upper)
    assert np.all(skeleton.angles >= skeleton.lower)
    changes = np.diff(solver.history[: solver.count])
    at_rest = np.flatnonzero(np.abs(changes) <= 1e-14)  # from there on it is kicked, to no avail
    assert np.all(changes[: at_rest[0] if len(at_rest) else 30] < 0.0)
    bent = abs(1.0 + 0.8 * cmath.exp(0.5j) + 0.6 * cmath.exp(1.0j))  # as near as both limits let it come
    assert found.error == pytest.approx(bent - math.hypot(0.2, 0.9), abs=1e-6)


@every
def test_many_turns_change_nothing(method):
    plain = chain_skeleton([0.6, 0.5, 0.4], [0.3, 0.4, 0.5])
    wound = chain_skeleton([0.6, 0.5, 0.4], [0.3 + 40 * math.pi, 0.4 - 60 * math.pi, 0.5])
    a = solve_ik(plain, (0, 2), (0.7, 0.6), method, 1e-9, 5_000)
    b = solve_ik(wound, (0, 2), (0.7, 0.6), method, 1e-9, 5_000)
    assert a.ending == b.ending == "reached"
    assert np.allclose(np.cos(plain.angles), np.cos(wound.angles), rtol=0, atol=1e-6)
    assert abs(wound.angles[0] - 40 * math.pi) < 4.0
    stage = open_level(InverseKinematics, "hard-09-many-turns")
    stage.run(300)
    assert stage.fault is None
