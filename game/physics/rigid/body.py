"""One rigid body: its state, what follows from it, forces at points, and a step."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from game.physics.effects import EffectSet
from game.physics.fields import DRAG
from game.physics.kernels import elementary, linear
from game.physics.rigid import motion
from game.physics.rigid.body_state import BodyState
from game.physics.rigid.effects import PUSHES, ROTATION, WINDOW
from game.physics.rigid.mass import inverse_moments, mass_properties, principal_axes, sphere_positions
from game.physics.rigid.motion import METHODS, advance
from game.physics.rigid.quaternion import (
    quaternion_from_matrix,
)
from game.physics.rigid.settings import LARGEST, checked_setting, vector
from game.physics.rigid.window import WALLS, keep_inside


class RigidBody(BodyState):
    """A rigid body in space.

    mass: kg. inertia: (3, 3) kg m² about the centre of mass, or (3,) moments about the body's own axes.
    position (3,) m of the centre of mass; orientation (4,), scalar first, of the body's axes; velocity (3,)
    m/s; angular_velocity (3,) rad/s in the world's frame. Further settings as for `change`. ValueError
    naming what makes no sense.

    The state is x, q, P, L; velocity, spin and accelerations follow from it. Inside, q is that of the
    principal frame, in which the tensor is diagonal.
    """

    def __init__(
        self,
        mass: float = 1.0,
        inertia: ArrayLike = (1.0, 1.0, 1.0),
        *,
        position: ArrayLike = (0.0, 0.0, 0.0),
        orientation: ArrayLike = (1.0, 0.0, 0.0, 0.0),
        velocity: ArrayLike = (0.0, 0.0, 0.0),
        angular_velocity: ArrayLike = (0.0, 0.0, 0.0),
        **settings: Any,
    ):
        self.states = np.zeros((1, motion.STATE_SIZE))
        self.constants = np.zeros((1, motion.CONSTANTS))
        self.loads = np.zeros((1, motion.LOADS))
        self.offsets, self.radii = np.zeros((0, 3)), np.zeros(0)  # in the principal frame
        self.bounces = 0
        self.method, self.effects = METHODS[0], EffectSet([ROTATION, PUSHES])
        self.gravity = self.damping = 0.0
        self.normalizing, self.wall, self.restitution = True, WALLS[0], 1.0
        self.lower, self.upper = np.full(3, -LARGEST), np.full(3, LARGEST)
        self._set_inertia(mass, inertia)
        self.position = position
        self.orientation = orientation
        self.velocity = velocity
        self.angular_velocity = angular_velocity
        self.change(**settings)

    @classmethod
    def from_spheres(
        cls, positions: ArrayLike, radii: ArrayLike, density: ArrayLike = 1000.0, **more: Any
    ) -> RigidBody:
        """A body of spheres joined as they stand: positions (n, 3) or (n, 2) m, radii (n,) m, kg/m³.

        The body's axes are the world's at first. ``more`` as for the class; a position moves it as a whole.
        """
        mass, center, inertia = mass_properties(positions, radii, density)
        body = cls(mass, inertia, **{"position": center, **more})
        body.offsets = linear.product(sphere_positions(positions) - center, body.axes)
        body.radii = np.array(radii, dtype=np.float64).reshape(-1)
        return body

    # -- what it is made of -------------------------------------------------------------------------

    def _set_inertia(self, mass: float, inertia: ArrayLike) -> None:
        if not (isinstance(mass, int | float | np.number) and 0.0 < mass < LARGEST):
            raise ValueError(f"mass: must be above 0 and finite, got {mass!r}")
        moments, self.axes = principal_axes(inertia)
        self._frame = quaternion_from_matrix(self.axes)
        row = self.constants[0]
        row[motion.INVERSE_MASS] = 1.0 / mass
        row[motion.MOMENTS : motion.INVERSES] = moments
        row[motion.INVERSES :] = inverse_moments(moments)

    def change_density(self, factor: float, keep: str = "momentum") -> None:
        """Make the body so many times as dense; keep "momentum" (the state as it is) or "velocity".

        ValueError, and nothing changed, for another word, or a factor that leaves no finite inertia.
        """
        if not (math.isfinite(factor) and factor > 0.0):
            raise ValueError(f"factor: must be above 0 and finite, got {factor!r}")
        if keep not in ("momentum", "velocity"):
            raise ValueError(f"keep = {keep!r}: expected momentum or velocity")
        row = self.constants[0]
        changed = np.concatenate(
            (
                row[:1] / factor,
                row[motion.MOMENTS : motion.INVERSES] * factor,
                row[motion.INVERSES :] / factor,
            )
        )
        if not np.isfinite(changed).all():
            raise ValueError(f"factor = {factor!r}: the inertia is no number any more")
        row[:] = changed
        if keep == "velocity":
            self.states[0, motion.P :] *= factor

    def change(self, **settings: Any) -> None:
        """Other settings from now on; ValueError, and nothing changed, if one of them makes no sense.

        method: of METHODS. effects: of `BODIES`. gravity: m/s² along -y. damping: 1/s, of both
        momenta. normalizing: keep |q| at 1. wall: of WALLS. restitution: of the walls. lower, upper: (3,) m,
        the box.
        """
        checked = {name: checked_setting(name, value) for name, value in settings.items()}
        if np.any(checked.get("lower", self.lower) >= checked.get("upper", self.upper)):
            raise ValueError("lower, upper: the box is empty")
        for name, value in checked.items():
            setattr(self, name, value)

    # -- forces and steps ---------------------------------------------------------------------------

    def apply_force(self, force: ArrayLike, point: ArrayLike | None = None) -> None:
        """Let a force (3,) N act during the next step at a point (3,) m of the world; None: at the centre."""
        force = vector("force", force)
        self.loads[0, motion.FORCE : motion.TORQUE] += force
        if point is not None:
            self.loads[0, motion.TORQUE :] += np.cross(
                vector("point", point) - self.states[0, motion.X : motion.Q], force
            )

    def apply_torque(self, torque: ArrayLike) -> None:
        """Let a torque (3,) N m act during the next step."""
        self.loads[0, motion.TORQUE :] += vector("torque", torque)

    def copy(self) -> RigidBody:
        """Another body of the same state, settings and forces."""
        other = copy.copy(self)
        for name in ("states", "constants", "loads", "offsets", "radii", "axes", "_frame", "lower", "upper"):
            setattr(other, name, getattr(self, name).copy())
        return other

    def clear_forces(self) -> None:
        """Forget all forces applied since the last step."""
        self.loads[:] = 0.0

    def apply_impulse(self, impulse: ArrayLike, point: ArrayLike | None = None) -> None:
        """Change the momenta at once by an impulse (3,) N s at a point (3,) m of the world."""
        impulse = vector("impulse", impulse)
        self.states[0, motion.P : motion.L] += impulse
        if point is not None:
            self.states[0, motion.L :] += np.cross(
                vector("point", point) - self.states[0, motion.X : motion.Q], impulse
            )

    def step(self, dt: float, steps: int = 1) -> None:
        """Make steps of dt s, all under the forces applied since the last call, which are then forgotten.

        ValueError unless dt is finite and above 0. Walls are looked at after each step.
        """
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        if PUSHES not in self.effects:
            self.clear_forces()
        walls = WINDOW in self.effects and len(self.radii) > 0
        keep = elementary.exp(-self.damping * dt) if DRAG in self.effects else 1.0
        for _ in range(steps if walls else 1):
            advance(
                METHODS.index(self.method), self.states, self.constants, self.loads, (self._fall(), keep),
                int(ROTATION in self.effects), int(self.normalizing), float(dt), 1 if walls else int(steps),
            )  # fmt: skip
            if walls:
                self._stay_inside()
        self.clear_forces()

    def _stay_inside(self) -> None:
        places = np.empty_like(self.offsets)
        self.bounces += keep_inside(
            self.states[0], self.constants[0], self.offsets, self.radii, self.lower, self.upper,
            float(self.restitution), WALLS.index(self.wall), places,
        )  # fmt: skip

    @property
    def is_free(self) -> bool:
        """True while nothing turns the body, so that the exact solution holds."""
        return not self.loads[0, motion.TORQUE :].any() and not (DRAG in self.effects and self.damping)

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        assert np.isfinite(self.states).all(), "finite"
        q = self.states[0, motion.Q : motion.P]
        assert not self.normalizing or abs(math.sqrt(float(linear.product(q, q))) - 1.0) < 1e-14, "|q| is 1"
        moments = self.moments
        assert 0.0 <= moments[0] <= moments[1] <= moments[2], "moments ascend"
        _, rotation = self.kinetic_energy
        assert rotation <= self.largest_rotation_energy * (1.0 + 1e-12), "energy within its bound"
