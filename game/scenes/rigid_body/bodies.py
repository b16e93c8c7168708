"""The bodies of the rigid body scene: A, its twin B by another method, and the exact one, pushed alike.

Each has an account: the energy and angular momentum that its method alone has made, in steps without torque
and without a wall. Also how often it has turned over.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.kernels import linear
from game.physics.rigid import RigidBody, mass_properties, quaternion_to_matrix
from game.physics.rigid.turning import measure
from game.scenes.rigid_body.level import RADIUS, SHARE

A, B, EXACT = range(3)
MADE_ENERGY, MADE_MOMENTUM, FLIPS, SIDE, ACCOUNT = 0, 1, 2, 3, 4  # columns of an account
ALIKE = 1e-9  # of a moment: others that differ by less are the same
NEAR = 0.75  # cos² of 30°
ON_A_SIDE = 0.5  # part of L along the middle axis from which on a body is on that side
FINE = 8  # steps of the exact body in one of the others while something turns it


class Bodies:
    """Three bodies of one design (n, 6), of a density in kg/m³."""

    def __init__(self, design: Floats, density: float):
        self.design, self.density = design, density
        self.accounts = np.zeros((3, ACCOUNT))
        self._make()

    def _make(self) -> None:
        """Bodies at rest with the body's own axes along the world's."""
        places, radii = self.design[:, :3], self.design[:, RADIUS]
        body = RigidBody.from_spheres(places, radii, self.density * self.design[:, SHARE])
        _, self.center, _ = mass_properties(places, radii, self.design[:, SHARE])
        self.all = [body, body.copy(), body.copy()]
        self.rows = np.concatenate([body.states for body in self.all])  # (3, 13), their states lie in it
        for index, one in enumerate(self.all):
            one.states = self.rows[index : index + 1]

    def take(self, rows: Floats, design: Floats, density: float) -> None:
        """Take over states (3, 13) of bodies of a design."""
        rows = rows.copy()
        if density != self.density or not np.array_equal(design, self.design):
            self.design, self.density = design.copy(), density
            self._make()
        self.rows[:] = rows
        for body in self.all:
            body.clear_forces()

    def start(self, place: Sequence[float] | None, orientation: Any, velocity: Any, spin: Any) -> None:
        """Put all three where a level has them."""
        turn = quaternion_to_matrix(orientation)
        for body in self.all:
            body.position = linear.product(turn, self.center) if place is None else place
            body.orientation = orientation
            body.velocity, body.angular_velocity = velocity, spin

    def meet(self) -> None:
        """Let the others be as A is, and begin new accounts."""
        self.rows[1:] = self.rows[A]
        self.accounts[:] = 0.0
        self.accounts[:, SIDE] = side_of(self.all[A])

    def change_density(self, density: float, keep: str) -> None:
        """Make all of it of another density; keep "momentum" or "velocity"."""
        for body in self.all:
            body.change_density(density / self.density, keep)
        self.take(self.rows, self.design, density)  # constants those of the design, to the bit
        self.accounts[:, :FLIPS] = 0.0

    def reshape(self, design: Floats) -> None:
        """Other spheres; place, turn, velocity and spin of the body's matter stay as they are."""
        before, center, accounts = self.all, self.center, self.accounts.copy()
        self.design = design.copy()
        self._make()
        for old, new in zip(before, self.all, strict=True):
            offset = linear.product(quaternion_to_matrix(old.orientation), self.center - center)
            spin = old.angular_velocity
            new.position, new.orientation = old.position + offset, old.orientation
            new.velocity, new.angular_velocity = old.velocity + np.cross(spin, offset), spin
        self.accounts[:] = accounts
        self.accounts[:, :FLIPS] = 0.0
        self.accounts[:, SIDE] = [side_of(body) for body in self.all]  # of another middle axis

    def point_of(self, index: int, arm: Sequence[float]) -> Floats:
        """Where (3,) m a point of the design's frame is on a body; arm (3,) m from the centre of mass."""
        body = self.all[index]
        return body.position + linear.product(quaternion_to_matrix(body.orientation), np.asarray(arm))

    def arm_of(self, index: int, point: Floats) -> tuple[float, float, float]:
        """The opposite: where a point of the world is in the body's own axes, from its centre of mass."""
        body = self.all[index]
        x, y, z = (linear.product(point - body.position, quaternion_to_matrix(body.orientation))).tolist()
        return x, y, z

    def step(self, dt: float, twin: bool, push: Sequence[float] | None) -> None:
        """Go on by dt s; push: force (3) N and arm (3) m of its point, or None."""
        for index, body in enumerate(self.all):
            if index == B and not twin:
                continue
            if push is not None:
                body.apply_force(push[:3], self.point_of(index, push[3:6]))
            free, bounces = body.is_free, body.bounces
            before = measure(body.state, body.constants[0])
            fine = FINE if index == EXACT and not free else 1
            body.step(dt / fine, fine)
            after = measure(body.state, body.constants[0])
            account = self.accounts[index]
            if free and body.bounces == bounces:
                account[MADE_ENERGY] += after[1] - before[1]
                account[MADE_MOMENTUM] += after[2] - before[2]
            self._count_flips(body, account)

    def _count_flips(self, body: RigidBody, account: Floats) -> None:
        """Count a flip where L has come from one side of the middle axis to the other.

        A sign that changes is not enough: about another axis the body wobbles, and its spin about the middle
        one changes sign twice in each turn.
        """
        side = side_of(body)
        if side == 0.0:
            return
        if side == -account[SIDE] and is_about_middle_axis(body):
            account[FLIPS] += 1.0
        account[SIDE] = side


def side_of(body: RigidBody) -> float:
    """On which side of the middle axis L is, seen from the body: 1, -1, or 0 where it is on neither."""
    _, _, momentum, _, _, spin, _ = measure(body.state, body.constants[0])
    along = body.moments[1] * spin
    return math.copysign(1.0, along) if abs(along) > ON_A_SIDE * momentum else 0.0


def is_about_middle_axis(body: RigidBody) -> bool:
    """Whether a body turns about its middle axis, near enough to turn over."""
    _, rotation, momentum, *_ = measure(body.state, body.constants[0])
    return turns_over(body.moments.tolist(), rotation, momentum)


def turns_over(moments: Sequence[float], rotation: float, momentum: float) -> bool:
    """Whether free motion brings L within 30° of the middle axis, so that a change of sides turns it over.

    moments: kg m², ascending. rotation: energy, J. momentum: |L|, kg m²/s. On its path L is nearest to that
    axis where its part along the first or the third is 0. A body of two equal moments has no middle axis.
    """
    first, middle, third = moments
    if not 0.0 < first < middle * (1.0 - ALIKE) or not middle < third * (1.0 - ALIKE) or momentum <= 0.0:
        return False
    inverse = 2.0 * rotation / (momentum * momentum)  # 1 / moment about the axis of L
    end = third if inverse < 1.0 / middle else first
    return (inverse - 1.0 / end) / (1.0 / middle - 1.0 / end) > NEAR
