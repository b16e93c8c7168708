"""The law of a plate against reference values: trajectories, cycles, stability, borders, cards in SI.

Values: two independent integrations each (DOP853 and RK4 with Richardson; DOP853 and Radau; closed forms).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.lab.benchmarks.plates import gap_after, numpy_rates
from game.physics.plates import Plate, Plates
from game.physics.plates.law import SPIN, THETA, VX, VY, X, Y
from game.physics.plates.regimes import BORDERS, THICKEST, drop, long_run

THIN = 1.0 / 14.0
FLUTTER = (-1.4622878338935463, -0.11692482028057719, -0.48202044915245384, -0.16436770853631522,
           -1.7866855005136855, -6.8831788885492315)  # fmt: skip
TUMBLE = (0.04095279702428671, -0.612814696754713, -0.7903113655134943, -1.4727156166058852,
          -0.8802614184582899, -7.222490529679695)  # fmt: skip


def in_body_axes(state: np.ndarray) -> np.ndarray:
    """(v_x', v_y', spin, angle, X, Y) of a state, as the paper has them."""
    c, s = math.cos(state[THETA]), math.sin(state[THETA])
    u = c * state[VX] + s * state[VY], c * state[VY] - s * state[VX]
    return np.array([*u, state[SPIN], state[THETA], state[X], state[Y]])


@pytest.mark.parametrize(("inertia", "end"), [(1.1, FLUTTER), (1.4, TUMBLE)])
def test_trajectories(inertia, end):
    plate = Plate(inertia=inertia, thickness=THIN)
    errors = []
    for dt in (0.04, 0.02):
        last = drop([plate], 0.2, 10.0, dt, every=round(10.0 / dt))[-1, :, 0]
        errors.append(np.max(np.abs(in_body_axes(last) - end)))
    assert errors[1] < 1e-6
    assert math.log2(errors[0] / errors[1]) > 3.6  # fourth order


@pytest.mark.parametrize(
    ("inertia", "period", "degrees", "descent", "swing"),
    [(0.4, 5.633964661665585, 36.64170383106511, 0.2978127877608484, 0.977368614251022),
     (0.8, 9.416737158777423, 63.19586679184026, 0.3289077924388688, 1.859342306124354)],
)  # fmt: skip
def test_cycles_of_flutter(inertia, period, degrees, descent, swing):
    (course,) = long_run([Plate(inertia=inertia, thickness=THIN)])
    assert course.regime == "flutter"
    found = (course.period, course.amplitude, course.descent, course.swing)
    assert found == pytest.approx((period, degrees, descent, swing), rel=1e-3)


def test_the_cycle_of_tumbling():
    (course,) = long_run([Plate(inertia=1.4, thickness=THIN)])
    assert course.regime == "tumble"
    found = (course.spin, course.descent, course.slope)
    assert found == pytest.approx((0.4916568893203183, 0.32405452937239226, 23.270511518120397), rel=1e-3)


def test_regimes_and_the_border_of_tumbling_from_both_sides():
    """From flutter to tumbling at I = 1.2149, within 2 %; chaos above, flutter about broadside from 3 on."""
    inertias = (0.4, 0.98 * 1.21489, 1.02 * 1.21489, 1.4, 2.0, 3.2)
    found = [course.regime for course in long_run([Plate(inertia=i, thickness=THIN) for i in inertias])]
    assert found == ["flutter", "flutter", "tumble", "tumble", "chaos", "flutter"]


def test_borders_hold_up_to_the_thickness_that_the_map_draws_them_to_and_not_at_a_thick_plate():
    """From both sides, 3 % and 4 % off, of a plate without thickness and of the thickest; not at 0.45."""
    flutter, tumble, chaos = BORDERS
    inertias = (0.97 * flutter, 1.03 * flutter, 0.97 * tumble, 1.1 * tumble, 0.96 * chaos, 1.04 * chaos)
    held = ["flutter", "tumble", "tumble", "chaos", "chaos", "flutter"]
    for thickness in (0.0, THICKEST):
        found = long_run([Plate(inertia=i, thickness=thickness) for i in inertias])
        assert [course.regime for course in found] == held, thickness
    (thick,) = long_run([Plate(inertia=1.35, thickness=0.45)])
    assert flutter < 1.35 < tumble and thick.regime == "flutter"


@pytest.mark.parametrize(
    ("inertia", "growth", "frequency"),
    [(1.1, 0.489279616871948, 1.2254884536728576), (3.0, 0.08954026, 1.0259340554067415)],
)
def test_broadside_is_unstable_as_its_eigenvalues_say(inertia, growth, frequency):
    """Growth and frequency of a small sway, by three samples of x'' = 2 g x' - (g² + f²) x."""
    plate = Plate(inertia=inertia, thickness=THIN, half_chord=1.0)
    states = drop([plate], 1e-12, 46.0, 0.01, every=50)[:, :, 0]
    tilt = states[52:, THETA]
    a = np.stack([tilt[1:-1], -tilt[:-2]], axis=1)
    twice, squared = np.linalg.lstsq(a, tilt[2:], rcond=None)[0]
    assert math.log(squared) / (2.0 * 0.5) == pytest.approx(growth, rel=2e-3)
    assert math.acos(twice / (2.0 * math.sqrt(squared))) / 0.5 == pytest.approx(frequency, rel=2e-3)


def test_steady_speeds_and_cards_in_si():
    plate = Plate(half_chord=0.02, inertia=5.0 / 3.0, thickness=0.0)
    assert plate.speed == pytest.approx(0.5718391382198319, rel=1e-12)
    assert plate.broadside == pytest.approx(0.6542491872762315, rel=1e-12)
    card = Plate(half_chord=0.0275, inertia=3.787878787878788, thickness=0.0)
    assert (card.speed, card.broadside) == pytest.approx((1.0108783309577865, 1.156560092272027), rel=1e-12)
    unit = plate.speed
    assert plate.edge_on / unit == pytest.approx(2.8024956081989645, rel=1e-12)
    world = Plates([plate], [(0.0, 0.0, 0.0)])
    world.settings = world.settings._replace(floor=-100.0)
    for _ in range(300):
        world.step(0.01)
    assert -world.velocities[0, 1] == pytest.approx(plate.broadside, rel=1e-9)  # no tilt: it stays level


def test_lift_and_drag_coefficients():
    plate = Plate()
    assert plate.lift_coefficient(math.radians(5.0)) == pytest.approx(0.2083778132003164, rel=1e-12)
    # the same from the law's own force on a plate held at 5 degrees, by the weight of a light one
    alpha = math.radians(5.0)
    u = np.array([math.cos(alpha), -math.sin(alpha)])  # body axes
    ax, ay, _ = numpy_rates(np.array([0.0, u[0], u[1], 0.0]), 1e9, 0.0, gravity=0.0)
    force = np.array([ax, ay]) * 1e9
    lift = force @ np.array([-u[1], u[0]])
    assert lift * math.pi == pytest.approx(plate.lift_coefficient(alpha), rel=1e-6)
    assert -force @ u * math.pi == pytest.approx(plate.drag_coefficient(alpha), rel=1e-6)


def test_the_kernel_and_numpy_are_the_same_law():
    assert gap_after(800, 0.005) < 1e-8
