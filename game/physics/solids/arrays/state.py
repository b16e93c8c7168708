"""What kernels read and write: bodies, shapes, corners, contacts; structures of arrays, one row for each.

A body's own frame has its origin at the centre of mass. A slot that is not in use has no flag (bodies), the
kind NONE (shapes). So ids stay what they are when others are taken away.

All shapes are corners with a rounding radius: a disc has one corner, a capsule two, a polygon up to
MOST_CORNERS, anticlockwise. A segment of a chain has four: the ghost before, both ends, the ghost after;
it is solid on the right of its direction and met from the left only.
"""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats, Ints, Longs
from game.physics.solids.arrays.plan import JointPlan

MOST_CORNERS = 64
NONE, DISC, POLYGON, SEGMENT = -1, 0, 1, 2  # kinds of shapes; a capsule is a polygon of two corners
# flags of a body; one that is neither dynamic nor key-framed is fixed
USED, DYNAMIC, KEY_FRAMED, ASLEEP, RESTLESS, WAKING = 1, 2, 4, 8, 16, 32

# columns of Contacts.manifolds: normal in the frame of a's body; then two points, POINT_WIDTH each
NORMAL_X, NORMAL_Y = 0, 1
FIRST_POINT = 2
# of a point: midway between both surfaces, in the frames of a's and b's body; distance when it was found;
# impulses of the last substep, N s
IN_A_X, IN_A_Y, IN_B_X, IN_B_Y, GAP, NORMAL_IMPULSE, TANGENT_IMPULSE = range(7)
POINT_WIDTH = 7
# place of b's body in the frame of a's when the manifold was found, and the angle between them
PLACE_X, PLACE_Y, PLACE_ANGLE = 16, 17, 18
# stiffness N/m of both points along normal and tangent, that solvers by penalty have come to
STIFF = 19
MANIFOLD_NUMBERS = 23
LINE = 8  # numbers of a line of the processor's memory
MANIFOLD_WIDTH = 3 * LINE  # one of them free, so that a manifold lies in three lines and not in four
# columns of Contacts.marks; GIVEN: they overlap by no motion of their own (born so, or put so)
POINTS, FEATURE_0, FEATURE_1, TOUCHING, FOUND, GIVEN = range(6)
MARKS_WIDTH = 6


class Bodies(NamedTuple):
    """n bodies. SI units; a fixed body has inverse mass and inertia 0, a key-framed one too."""

    positions: Floats  # (n, 2) m, of the centres of mass
    angles: Floats  # (n,) rad
    rotations: Floats  # (n, 2) cosine and sine of the angle
    velocities: Floats  # (n, 2) m/s
    spins: Floats  # (n,) rad/s
    inverse_masses: Floats  # (n,) 1/kg
    inverse_inertias: Floats  # (n,) 1/(kg m²) about the centre of mass
    forces: Floats  # (n, 3) N, N, N m: of the next step only
    gravity_scales: Floats  # (n,)
    flags: Ints  # (n,) USED | ...
    reaches: Floats  # (n,) m, farthest point of its shapes from the centre of mass
    cores: Floats  # (n,) m, how far it may go in a step without passing through something thin
    quiet: Floats  # (n,) s, for how long it has been slow
    late: Floats  # (n,) s, of the last step, that continuous collision cut off
    stored: Floats  # (n,) J, what sinking has paid into the springs of its contacts: see solvers/governor
    found: Floats  # (n, 4) pose (m, m, rad) when its boxes were made, and how much room these left, m


class Shapes(NamedTuple):
    """s shapes, each fixed to a body."""

    kinds: Ints  # (s,)
    bodies: Ints  # (s,)
    starts: Ints  # (s,) first corner in the pool
    counts: Ints  # (s,) corners
    radii: Floats  # (s,) m, of rounding; of a disc, its radius
    frictions: Floats  # (s,)
    restitutions: Floats  # (s,) 0 to 1
    densities: Floats  # (s,) kg/m²
    categories: Longs  # (s,) bits
    masks: Longs  # (s,) bits: which categories it meets
    sizes: Floats  # (s,) m, radius of the least circle about its middle: what tolerances scale with
    boxes: Floats  # (s, 4) m, x0 y0 x1 y1 with some room


class Pool(NamedTuple):
    """Corners of all shapes in the frames of their bodies."""

    corners: Floats  # (v, 2) m
    normals: Floats  # (v, 2) outward normal of the edge that begins at the corner


class Contacts(NamedTuple):
    """Pairs of shapes whose boxes overlap, in ascending order of (a, b), and their manifolds.

    Space for more than there are: ``count[0]`` are in use.
    """

    count: Longs  # type: ignore[assignment]  # (2,) pairs; those that touch
    order: Ints  # (p,) in which they are solved: by colours, of which each has every body at most once
    shapes: Ints  # (p, 2) a, b: a's kind is not below b's
    bodies: Ints  # (p, 2) of a, of b
    marks: Ints  # (p, MARKS_WIDTH)
    manifolds: Floats  # (p, MANIFOLD_WIDTH)


# columns of Rows.rows: what a solver reads of one contact in each sweep. Normal from a to b, friction, 1
# where one
# of the two cannot move, inverse masses and inertias, roundings (b's as it is, a's negative: levers end on
# the
# core when this much of the normal is added), coupling of both points (entry of K)
(
    ROW_NX, ROW_NY, ROW_MU, ROW_HARD, ROW_IMA, ROW_IIA, ROW_IMB, ROW_IIB, ROUND_A, ROUND_B, COUPLING,
) = range(11)  # fmt: skip
ROW_POINT = 11
# of a point of a row, for levers r from both centres of mass (when the step began): r x n of a and b, r .
# n of a
# and b, gap when the step began, 1 / effective mass along the normal, effective mass along the tangent,
# accumulated impulses
CROSS_A, CROSS_B, DOT_A, DOT_B, SEP, STIFF_N, MASS_T, JN, JT = range(9)
ROW_POINT_WIDTH = 9
ROW_WIDTH = 29
# columns of Rows.rare: what only the beginning and the end of a step ask for
# restitution, gap speeds before the step (negative: closing), 1 for two that hit each other in this step, or
# overlap so deeply that they part at the fastest push (the impulses of such a substep are no guess for the
# next), largest impulses of any substep
RESTITUTION, APPROACH_0, APPROACH_1, IMPACT, MOST_0, MOST_1 = range(6)
RARE_WIDTH = 6
# columns of Batches.values behind those of Rows.rows: gaps of both points now, their largest impulses, how
# many points there are, and RESTITUTION, APPROACH_0/1, IMPACT
BATCH_GAP, BATCH_MOST, BATCH_POINTS, BATCH_RARE = (ROW_WIDTH + k for k in (0, 2, 4, 5))
BATCH_WIDTH = ROW_WIDTH + 9
POINTS_WIDTH = 8
WORKS_WIDTH, DRIFTS_WIDTH = 7, 8
# columns of Rows.ends
END_A, END_B, END_POINTS, END_PAIR = range(4)
# columns of Motion: velocity, spin, what a body has moved since the step began, cosine and sine of what it
# has turned, and that angle
VX, VY, W, DX, DY, DC, DS, DA = range(8)
MOTION_WIDTH = 8


class Rows(NamedTuple):
    """Contacts that touch, made ready for a solver; one contiguous row each. ``count[0]`` are in use.

    Where ``count[1]`` is 0, only ends are there; the rest is in batches.
    """

    count: Longs  # type: ignore[assignment]  # (2,)
    ends: Ints  # (p, 4) body a, body b, points, pair
    rows: Floats  # (p, ROW_WIDTH)
    rare: Floats  # (p, RARE_WIDTH)


class Batches(NamedTuple):
    """Rows that share no moving body, side by side; see `rows`. ``count[0]`` are in use."""

    count: Longs  # type: ignore[assignment]  # (1,)
    values: Floats  # (p, BATCH_WIDTH, LANES)
    ends: Ints  # (p, 2, LANES) bodies a, bodies b
    rows: Ints  # (p, LANES)
    pairs: Ints  # (p, LANES)
    filled: Ints  # (p,) lanes that have a row of their own
    kinds: Ints  # (p,) bits
    lately: Ints  # (n,) the last batch that a body was put into


class Scratch(NamedTuple):
    """Memory of the kernels, worth nothing between steps (but for the events of the last)."""

    motion: Floats  # (n, MOTION_WIDTH)
    accelerations: Floats  # (n, 3) m/s², m/s², rad/s²: of gravity, forces and torques
    air: Floats  # (n, 3) m/s, of the air about each body, and 1 where it drags (dynamic, awake)
    corners: Floats  # (MOST_CORNERS, 2) m, of the second shape in the frame of the first
    normals: Floats  # (MOST_CORNERS, 2)
    manifold: Floats  # (9,) see collide; the last: a distance that the two are apart at least
    features: Longs  # (2,)
    heads: Ints  # (buckets + 1,)
    members: Ints  # (s,)
    cells: Longs  # (s, 3)
    pair_keys: Ints  # (p, 2)
    pair_spare: Ints  # (p, 2)
    tallies: Ints  # (s + 1,)
    colours: Longs  # (n,) bits of colours in which a body has a pair
    colour_of: Ints  # (p,)
    parents: Ints  # (n,)
    meetings: Ints  # (n,) how many others a body meets in a substep
    speeds: Floats  # (n, 6) m/s, m/s, rad/s: in a substep, after the forces; and with the push of overlap
    going: Floats  # (n, 3) m/s, m/s, rad/s: sum over the substeps of what bodies go on with, without push
    works: Floats  # (n, WORKS_WIDTH) J, of groups of bodies that touch
    drifts: Floats  # (n, DRIFTS_WIDTH) of these groups as if each were one rigid body
    excused: Ints  # (n,) 1: something else than contacts may give it energy
    fractions: Floats  # (n,) of the step's motion that continuous collision leaves
    plan: JointPlan  # of the direct solve of joints
    stiffness: Floats  # (n,) inverse inertias that joints see, 1/(kg m²)
    before: Floats  # (n, MOTION_WIDTH) motion at the beginning of a substep
    starts: Ints  # (n + 1,) of each body's part of touching
    touching: Ints  # (2 (p + j),) rows of contacts, then -1 - joint, that a body takes part in
    points: Floats  # (p, POINTS_WIDTH) both points' own numbers of a solver
    batches: Batches
    begun: Ints  # (e, 2) shapes of contacts that began in the last step
    # (e, 5) m, m, N s, m/s, s: where, normal impulse, speed of approach, when from the step's beginning
    # (negative: in the one before, which was cut short; beyond it: in the first substep of the next)
    begun_places: Floats
    events: Longs  # (4,) contacts begun; joints broken; bodies gone wrong; stopped by continuous collision
