"""The arrays of a world of solids: tables that grow, contacts, and the scratch memory of kernels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels.lanes import LANES
from game.physics.solids.arrays import layout, state
from game.physics.solids.arrays.layout import Joints
from game.physics.solids.arrays.plan import empty_plan
from game.physics.solids.arrays.state import Batches, Bodies, Contacts, Pool, Rows, Scratch, Shapes
from game.physics.solids.tables import Column, Table

MOST_BODIES, MOST_SHAPES, MOST_POOL, MOST_JOINTS = 20_000, 200_000, 2_000_000, 100_000
EVENTS = 4096  # of one step that are kept

_INT = np.int32
BODY_COLUMNS = {
    "positions": Column(width=2), "angles": Column(), "rotations": Column(width=2),
    "velocities": Column(width=2), "spins": Column(), "inverse_masses": Column(),
    "inverse_inertias": Column(), "forces": Column(width=3), "gravity_scales": Column(empty=1.0),
    "flags": Column(_INT), "reaches": Column(), "cores": Column(), "quiet": Column(), "late": Column(),
    "stored": Column(),
    "found": Column(width=4),
}  # fmt: skip
SHAPE_COLUMNS = {
    "kinds": Column(_INT, empty=state.NONE),
    "bodies": Column(_INT),
    "starts": Column(_INT),
    "counts": Column(_INT),
    "radii": Column(),
    "frictions": Column(),
    "restitutions": Column(),
    "densities": Column(),
    "categories": Column(np.int64),
    "masks": Column(np.int64),
    "sizes": Column(),
    "boxes": Column(width=4),
}
POOL_COLUMNS = {"corners": Column(width=2), "normals": Column(width=2)}
JOINT_COLUMNS = {
    "kinds": Column(_INT, empty=layout.NO_JOINT),
    "flags": Column(_INT),
    "bodies": Column(_INT, 2),
    "anchors": Column(width=4),
    "parameters": Column(width=layout.PARAMETERS),
    "impulses": Column(width=layout.IMPULSES),
    "stiffnesses": Column(width=layout.IMPULSES),
    "starts": Column(width=layout.IMPULSES),
    "rows": Column(width=layout.JOINT_ROW, empty=-1.0),
    "lines": Column(width=layout.LINES),
}


def body_table() -> Table[Bodies]:
    """Empty."""
    return Table("bodies", Bodies, BODY_COLUMNS, MOST_BODIES)


def shape_table() -> Table[Shapes]:
    """Empty."""
    return Table("shapes", Shapes, SHAPE_COLUMNS, MOST_SHAPES)


def pool_table() -> Table[Pool]:
    """Empty."""
    return Table("corners", Pool, POOL_COLUMNS, MOST_POOL)


def joint_table() -> Table[Joints]:
    """Empty."""
    return Table("joints", Joints, JOINT_COLUMNS, MOST_JOINTS)


def contacts_of(capacity: int) -> Contacts:
    """Space for so many pairs, none there."""
    return Contacts(
        np.zeros(2, dtype=np.int64),
        np.zeros(capacity, dtype=_INT),
        np.zeros((capacity, 2), dtype=_INT),
        np.zeros((capacity, 2), dtype=_INT),
        np.zeros((capacity, state.MARKS_WIDTH), dtype=_INT),
        aligned_zeros(capacity, state.MANIFOLD_WIDTH),
    )


def rows_of(capacity: int) -> Rows:
    """Space for so many rows, none there."""
    return Rows(
        np.zeros(2, dtype=np.int64),
        np.zeros((capacity, 4), dtype=_INT),
        np.zeros((capacity, state.ROW_WIDTH)),
        np.zeros((capacity, state.RARE_WIDTH)),
    )


def aligned_zeros(rows: int, columns: int) -> NDArray[np.float64]:
    """(rows, columns) zeros that begin where a line of the processor's memory does."""
    numbers = np.zeros(rows * columns + state.LINE)
    first = -(numbers.ctypes.data // numbers.itemsize) % state.LINE
    return numbers[first : first + rows * columns].reshape(rows, columns)


def batches_of(bodies: int, pairs: int) -> Batches:
    """Space for batches of one row each, none there: memory that is not touched costs nothing."""
    return Batches(
        np.zeros(1, dtype=np.int64),
        aligned_zeros(pairs, state.BATCH_WIDTH * LANES).reshape(pairs, state.BATCH_WIDTH, LANES),
        np.zeros((pairs, 2, LANES), dtype=_INT),
        np.zeros((pairs, LANES), dtype=_INT),
        np.zeros((pairs, LANES), dtype=_INT),
        np.zeros(pairs, dtype=_INT),
        np.zeros(pairs, dtype=_INT),
        np.zeros(bodies, dtype=_INT),
    )


def scratch_of(bodies: int, shapes: int, pairs: int, joints: int = 0) -> Scratch:
    """Memory for kernels that see so many slots and pairs."""
    buckets = 1 << max(4, (2 * shapes).bit_length())
    return Scratch(
        motion=aligned_zeros(bodies, state.MOTION_WIDTH),
        accelerations=np.zeros((bodies, 3)),
        air=np.zeros((bodies, 3)),
        corners=np.zeros((state.MOST_CORNERS, 2)),
        normals=np.zeros((state.MOST_CORNERS, 2)),
        manifold=np.zeros(9),
        features=np.zeros(2, dtype=np.int64),
        heads=np.zeros(buckets + 1, dtype=_INT),
        members=np.zeros(shapes, dtype=_INT),
        cells=np.zeros((shapes, 3), dtype=np.int64),
        pair_keys=np.zeros((pairs, 2), dtype=_INT),
        pair_spare=np.zeros((pairs, 2), dtype=_INT),
        tallies=np.zeros(shapes + 1, dtype=_INT),
        colours=np.zeros(bodies, dtype=np.int64),
        colour_of=np.zeros(pairs, dtype=_INT),
        parents=np.zeros(bodies, dtype=_INT),
        meetings=np.zeros(bodies, dtype=_INT),
        speeds=np.zeros((bodies, 6)),
        going=np.zeros((bodies, 3)),
        works=np.zeros((bodies, state.WORKS_WIDTH)),
        drifts=np.zeros((bodies, state.DRIFTS_WIDTH)),
        excused=np.zeros(bodies, dtype=_INT),
        fractions=np.ones(bodies),
        plan=empty_plan(),
        stiffness=np.zeros(bodies),
        before=np.zeros((bodies, state.MOTION_WIDTH)),
        starts=np.zeros(bodies + 1, dtype=_INT),
        touching=np.zeros(2 * (pairs + joints), dtype=_INT),
        points=np.zeros((pairs, state.POINTS_WIDTH)),
        batches=batches_of(bodies, pairs),
        begun=np.zeros((EVENTS, 2), dtype=_INT),
        begun_places=np.zeros((EVENTS, 5)),
        events=np.zeros(4, dtype=np.int64),
    )
