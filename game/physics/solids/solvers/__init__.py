"""Solvers: each a file, all on one set of contacts and joints, chosen live by name from SOLVERS.

The protocol. A solver is one ``lean_kernel`` ``solve(bodies, contacts, rows, joints, scratch, numbers)``,
called once a step. It runs all ``numbers.substeps`` of ``numbers.h`` s. To add one: a file with that
kernel, a line below.

Prepared before the call (`stepping.begin_step`, `stepping.fill_rows`):

- ``scratch.motion`` (n, MOTION_WIDTH): velocities VX, VY, W; what each body has moved since the step began,
  DX, DY, and turned, DA with cosine DC and sine DS: 0, 0, 0, 1, 0. Bodies that are fixed or asleep have no
  velocity; key-framed ones keep theirs. ``scratch.accelerations`` (n, 3), ``scratch.air`` (n, 3): see
  `motion.accelerate`, which a substep calls first; `motion.move` advances the places.
- ``rows``: ``count[0]`` contacts. ``ends[c]``: body a, body b, points (1 or 2), pair. ``rows[c]``: normal
  from a to b, friction, whether one end cannot move, inverse masses and inertias (0 for what is not
  dynamic: write velocities of both ends without asking), roundings ROUND_A/B, COUPLING of both points; from
  ROW_POINT on, ROW_POINT_WIDTH each, the points: for levers r from both centres CROSS_A/B = r x n and
  DOT_A/B = r . n, SEP the gap when the step began, STIFF_N one over the effective mass along n, MASS_T
  that along t, and the impulses JN, JT of the last substep of the last step (warm start; 0 for a new
  contact). The tangent is t = (ny, -nx), so r = DOT n + CROSS t and r x t = -DOT. The gap now is
  `impulses.gap_now`: rounding does not turn with a body, so discs roll without bumps.
- ``rare[c]``: RESTITUTION, speeds APPROACH_0/1 of the gap before the step (negative: closing), MOST_0/1 =
  0.
- ``joints``: see `joints.layout`: each is up to six lines, so a solver takes all kinds at once.
  `lines.prepare_joints` once; then, for solvers of velocities, in each substep `lines.start_joints_warm`,
  `geometric.steady_turns` and `direct.solve_joints`; solvers of positions read the lines that
  `lines.write_lines` makes of the places now.
- ``contacts.manifolds``: numbers from STIFF on are a solver's own and stay with a pair from step to step.

Expected after it: final velocities and places in ``scratch.motion``; JN, JT: impulses (N s) of the last
substep, which come back as warm start (a solver that needs forces divides by h); MOST_0/1: the largest
normal impulse of any substep (it makes events, and says that a point touched); joint impulses in
``joints.impulses``. Key-framed bodies must end with the velocity that they began with. Impacts:
`impacts.resolve_impacts`, after the forces of each substep. ``bodies`` is read only: places of the beginning,
``inverse_masses``, ``flags``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from game.physics.solids.solvers.augmented_vertex_block_descent import (
    solve_augmented_vertex_block_descent,
)
from game.physics.solids.solvers.complementarity import solve_by_complementarity
from game.physics.solids.solvers.compliant_lagrangian import solve_compliant_lagrangian
from game.physics.solids.solvers.sequential_impulses import solve_sequential_impulses
from game.physics.solids.solvers.shock_propagation import solve_shock_propagation
from game.physics.solids.solvers.soft_step import solve_soft_step, solve_unjoined_soft_step
from game.physics.solids.solvers.xpbd import solve_xpbd

SOLVERS: dict[str, Callable[..., Any]] = {
    "soft-step": solve_soft_step,
    "sequential-impulses": solve_sequential_impulses,
    "xpbd": solve_xpbd,
    "augmented-vertex-block-descent": solve_augmented_vertex_block_descent,
    "compliant-lagrangian": solve_compliant_lagrangian,
    "shock-propagation": solve_shock_propagation,
    "complementarity": solve_by_complementarity,
}
# in the place of these, where nothing is joined: the same to the bit, and compiled in less time
UNJOINED: dict[str, Callable[..., Any]] = {"soft-step": solve_unjoined_soft_step}
LIMITED = frozenset({"complementarity"})  # solvers that raise LimitError where too much touches
# how a solver is meant to be used, where that is not four substeps of one sweep
SUGGESTED: dict[str, dict[str, int]] = {
    "sequential-impulses": {"substeps": 1, "iterations": 10},
    "xpbd": {"substeps": 16},
    "augmented-vertex-block-descent": {"substeps": 1, "iterations": 10},
    "compliant-lagrangian": {"substeps": 4, "iterations": 4},
    "shock-propagation": {"substeps": 1},
    "complementarity": {"substeps": 2},
}
