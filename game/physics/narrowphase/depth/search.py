"""Generalised penetration depth by branch and bound over the angle.

For A turned by theta the least displacement is the translational depth d(theta), so that the depth with
rotation is the least of

    sigma² = d(theta)² + 4 k² sin²(theta / 2),   k² = polar second moment of area of A / its area

the object norm of Kazerounian and Rastegar 1992: the mean square displacement of A's points. d jumps where A
comes to fit into a gap of B, so the bound over an interval theta +- w is not d less something: every B_j -
A_i(theta') contains B_j - A_i(theta) eroded by 2 R_i sin(w / 2), the farthest that a point of A_i goes. The
distance to what these leave free is no more than d anywhere in the interval.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.narrowphase.depth.sums import build_differences, shrink
from game.physics.narrowphase.depth.union import nearest_free

# Columns of an interval: its middle and half its width (rad), sigma in the middle and a bound below (m), and
# what became of it.
MIDDLE, HALF, SIGMA, BOUND, STATE = range(5)
INTERVAL = 5
PRUNED, SPLIT, ENDED = range(3)
NARROWEST = 1e-7  # rad, half the width of an interval that is not split
# Columns of an answer: sigma (m), displacement (m), angle (rad), bound below sigma (m), evaluations.
FOUND, FOUND_X, FOUND_Y, FOUND_ANGLE, FOUND_BOUND, EVALUATIONS, INTERVALS = range(7)
ANSWER = 7


@inner_kernel
def _turn_norm(gyration, angle):
    """The object norm (m) of a turn alone."""
    return 2.0 * gyration * abs(elementary.sin(0.5 * angle))


@inner_kernel
def _try_angle(pair, angle, most, answer):
    """Take the motion with this angle as the answer if it is shorter; sigma, or at least ``most``."""
    a, b, differences, gyration, slack = pair
    build_differences(a, b, angle, differences)
    shrink(a, b, 0.0, differences)
    d, x, y = nearest_free(differences, slack, most)
    sigma = elementary.hypot(d, _turn_norm(gyration, angle))
    if d < most and sigma < answer[FOUND]:
        answer[FOUND], answer[FOUND_X], answer[FOUND_Y], answer[FOUND_ANGLE] = sigma, x, y, angle
    answer[EVALUATIONS] += 1.0
    return sigma


@inner_kernel
def _parallel_angle(a, b, middle, half):
    """An angle within the interval at which an edge of A runs against one of B, as where they touch; the
    middle if there is none."""
    best, least = middle, half
    for i in range(a.starts.shape[0] - 1):
        for p in range(a.starts[i], a.starts[i + 1]):
            p2 = p + 1 if p + 1 < a.starts[i + 1] else a.starts[i]
            heading = elementary.atan2(a.corners[p, 1] - a.corners[p2, 1], a.corners[p, 0] - a.corners[p2, 0])
            for j in range(b.starts.shape[0] - 1):
                for q in range(b.starts[j], b.starts[j + 1]):
                    q2 = q + 1 if q + 1 < b.starts[j + 1] else b.starts[j]
                    other = elementary.atan2(
                        b.corners[q2, 1] - b.corners[q, 1], b.corners[q2, 0] - b.corners[q, 0]
                    )
                    away = other - heading - middle
                    away -= 2.0 * math.pi * math.floor(away / (2.0 * math.pi) + 0.5)
                    if abs(away) <= least:
                        best, least = middle + away, abs(away)
    return best


@inner_kernel
def _look(pair, row, most, answer):
    """Sigma in the middle of an interval, and the bound below it anywhere within; both are looked for no
    farther than ``most``, m."""
    a, b, differences, gyration, slack = pair
    row[SIGMA] = _try_angle(pair, row[MIDDLE], most, answer)
    nearest = max(0.0, abs(row[MIDDLE]) - row[HALF])
    shrink(a, b, 2.0 * elementary.sin(0.5 * row[HALF]), differences)
    d, _, _ = nearest_free(differences, slack, most)
    row[BOUND] = max(row[BOUND], elementary.hypot(d, _turn_norm(gyration, nearest)))


@lean_kernel
def search(pair, tolerance, rows, answer):
    """The least sigma to ``tolerance`` (m): intervals into rows (n, INTERVAL), the answer (ANSWER,).

    pair: A's parts, B's parts about A's centroid, space for their differences, radius of gyration m, slack m.
    Level by level, an interval is halved unless its bound comes within the tolerance of the shortest motion
    found. It is not if it is the narrowest, or the rows are full. FOUND_BOUND says what is then certain.
    """
    a, b, _, gyration, _ = pair
    answer[:] = 0.0
    answer[FOUND] = math.inf
    _try_angle(pair, 0.0, math.inf, answer)
    certain = answer[FOUND]
    rows[0, MIDDLE], rows[0, HALF], rows[0, BOUND] = 0.0, math.pi, 0.0
    count, k = 1, 0
    while k < count:
        row = rows[k]
        k += 1
        nearest = max(0.0, abs(row[MIDDLE]) - row[HALF])
        row[BOUND] = max(row[BOUND], _turn_norm(gyration, nearest))
        row[SIGMA], row[STATE] = math.nan, PRUNED
        if row[BOUND] < answer[FOUND] - tolerance:
            _look(pair, row, answer[FOUND] * (1.0 + 1e-12), answer)
        if row[BOUND] >= answer[FOUND] - tolerance:
            certain = min(certain, row[BOUND])
            continue
        if row[HALF] < NARROWEST or count + 2 > rows.shape[0]:
            row[STATE] = ENDED
            angle = _parallel_angle(a, b, row[MIDDLE], row[HALF])
            _try_angle(pair, angle, answer[FOUND] * (1.0 + 1e-12), answer)
            certain = min(certain, row[BOUND])
            continue
        row[STATE] = SPLIT
        half = 0.5 * row[HALF]
        inner = -half if row[MIDDLE] > 0.0 else half  # nearer to no turn first
        for side in range(2):
            rows[count, MIDDLE] = row[MIDDLE] + (inner if side == 0 else -inner)
            rows[count, HALF], rows[count, BOUND] = half, row[BOUND]
            count += 1
    answer[FOUND_BOUND] = min(certain, answer[FOUND])
    answer[INTERVALS] = count


@lean_kernel
def sample_depths(pair, angles, depths):
    """The translational depth d (m) and where it leads, for each of angles (n,) rad, into depths (n, 3)."""
    a, b, differences, _, slack = pair
    for k in range(angles.shape[0]):
        build_differences(a, b, angles[k], differences)
        shrink(a, b, 0.0, differences)
        depths[k, 0], depths[k, 1], depths[k, 2] = nearest_free(differences, slack, math.inf)
