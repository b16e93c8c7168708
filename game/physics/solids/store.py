"""What a world of solids holds: tables of bodies, shapes, joints, contacts; views of them, copies, checks."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementwise, linear
from game.physics.solids import memory
from game.physics.solids.arrays import state as st
from game.physics.solids.arrays.layout import NO_JOINT, Joints
from game.physics.solids.arrays.state import Bodies, Contacts, Pool, Shapes


class SolidState(NamedTuple):
    """All that later steps depend on; copies."""

    bodies: Bodies
    shapes: Shapes
    pool: Pool
    joints: Joints
    contacts: Contacts  # those in use
    origins: Floats  # (n, 2) m
    masses: Floats  # (n, 2) kg, kg m²
    free: tuple[NDArray[np.int64], ...]  # slots of bodies, shapes, corners and joints
    free_runs: tuple[tuple[int, int], ...]  # corners that are free: (first, count)
    excluded: NDArray[np.int64]
    stale: bool
    time: float


def arrays_of(rows: Any) -> tuple[NDArray[Any], ...]:
    """The arrays of a NamedTuple, whatever their kinds."""
    return tuple(rows)


class SolidStore:
    """Memory of a world. Ids of bodies, shapes and joints stay what they are until these are removed."""

    def __init__(self) -> None:
        self._bodies, self._shapes = memory.body_table(), memory.shape_table()
        self._pool, self._joints = memory.pool_table(), memory.joint_table()
        self._contacts, self._spare = memory.contacts_of(64), memory.contacts_of(64)
        self._rows = memory.rows_of(64)
        self._scratch = memory.scratch_of(0, 0, 64)
        self._origins: Floats = np.zeros((16, 2))  # in the frames of the bodies
        self._masses: Floats = np.zeros((16, 2))  # kg, kg m², as if dynamic; 0 for what has none
        self._runs: dict[int, list[int]] = {}
        self._excluded: NDArray[np.int64] = np.zeros(0, dtype=np.int64)
        self._stale = True
        self._fitting = False
        self.time = 0.0
        self.steps = 0

    @property
    def bodies(self) -> Bodies:
        """Rows of all slots: views, valid until a body is added. Read them; write velocities by
        `set_velocity`.
        """
        return self._bodies.rows

    @property
    def shapes(self) -> Shapes:
        """Rows of all slots: views."""
        return self._shapes.rows

    @property
    def pool(self) -> Pool:
        """Corners of all shapes: views."""
        return self._pool.rows

    @property
    def joints(self) -> Joints:
        """Rows of all slots: views."""
        return self._joints.rows

    @property
    def contacts(self) -> Contacts:
        """Pairs and manifolds in use: views."""
        count = int(self._contacts.count[0])
        return Contacts(self._contacts.count, *(array[:count] for array in arrays_of(self._contacts)[1:]))

    def ids(self) -> NDArray[np.int64]:
        """Of all bodies, ascending."""
        return np.flatnonzero(self.bodies.flags & st.USED)

    def shapes_of(self, body: int) -> NDArray[np.int64]:
        """Ids of a body's shapes."""
        self._known(body)
        return np.flatnonzero((self.shapes.bodies == body) & (self.shapes.kinds != st.NONE))

    def origin(self, body: int) -> tuple[float, float]:
        """Where the origin of the body's shapes is now, m."""
        self._known(body)
        c, s = self.bodies.rotations[body].tolist()
        x, y = self._origins[body].tolist()
        px, py = self.bodies.positions[body].tolist()
        return px + c * x - s * y, py + s * x + c * y

    def corners(self, shape: int) -> Floats:
        """Corners (k, 2) m of a shape in the world (a segment's ghosts left out)."""
        self._known_shape(shape)
        start, count = int(self.shapes.starts[shape]), int(self.shapes.counts[shape])
        local = self.pool.corners[start : start + count]
        if self.shapes.kinds[shape] == st.SEGMENT:
            local = local[1:3]
        body = int(self.shapes.bodies[shape])
        c, s = self.bodies.rotations[body].tolist()
        turned: Floats = linear.product(local, np.array([[c, s], [-s, c]])) + self.bodies.positions[body]
        return turned

    def local(self, body: int, point: tuple[float, float]) -> tuple[float, float]:
        """A point of the world (m) in the frame of a body."""
        rows = self.bodies
        c, s = rows.rotations[body].tolist()
        x, y = point[0] - float(rows.positions[body, 0]), point[1] - float(rows.positions[body, 1])
        return c * x + s * y, c * y - s * x

    def _tables(self) -> tuple[Any, ...]:
        return self._bodies, self._shapes, self._pool, self._joints

    def state(self) -> SolidState:
        """Copies of all that later steps depend on."""
        tables: list[Any] = [table.copy() for table in self._tables()]
        contacts = self.contacts
        contacts = contacts._replace(manifolds=contacts.manifolds[:, : st.MANIFOLD_NUMBERS])
        contacts = Contacts(*(array.copy() for array in arrays_of(contacts)))
        runs = tuple((start, count) for count, starts in self._runs.items() for start in starts)
        return SolidState(
            tables[0][0], tables[1][0], tables[2][0], tables[3][0], contacts,
            self._origins[: self._bodies.top].copy(), self._masses[: self._bodies.top].copy(),
            tuple(free for _, free in tables), runs,
            self._excluded.copy(), self._stale, self.time,
        )  # fmt: skip

    def restore(self, state: SolidState) -> None:
        """Be as when `state` was called: what follows is equal to the bit."""
        tables = self._tables()
        rows = (state.bodies, state.shapes, state.pool, state.joints)
        for table, given, free in zip(tables, rows, state.free, strict=True):
            table.restore(given, free)
        count = len(state.contacts.shapes)
        if count > len(self._contacts.shapes):
            self._contacts, self._spare = memory.contacts_of(count), memory.contacts_of(count)
            self._rows = memory.rows_of(count)
        np.copyto(self._contacts.count, state.contacts.count)
        for own, kept in zip(arrays_of(self._contacts)[1:], arrays_of(state.contacts)[1:], strict=True):
            own[tuple(slice(size) for size in kept.shape)] = kept
        if len(self._origins) < len(state.origins):
            self._origins, self._masses = np.zeros((2, 2 * len(state.origins), 2))
        self._origins[: len(state.origins)] = state.origins
        self._masses[: len(state.masses)] = state.masses
        self._runs = {}
        for start, size in state.free_runs:
            self._runs.setdefault(size, []).append(start)
        self._excluded, self._stale, self.time = state.excluded.copy(), state.stale, state.time
        self._fitting = False

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        rows, used = self.bodies, self.bodies.flags & st.USED != 0
        for name, array in rows._asdict().items():
            assert np.isfinite(array).all(), f"{name} are finite"
        lengths = elementwise.hypot(rows.rotations[used, 0], rows.rotations[used, 1])
        assert np.abs(lengths - 1.0).max(initial=0.0) < 1e-9, "rotations have length 1"
        still = rows.flags & st.DYNAMIC == 0
        assert not rows.inverse_masses[still].any(), "what is not dynamic has no inverse mass"
        assert (rows.flags[self.shapes.bodies[self.shapes.kinds != st.NONE]] & st.USED != 0).all(), (
            "shapes have bodies"
        )

    def _changed(self) -> None:
        """Bodies or shapes have come or gone."""
        self._stale, self._fitting = True, False

    def _known(self, body: int) -> None:
        if not (0 <= body < self._bodies.top and self._bodies.rows.flags[body] & st.USED):
            raise ValueError(f"body {body!r}: there is none of this number")

    def _known_shape(self, shape: int) -> None:
        if not (0 <= shape < self._shapes.top and self._shapes.rows.kinds[shape] != st.NONE):
            raise ValueError(f"shape {shape!r}: there is none of this number")

    def _known_joint(self, joint: int) -> None:
        if not (0 <= joint < self._joints.top and self._joints.rows.kinds[joint] != NO_JOINT):
            raise ValueError(f"joint {joint!r}: there is none of this number")
