"""Geometry of a pot: the window that a pocket leaves to a ball, free lanes, and the chance of a hit.

A ball goes down cleanly if its centre passes between its pocket's jaws, each grown by the ball's radius. Seen
from the ball that is a window of angles. A ball may also brush a jaw, the far one deeper than the near one,
and into a corner it may come along the rail. How much that widens the window was measured with exact balls
(see tests). A hand's unsteadiness turns the path of the object ball by about sigma d/(2 R cos cut). Here d is
the length of the cue ball's path (Leckie and Greenspan 2006, Monte-Carlo methods in pool strategy game trees.
Also Smith 2007, PickPocket: a computer billiards shark). The chance of a pot is the share of a normal
distribution in the window.

These are estimates for choosing what to play; what is chosen is played exactly.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.laws.lean import inner_kernel
from game.billiards.table.table import Table
from game.physics.kernels import elementary, linear

# columns of gates (p, 11): the pocket, its radius of capture, its jaws (x, y m) and their radius (0: none);
# the direction into it (unit vector), and 1 for a corner, 0 for a side pocket
GATE_X, GATE_Y, GATE_RADIUS, LEFT_X, LEFT_Y, RIGHT_X, RIGHT_Y, JAW_RADIUS, AXIS_X, AXIS_Y, CORNER = range(11)
GATE_COLUMNS = 11

# how far beyond a clean entry a ball may come to the far and the near jaw and fall all the same, m, and how
# that changes with the angle between its path and that direction, m/rad; along a rail from RAIL_FROM rad on
CORNER_FAR, CORNER_FAR_SLOPE = 0.009, 0.017
CORNER_NEAR, CORNER_NEAR_SLOPE = 0.009, -0.012
RAIL_FROM, RAIL_SLOPE = 0.40, 0.34
SIDE_FAR, SIDE_FAR_SLOPE = 0.013, 0.022
SIDE_NEAR, SIDE_NEAR_SLOPE = 0.013, -0.013
WIDEST = 1.5  # rad; of a window to each side

CLEARANCE = 0.001  # m; lanes are wider than the balls by this
LEAST_COSINE = 0.2  # of the cut; thinner cuts are not played
SIGHT = 0.0025  # rad; unsteadiness of the cue ball's direction: azimuth, and squirt of an unsteady tip
RUB = 0.004  # rad; unsteadiness of the object ball's direction whatever the distance: throw
NEAR = 0.45  # m; how near the cue ball is taken to be to a ball that is played later
SLACK = 0.5 * 0.0572 * 0.9  # m; 2 R cos cut over two for it


class Geometry(NamedTuple):
    """What geometry needs of a table besides the places of the balls.

    radii (n,) m of the balls; gates (p, 11): see above; bed (4,) m: left, right, lower, upper of the straight
    rails; cue: row of the cue ball; sight: unsteadiness of its direction, rad.
    """

    radii: Floats
    gates: Floats
    bed: Floats
    cue: int
    sight: float


def gates_of(table: Table) -> Floats:
    """Pockets with their jaws (p, 11), in the table's frame. Left and right as seen from the bed."""
    gates = np.zeros((len(table.pockets), GATE_COLUMNS))
    middle = np.array([0.5 * table.width, 0.5 * table.length])
    for k, (x, y, radius) in enumerate(table.pockets.tolist()):
        gates[k, :3] = x, y, radius
        if len(table.jaws) < 2:
            continue
        away = np.sqrt((elementary.square(table.jaws[:, :2] - (x, y))).sum(axis=1))
        a, b = np.argsort(away, kind="stable")[:2]
        if away[b] > 4.0 * radius:
            continue
        inward = middle - (x, y)
        side = (table.jaws[a, 0] - x) * inward[1] - (table.jaws[a, 1] - y) * inward[0]
        left, right = (a, b) if side > 0.0 else (b, a)
        gates[k, LEFT_X : LEFT_Y + 1] = table.jaws[left, :2]
        gates[k, RIGHT_X : RIGHT_Y + 1] = table.jaws[right, :2]
        gates[k, JAW_RADIUS] = table.jaws[left, 2]
        across = table.jaws[left, :2] - table.jaws[right, :2]
        axis = np.array([across[1], -across[0]]) / np.sqrt(linear.product(across, across))
        gates[k, AXIS_X : AXIS_Y + 1] = axis
        gates[k, CORNER] = float(abs(axis[0] * axis[1]) > 0.1)
    return gates


@inner_kernel
def _widening(gates, p, dx, dy):
    """By how much the far and the near jaw yield to a ball that comes along (dx, dy), m."""
    along = dx * gates[p, AXIS_X] + dy * gates[p, AXIS_Y]
    off = abs(elementary.atan2(dx * gates[p, AXIS_Y] - dy * gates[p, AXIS_X], along))
    if gates[p, CORNER] == 0.0:
        return SIDE_FAR + SIDE_FAR_SLOPE * off, max(SIDE_NEAR + SIDE_NEAR_SLOPE * off, 0.0)
    near = max(CORNER_NEAR + CORNER_NEAR_SLOPE * off, 0.0) + RAIL_SLOPE * max(off - RAIL_FROM, 0.0)
    return CORNER_FAR + CORNER_FAR_SLOPE * off, near


@inner_kernel
def pocket_window(gates, p, x, y, radius):
    """Direction (rad) of the middle of pocket p's window for a ball at (x, y) m, and half its width (rad).

    Not above 0: the pocket cannot be reached. The direction is that of the pocket's middle then.
    """
    dx = gates[p, GATE_X] - x
    dy = gates[p, GATE_Y] - y
    away = math.sqrt(dx * dx + dy * dy)
    towards = elementary.atan2(dy, dx)
    if away <= gates[p, GATE_RADIUS]:
        return towards, 1.0
    if gates[p, JAW_RADIUS] == 0.0:
        return towards, elementary.asin(gates[p, GATE_RADIUS] / away)
    reach = gates[p, JAW_RADIUS] + radius
    far_yields, near_yields = _widening(gates, p, dx, dy)
    low = -WIDEST
    high = WIDEST
    nearest = 0.0
    for side in range(2):
        jaw_x = gates[p, LEFT_X + 2 * side] - x
        jaw_y = gates[p, LEFT_Y + 2 * side] - y
        far = math.sqrt(jaw_x * jaw_x + jaw_y * jaw_y)
        if far <= reach:
            continue
        # angle from the pocket's middle to the jaw, without a branch cut
        turn = elementary.atan2(dx * jaw_y - dy * jaw_x, dx * jaw_x + dy * jaw_y)
        if side == 0:
            nearest = far
            high = turn - elementary.asin(reach / far)
        else:
            nearest = nearest - far
            low = turn + elementary.asin(reach / far)
    left_yields = near_yields if nearest < 0.0 else far_yields
    right_yields = far_yields if nearest < 0.0 else near_yields
    high = min(high + left_yields / away, WIDEST)
    low = max(low - right_yields / away, -WIDEST)
    return towards + 0.5 * (low + high), 0.5 * (high - low)


@inner_kernel
def lane_is_free(places, radii, from_x, from_y, to_x, to_y, radius, skip, skip_too):
    """True if a ball of this radius can go straight from one point to another, all m, and touch no ball.

    places (n, 2) m, radii (n,) m. Balls `skip` and `skip_too` are not looked at.
    """
    dx = to_x - from_x
    dy = to_y - from_y
    square = dx * dx + dy * dy
    for k in range(places.shape[0]):
        if k in (skip, skip_too):
            continue
        x = places[k, 0] - from_x
        y = places[k, 1] - from_y
        reach = radius + radii[k] + CLEARANCE
        along = x * dx + y * dy
        if along <= 0.0:
            # behind the start: in the way only if it is touched there already, and the lane leads into it
            continue
        if along >= square:
            x -= dx
            y -= dy
            if x * x + y * y < reach * reach:
                return False
            continue
        across = x * dy - y * dx
        if across * across < reach * reach * square:
            return False
    return True


@inner_kernel(inline="always")
def chance_within(half, sigma):
    """Share of a normal distribution within +-half."""
    return elementary.erf(half / (1.4142135623730951 * sigma))


@inner_kernel
def pot_chance(places, geometry, ball, p):
    """Chance that the cue ball pots `ball` directly into pocket p; 0 if it cannot. places (n, 2) m."""
    radii, gates, bed, cue, sight = geometry
    x = places[ball, 0]
    y = places[ball, 1]
    direction, half = pocket_window(gates, p, x, y, radii[ball])
    if half <= 0.0:
        return 0.0
    reach = 2.0 * math.sqrt(radii[cue] * radii[ball])
    ux = elementary.cos(direction)
    uy = elementary.sin(direction)
    ghost_x = x - reach * ux
    ghost_y = y - reach * uy
    margin = radii[cue] - 0.002
    if not (bed[0] + margin <= ghost_x <= bed[1] - margin and bed[2] + margin <= ghost_y <= bed[3] - margin):
        return 0.0
    dx = ghost_x - places[cue, 0]
    dy = ghost_y - places[cue, 1]
    distance = math.sqrt(dx * dx + dy * dy)
    cosine = 1.0 if distance < 1e-9 else (dx * ux + dy * uy) / distance
    if cosine < LEAST_COSINE:
        return 0.0
    if not lane_is_free(places, radii, x, y, gates[p, GATE_X], gates[p, GATE_Y], radii[ball], ball, cue):
        return 0.0
    if not lane_is_free(
        places, radii, places[cue, 0], places[cue, 1], ghost_x, ghost_y, radii[cue], cue, ball
    ):
        return 0.0
    sigma = sight * (distance / (reach * cosine) + 1.0) + RUB
    return chance_within(half, sigma)


@inner_kernel
def openness(places, geometry, ball):
    """Chance that a ball can be potted later on, once the cue ball lies well for it. places (n, 2) m."""
    radii, gates, _, cue, sight = geometry
    best = 0.0
    second = 0.0
    for p in range(gates.shape[0]):
        _, half = pocket_window(gates, p, places[ball, 0], places[ball, 1], radii[ball])
        if half <= 0.0:
            continue
        sigma = sight * (NEAR / (2.0 * SLACK) + 1.0) + RUB
        chance = chance_within(half, sigma)
        if chance <= second:
            continue
        if not lane_is_free(
            places, radii, places[ball, 0], places[ball, 1], gates[p, GATE_X], gates[p, GATE_Y],
            radii[ball], ball, cue,
        ):  # fmt: skip
            continue
        if chance > best:
            second = best
            best = chance
        else:
            second = chance
    return best + 0.3 * second * (1.0 - best)
