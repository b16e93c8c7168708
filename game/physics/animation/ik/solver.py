"""The loop that all methods of inverse kinematics share: when to stop, and what to do at a dead point.

It ends when the error is within the tolerance, or when the iterations are spent. It also ends when the best
error has not become smaller by PROGRESS of the tolerance for WINDOW iterations. That is a target out of
reach, or so far that 1/k of progress is no progress.

A straight chain with its target on its axis is a dead point: Jᵀe = 0 though the target can be reached, and
every gradient method stands still. There, one joint is kicked by a fixed angle; if that leads nowhere, the
best pose so far is taken again. A target far out of reach is aimed at on its line from the root, a quarter
beyond the reach. That has the same best pose and keeps every step moderate (Buss 2009, clamped targets).

Arrays as in `ik_chain`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.animation.ik import chain
from game.physics.animation.ik.armijo import relax_by_armijo
from game.physics.animation.ik.buss import relax_by_buss
from game.physics.animation.ik.ccd import relax_by_cycle
from game.physics.animation.ik.chain import copy_row, error_of, place_points, pull_joints, squared_reach
from game.physics.animation.ik.damped import relax_adaptively, relax_damped
from game.physics.animation.ik.fabrik import relax_by_reaching
from game.physics.animation.ik.gradient import relax_by_gradient

METHODS = ("gradient", "buss", "armijo", "damped", "ccd", "fabrik", "damped-fixed")
GRADIENT, BUSS, ARMIJO, DAMPED, CCD, FABRIK, DAMPED_FIXED = range(7)
ENDINGS = ("reached", "no progress", "spent")
REACHED, NO_PROGRESS, SPENT = range(3)

WINDOW = 32  # iterations without progress
PROGRESS = 1e-3  # of the tolerance
DEAD = 1e-12  # |Jᵀe| / (|e| Σ l) of a dead point
KICK = 0.2  # rad, to one side, then to the other, then farther
MOST_KICKS = 3
BEYOND = 1.25  # of the reach: where a target farther off is aimed at


@kernel(inline="always")
def relax(method, base, links, aim, points, numbers):
    """One iteration of a method; gives how often the chain was placed, negative if it stayed as it was."""
    if method == GRADIENT:
        return relax_by_gradient(base, links, aim, points, numbers)
    if method == BUSS:
        return relax_by_buss(base, links, aim, points, numbers)
    if method == ARMIJO:
        return relax_by_armijo(base, links, aim, points, numbers)
    if method == DAMPED:
        return relax_adaptively(base, links, aim, points, numbers)
    if method == CCD:
        return relax_by_cycle(base, links, aim, points, numbers)
    if method == FABRIK:
        return relax_by_reaching(base, links, aim, points, numbers)
    return relax_damped(base, links, aim, points, numbers)


@kernel(inline="always")
def kick_joint(links, kicks):
    """Turn one joint, the middle one if that moves the end, by a fixed angle, away from a limit it is at."""
    n = links.shape[1]
    chosen = n // 2
    while chosen > 0 and _stands(links, chosen):
        chosen -= 1
    turn = KICK * (kicks + 1) if kicks % 2 == 0 else -KICK * kicks
    angle = links[chain.ANGLE, chosen]
    if angle + turn > links[chain.UPPER, chosen] or angle + turn < links[chain.LOWER, chosen]:
        turn = -turn
    links[chain.ANGLE, chosen] = min(
        max(angle + turn, links[chain.LOWER, chosen]), links[chain.UPPER, chosen]
    )


@kernel(inline="always")
def _stands(links, i):
    """Does turning a joint change nothing: fixed by its limits, or its link without length?"""
    return links[chain.LENGTH, i] == 0.0 or links[chain.LOWER, i] == links[chain.UPPER, i]


@kernel(inline="always")
def aim_at(base, links, target, aim):
    """Write where to aim, and give reach (m) and the least error (m) that there can be without limits."""
    total, longest = 0.0, 0.0
    for i in range(links.shape[1]):
        total += links[chain.LENGTH, i]
        longest = max(longest, links[chain.LENGTH, i])
    dx, dy = target[0] - base[0], target[1] - base[1]
    distance = math.sqrt(dx * dx + dy * dy)
    share = BEYOND * total / distance if distance > BEYOND * total else 1.0
    aim[0], aim[1] = base[0] + share * dx, base[1] + share * dy
    return total, max(0.0, distance - total, 2.0 * longest - total - distance)


@kernel(_nrt=False)
def solve_links(method, base, links, start, targets, points, numbers, history, found):
    """Move a chain's end to targets (m, 2), each from the angles (and to those) in ``start`` (m, n).

    Of numbers, KEEP_BEST is 1.0 to keep the best pose on the way, not the last one. That is done anyway after
    a kick that has led nowhere, but not if it ends soon after one. history (h,): the errors before each
    iteration of the last target, as far as it has space. found (m, 4): error, iterations, placings, ending.
    """
    tolerance, most, keep_best = (
        numbers[chain.TOLERANCE],
        int(numbers[chain.ITERATIONS]),
        numbers[chain.KEEP_BEST] > 0.0,
    )
    aim = numbers[chain.AIM_X : chain.AIM_Y + 1]
    for task in range(targets.shape[0]):
        target = targets[task]
        for i in range(links.shape[1]):
            links[chain.ANGLE, i] = start[task, i]
        reach, least = aim_at(base, links, target, aim)
        goal = target if method in (DAMPED_FIXED, FABRIK) else aim
        numbers[chain.REACH_SQUARE], numbers[chain.MEMORY] = squared_reach(links), 0.0
        place_points(base, links, chain.ANGLE, points)
        best, mark, mark_best, kicks, placings, ending, k = math.inf, 0, math.inf, 0, 1, SPENT, 0
        kicked, stuck = -WINDOW, False
        while True:
            error = error_of(points, target)
            if k < history.shape[0]:
                history[k] = error
            if error < best:
                best = error
                copy_row(links, chain.ANGLE, chain.BEST)
            if error <= tolerance:
                ending = REACHED
                break
            if k >= most:
                break
            still = stuck
            if k - mark >= WINDOW:
                still = still or mark_best - best <= PROGRESS * tolerance
                mark, mark_best = k, best
            dead = pull_joints(points, goal, links) <= DEAD * error_of(points, goal) * reach
            if not (dead or still):
                k += 1
                taken = relax(method, base, links, goal, points, numbers)
                placings, stuck = placings + abs(taken), taken < 0
                continue
            if best <= least + tolerance or kicks == MOST_KICKS:
                ending = NO_PROGRESS
                break
            if kicks > 0:
                copy_row(links, chain.BEST, chain.ANGLE)
            if dead:
                kicked = k
            kick_joint(links, kicks)
            place_points(base, links, chain.ANGLE, points)
            k, stuck = k + 1, False
            kicks, placings, mark, mark_best, numbers[chain.MEMORY] = kicks + 1, placings + 1, k, best, 0.0
        begun = ending == SPENT and k - kicked < WINDOW  # a kick that the next call may go on from
        if (keep_best or kicks > 0) and best < error and not begun:
            copy_row(links, chain.BEST, chain.ANGLE)
            place_points(base, links, chain.ANGLE, points)
            error = best
        found[task, 0], found[task, 1], found[task, 2], found[task, 3] = error, k, placings, ending
        for i in range(links.shape[1]):
            start[task, i] = links[chain.ANGLE, i]
