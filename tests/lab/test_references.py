"""References against a second way of computing them."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from game.lab.references import CAROM, missed_share, two_balls


def time_of_contact(p, v, radius):
    """Least root of |d + u t| = 2 R by bisection of the closing branch."""
    d, u = p[1] - p[0], v[1] - v[0]
    nearest = -float(d @ u) / float(u @ u)
    low, high = 0.0, nearest
    for _ in range(200):
        middle = 0.5 * (low + high)
        if np.linalg.norm(d + u * middle) > 2.0 * radius:
            low = middle
        else:
            high = middle
    return low


def test_carom_event_by_event():
    p, v = CAROM.start[:2].copy(), CAROM.velocities[:2].copy()
    contact = time_of_contact(p, v, CAROM.radius)
    assert contact == pytest.approx(CAROM.event_times[0], abs=1e-13)
    p = p + v * contact
    normal = (p[1] - p[0]) / np.linalg.norm(p[1] - p[0])
    swap = (v[0] - v[1]) @ normal * normal
    v = np.array([v[0] - swap, v[1] + swap])
    right = contact + (CAROM.width - CAROM.radius - p[1, 0]) / v[1, 0]
    lower = contact + (CAROM.radius - p[0, 1]) / v[0, 1]
    assert (right, lower) == pytest.approx(CAROM.event_times[1:], abs=1e-12)
    end = p + v * (CAROM.time - contact)
    end[1, 0] = 2.0 * (CAROM.width - CAROM.radius) - end[1, 0]
    end[0, 1] = 2.0 * CAROM.radius - end[0, 1]
    assert np.abs(end - CAROM.end[:2]).max() < 1e-12
    assert np.abs(v * [[1, -1], [-1, 1]] - CAROM.end_velocities[:2]).max() < 1e-12
    assert (CAROM.end[2] == CAROM.start[2]).all()


def test_the_struck_ball_of_the_carom_passes_the_third_closely():
    way = CAROM.end_velocities[1]
    off = CAROM.start[2] - CAROM.end[1]
    across = abs(way[0] * off[1] - way[1] * off[0]) / np.linalg.norm(way)
    assert across - 2.0 * CAROM.radius == pytest.approx(4.2e-3, abs=1e-5)


def test_two_balls_meet_once():
    p = np.array([[0.0, 0.0], [1.0, 0.02]])
    v = np.array([[10.0, 0.1], [0.0, 0.0]])
    contact = 0.0940942065485371
    before = two_balls(p, v, 0.03, contact - 1e-9)
    assert np.abs(before - (p + v * (contact - 1e-9))).max() < 1e-15
    after = two_balls(p, v, 0.03, 0.2)
    assert np.abs(after.sum(axis=0) - (p + 0.2 * v).sum(axis=0)).max() < 1e-14
    met = p + v * contact
    left = (after - met) / (0.2 - contact)
    assert (left * left).sum() == pytest.approx((v * v).sum(), rel=1e-12)
    # the struck ball leaves along the line of centres
    line = met[1] - met[0]
    assert abs(left[1, 0] * line[1] - left[1, 1] * line[0]) < 1e-10


def test_two_balls_that_part_or_pass_go_straight_on():
    p = np.array([[0.0, 0.0], [1.0, 0.0]])
    for v in ([[-1.0, 0.0], [0.0, 0.0]], [[1.0, 0.2], [0.0, 0.0]]):
        assert (two_balls(p, np.array(v), 0.03, 3.0) == p + 3.0 * np.array(v)).all()


@pytest.mark.parametrize("way", [0.05, 0.0125, 8.0 / 60.0, 0.3])
def test_missed_share_against_quadrature(way):
    """A hit at impact parameter b counts on half a chord, sqrt(D^2 - b^2), of the way of one step."""
    d = 2.0 * 0.028575

    def missed(b):
        return max(0.0, 1.0 - math.sqrt(d * d - b * b) / way)

    edge = math.sqrt(max(0.0, d * d - way * way))
    expected = (quad(missed, 0.0, edge)[0] + quad(missed, edge, d, epsabs=1e-13)[0]) / d
    assert missed_share(way * 60.0, 1.0 / 60.0, 0.028575) == pytest.approx(expected, abs=1e-9)


def test_missed_share_of_usual_shots():
    for speed, dt, share in (
        (3.0, 1 / 60, 0.149072241760022),
        (3.0, 1 / 240, 0.00803148360173245),
        (8.0, 1 / 60, 0.663358712213769),
    ):
        assert missed_share(speed, dt, 0.028575) == pytest.approx(share, rel=1e-12)
