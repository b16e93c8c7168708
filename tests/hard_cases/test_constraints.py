"""Linked particles where it hurts: no length, no mobility, too much stretch, contradictions, a wild hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.constraints import (
    AREAS,
    ATTACHMENTS,
    DAMPING,
    LINKS,
    MODELS,
    ORDERS,
    SCHEMES,
    TEARING,
    PositionBasedDynamics,
    shapes,
)
from game.physics.fields import GRAVITY, GROUND

G = 9.81
FALLING = GRAVITY | LINKS


def run(system, dt, steps):
    for _ in range(steps):
        system.step(dt)
        system.check()
    return system


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("solver", ["gauss-seidel", "direct"])
def test_c14_h1_links_without_length(model, solver):
    """Ends that coincide have no direction: nothing happens to them, and nothing is not a number."""
    system = PositionBasedDynamics(
        [(0, 0), (0, 0), (1, 0)], [1, 1, 0], [(0, 1), (1, 2)], rest_lengths=[0.0, 1.0], model=model,
        solver=solver, effects=FALLING,
    )  # fmt: skip
    run(system, 1 / 60, 60)
    apart = PositionBasedDynamics(
        [(0, 0), (0, 0)], 1.0, [(0, 1)], rest_lengths=[0.5], model=model, solver=solver, effects=FALLING
    )
    run(apart, 1 / 60, 60)
    assert np.array_equal(apart.positions[0], apart.positions[1])
    assert apart.positions[0, 1] < -4.0
    zero = PositionBasedDynamics(
        [(0, 0), (3, 0)],
        [0, 1],
        [(0, 1)],
        rest_lengths=[0.0],
        model=model,
        solver=solver,
        effects=LINKS | LINKS,
    )
    run(zero, 1 / 60, 60)
    assert np.linalg.norm(zero.positions[1]) < 1e-9


def test_c14_h2_nothing_can_move():
    system = PositionBasedDynamics(
        [(0, 0), (3, 0), (0, 5)], 0.0, [(0, 1), (1, 2)], rest_lengths=[1, 1], effects=FALLING
    )
    run(system, 1 / 60, 30)
    assert np.array_equal(system.positions, [(0, 0), (3, 0), (0, 5)])
    assert not system.velocities.any()


@pytest.mark.parametrize("scheme", SCHEMES)
def test_c14_h3_ten_times_overstretched(scheme):
    """0.45 m to be made good in a step would be 27 m/s; with a limit it comes together and stays so."""
    system = PositionBasedDynamics(
        [(0, 0), (0.5, 0)], [0, 1], [(0, 1)], rest_lengths=[0.05], scheme=scheme, speed_limit=3.0,
        effects=FALLING | DAMPING, damping=1.0,
    )  # fmt: skip
    fastest = 0.0
    for _ in range(240):
        run(system, 1 / 60, 1)
        fastest = max(fastest, float(np.linalg.norm(system.velocities[1])))
    assert fastest <= 3.0 + 1e-12
    assert system.measure().worst_strain < 0.05


@pytest.mark.parametrize(("ratio", "factor"), [(1.0, 0.975528258147577), (1e2, 0.998922199533774)])
def test_c14_h4_mass_ratio_slows_the_sweeps_as_predicted(ratio, factor):
    """Heavy end bead of ten links: the error's factor a sweep is reported, not hidden."""
    weights = [0.0] + [1.0] * 9 + [1.0 / ratio]
    system = PositionBasedDynamics(
        [(0, -0.1 * i) for i in range(11)], weights, [(i, i + 1) for i in range(10)], order="natural",
        iterations=1, effects=LINKS | LINKS,
    )  # fmt: skip
    system.fields[1, 10] -= 1e-6
    errors = []
    for _ in range(1500):
        system.step(1.0)
        system.fields[2:4] = 0.0
        errors.append(np.abs(np.diff(system.positions[:, 1]) + 0.1).max())
    late = 100 if ratio == 1.0 else 1400
    assert errors[late] / errors[late - 1] == pytest.approx(factor, abs=2e-5 if ratio > 1 else 2e-4)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("order", ORDERS)
def test_c14_h5_contradictions_are_bounded_and_keep_momentum(model, order):
    """A triangle of links 1, 1 and 3 cannot be; three of one pair want different lengths."""
    system = PositionBasedDynamics(
        [(0, 0), (1, 0), (0.5, 0.8)], 1.0, [(0, 1), (1, 2), (0, 2), (0, 1), (0, 1)],
        rest_lengths=[1, 1, 3, 0.5, 2.0], model=model, order=order, effects=LINKS | DAMPING, damping=2.0,
    )  # fmt: skip
    centre = system.positions.mean(axis=0)
    for _ in range(300):
        run(system, 1 / 60, 1)
        assert np.abs(system.positions).max() < 10
    assert np.allclose(system.positions.mean(axis=0), centre, rtol=0, atol=1e-9)
    assert system.measure().mean_excess > 0.1


@pytest.mark.parametrize("solver", ["gauss-seidel", "direct"])
def test_c14_h6_taut_between_two_pins(solver):
    """As long as the span: no solution with gravity, a singular matrix; finite, and nearly straight."""
    x = np.linspace(0, 1, 11)
    system = PositionBasedDynamics(
        np.stack([x, 0 * x], axis=1), [0] + [1] * 9 + [0], [(i, i + 1) for i in range(10)], solver=solver,
        effects=FALLING | DAMPING, damping=5.0, speed_limit=20.0, substeps=4,
    )  # fmt: skip
    run(system, 1 / 60, 300)
    assert -0.2 < system.positions[:, 1].min() < 0.0
    assert np.abs(system.positions[:, 0] - x).max() < 0.05


@pytest.mark.parametrize("scheme", SCHEMES)
def test_c14_h7_step_changes_while_it_moves(scheme):
    """Velocity is way over the step's own length: free fall keeps its speed when the step changes."""
    system = PositionBasedDynamics([(0, 0)], 1.0, effects=FALLING, scheme=scheme)
    time = 0.0
    for dt in [1 / 60] * 30 + [1 / 240] * 30 + [1 / 30] * 30:
        before = system.velocities[0, 1]
        system.step(dt)
        time += dt
        assert before - system.velocities[0, 1] == pytest.approx(G * dt, rel=1e-9)
    assert system.velocities[0, 1] == pytest.approx(-G * time, rel=1e-9)


def test_c14_h8_order_matters_no_more_than_the_residual():
    """A hanging net solved in three orders: the ends differ by less than the stretch that is left."""
    net = shapes.cloth((0, 0), 8, 8, 0.1)
    ends, left = [], []
    for order in ORDERS:
        system = PositionBasedDynamics(
            *net[:3], order=order, iterations=30, substeps=4, effects=FALLING | DAMPING, damping=2.0
        )
        run(system, 1 / 60, 240)
        ends.append(system.positions)
        left.append(system.measure().worst_strain * 0.1 * 8)
    for end in ends[1:]:
        assert np.abs(end - ends[0]).max() <= 2 * max(left)
    assert not np.array_equal(ends[0], ends[2])


@pytest.mark.parametrize("scheme", SCHEMES)
def test_c14_h9_wild_hand(scheme):
    """Held and thrown about by metres a frame: at rest again a few seconds after the hand let go."""
    net = shapes.cloth((0, 0), 12, 12, 0.1, pins="corners")
    system = PositionBasedDynamics(
        *net[:3],
        scheme=scheme,
        substeps=4,
        iterations=4,
        speed_limit=20.0,
        effects=FALLING | DAMPING,
        damping=0.5,
    )
    kinetic_before = run(system, 1 / 60, 60).energy()[0]
    rng = np.random.default_rng(3)
    system.grab(77)
    for _ in range(120):
        system.drag(rng.uniform(-5, 5, 2))
        run(system, 1 / 60, 1)
        assert np.linalg.norm(system.velocities, axis=1).max() <= 20.0 + 1e-9
        assert np.abs(system.positions).max() < 40
    system.release()
    assert system.held == -1
    assert system.inverse_masses[77] == 1.0
    run(system, 1 / 60, 600)
    assert system.energy()[0] < max(kinetic_before, 1.0)
    assert np.linalg.norm(system.positions, axis=1).max() < 3.5


def test_c14_h9_hand_leads_where_it_says():
    system = PositionBasedDynamics(
        [(0, 0), (1, 0)], [0, 1], [(0, 1)], speed_limit=30.0, effects=FALLING, substeps=3
    )
    system.grab(0)
    system.drag((0.2, 0.3))
    system.step(1 / 60)
    assert np.allclose(system.positions[0], (0.2, 0.3), rtol=0, atol=1e-15)
    system.release()
    for _ in range(10):
        system.step(1 / 60)
    assert np.allclose(system.positions[0], (0.2, 0.3), rtol=0, atol=1e-15)
    with pytest.raises(ValueError, match="particle 2"):
        system.grab(2)


@pytest.mark.parametrize("links", [1, 1000])
def test_c14_h10_one_link_or_a_thousand(links):
    """Let go from horizontal. Solved directly it keeps its length, though a link goes its own a substep."""
    positions = np.stack([0.01 * np.arange(links + 1), np.zeros(links + 1)], axis=1)
    for solver in ("gauss-seidel", "direct"):
        system = PositionBasedDynamics(
            positions, [0] + [1] * links, [(i, i + 1) for i in range(links)], solver=solver, substeps=8,
            iterations=2, effects=FALLING,
        )  # fmt: skip
        run(system, 1 / 60, 30)
        if solver == "direct":
            assert system.measure().length_ratio < 1.02


def test_chain_of_a_hundred_links_hardly_stretches():
    """Under 1 % at 20 projections a link: substeps, attachments, or two direct solves."""
    for settings in (
        {"substeps": 20, "iterations": 1, "effects": FALLING | ATTACHMENTS | DAMPING},
        {"substeps": 4, "iterations": 2, "solver": "direct", "effects": FALLING | DAMPING},
    ):
        rope = shapes.rope((0, 0), (0, -5), 100)
        system = run(PositionBasedDynamics(*rope[:3], damping=1.0, **settings), 1 / 60, 300)
        assert system.measure().length_ratio < 1.01
        assert np.linalg.norm(system.positions[-1]) < 5.05


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("stiffness", [0.0, 1e-9, 0.5, 1.0])
def test_c15_any_stiffness(model, stiffness):
    """0 is free, 1 is a rigid link."""
    system = PositionBasedDynamics(
        [(0, 0), (0, -1)], [0, 1], [(0, 1)], stiffness, model=model, effects=FALLING,
        compliances=1e12 if stiffness == 0.0 else (1 - stiffness) * 1e-2,
    )  # fmt: skip
    run(system, 1 / 60, 60)
    fall = -system.positions[1, 1] - 1
    if stiffness == 0.0:
        assert fall == pytest.approx(G / 2 * 61 / 60, rel=1e-9)
    elif stiffness == 1.0:
        assert fall < 1e-9


@pytest.mark.parametrize(
    ("changes", "word"),
    [
        ({"stiffness": -0.1}, "stiffness"),
        ({"stiffness": 1.1}, "stiffness"),
        ({"stiffness": math.nan}, "stiffness"),
        ({"compliances": -1.0}, "compliance"),
        ({"compliances": math.nan}, "compliance"),
        ({"rest_lengths": [-1.0]}, "rest"),
        ({"rest_lengths": [1.0, 2.0]}, "rest"),
        ({"inverse_masses": [-1.0, 1.0]}, r"inverse_masses\[0\]"),
        ({"inverse_masses": [math.nan, 1.0]}, "inverse_masses"),
        ({"inverse_masses": [math.inf, 1.0]}, "inverse_masses"),
        ({"positions": [(0, 0), (math.nan, 1)]}, "positions"),
        ({"positions": [(0, 0), (1e300, 1)]}, "positions"),
        ({"positions": np.zeros((0, 2))}, "positions"),
        ({"links": [(0, 2)]}, r"links\[0\]"),
        ({"links": [(0, 0)]}, r"links\[0\]"),
        ({"links": [(0.5, 1)]}, "links"),
        ({"links": [(-1, 0)]}, r"links\[0\]"),
        ({"iterations": 0}, "iterations"),
        ({"iterations": 1.5}, "iterations"),
        ({"substeps": 0}, "substeps"),
        ({"damping": -1.0}, "damping"),
        ({"damping": math.nan}, "damping"),
        ({"gravity": math.inf}, "gravity"),
        ({"floor": math.nan}, "floor"),
        ({"relaxation": 2.0}, "relaxation"),
        ({"relaxation": 0.0}, "relaxation"),
        ({"speed_limit": 0.0}, "speed_limit"),
        ({"model": "spring"}, "model"),
        ({"scheme": "rk4"}, "scheme"),
        ({"solver": "magic"}, "solver"),
        ({"stretch_limit": -1.0}, "stretch_limit"),
    ],
)
def test_absurd_input_is_refused(changes, word):
    given = {"positions": [(0, 0), (1, 0)], "inverse_masses": [0, 1], "links": [(0, 1)], **changes}
    with pytest.raises(ValueError, match=word):
        PositionBasedDynamics(**given)


@pytest.mark.parametrize("dt", [0.0, -1.0, math.nan, math.inf])
def test_absurd_steps_are_refused(dt):
    system = PositionBasedDynamics([(0, 0)])
    with pytest.raises(ValueError, match="dt"):
        system.step(dt)


def test_a_refused_change_changes_nothing():
    system = PositionBasedDynamics([(0, 0), (1, 0)], [0, 1], [(0, 1)], effects=FALLING)
    with pytest.raises(ValueError, match="iterations"):
        system.change(substeps=3, iterations=-1)
    assert system.settings.substeps == 1


@pytest.mark.parametrize("model", MODELS)
def test_c15_very_soft_and_heavy_or_stiff_and_light(model):
    for mass, stiffness, compliance in ((1e4, 1e-6, 1.0), (1e-6, 1.0, 0.0), (1e-6, 1 - 1e-12, 1e-12)):
        system = PositionBasedDynamics(
            [(0, 0), (0, -1), (0.5, -1)], [0, 1 / mass, 1 / mass], [(0, 1), (1, 2), (0, 2)], stiffness,
            compliances=compliance, model=model, effects=FALLING | GROUND, floor=-50.0,
        )  # fmt: skip
        run(system, 1 / 60, 120)
        assert system.positions[:, 1].min() >= -50.0


def test_c15_multipliers_begin_anew_each_substep():
    """A stiffness that drifted would show in the rest stretch after a thousand substeps."""
    system = PositionBasedDynamics(
        [(0, 0), (0, -1)], [0, 1], [(0, 1)], model="xpbd", compliances=0.01, iterations=3,
        effects=FALLING | DAMPING, damping=30.0,
    )  # fmt: skip
    stretch = []
    for _ in range(4):
        run(system, 1 / 60, 600)
        stretch.append(-system.positions[1, 1] - 1)
    assert stretch[-1] == pytest.approx(0.0981, abs=1e-12)
    assert stretch[-1] == pytest.approx(stretch[-2], abs=1e-13)


def test_tearing_counts_and_bounds():
    """A weak net under a heavy row tears, and never mends."""
    net = shapes.cloth((0, 0), 10, 10, 0.1)
    weights = net.inverse_masses.copy()
    weights[shapes.cloth_index(10, 10)[-1]] = 1e-3
    system = PositionBasedDynamics(
        net.positions, weights, net.links, iterations=5, effects=FALLING | TEARING, stretch_limit=0.3
    )
    torn = 0
    for _ in range(120):
        run(system, 1 / 60, 1)
        now = int(system.torn.sum())
        assert now >= torn
        torn = now
    assert 0 < torn == system.tears
    assert system.measure().worst_strain <= 0.3 + 1e-9


def test_state_goes_on_exactly_where_it_was_taken():
    jelly = shapes.joined([shapes.block((0, 0.5), 5, 5, 0.2), shapes.cloth((2, 2), 6, 6, 0.2)])

    def begin():
        return PositionBasedDynamics(
            *jelly[:3], areas=jelly.areas, model="xpbd", compliances=1e-4, scheme="bdf2", substeps=3,
            iterations=2, floor=0.0, stretch_limit=0.4, speed_limit=30.0,
            effects=FALLING | GROUND | AREAS | TEARING | DAMPING | ATTACHMENTS, damping=0.1,
        )  # fmt: skip

    system = begin()
    system.grab(3)
    system.drag((2.0, 4.0))
    run(system, 1 / 60, 50)
    kept = type(system.state())(*(np.array(part) for part in system.state()))
    run(system, 1 / 60, 50)
    other = begin()
    other.restore(kept)
    run(other, 1 / 60, 50)
    for now, then in zip(system.state(), other.state(), strict=True):
        assert now.tobytes() == then.tobytes()


@pytest.mark.parametrize("form", ["list", "float32", "strided", "read-only"])
def test_any_form_of_numbers_will_do(form):
    positions = np.array([(0, 0), (1, 0), (2, 0.5)], dtype=np.float64)
    given = {
        "list": positions.tolist(),
        "float32": positions.astype(np.float32),
        "strided": np.repeat(positions, 2, axis=0)[::2],
        "read-only": positions.copy(),
    }[form]
    if form == "read-only":
        given.flags.writeable = False
    ends = []
    for values in (positions, given):
        system = PositionBasedDynamics(values, [0, 1, 1], [(0, 1), (1, 2)], effects=FALLING)
        ends.append(run(system, 1 / 60, 30).positions)
    assert np.array_equal(*ends)
