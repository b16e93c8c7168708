"""A skeleton of straight bones in the plane: a tree whose bones carry their children with them.

Each bone has a place in its parent's frame, an angle against its parent and a length. It lies along the first
axis of its own frame, so its end is computed. The frame in the world is a 3 x 3 matrix on (x, y, 1):

    W_i = W_parent(i) T(offset_i) R(angle_i),   W_parent(root) = 1

which holds turn and shift alike, so one product hands a parent's motion on to all below it.

Arrays: parents, order (n,); offsets, bases, ends (n, 2) m; angles, lengths (n,); world (n, 3, 3) frames.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.kernels import elementary

NO_PARENT = -1
LARGEST = 1e9  # m and rad; beyond it a double no longer holds a place to a micrometre


class SkeletonError(ValueError):
    """A skeleton that cannot be, or a bone that is not there."""


@kernel
def place_bones(order, parents, offsets, angles, world):
    """Write the frames ``world`` (n, 3, 3) of bones: parents before children as ``order`` (n,) has them."""
    for k in range(order.shape[0]):
        i = order[k]
        p = parents[i]
        c, s = elementary.cos(angles[i]), elementary.sin(angles[i])
        x, y = offsets[i, 0], offsets[i, 1]
        if p < 0:
            world[i, 0, 0], world[i, 0, 1], world[i, 0, 2] = c, -s, x
            world[i, 1, 0], world[i, 1, 1], world[i, 1, 2] = s, c, y
        else:
            for row in range(2):
                a, b = world[p, row, 0], world[p, row, 1]
                world[i, row, 0] = a * c + b * s
                world[i, row, 1] = b * c - a * s
                world[i, row, 2] = a * x + b * y + world[p, row, 2]
        world[i, 2, 0], world[i, 2, 1], world[i, 2, 2] = 0.0, 0.0, 1.0


@kernel
def place_bones_in_frames(order, parents, offsets, angles, worlds):
    """The same for many poses: ``angles`` (f, n), ``worlds`` (f, n, 3, 3)."""
    for k in range(angles.shape[0]):
        place_bones(order, parents, offsets, angles[k], worlds[k])


@kernel
def place_ends(world, lengths, bases, ends):
    """Write where bones begin and end (n, 2)."""
    for i in range(lengths.shape[0]):
        for row in range(2):
            bases[i, row] = world[i, row, 2]
            ends[i, row] = world[i, row, 2] + world[i, row, 0] * lengths[i]


class Skeleton:
    """Bones by parent, place, angle and length, and their frames.

    parents: (n,) index of each bone's parent, -1 for a root; in any order. offsets: (n, 2) m, place in the
    parent's frame (in the world for a root); None: at the parent's end. angles: (n,) rad against the parent.
    lengths: (n,) m, 0 or more. lower, upper: (n,) rad, limits of the angles, infinite where there are none.

    `world` (n, 3, 3), `bases` and `ends` (n, 2) m are those of the last `update`. SkeletonError for what is
    not finite, of unequal number, or goes in a circle.
    """

    def __init__(
        self,
        parents: ArrayLike,
        lengths: ArrayLike,
        angles: ArrayLike | None = None,
        offsets: ArrayLike | None = None,
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
    ) -> None:
        self.parents = checked_parents(parents)
        self.count = n = len(self.parents)
        self.order = order_of(self.parents)
        self.lengths = _checked("lengths", lengths, (n,), 0.0)
        self.angles = _checked("angles", np.zeros(n) if angles is None else angles, (n,))
        self.offsets = _checked("offsets", self._at_ends() if offsets is None else offsets, (n, 2))
        self.lower = _limits("lower", -math.inf if lower is None else lower, n)
        self.upper = _limits("upper", math.inf if upper is None else upper, n)
        if np.any(self.lower > self.upper):
            bone = int(np.argmax(self.lower > self.upper))
            raise SkeletonError(f"limits: bone {bone} has a lower limit above its upper one")
        self.world = np.zeros((n, 3, 3))
        self.bases, self.ends = np.zeros((n, 2)), np.zeros((n, 2))
        self.update()

    def _at_ends(self) -> Floats:
        offsets = np.zeros((self.count, 2))
        has = self.parents >= 0
        offsets[has, 0] = self.lengths[self.parents[has]]
        return offsets

    # -- posing -------------------------------------------------------------------------------------

    def update(self) -> Floats:
        """Frames, beginnings and ends from the present angles; gives `world` (n, 3, 3)."""
        place_bones(self.order, self.parents, self.offsets, self.angles, self.world)
        place_ends(self.world, self.lengths, self.bases, self.ends)
        return self.world

    def pose(self, angles: ArrayLike) -> Floats:
        """Take these angles (n,) rad, not limited; gives `world`."""
        self.angles[:] = _checked("angles", angles, (self.count,))
        return self.update()

    def turn(self, bone: int, angle: float, limited: bool = True) -> Floats:
        """Turn one bone to an angle (rad) against its parent, within its limits; gives `world`.

        SkeletonError for a bone that there is not, or an angle that is not finite.
        """
        bone = self.bone(bone)
        if not abs(angle) <= LARGEST:
            raise SkeletonError(f"angle: expected a finite number of rad, got {angle!r}")
        low, high = (float(self.lower[bone]), float(self.upper[bone])) if limited else (-math.inf, math.inf)
        self.angles[bone] = min(max(angle, low), high)
        return self.update()

    def frames(self, angles: ArrayLike) -> Floats:
        """Frames (f, n, 3, 3) of many poses (f, n) rad at once; the present pose stays.

        SkeletonError unless there are n finite numbers for each.
        """
        angles = np.ascontiguousarray(angles, np.float64)
        if angles.ndim != 2 or angles.shape[1] != self.count or not np.all(np.isfinite(angles)):
            raise SkeletonError(f"angles: expected (frames, {self.count}) finite numbers")
        worlds = np.empty((len(angles), self.count, 3, 3))
        place_bones_in_frames(self.order, self.parents, self.offsets, angles, worlds)
        return worlds

    def world_angle(self, bone: int) -> float:
        """Direction of a bone in the world, rad in (-pi, pi]."""
        frame = self.world[self.bone(bone)]
        return elementary.atan2(frame[1, 0], frame[0, 0])

    # -- the tree -----------------------------------------------------------------------------------

    def bone(self, index: int) -> int:
        """The index of a bone; SkeletonError if there is no such bone."""
        if isinstance(index, bool) or not 0 <= int(index) < self.count or int(index) != index:
            raise SkeletonError(f"bone {index!r}: this skeleton has bones 0 to {self.count - 1}")
        return int(index)

    def children(self, bone: int) -> list[int]:
        """Bones that hang on a bone."""
        return np.flatnonzero(self.parents == self.bone(bone)).tolist()

    def path(self, start: int, end: int) -> list[int]:
        """Bones from ``start`` down to ``end``; SkeletonError if ``end`` does not hang on ``start``."""
        bone, path = self.bone(end), [self.bone(end)]
        while bone != self.bone(start):
            bone = int(self.parents[bone])
            if bone < 0:
                raise SkeletonError(f"chain: bone {end} does not hang on bone {start}")
            path.append(bone)
        return path[::-1]

    def copy(self) -> Skeleton:
        """A skeleton of its own in the same pose."""
        return Skeleton(self.parents, self.lengths, self.angles, self.offsets, self.lower, self.upper)

    def check(self) -> None:
        """Raise SkeletonError unless frames are rigid and those of the present angles, and all is finite."""
        if not (np.all(np.isfinite(self.angles)) and np.all(np.isfinite(self.world))):
            raise SkeletonError("pose: not finite")
        again = Skeleton(self.parents, self.lengths, self.angles, self.offsets, self.lower, self.upper)
        if not np.array_equal(again.world, self.world):
            raise SkeletonError("world: not that of the present angles")
        turn = self.world[:, :2, :2]
        off = np.abs((turn[:, :, None, :] * turn[:, None, :, :]).sum(axis=3) - np.eye(2)).max()
        if off > 1e-13 * (self.count + 1):
            raise SkeletonError(f"world: frames are off a rotation by {off:.1e}")


def order_of(parents: Longs) -> Longs:
    """Bones in an order that has parents before children; SkeletonError if they go in a circle."""
    depth = np.full(len(parents), -1)
    for i in range(len(parents)):
        way: list[int] = []
        bone = i
        while bone >= 0 and depth[bone] < 0:
            if len(way) > len(parents):
                raise SkeletonError(f"parents: bone {i} hangs on itself")
            way.append(bone)
            bone = int(parents[bone])
        first = 0 if bone < 0 else int(depth[bone]) + 1
        for k, above in enumerate(reversed(way)):
            depth[above] = first + k
    return np.argsort(depth, kind="stable")


def checked_parents(parents: ArrayLike) -> Longs:
    """Parents as indices (n,); SkeletonError unless each is a bone or -1 and there is at least one bone."""
    given = np.asarray(parents)
    if given.ndim != 1 or given.size == 0 or given.dtype.kind not in "iuf":
        raise SkeletonError("parents: expected a row of at least one whole number")
    indices = given.astype(np.int64)
    if not np.array_equal(indices, given):
        raise SkeletonError("parents: expected whole numbers")
    if np.any(indices < NO_PARENT) or np.any(indices >= len(indices)):
        raise SkeletonError(f"parents: expected indices from -1 to {len(indices) - 1}")
    return indices


def _checked(name: str, values: ArrayLike, shape: Sequence[int], least: float = -LARGEST) -> Floats:
    array = np.array(values, dtype=np.float64, order="C")
    if array.shape != tuple(shape):
        raise SkeletonError(f"{name}: expected shape {tuple(shape)}, got {array.shape}")
    if not np.all((array >= least) & (array <= LARGEST)):
        raise SkeletonError(f"{name}: expected finite numbers from {least:g} to {LARGEST:g}")
    return array


def _limits(name: str, values: ArrayLike, count: int) -> Floats:
    array = np.array(np.broadcast_to(np.asarray(values, dtype=np.float64), (count,)))
    if np.any(np.isnan(array)):
        raise SkeletonError(f"{name}: not a number")
    return array


def chain_skeleton(lengths: ArrayLike, angles: ArrayLike | None = None) -> Skeleton:
    """A single row of bones, each at the end of the one before; the first at the origin.

    lengths (n,) m; angles (n,) rad against the bone before, else 0. SkeletonError as of `Skeleton`.
    """
    lengths = np.atleast_1d(np.asarray(lengths, dtype=np.float64))
    return Skeleton(np.arange(len(lengths)) - 1, lengths, angles)
