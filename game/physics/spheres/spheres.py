"""Bodies made of spheres, as structures of arrays: what they are (`SphereBodies`) and how they move.

Mostly each sphere is a body of its own. Several may be joined to one; then its mass, centre and inertia
follow from the spheres (the offset theorem). Motion is kept as position, orientation, momentum and angular
momentum about the body's own centre; velocities are made from them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import linear
from game.physics.rigid.quaternion import matrix_of, quaternion_to_matrix
from game.physics.spheres.composition import (
    LARGEST,
    Composition,
    checked_kinds,
    checked_numbers,
    checked_owners,
    checked_turns,
    checked_vectors,
    invert_inertias,
    join_spheres,
    symmetric,
)  # fmt: skip

# columns of the velocities that a step works on; the last row is a body that nothing moves
VX, VY, VZ, WX, WY, WZ, WEIGHT, IXX, IYY, IZZ, IXY, IXZ, IYZ = range(13)
WORK_COLUMNS = 16


class MotionState(NamedTuple):
    """How bodies move: all that changes, one row for each body."""

    positions: Floats  # (n, 3) m, of centres of mass
    orientations: Floats  # (n, 4) unit quaternions, scalar first
    momenta: Floats  # (n, 3) kg m/s
    spins: Floats  # (n, 3) kg m²/s, angular momentum about the centre of mass


@lean_kernel
def gather_velocities(state, composition, work):
    """Velocities, inverse masses and inverse inertias in the world's frame, (n + 1, WORK_COLUMNS) written."""
    n = composition.masses.shape[0]
    for column in range(WORK_COLUMNS):
        work[n, column] = 0.0
    for i in range(n):
        weight = 1.0 / composition.masses[i]
        lx, ly, lz = state.spins[i, 0], state.spins[i, 1], state.spins[i, 2]
        xx, yy, zz, xy, xz, yz = world_inertia(state.orientations, composition, i)
        work[i, VX] = state.momenta[i, 0] * weight
        work[i, VY] = state.momenta[i, 1] * weight
        work[i, VZ] = state.momenta[i, 2] * weight
        work[i, WX] = xx * lx + xy * ly + xz * lz
        work[i, WY] = xy * lx + yy * ly + yz * lz
        work[i, WZ] = xz * lx + yz * ly + zz * lz
        work[i, WEIGHT] = weight
        work[i, IXX] = xx
        work[i, IYY] = yy
        work[i, IZZ] = zz
        work[i, IXY] = xy
        work[i, IXZ] = xz
        work[i, IYZ] = yz


@inner_kernel
def world_inertia(orientations, composition, i):
    """Inverse inertia of body i in the world's frame: xx, yy, zz, xy, xz, yz."""
    j = composition.inverse_inertias
    if composition.round_bodies[i]:
        return j[i, 0], j[i, 0], j[i, 0], 0.0, 0.0, 0.0
    q = orientations
    a, b, c, d, e, f, g, h, k = matrix_of((q[i, 0], q[i, 1], q[i, 2], q[i, 3]))
    xx, yy, zz, xy, xz, yz = j[i, 0], j[i, 1], j[i, 2], j[i, 3], j[i, 4], j[i, 5]
    # rows of R J
    ax, ay, az = a * xx + b * xy + c * xz, a * xy + b * yy + c * yz, a * xz + b * yz + c * zz
    dx, dy, dz = d * xx + e * xy + f * xz, d * xy + e * yy + f * yz, d * xz + e * yz + f * zz
    gx, gy, gz = g * xx + h * xy + k * xz, g * xy + h * yy + k * yz, g * xz + h * yz + k * zz
    return (
        ax * a + ay * b + az * c, dx * d + dy * e + dz * f, gx * g + gy * h + gz * k,
        ax * d + ay * e + az * f, ax * g + ay * h + az * k, dx * g + dy * h + dz * k,
    )  # fmt: skip


@lean_kernel
def place_spheres(state, composition, places):
    """World positions of all spheres' centres, (s, 3) m written."""
    for s in range(composition.radii.shape[0]):
        i = composition.owners[s]
        ox, oy, oz = composition.offsets[s, 0], composition.offsets[s, 1], composition.offsets[s, 2]
        places[s, 0] = state.positions[i, 0]
        places[s, 1] = state.positions[i, 1]
        places[s, 2] = state.positions[i, 2]
        if ox != 0.0 or oy != 0.0 or oz != 0.0:
            q = state.orientations
            a, b, c, d, e, f, g, h, k = matrix_of((q[i, 0], q[i, 1], q[i, 2], q[i, 3]))
            places[s, 0] += a * ox + b * oy + c * oz
            places[s, 1] += d * ox + e * oy + f * oz
            places[s, 2] += g * ox + h * oy + k * oz


class SphereBodies:
    """What bodies are made of, how they stand and move.

    positions: (s, 3) or (s, 2) m, of the spheres. radii: (s,) m. velocities, turning: (n, 3) m/s and rad/s
    of the bodies. masses: (s,) kg, infinite for a sphere that nothing moves. inertias: "unit" (1 kg m², as
    the course has it), "solid" (2/5 m r²), (n,) numbers or (n, 3, 3) tensors in the frame of the body.
    kinds: (s,) materials. owners: (s,) body of each sphere, 0, 1, ...; None makes each sphere a body.
    ValueError, naming what is wrong, for nonsense.
    """

    def __init__(
        self,
        positions: ArrayLike,
        radii: ArrayLike,
        velocities: ArrayLike | None = None,
        turning: ArrayLike | None = None,
        *,
        masses: ArrayLike = 1.0,
        inertias: ArrayLike | str = "unit",
        orientations: ArrayLike | None = None,
        kinds: ArrayLike = 0,
        owners: ArrayLike | None = None,
    ):
        places = checked_vectors("positions", positions, None)
        s = len(places)
        radii = checked_numbers("radii", radii, s, 1e-9, LARGEST)
        weights = checked_numbers("masses", masses, s, 1e-12, math.inf)
        self.single = owners is None
        who = np.arange(s) if owners is None else checked_owners(owners, s)
        n = int(who.max()) + 1
        mass, centre = join_spheres(places, weights, who, n)
        self.state = MotionState(centre, np.zeros((n, 4)), np.zeros((n, 3)), np.zeros((n, 3)))
        self.state.orientations[:] = checked_turns(orientations, n)
        offsets = places - centre[who]
        if not self.single:
            self._turn_back(offsets, who)
        inverse, round_bodies = invert_inertias(inertias, offsets, radii, weights, who, mass)
        self.composition = Composition(
            mass, inverse, round_bodies, radii, who, offsets, checked_kinds(kinds, s)
        )
        self.count = n
        self.alike = self.single and bool(round_bodies.all())  # each a ball that turns alike about all axes
        self.set_velocities(
            np.zeros((n, 3)) if velocities is None else velocities,
            np.zeros((n, 3)) if turning is None else turning,
        )

    @classmethod
    def of_parts(cls, composition: Composition, state: MotionState) -> SphereBodies:
        """Bodies of parts that other bodies gave; they are taken as they are, not copied."""
        bodies = cls.__new__(cls)
        bodies.composition, bodies.state, bodies.count = composition, state, len(composition.masses)
        bodies.single = len(composition.radii) == bodies.count and not composition.offsets.any()
        bodies.alike = bodies.single and bool(composition.round_bodies.all())
        return bodies

    def _turn_back(self, offsets: Floats, owners: Longs) -> None:
        """Bring offsets (s, 3) from the world's frame into those of the bodies."""
        for s, i in enumerate(owners.tolist()):
            rotation = quaternion_to_matrix(self.state.orientations[i])
            offsets[s] = linear.product(rotation.T, offsets[s])

    def set_velocities(self, velocities: ArrayLike, turning: ArrayLike) -> None:
        """Give all bodies velocities (n, 3) m/s and angular velocities (n, 3) rad/s.

        ValueError for numbers that are not finite, or a velocity of a body that nothing moves.
        """
        v = checked_vectors("velocities", velocities, self.count)
        w = checked_vectors("turning", turning, self.count)
        heavy = np.isinf(self.composition.masses)
        if np.any(v[heavy] != 0.0) or np.any(w[heavy] != 0.0):
            raise ValueError("velocities: a body of infinite mass stays where it is")
        np.copyto(self.state.momenta, v * np.where(heavy, 0.0, self.composition.masses)[:, None])
        inverse = self.composition.inverse_inertias[:, :1]
        np.copyto(self.state.spins, np.divide(w, inverse, out=np.zeros_like(w), where=inverse > 0.0))
        for i in np.flatnonzero(self.composition.round_bodies == 0).tolist():
            rotation = quaternion_to_matrix(self.state.orientations[i])
            tensor = linear.inverse(symmetric(self.composition.inverse_inertias[i]))
            self.state.spins[i] = linear.product(
                linear.product(linear.product(rotation, tensor), rotation.T), w[i]
            )

    @property
    def velocities(self) -> Floats:
        """(n, 3) m/s."""
        return self.state.momenta / self.composition.masses[:, None]

    @property
    def turning(self) -> Floats:
        """Angular velocities (n, 3) rad/s."""
        work = np.zeros((self.count + 1, WORK_COLUMNS))
        gather_velocities(self.state, self.composition, work)
        return work[:-1, WX : WZ + 1].copy()

    def places(self) -> Floats:
        """World positions of all spheres (s, 3) m, a copy."""
        if self.single:
            return self.state.positions.copy()
        places = np.empty((len(self.composition.radii), 3))
        place_spheres(self.state, self.composition, places)
        return places

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        for name, array in self.state._asdict().items():
            assert np.isfinite(array).all(), f"{name} are finite"
        lengths = np.sqrt((self.state.orientations * self.state.orientations).sum(axis=1))
        assert np.abs(lengths - 1.0).max(initial=0.0) < 1e-12, "orientations have length 1"
        heavy = np.isinf(self.composition.masses)
        assert not self.state.momenta[heavy].any(), "what nothing moves has no momentum"
