"""The state of a rigid body and what follows from it: velocity, spin, accelerations, tensor, energy."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import linear
from game.physics.rigid import motion
from game.physics.rigid.quaternion import (
    matrix_of,
    normalize,
    quaternion_conjugate,
    quaternion_multiply,
    quaternion_normalized,
)
from game.physics.rigid.settings import vector
from game.physics.rigid.turning import measure
from game.physics.rigid.window import place_spheres


class BodyState:
    """x, q, P, L of one body, what it is made of, the loads of its next step; and all that they mean.

    states (1, 13), constants (1, 7), loads (1, 6): see motion. offsets (n, 3) m and radii (n,) m of its
    spheres, in the principal frame; axes (3, 3): that frame in the body's own, in columns.
    """

    states: Floats
    constants: Floats
    loads: Floats
    offsets: Floats
    radii: Floats
    axes: Floats
    _frame: Floats  # the axes as a quaternion
    effects: EffectSet
    gravity: float

    # -- state --------------------------------------------------------------------------------------

    @property
    def state(self) -> Floats:
        """(13,): place, turn of the principal frame, momentum, angular momentum. A view."""
        return self.states[0]

    @property
    def position(self) -> Floats:
        """Centre of mass (3,) m."""
        return self.states[0, motion.X : motion.Q].copy()

    @position.setter
    def position(self, value: ArrayLike) -> None:
        self.states[0, motion.X : motion.Q] = vector("position", value)

    @property
    def orientation(self) -> Floats:
        """Turn (4,) of the body's own axes, scalar first."""
        return quaternion_multiply(self.states[0, motion.Q : motion.P], quaternion_conjugate(self._frame))

    @orientation.setter
    def orientation(self, value: ArrayLike) -> None:
        self.states[0, motion.Q : motion.P] = quaternion_multiply(quaternion_normalized(value), self._frame)

    @property
    def momentum(self) -> Floats:
        """P (3,) kg m/s."""
        return self.states[0, motion.P : motion.L].copy()

    @momentum.setter
    def momentum(self, value: ArrayLike) -> None:
        self.states[0, motion.P : motion.L] = vector("momentum", value)

    @property
    def angular_momentum(self) -> Floats:
        """L (3,) kg m²/s about the centre of mass, world frame."""
        return self.states[0, motion.L :].copy()

    @angular_momentum.setter
    def angular_momentum(self, value: ArrayLike) -> None:
        self.states[0, motion.L :] = vector("angular_momentum", value)

    # -- what follows from it -----------------------------------------------------------------------

    @property
    def mass(self) -> float:
        """kg."""
        return 1.0 / float(self.constants[0, motion.INVERSE_MASS])

    @property
    def moments(self) -> Floats:
        """Principal moments (3,) kg m², ascending."""
        return self.constants[0, motion.MOMENTS : motion.INVERSES].copy()

    @property
    def rotation(self) -> Floats:
        """(3, 3), from the principal frame to the world's: its columns are the principal axes."""
        return np.array(matrix_of(normalize(tuple(self.states[0, motion.Q : motion.P].tolist())))).reshape(
            3, 3
        )

    @property
    def inertia(self) -> Floats:
        """J(t) = R I Rᵀ (3, 3) kg m², world frame."""
        turn = self.rotation
        return linear.product(turn * self.moments, turn.T)

    @property
    def inverse_inertia(self) -> Floats:
        """J⁻¹ (3, 3), world frame; about an axis without inertia nothing turns."""
        turn = self.rotation
        return linear.product(turn * self.constants[0, motion.INVERSES :], turn.T)

    @property
    def velocity(self) -> Floats:
        """v = P / m (3,) m/s."""
        return self.states[0, motion.P : motion.L] * self.constants[0, motion.INVERSE_MASS]

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        self.states[0, motion.P : motion.L] = vector("velocity", value) * self.mass

    @property
    def angular_velocity(self) -> Floats:
        """w = J⁻¹ L (3,) rad/s, world frame."""
        return linear.product(self.rotation, self.spin)

    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None:
        self.states[0, motion.L :] = linear.product(self.inertia, vector("angular_velocity", value))

    @property
    def spin(self) -> Floats:
        """The angular velocity (3,) rad/s about the principal axes."""
        return np.array(measure(self.states[0], self.constants[0])[4:])

    @property
    def force(self) -> Floats:
        """Sum (3,) N of the forces of the next step, with that of gravity."""
        force = self.loads[0, motion.FORCE : motion.TORQUE].copy()
        force[1] -= self._fall() * self.mass
        return force

    @property
    def torque(self) -> Floats:
        """Sum (3,) N m of the torques of the next step about the centre of mass."""
        return self.loads[0, motion.TORQUE :].copy()

    @property
    def acceleration(self) -> Floats:
        """a = f / m (3,) m/s²."""
        return self.force * self.constants[0, motion.INVERSE_MASS]

    @property
    def angular_acceleration(self) -> Floats:
        """α = J⁻¹ (t - w x L) (3,) rad/s²: it is not zero for a free body whose w and L differ."""
        return linear.product(
            self.inverse_inertia, self.torque - np.cross(self.angular_velocity, self.states[0, motion.L :])
        )

    @property
    def kinetic_energy(self) -> tuple[float, float]:
        """J of the motion of the centre of mass, and of the rotation."""
        return measure(self.states[0], self.constants[0])[:2]

    @property
    def largest_rotation_energy(self) -> float:
        """L² / (2 I1), J: what the energy of rotation can rise to while L stays."""
        angular = self.states[0, motion.L :]
        inverses = self.constants[0, motion.INVERSES :]
        return 0.5 * float(linear.product(angular, angular)) * float(inverses.max())

    def spheres(self) -> Floats:
        """Centres (n, 3) m of the spheres."""
        places = np.empty_like(self.offsets)
        place_spheres(self.states[0], self.offsets, places)
        return places

    def _fall(self) -> float:
        return float(self.gravity) if GRAVITY in self.effects else 0.0
