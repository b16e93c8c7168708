"""All joints at once: the exact impulses of one substep, by block elimination along the order of `plan`.

Unknowns are the impulses of all EQUAL lines (and of ropes that are taut): S j = r with S = J M⁻¹ Jᵀ +
compliance, symmetric positive definite, blocks of 3 x 3 (Baraff 1996, "Linear-time dynamics using Lagrange
multipliers"). Time grows with the number of joints, whatever their masses; sweeps need as many of them as a
chain is long, squared. Limits, drives and mice are swept before it. A millionth of a part of compliance is
left in S. So redundant joints (two welds on one pair, a loop that closes) share their load instead of
dividing by zero.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import layout
from game.physics.solids.joints.lines import line_speed, push_line, write_all_lines
from game.physics.solids.joints.sweeps import (
    line_coupling,
    solve_block,
    sweep_bounded,
    sweep_joints,
)

LEAST_GIVE = 1e-9  # of a line's own entry of S


@inner_kernel
def choose_lines(joints, plan, motion):
    """Which lines take part: those that are EQUAL, and the one of a rope that is taut or is about to be."""
    for p in range(plan.order.shape[0]):
        k = plan.order[p]
        for n in range(3):
            on = (
                joints.rows[k, layout.SUBSTEP] > 0.0
                and joints.lines[k, n * layout.LINE_WIDTH + layout.LINE] == layout.EQUAL
            )
            plan.slots[p, n] = n if on else -1
        at = layout.HIGH * layout.LINE_WIDTH
        alone = joints.lines[k, layout.LINE] == layout.OFF and joints.lines[k, at + layout.LINE] != layout.OFF
        if alone and joints.rows[k, layout.SUBSTEP] > 0.0:
            closing = joints.lines[k, at + layout.LINE_GAP] + joints.rows[k, layout.SUBSTEP] * line_speed(
                joints, k, at, motion
            )
            if joints.impulses[k, layout.HIGH] > 0.0 or closing < 0.0:
                plan.slots[p, 0] = layout.HIGH


@inner_kernel
def fill_diagonal(joints, plan, motion, pushing):
    """Diagonal blocks and right sides."""
    row = joints.rows
    for p in range(plan.order.shape[0]):
        k = plan.order[p]
        soft, rate = LEAST_GIVE, 0.0
        if (pushing or row[k, layout.OWN] > 0.0) and row[k, layout.SUBSTEP] > 0.0:
            soft, rate = LEAST_GIVE + row[k, layout.GIVE] / row[k, layout.MASS], row[k, layout.RATE]
        for n in range(3):
            plan.right[p, n] = 0.0
            for m in range(3):
                plan.diagonal[p, 3 * n + m] = 1.0 if n == m else 0.0
        for n in range(3):
            slot = plan.slots[p, n]
            if slot < 0:
                continue
            at, right = slot * layout.LINE_WIDTH, 0.0
            for m in range(3):
                if plan.slots[p, m] >= 0:
                    coupling = line_coupling(joints, k, at, plan.slots[p, m] * layout.LINE_WIDTH)
                    if m == n:
                        plan.diagonal[p, 4 * n] = (1.0 + soft) * coupling
                    else:
                        plan.diagonal[p, 3 * n + m] = coupling
            gap = joints.lines[k, at + layout.LINE_GAP]
            right = gap / row[k, layout.SUBSTEP] if slot == layout.HIGH and gap > 0.0 else rate * gap
            own = plan.diagonal[p, 4 * n] - plan.diagonal[p, 4 * n] / (1.0 + soft)
            if rate > 0.0 and row[k, layout.GIVE] > 0.0:
                right += own * joints.impulses[k, slot]
            plan.right[p, n] = -right - line_speed(joints, k, at, motion)


@inner_kernel
def fill_links(joints, plan):
    """Blocks of joints that share a body."""
    line, row = joints.lines, joints.rows
    for e in range(plan.blocks.shape[0]):
        for n in range(9):
            plan.blocks[e, n] = 0.0
    for link in range(plan.links.shape[0]):
        e, high, low, body = (
            plan.links[link, 0],
            plan.links[link, 1],
            plan.links[link, 2],
            plan.links[link, 3],
        )
        k, q = plan.order[high], plan.order[low]
        if row[k, layout.SUBSTEP] < 0.0 or row[q, layout.SUBSTEP] < 0.0:
            continue
        k_is_b, q_is_b = joints.bodies[k, 1] == body, joints.bodies[q, 1] == body
        sign = 1.0 if k_is_b == q_is_b else -1.0
        im, ii = (
            (row[k, layout.JIMB], row[k, layout.JIIB])
            if k_is_b
            else (row[k, layout.JIMA], row[k, layout.JIIA])
        )
        turn_k, turn_q = layout.LB if k_is_b else layout.LA, layout.LB if q_is_b else layout.LA
        for n in range(3):
            for m in range(3):
                i, j = plan.slots[high, n], plan.slots[low, m]
                if i < 0 or j < 0:
                    continue
                i, j = i * layout.LINE_WIDTH, j * layout.LINE_WIDTH
                along = (
                    line[k, i + layout.UX] * line[q, j + layout.UX]
                    + line[k, i + layout.UY] * line[q, j + layout.UY]
                )
                plan.blocks[e, 3 * n + m] += sign * (
                    im * along + ii * line[k, i + turn_k] * line[q, j + turn_q]
                )


@inner_kernel
def invert_three(d, p):
    """Replace the symmetric block p by its inverse."""
    a, b, c = d[p, 0], d[p, 1], d[p, 2]
    e, f, i = d[p, 4], d[p, 5], d[p, 8]
    x, y, z = e * i - f * f, c * f - b * i, b * f - c * e
    over = 1.0 / (a * x + b * y + c * z)
    d[p, 0], d[p, 1], d[p, 2] = x * over, y * over, z * over
    d[p, 3], d[p, 6] = y * over, z * over
    d[p, 4], d[p, 8] = (a * i - c * c) * over, (a * e - b * b) * over
    d[p, 5] = (b * c - a * f) * over
    d[p, 7] = d[p, 5]


@inner_kernel
def eliminate(plan):
    """Forward: blocks that remain, and right sides; then back: right becomes the impulses."""
    d, blocks, right, starts, below = plan.diagonal, plan.blocks, plan.right, plan.starts, plan.below
    update = 0
    for p in range(plan.order.shape[0]):
        invert_three(d, p)
        for e in range(starts[p], starts[p + 1]):
            i = below[e]
            for n in range(3):
                g0 = (
                    blocks[e, 3 * n] * d[p, 0]
                    + blocks[e, 3 * n + 1] * d[p, 3]
                    + blocks[e, 3 * n + 2] * d[p, 6]
                )
                g1 = (
                    blocks[e, 3 * n] * d[p, 1]
                    + blocks[e, 3 * n + 1] * d[p, 4]
                    + blocks[e, 3 * n + 2] * d[p, 7]
                )
                g2 = (
                    blocks[e, 3 * n] * d[p, 2]
                    + blocks[e, 3 * n + 1] * d[p, 5]
                    + blocks[e, 3 * n + 2] * d[p, 8]
                )
                right[i, n] -= g0 * right[p, 0] + g1 * right[p, 1] + g2 * right[p, 2]
                for other in range(starts[p], e + 1):
                    target = plan.targets[update + other - starts[p]]
                    for m in range(3):
                        product = g0 * blocks[other, 3 * m] + g1 * blocks[other, 3 * m + 1]
                        product += g2 * blocks[other, 3 * m + 2]
                        if target < 0:
                            d[-1 - target, 3 * n + m] -= product
                        else:
                            blocks[target, 3 * n + m] -= product
            update += e + 1 - starts[p]
    for p in range(plan.order.shape[0] - 1, -1, -1):
        y0, y1, y2 = right[p, 0], right[p, 1], right[p, 2]
        for e in range(starts[p], starts[p + 1]):
            i = below[e]
            y0 -= blocks[e, 0] * right[i, 0] + blocks[e, 3] * right[i, 1] + blocks[e, 6] * right[i, 2]
            y1 -= blocks[e, 1] * right[i, 0] + blocks[e, 4] * right[i, 1] + blocks[e, 7] * right[i, 2]
            y2 -= blocks[e, 2] * right[i, 0] + blocks[e, 5] * right[i, 1] + blocks[e, 8] * right[i, 2]
        for n in range(3):
            right[p, n] = d[p, 3 * n] * y0 + d[p, 3 * n + 1] * y1 + d[p, 3 * n + 2] * y2


@inner_kernel
def push_solution(joints, plan, motion):
    """Apply the impulses; a rope does not push."""
    for p in range(plan.order.shape[0]):
        k = plan.order[p]
        for n in range(3):
            slot = plan.slots[p, n]
            if slot < 0:
                continue
            j = plan.right[p, n]
            if slot == layout.HIGH:
                j = max(j, -joints.impulses[k, slot])
            joints.impulses[k, slot] += j
            push_line(joints, k, slot * layout.LINE_WIDTH, motion, j)


@inner_kernel
def solve_joints(joints, plan, motion, pushing):
    """One pass over all joints: limits, drives and mice swept, the rest at once; all swept without a plan."""
    if plan.order.shape[0] == 0:
        sweep_joints(joints, motion, pushing)
    else:
        write_all_lines(joints, motion)
        sweep_bounded(joints, motion, pushing)
        for k in range(joints.kinds.shape[0]):
            if joints.kinds[k] == layout.MOUSE and joints.rows[k, layout.SUBSTEP] > 0.0:
                solve_block(joints, k, motion, pushing)
        choose_lines(joints, plan, motion)
        fill_diagonal(joints, plan, motion, pushing)
        fill_links(joints, plan)
        eliminate(plan)
        push_solution(joints, plan, motion)
