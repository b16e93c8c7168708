"""Solvers: each a file, all on one set of contacts and joints, chosen live by name from SOLVERS.

The protocol. A solver is one ``lean_kernel`` ``solve(bodies, rows, joints, scratch, numbers)``, called once a
step. It runs all ``numbers.substeps`` of ``numbers.h`` s. To add one: a file with that kernel, a line below.

Prepared before the call (`stepping.begin_step`):

- ``scratch.motion`` (n, MOTION_WIDTH): velocities VX, VY, W; what each body has moved since the step began,
  DX, DY, and turned, DA with cosine DC and sine DS: 0, 0, 0, 1, 0. Bodies that are fixed or asleep have no
  velocity; key-framed ones keep theirs. ``scratch.accelerations`` (n, 3), ``scratch.air`` (n, 3): see
  `motion.accelerate`, which a substep calls first; `motion.move` advances the places.
- ``rows``: ``count[0]`` contacts. ``ends[c]``: body a, body b, points (1 or 2), pair. ``rows[c]``: normal
from a
  to b, friction, whether one end cannot move, inverse masses and inertias (0 for what is not dynamic: write
  velocities of both ends without asking), roundings ROUND_A/B, COUPLING of both points; from ROW_POINT on,
  ROW_POINT_WIDTH each, the points: for levers r from both centres CROSS_A/B = r x n and DOT_A/B = r . n,
  SEP the gap
  when the step began, 1/effective mass STIFF_N along n, effective mass MASS_T along t, and the impulses
  JN, JT of the last substep of the last
  step (warm start; 0 for a new contact). The tangent is t = (ny, -nx), so r = DOT n + CROSS t and r x t =
  -DOT. The gap now is `impulses.gap_now`: rounding does not turn with a body, so discs roll without bumps.
- ``rare[c]``: RESTITUTION, speeds APPROACH_0/1 of the gap before the step (negative: closing), MOST_0/1 = 0.
- ``joints``: see `joints.layout`. Kinds without rows of their own for a solver are swept by
  `joints.sweeps`: `prepare_joints` once, then `start_joints_warm` and `sweep_joints` in each substep.

Expected after it: final velocities and places in ``scratch.motion``; JN, JT: impulses (N s) of the last
substep,
which come back as warm start (a solver that needs forces divides by h); MOST_0/1: the largest normal impulse
of any substep (it makes events, and says that a point touched); joint impulses in ``joints.impulses``.
Key-framed bodies must end with the velocity that they began with. Bounces: `impulses.bounce_contacts`.
``bodies`` is read only: places of the beginning, ``inverse_masses``, ``flags``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from game.physics.solids.solvers.sequential_impulses import solve_sequential_impulses
from game.physics.solids.solvers.soft_step import solve_soft_step

SOLVERS: dict[str, Callable[..., Any]] = {
    "soft-step": solve_soft_step,
    "sequential-impulses": solve_sequential_impulses,
}
