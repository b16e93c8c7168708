"""What linked particles must do exactly: closed forms of sweeps, stretch, springs, pendulums."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import ellipj, ellipk

from game.physics.constraints import AREAS, ATTACHMENTS, DAMPING, LINKS, PositionBasedDynamics, shapes
from game.physics.fields import GRAVITY, GROUND

G = 9.81
EPS = 2.0**-52


def run(system, dt, steps):
    for _ in range(steps):
        system.step(dt)
    return system


def hanging(links, length=1.0, mass=1.0, end=1.0, **settings):
    """A chain hanging straight down from its pin at the origin, solved from the pin to the tip."""
    positions = [(0.0, -length * i / links) for i in range(links + 1)]
    weights = [0.0] + [1.0 / mass] * (links - 1) + [1.0 / end]
    settings = {"effects": GRAVITY | LINKS | DAMPING, "order": "natural", **settings}
    return PositionBasedDynamics(positions, weights, [(i, i + 1) for i in range(links)], **settings)


# -- sweeps ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("links", "factor"), [(5, 0.904508497187474), (10, 0.975528258147577), (20, 0.993844170297569)]
)
def test_a_sweep_multiplies_the_error_by_cos_squared(links, factor):
    """cos²(pi / 2 N): the last of many sweeps of a chain that was displaced along itself."""
    assert abs(math.cos(math.pi / (2 * links)) ** 2 - factor) < 4 * EPS
    system = hanging(links, effects=LINKS | LINKS, iterations=1)
    system.fields[1, links] -= 1e-4
    errors = []
    for _ in range(6 * links):
        system.step(1.0)
        system.fields[2:4] = 0.0
        errors.append(np.abs(system.positions[:, 1] + np.linspace(0, 1, links + 1)).max())
    assert errors[-1] / errors[-2] == pytest.approx(factor, abs=2e-3)


@pytest.mark.parametrize(("links", "end", "total"), [(20, 1.0, 0.001294375), (10, 100.0, 0.0063765)])
def test_stretch_of_one_sweep_a_substep(links, end, total):
    """(N - 1) (M + (N - 2) / 2) g h²; link i below N by (N - 1 - i + M) g h², the last not at all."""
    h = 1.0 / 1200.0
    system = hanging(links, end=end, substeps=20, iterations=1, damping=40.0)
    run(system, 20 * h, 3000)
    stretch = -np.diff(system.positions[:, 1]) - 1.0 / links
    expected = [(links - 1 - i + end) * G * h * h for i in range(1, links)] + [0.0]
    assert abs((links - 1) * (end + (links - 2) / 2) * G * h * h - total) < 1e-15
    assert np.allclose(stretch, expected, rtol=0, atol=1e-11)


def test_substeps_win_by_their_number_over_sweeps():
    """Equal cost, 20 links: 1x20, 5x4 and 20x1 (substeps x sweeps); n against n² in the stretch."""
    stretch = {}
    for substeps, sweeps in ((1, 20), (5, 4), (20, 1), (80, 1)):
        system = run(hanging(20, substeps=substeps, iterations=sweeps, damping=20.0), 1 / 60, 900)
        stretch[substeps, sweeps] = -system.positions[-1, 1] - 1.0
    assert stretch[1, 20] == pytest.approx(2.46e-2, rel=0.05)
    assert stretch[5, 4] == pytest.approx(5.1e-3, rel=0.05)
    assert stretch[20, 1] == pytest.approx(1.294375e-3, rel=1e-6)
    assert stretch[80, 1] == pytest.approx(1.294375e-3 / 16, rel=1e-6)


def test_over_relaxation_is_quicker():
    """With 2 / (1 + sin(pi / 2 N)) to 1e-4 of the error in some 38 sweeps for 10 links, in place of 372."""
    needed = {}
    for relaxation in (1.0, 2.0 / (1.0 + math.sin(math.pi / 20.0))):
        system = hanging(10, effects=LINKS | LINKS, iterations=1, relaxation=relaxation)
        system.fields[1, 10] -= 1e-6
        sweeps = 0
        while np.abs(system.positions[:, 1] + np.linspace(0, 1, 11)).max() > 1e-10:
            system.step(1.0)
            system.fields[2:4] = 0.0
            sweeps += 1
        needed[relaxation > 1] = sweeps
    assert 250 < needed[False] < 420
    assert needed[True] < 60


# -- springs --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("k", "sweeps", "dt", "stretch"),
    [(0.1, 1, 1 / 60, 0.024525), (0.1, 4, 1 / 60, 0.00519881506251817),
     (0.1, 4, 1 / 120, 0.00129970376562954), (0.01, 10, 1 / 60, 0.0257738405704361)],
)  # fmt: skip
def test_rest_stretch_of_a_position_based_spring_depends_on_step_and_sweeps(k, sweeps, dt, stretch):
    """One bead: g dt² q / (1 - q), q = (1 - k)^n."""
    q = (1 - k) ** sweeps
    assert abs(G * dt * dt * q / (1 - q) - stretch) < 1e-16
    system = run(hanging(1, stiffness=k, iterations=sweeps, damping=30.0), dt, 4000)
    assert abs(-system.positions[1, 1] - 1.0 - stretch) < 1e-12


@pytest.mark.parametrize(
    ("sweeps", "even"),
    [(1, 0.9), (2, 0.683772233983162), (5, 0.369042655519807), (10, 0.205671765275718)],
)
def test_even_stiffness_does_not_depend_on_sweeps(sweeps, even):
    """k' = 1 - (1 - k)^(1/n): the same stretch for any n, though not for any step."""
    system = hanging(1, stiffness=0.9, iterations=sweeps, model="pbd-even", damping=5.0)
    run(system, 1 / 60, 500)
    assert abs(1 - (1 - 0.9) ** (1 / sweeps) - even) < 1e-14
    assert abs(-system.positions[1, 1] - 1.0 - G / 3600 * 0.1 / 0.9) < 1e-12
    run(system, 1 / 120, 1000)
    assert abs(-system.positions[1, 1] - 1.0 - G / 14400 * 0.1 / 0.9) < 1e-12


@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
@pytest.mark.parametrize("dt", [1 / 30, 1 / 60, 1 / 240])
def test_rest_stretch_with_compliance_is_hookes(dt, scheme):
    """m g / k = 0.0981 m for k = 100 N/m at any step."""
    system = hanging(1, model="xpbd", compliances=0.01, iterations=1, damping=20.0, scheme=scheme)
    run(system, dt, round(20 / dt))
    assert abs(-system.positions[1, 1] - 1.0 - 0.0981) < 1e-12


@pytest.mark.compiled
def test_rest_extension_of_a_chain_with_compliance():
    """alpha g N (N + 1) / 2, and what one sweep a substep adds to it: N (N - 1) / 2 g h², whatever alpha."""
    exact = 1e-5 * G * 20 * 21 / 2
    h = 1.0 / 1200.0
    assert abs(exact - 0.020601) < 1e-15
    for alpha in (1e-5, 1e-6):
        one = run(
            hanging(20, model="xpbd", compliances=alpha, substeps=20, iterations=1, damping=20.0),
            20 * h,
            4000,
        )
        extra = -one.positions[-1, 1] - 1.0 - exact * alpha / 1e-5
        assert extra == pytest.approx(190 * G * h * h, rel=1e-6)
    many = run(hanging(20, model="xpbd", compliances=1e-5, iterations=2000, damping=20.0), 1 / 60, 600)
    assert -many.positions[-1, 1] - 1.0 == pytest.approx(exact, rel=1e-9)
    direct = run(
        hanging(20, model="xpbd", compliances=1e-5, iterations=1, solver="direct", damping=20.0), 1 / 60, 600
    )
    assert -direct.positions[-1, 1] - 1.0 == pytest.approx(exact, rel=1e-9)


def test_a_spring_with_compliance_loses_the_amplitude_of_backward_euler():
    """1 / sqrt(1 + (w dt)²) a step: 0.439565 after a second with w = 10 rad/s at 60 Hz."""
    w, dt = 10.0, 1 / 60
    system = PositionBasedDynamics(
        [(0, 0), (1.1, 0)], [0, 1], [(0, 1)], rest_lengths=[1.0], model="xpbd", compliances=0.01,
        iterations=1, effects=LINKS | LINKS, velocities=[(0, 0), (0, 0)],
    )  # fmt: skip
    # amplitude by position and the velocity of implicit Euler: x² + (v / w)² falls by exactly 1 + (w dt)²
    run(system, dt, 1)
    before = math.hypot(system.positions[1, 0] - 1, system.velocities[1, 0] / w)
    run(system, dt, 60)
    after = math.hypot(system.positions[1, 0] - 1, system.velocities[1, 0] / w)
    assert after / before == pytest.approx(0.439565198601358, rel=1e-11)


def test_damped_spring_converges_to_the_closed_form():
    """m = 1, k = 100, c = 2, x0 = 0.1: x(1) = -0.0336851680590413; order 1 with Euler, 2 with BDF2."""
    for scheme, order in (("euler", 1), ("bdf2", 2)):
        counts, errors = [200, 400, 800, 1600, 3200], []
        for n in counts:
            system = PositionBasedDynamics(
                [(0, 0), (2.1, 0)], [0, 1], [(0, 1)], rest_lengths=[2.0], model="xpbd", compliances=0.01,
                iterations=1, effects=LINKS | DAMPING, damping=2.0, scheme=scheme,
            )  # fmt: skip
            run(system, 1.0 / n, n)
            errors.append(abs(system.positions[1, 0] - 2.0 + 0.0336851680590413))
        slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
        assert order - 0.15 <= slope <= order + 0.25


@pytest.mark.parametrize(
    ("links", "stretch"), [([(0, 1), (1, 2)], 0.5 * G / 100 + G / 200), ([(0, 1), (0, 1)], None)]
)
def test_springs_in_series_and_side_by_side(links, stretch):
    """Side by side k1 + k2; in series 1/k = 1/k1 + 1/k2, here with a bead of next to no mass between."""
    if stretch is None:
        system = PositionBasedDynamics(
            [(0, 0), (0, -1)], [0, 1], links, model="xpbd", compliances=[0.01, 0.005], iterations=400,
            effects=GRAVITY | LINKS | DAMPING, damping=20.0,
        )  # fmt: skip
        run(system, 1 / 60, 600)
        assert -system.positions[1, 1] - 1 == pytest.approx(G / 300, abs=1e-10)
        return
    system = PositionBasedDynamics(
        [(0, 0), (0, -1), (0, -2)], [0, 1e6, 1], links, model="xpbd", compliances=[0.01, 0.005], iterations=1,
        solver="direct", effects=GRAVITY | LINKS | DAMPING, damping=20.0,
    )  # fmt: skip
    run(system, 1 / 60, 600)
    assert -system.positions[2, 1] - 2 == pytest.approx(G * 0.015 + 1e-6 * G * 0.01, abs=1e-10)


# -- motion ---------------------------------------------------------------------------------------------


def pendulum(steps, scheme, until=1.0, **settings):
    """One link of 1 m from horizontal: the angle from straight down, released on the side of +x."""
    system = PositionBasedDynamics(
        [(0, 0), (1, 0)], [0, 1], [(0, 1)], iterations=1, scheme=scheme, effects=GRAVITY | LINKS, **settings
    )
    run(system, until / steps, steps)
    return system


def exact_angle(t):
    """2 asin(k sn(K - w t)) with k = sin 45°."""
    k2 = 0.5
    sn = ellipj(ellipk(k2) - math.sqrt(G) * t, k2)[0]
    return 2 * math.asin(math.sqrt(k2) * sn)


@pytest.mark.parametrize(("scheme", "order"), [("euler", 1), ("bdf2", 2)])
def test_order_of_a_pendulum(scheme, order):
    """theta(1) = -1.4050273115248 released at 90°."""
    assert abs(exact_angle(1.0) + 1.4050273115248) < 1e-12
    counts, errors = [200, 400, 800, 1600, 3200], []
    for n in counts:
        x, y = pendulum(n, scheme).positions[1]
        errors.append(math.hypot(x - math.sin(exact_angle(1.0)), y + math.cos(exact_angle(1.0))))
    slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert order - 0.15 <= slope <= order + 0.25


@pytest.mark.parametrize(
    ("scheme", "frequency", "lost"), [("euler", 60, 8.795), ("euler", 600, 2.6), ("bdf2", 60, 0.255)]
)
def test_energy_lost_by_a_pendulum_in_ten_seconds(scheme, frequency, lost):
    """Of 9.81 J: nine tenths gone with Euler at 60 Hz, and next to nothing with BDF2."""
    system = pendulum(10 * frequency, scheme, 10.0)
    kinetic, potential = system.energy()
    assert -(kinetic + potential) == pytest.approx(lost, rel=0.03)


SWINGING = {
    2: (1.0, [-0.497415570745156, 0.0507715469556641, -0.976164772438102, -0.0934477370474356]),
    5: (0.8, [-0.190965874450991, -0.0594309245693561, -0.389138449232602, -0.0864055534718355,
              -0.582905620171927, -0.135946278801312, -0.76373204020427, -0.22139688335322,
              -0.928429039428859, -0.334864493032881]),
}  # fmt: skip


@pytest.mark.parametrize(
    ("scheme", "substeps", "error"), [("euler", 20, 1.9e-2), ("bdf2", 20, 2.9e-4), ("bdf2", 100, 1.15e-5)]
)
def test_a_swinging_chain_of_five(scheme, substeps, error):
    """Against Lagrange's equations, by one sweep a substep."""
    until, nodes = SWINGING[5]
    positions = [(0.2 * i, 0.0) for i in range(6)]
    system = PositionBasedDynamics(
        positions, [0] + [1] * 5, [(i, i + 1) for i in range(5)], order="natural", iterations=1,
        substeps=substeps, scheme=scheme, effects=GRAVITY | LINKS,
    )  # fmt: skip
    run(system, 1 / 60, round(until * 60))
    off = np.abs(system.positions[1:] - np.reshape(nodes, (5, 2))).max()
    assert off == pytest.approx(error, rel=0.02)


def test_more_sweeps_do_not_mend_a_trajectory():
    """Two links at 60 Hz: 1 sweep or 100, the error at 1 s is the same to a few per cent."""
    _, nodes = SWINGING[2]
    errors = []
    for sweeps in (1, 100):
        system = PositionBasedDynamics(
            [(0, 0), (0.5, 0), (1, 0)],
            [0, 1, 1],
            [(0, 1), (1, 2)],
            iterations=sweeps,
            effects=GRAVITY | LINKS,
        )
        run(system, 1 / 60, 60)
        errors.append(np.linalg.norm(system.positions[1:] - np.reshape(nodes, (2, 2)), axis=1).max())
    assert errors[0] == pytest.approx(errors[1], rel=0.1)
    assert errors[1] > 0.1


def test_bdf2_velocity_with_the_prediction_of_euler_doubles_gravity():
    """Why both halves are needed: a naive twin falls twice as far in ten seconds."""
    h, y, before, v = 1 / 60, 0.0, 0.0, 0.0
    for i in range(600):
        v -= h * G
        p = y + h * v
        v = (3 * p - 4 * y + before) / (2 * h) if i else (p - y) / h
        before, y = y, p
    assert -y / (G * 50) == pytest.approx(1.993, abs=5e-3)
    system = PositionBasedDynamics([(0, 0)], scheme="bdf2", effects=GRAVITY | LINKS)
    run(system, 1 / 60, 600)
    assert -system.positions[0, 1] / (G * 50) == pytest.approx(1.0, abs=2e-3)


@pytest.mark.compiled
@pytest.mark.parametrize(
    ("links", "sag", "rise"),
    [(10, 0.804370998291229, 0.871546766346051), (20, 0.79827310891564, 0.435603127368318)],
)
def test_a_rope_between_two_pins_hangs_as_the_discrete_catenary(links, sag, rise):
    """2 m of rope over 1 m; each slope is ``rise`` more than the last. Projecting from where gravity took it,
    a substep of h is off by about h²."""
    x = np.linspace(0, 1, links + 1)
    errors = []
    for substeps in (8, 32):
        system = PositionBasedDynamics(
            np.stack([x, -1e-3 * np.sin(math.pi * x)], axis=1), [0.0] + [1.0] * (links - 1) + [0.0],
            [(i, i + 1) for i in range(links)], rest_lengths=2.0 / links * np.ones(links), substeps=substeps,
            iterations=2, solver="direct", effects=GRAVITY | LINKS | DAMPING, damping=8.0, speed_limit=10.0,
        )  # fmt: skip
        run(system, 1 / 60, 900)
        assert system.measure().worst_strain < 1e-13
        errors.append(-system.positions[:, 1].min() - sag)
    assert 0 < errors[1] < 3e-7
    assert errors[0] / errors[1] == pytest.approx(16.0, rel=0.02)
    way = np.diff(system.positions, axis=0)
    assert np.allclose(np.diff(way[:, 1] / way[:, 0]), rise, rtol=0, atol=1.2e-3)


@pytest.mark.parametrize(("links", "mode"), [(2, 0.585786437626905), (5, 0.263560319718141)])
def test_slowest_swing_of_a_chain(links, mode):
    """Small oscillations: w² = g / l times the least zero of the Laguerre polynomial L_N."""
    from numpy.polynomial.laguerre import lagroots

    zero = lagroots([0] * links + [1])[0]
    assert abs(zero - mode) < 1e-12
    length = 0.2
    w = math.sqrt(zero * G / length)
    # the shape of the mode: L_N-like values along the chain, by the eigenvector of the linear problem
    stiff = np.zeros((links, links))
    for i in range(links):
        tension = links - i
        stiff[i, i] += tension
        if i:
            stiff[i, i - 1] -= tension
            stiff[i - 1, i] -= tension
            stiff[i - 1, i - 1] += tension
    _, vectors = np.linalg.eigh(stiff)
    shape = vectors[:, 0] / np.abs(vectors[:, 0]).max() * 1e-3
    y = [0.0]
    x = [0.0, *shape]
    for i in range(links):
        y.append(y[-1] - math.sqrt(length**2 - (x[i + 1] - x[i]) ** 2))
    system = PositionBasedDynamics(
        np.stack([x, y], axis=1), [0.0] + [1.0] * links, [(i, i + 1) for i in range(links)],
        rest_lengths=length * np.ones(links), solver="direct", iterations=2, scheme="bdf2", substeps=40,
        effects=GRAVITY | LINKS,
    )  # fmt: skip
    quarter = 0.5 * math.pi / w
    run(system, quarter / 60, 60)
    assert np.abs(system.positions[1:, 0]).max() < 1e-3 * 2e-2
    assert system.velocities[-1, 0] == pytest.approx(-shape[-1] * w, rel=1e-2)


# -- conservation ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["pbd", "pbd-even", "xpbd"])
@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_momentum_is_kept_without_pins(model, scheme):
    """A jelly thrown and shaken: linear momentum to rounding."""
    jelly = shapes.block((0, 0), 6, 5, 0.1)
    velocities = np.random.default_rng(2).normal(0, 1, jelly.positions.shape)
    system = PositionBasedDynamics(
        *jelly[:3], stiffness=0.5, areas=jelly.areas, model=model, compliances=1e-4, velocities=velocities,
        effects=LINKS | AREAS, iterations=3, substeps=2, scheme=scheme,
    )  # fmt: skip
    start = system.momentum()
    run(system, 1 / 60, 120)
    now = system.momentum()
    scale = 1e-13 * 240 * np.abs(velocities).sum()
    assert abs(now[0] - start[0]) < scale
    assert abs(now[1] - start[1]) < scale


@pytest.mark.parametrize("what", ["link", "outline"])
def test_a_projection_turns_nothing(what):
    """Corrections times masses make no moment about any point."""
    rng = np.random.default_rng(8)
    positions, weights = rng.normal(0, 1, (5, 2)), rng.uniform(0.2, 3, 5)
    system = PositionBasedDynamics(
        positions,
        weights,
        [(0, 3)] if what == "link" else [],
        rest_lengths=[0.1] if what == "link" else None,
        areas=[[0, 1, 2, 3, 4]] if what == "outline" else (),
        effects=LINKS | AREAS,
        iterations=1,
    )
    system.outlines.rows[0] *= 3.0
    system.step(1.0)
    moved = (system.positions - positions) / weights[:, None]
    assert np.abs(moved).max() > 0.1
    moment = np.sum(positions[:, 0] * moved[:, 1] - positions[:, 1] * moved[:, 0])
    assert abs(moment) < 64 * EPS * np.abs(moved).sum()


def test_damping_is_a_force():
    """A lone particle of 2 kg with k_d = 3: each step divides the speed by 1 + h k_d / m."""
    system = PositionBasedDynamics([(0, 0)], [0.5], velocities=[(2, 0)], damping=3.0, effects=DAMPING | LINKS)
    run(system, 0.01, 100)
    assert system.velocities[0, 0] == pytest.approx(2.0 / (1 + 0.015) ** 100, rel=1e-12)


def test_ground_stops_and_fixed_particles_stay():
    system = PositionBasedDynamics(
        [(0, 1), (1, 1), (2, -3)], [1, 0, 0], floor=0.25, effects=GRAVITY | GROUND | LINKS
    )
    run(system, 1 / 60, 120)
    assert np.array_equal(system.positions, [(0, 0.25), (1, 1), (2, -3)])
    assert np.array_equal(system.velocities, np.zeros((3, 2)))


@pytest.mark.parametrize("what", [GRAVITY, GROUND, LINKS, AREAS, ATTACHMENTS, DAMPING])
def test_what_is_off_does_nothing(what):
    """Each effect changes a fall of a jelly on a rope, and only if it is on."""
    jelly = shapes.joined([shapes.block((0, 0.3), 4, 4, 0.2), shapes.rope((0, 1), (1, 1), 8)])
    everything = GRAVITY | GROUND | LINKS | AREAS | ATTACHMENTS | DAMPING
    ends = []
    for effects in (everything, everything.without(what)):
        system = PositionBasedDynamics(
            *jelly[:3],
            areas=jelly.areas,
            stiffness=0.3,
            effects=effects,
            floor=0.0,
            damping=0.4,
            iterations=2,
        )
        ends.append(run(system, 1 / 60, 40).positions)
    assert np.abs(ends[0] - ends[1]).max() > 1e-6


def test_usual_effects_are_those_that_the_arguments_are_for():
    """A jelly made without a word about effects falls, keeps its area, is damped and stopped by its floor."""
    jelly = shapes.block((0, 1), 4, 4, 0.2)
    system = PositionBasedDynamics(*jelly[:3], areas=jelly.areas, floor=0.0, damping=0.5, substeps=4)
    assert AREAS in system.settings.effects
    run(system, 1 / 60, 240)
    assert system.positions[:, 1].min() == 0.0
    assert system.energy()[0] < 1e-3


@pytest.mark.parametrize("order", ["natural", "reversed", "coloured"])
@pytest.mark.parametrize("model", ["pbd", "xpbd"])
def test_each_link_has_its_own_numbers_in_any_order(order, model):
    """Beads on springs of their own: a stretch of α m g, or g dt² (1 - k) / k, whichever is solved first."""
    compliances, stiffness = np.array([1e-3, 4e-3, 2e-2]), np.array([0.9, 0.5, 0.2])
    tops = [(float(i), 0.0) for i in range(3)]
    system = PositionBasedDynamics(
        [*tops, *((x, -1.0) for x, _ in tops)], [0.0] * 3 + [1.0] * 3, [(i, i + 3) for i in range(3)],
        stiffness, compliances=compliances, model=model, order=order, iterations=1, damping=5.0,
        effects=GRAVITY | LINKS | DAMPING,
    )  # fmt: skip
    run(system, 1 / 60, 2_000)
    expected = compliances * G if model == "xpbd" else G / 3600 * (1 - stiffness) / stiffness
    assert np.allclose(-1.0 - system.positions[3:, 1], expected, rtol=0, atol=1e-10)


@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_no_step_leaves_anything_but_its_state(scheme):
    """A system built again and given the state goes on by the same bits: multipliers begin at 0 each time."""

    def jelly():
        ring = shapes.ring((0.0, 0.0), 0.5, 8)
        return PositionBasedDynamics(
            ring.positions, 1.0, ring.links, areas=[list(range(8))], compliances=1e-4, area_compliance=1e-3,
            model="xpbd", scheme=scheme, iterations=4, floor=-0.6, effects=GRAVITY | LINKS | AREAS | GROUND,
        )  # fmt: skip

    system, fresh = jelly(), jelly()
    run(system, 1 / 60, 25)
    fresh.restore(type(system.state())(*(part.copy() for part in system.state())))
    run(system, 1 / 60, 3)
    run(fresh, 1 / 60, 3)
    assert np.array_equal(system.fields, fresh.fields)


def test_what_is_let_go_begins_bdf2_anew():
    """The hand led it, no force did: its first step falls g h², one of Euler, and not 4/9 g h²."""
    h = 1 / 60
    system = PositionBasedDynamics([(0.0, 0.0)], scheme="bdf2", effects=GRAVITY | LINKS)
    system.grab(0)
    run(system, h, 5)
    assert system.positions.tolist() == [[0.0, 0.0]]
    system.release()
    run(system, h, 1)
    assert system.positions[0, 1] == pytest.approx(-G * h * h, rel=1e-14)


def test_a_change_of_scheme_begins_bdf2_anew():
    """Euler keeps no step before; what stands there is older, and does not count."""
    h = 1 / 60

    def falling(**more):
        return PositionBasedDynamics([(0.0, 0.0)], velocities=[(1.0, 2.0)], effects=GRAVITY | LINKS, **more)

    system = falling(scheme="bdf2")
    run(system, h, 4)
    system.change(scheme="euler")
    run(system, h, 4)
    system.change(scheme="bdf2")
    start, speed = system.positions, system.velocities
    run(system, h, 1)
    assert system.velocities[0] == pytest.approx(speed[0] - (0.0, G * h), abs=1e-13)
    assert system.positions[0] == pytest.approx(start[0] + h * (speed[0] - (0.0, G * h)), abs=1e-14)
