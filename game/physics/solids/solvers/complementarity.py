"""Referee: contacts, friction and joints of a substep solved exactly, by pivoting and not by sweeps.

Baraff 1994, "Fast Contact Force Computation for Nonpenetrating Rigid Bodies", section 4: contact as a linear
complementarity problem solved directly. In velocities and impulses, after Stewart and Trinkle 1996 and
Anitescu and Potra 1997, for which Painlevé's sliding rod has a solution too. Friction's pyramid, which in a
plane is the cone itself: a contact has a normal impulse, two of friction, and a speed of sliding. Joints'
equal lines are eliminated first; limits and drives are rows like contacts and friction. Overlap deeper than
the slop parts by a tenth in a substep. Every residual is at rounding's height, whatever the masses.

What it cannot do: its time grows with the cube of the points, so it refuses more than 60 of them. With
redundant contacts the one solution that it finds among many is not the symmetric one, so single forces mean
little.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.physics.kernels import linear
from game.physics.kernels.limits import LimitError
from game.physics.solids.arrays import layout, state
from game.physics.solids.joints.lines import prepare_joints, write_all_lines
from game.physics.solids.joints.sweeps import solve_block
from game.physics.solids.solvers.impacts import ALONE, resolve_impacts
from game.physics.solids.solvers.lemke import solve_complementarity
from game.physics.solids.solvers.motion import accelerate, move
from game.physics.solids.solvers.positions import clear_impulses, note_gaps
from game.physics.solids.solvers.xpbd import clear_joint_impulses

MOST_POINTS = 60
PART = 0.1  # of an overlap beyond the slop, that a substep takes away
LEAST_GIVE = 1e-9


@lean_kernel
def begin(bodies, joints, numbers):
    """Once a step."""
    prepare_joints(bodies, joints, (0.2 / numbers.h, 1.0, 0.0), numbers)


@lean_kernel
def begin_substep(rows, joints, scratch, numbers):
    """Velocities by forces and impacts alone, gaps, lines; a hand pulls before all else."""
    clear_impulses(rows)
    clear_joint_impulses(joints)
    accelerate(scratch, numbers)
    resolve_impacts(rows, scratch, numbers, ALONE)
    note_gaps(rows, scratch.motion, scratch.points)
    write_all_lines(joints, scratch.motion)
    for k in range(joints.kinds.shape[0]):
        if joints.kinds[k] == layout.MOUSE and joints.rows[k, layout.SUBSTEP] > 0.0:
            solve_block(joints, k, scratch.motion, True)


@lean_kernel
def end_substep(scratch, h):
    """Places."""
    move(scratch.motion, h)


class Conditions:
    """Rows of a substep: speeds J v, what is asked of them, and where their impulses go."""

    def __init__(self, bodies: int) -> None:
        self.bodies = bodies
        self.jacobian: list[Floats] = []
        self.wanted: list[float] = []  # J v + wanted >= 0, or = 0
        self.give: list[float] = []
        self.to: list[tuple[Any, tuple[int, int], float]] = []  # array, its element, sign

    def add(
        self, ends: tuple[int, int], u: tuple[float, float], torques: tuple[float, float], wanted: float
    ) -> None:
        """A speed u . (vb - va) + torques[1] wb - torques[0] wa."""
        row = np.zeros(3 * self.bodies)
        a, b = ends
        row[3 * a : 3 * a + 3] -= u[0], u[1], torques[0]
        row[3 * b : 3 * b + 3] += u[0], u[1], torques[1]
        self.jacobian.append(row)
        self.wanted.append(wanted)
        self.give.append(0.0)

    def matrix(self) -> Floats:
        """J (m, 3 n)."""
        return np.array(self.jacobian).reshape(-1, 3 * self.bodies)


def contact_conditions(rows: Any, scratch: Any, numbers: Any) -> tuple[Conditions, Conditions, list[float]]:
    """Normals and tangents of all points, and their friction."""
    n = len(scratch.motion)
    normals, tangents, frictions = Conditions(n), Conditions(n), []
    for c in range(int(rows.count[0])):
        ends = int(rows.ends[c, state.END_A]), int(rows.ends[c, state.END_B])
        row = rows.rows[c]
        nx, ny = float(row[state.ROW_NX]), float(row[state.ROW_NY])
        for k in range(int(rows.ends[c, state.END_POINTS])):
            at, gap = state.ROW_POINT + k * state.ROW_POINT_WIDTH, float(scratch.points[c, k])
            wanted = gap / numbers.h
            if gap < 0.0:
                wanted = max(PART * min(0.0, gap + numbers.slop) / numbers.h, -numbers.push)
            normals.add(ends, (nx, ny), (row[at + state.CROSS_A], row[at + state.CROSS_B]), wanted)
            normals.to.append((rows.rows, (c, at + state.JN), 1.0))
            tangents.add(ends, (ny, -nx), (-row[at + state.DOT_A], -row[at + state.DOT_B]), 0.0)
            tangents.to.append((rows.rows, (c, at + state.JT), 1.0))
            frictions.append(float(row[state.ROW_MU]))
    return normals, tangents, frictions


def joint_conditions(
    joints: Any, bodies: int, h: float
) -> tuple[Conditions, Conditions, Conditions, list[float]]:
    """Equal lines, one-sided ones, drives, and the most impulse of these."""
    equal, limits, drives = Conditions(bodies), Conditions(bodies), Conditions(bodies)
    most = []
    for k in np.flatnonzero((joints.rows[:, layout.SUBSTEP] > 0.0) & (joints.kinds != layout.MOUSE)).tolist():
        ends = int(joints.bodies[k, 0]), int(joints.bodies[k, 1])
        row = joints.rows[k]
        for slot in range(layout.IMPULSES):
            line = joints.lines[k, slot * layout.LINE_WIDTH : (slot + 1) * layout.LINE_WIDTH]
            if line[layout.LINE] == layout.OFF:
                continue
            u, torques = (line[layout.UX], line[layout.UY]), (line[layout.LA], line[layout.LB])
            kind, to = line[layout.LINE], (joints.impulses, (k, slot), 1.0)
            bound = h * float(joints.parameters[k, layout.MOST])
            if kind == layout.ONE_SIDED:
                gap = float(line[layout.LINE_GAP])
                limits.add(ends, u, torques, gap / h if gap > 0.0 else PART * gap / h)
                limits.to.append(to)
            elif kind == layout.EQUAL or (kind == layout.DRIVING and not np.isfinite(bound)):
                equal.add(
                    ends,
                    u,
                    torques,
                    row[layout.RATE] * line[layout.LINE_GAP]
                    if kind == layout.EQUAL
                    else -float(joints.parameters[k, layout.SPEED]),
                )
                weight = (u[0] * u[0] + u[1] * u[1]) * (row[layout.JIMA] + row[layout.JIMB])
                weight += row[layout.JIIA] * (torques[0] * torques[0]) + row[layout.JIIB] * (
                    torques[1] * torques[1]
                )
                equal.give[-1] = weight * (
                    LEAST_GIVE + (row[layout.GIVE] / row[layout.MASS] if slot != layout.DRIVE else 0.0)
                )
                equal.to.append(to)
            else:
                drives.add(ends, u, torques, -float(joints.parameters[k, layout.SPEED]))
                drives.to.append(to)
                most.append(bound)
    return equal, limits, drives, most


def complementarity_problem(
    inverse: Floats, free: Floats, groups: tuple[Conditions, ...], frictions: list[float], most: list[float]
) -> tuple[Floats, Floats, Floats]:
    """A, q of the problem and J of its impulses: normals, limits; tangents and drives, both ways; sliding."""
    normals, tangents, limits, drives = groups
    pushes = np.concatenate([normals.matrix(), limits.matrix()])
    drags = np.concatenate([tangents.matrix(), drives.matrix()])
    p, d = len(pushes), len(drags)
    j = np.concatenate([pushes, drags, -drags])
    a, q = np.zeros((p + 3 * d, p + 3 * d)), np.zeros(p + 3 * d)
    a[: p + 2 * d, : p + 2 * d] = linear.product(linear.product(j, inverse), j.T)
    slide_wanted = np.array(tangents.wanted + drives.wanted)
    wanted = np.concatenate([normals.wanted, limits.wanted, slide_wanted, -slide_wanted])
    q[: p + 2 * d] = linear.product(j, free) + wanted
    for i in range(d):
        slack = p + 2 * d + i
        a[p + i, slack] = a[p + d + i, slack] = 1.0
        a[slack, p + i] = a[slack, p + d + i] = -1.0
        if i < len(frictions):
            a[slack, i] = frictions[i]
        else:
            q[slack] = most[i - len(frictions)]
    return a, q, j


def solve_substep(bodies: Any, rows: Any, joints: Any, scratch: Any, numbers: Any) -> None:
    """Velocities and impulses of one substep. ArithmeticError if pivots find none."""
    motion = scratch.motion
    n = len(motion)
    inverse = np.repeat(bodies.inverse_masses, 3)
    inverse[2::3] = bodies.inverse_inertias
    normals, tangents, frictions = contact_conditions(rows, scratch, numbers)
    equal, limits, drives, most = joint_conditions(joints, n, numbers.h)
    m = np.diag(inverse)
    free = motion[:, state.VX : state.W + 1].ravel().copy()
    e = equal.matrix()
    if len(e):  # equal lines are always kept: what is left moves within them
        hold = linear.solve(
            linear.product(linear.product(e, m), e.T) + np.diag(equal.give),
            np.concatenate(
                [(linear.product(e, m)), (linear.product(e, free) + equal.wanted)[:, None]], axis=1
            ),
        )
        along, across = hold[:, :-1], hold[:, -1]
        free = free - linear.product(linear.product(m, e.T), across)
        m = m - linear.product(linear.product(m, e.T), along)
    a, q, j = complementarity_problem(m, free, (normals, tangents, limits, drives), frictions, most)
    size = np.ones(len(q))
    size[: len(j)] = 1.0 / np.sqrt(np.maximum(np.diag(a)[: len(j)], 1e-300))
    size[len(j) :] = 1.0 / np.maximum(size[len(j) - len(size[len(j) :]) : len(j)], 1e-300) if len(j) else 1.0
    scaled = size[:, None] * a * size
    scaled_q = size * q
    largest = float(np.abs(scaled_q[: len(j)]).max(initial=0.0)) or 1.0
    z = solve_complementarity(scaled, scaled_q / largest)
    if z is None:
        raise ArithmeticError("complementarity: no solution was found by pivots")
    z = largest * size * z
    impulses = z[: len(j)]
    after = free + linear.product(linear.product(m, j.T), impulses)
    p, d = len(normals.to) + len(limits.to), len(tangents.to) + len(drives.to)
    give_back(normals.to + limits.to, impulses[:p])
    give_back(tangents.to + drives.to, impulses[p : p + d] - impulses[p + d : p + 2 * d])
    if len(e):
        give_back(equal.to, -(across + linear.product(linear.product(along, j.T), impulses)))
    motion[:, state.VX : state.W + 1] = after.reshape(n, 3)


def give_back(to: list[tuple[Any, tuple[int, int], float]], impulses: Floats) -> None:
    """Impulses to where they belong."""
    for (array, place, sign), impulse in zip(to, impulses.tolist(), strict=True):
        array[place] = sign * impulse


def solve_by_complementarity(
    bodies: Any, contacts: Any, rows: Any, joints: Any, scratch: Any, numbers: Any
) -> None:
    """All substeps of one step. See the package. LimitError for more than MOST_POINTS contact points."""
    count = int(rows.count[0])
    points = int(rows.ends[:count, state.END_POINTS].sum())
    if points > MOST_POINTS:
        raise LimitError(f"contact points = {points}: the complementarity solver takes at most {MOST_POINTS}")
    begin(bodies, joints, numbers)
    for _ in range(numbers.substeps):
        begin_substep(rows, joints, scratch, numbers)
        solve_substep(bodies, rows, joints, scratch, numbers)
        for k in range(2):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH + state.JN
            held = rows.ends[:count, state.END_POINTS] > k
            np.maximum(
                rows.rare[:count, state.MOST_0 + k],
                np.where(held, rows.rows[:count, at], 0.0),
                out=rows.rare[:count, state.MOST_0 + k],
            )
        end_substep(scratch, numbers.h)
