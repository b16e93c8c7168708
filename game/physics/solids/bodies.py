"""Bodies of a world: added, changed, removed; all that comes in is checked here."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.kernels import elementary, elementwise, linear
from game.physics.solids.arrays import state
from game.physics.solids.outlines import LARGEST
from game.physics.solids.shapes import (
    Part,
    Shape,
    checked_number,
    checked_pair,
    outward_normals,
    parts_mass,
)
from game.physics.solids.store import SolidStore, arrays_of

KINDS = {
    "fixed": state.USED,
    "dynamic": state.USED | state.DYNAMIC,
    "key-framed": state.USED | state.KEY_FRAMED,
}
FASTEST = 1e6  # m/s, rad/s


class SolidBodies(SolidStore):
    """What can be done to bodies, whatever makes them move."""

    def add_body(
        self,
        shapes: Shape | Sequence[Shape],
        position: ArrayLike = (0.0, 0.0),
        angle: float = 0.0,
        velocity: ArrayLike = (0.0, 0.0),
        spin: float = 0.0,
        *,
        kind: str = "dynamic",
        gravity_scale: float = 1.0,
        restless: bool = False,
    ) -> int:
        """A body of one or several shapes; its id.

        position m and angle rad of the frame in which the shapes are given; velocity m/s of the centre of
        mass; spin rad/s. kind: dynamic, fixed, key-framed (it moves as it is told). restless: never sleeps.
        ValueError.
        """
        given = [shapes] if not isinstance(shapes, Iterable) else list(shapes)
        if kind not in KINDS:
            raise ValueError(f"kind = {kind!r}: expected one of {', '.join(KINDS)}")
        if not given:
            raise ValueError("shapes: a body has at least one")
        x, y = checked_pair("position", position)
        turn = checked_number("angle", angle, -LARGEST, LARGEST)
        vx, vy = checked_pair("velocity", velocity, FASTEST)
        w = checked_number("spin", spin, -FASTEST, FASTEST)
        scale = checked_number("gravity_scale", gravity_scale, -1e6, 1e6)
        parts = [(part, shape) for shape in given for part in shape.parts()]
        mass = parts_mass([part for part, _ in parts])
        if kind == "dynamic":
            self._check_dynamic([part for part, _ in parts], mass.mass, mass.inertia)
        if kind == "fixed" and (vx, vy, w) != (0.0, 0.0, 0.0):
            raise ValueError("velocity: a fixed body has none (a key-framed one may)")
        cx, cy = mass.centre  # of a chain: its origin
        body = self._bodies.take()
        rows = self.bodies
        c, s = elementary.cos(turn), elementary.sin(turn)
        rows.flags[body] = KINDS[kind] | (state.RESTLESS if restless else 0)
        rows.positions[body] = x + c * cx - s * cy, y + s * cx + c * cy
        rows.angles[body], rows.rotations[body] = turn, (c, s)
        rows.velocities[body], rows.spins[body] = (vx, vy), w
        rows.gravity_scales[body] = scale
        if kind == "dynamic":
            rows.inverse_masses[body], rows.inverse_inertias[body] = 1.0 / mass.mass, 1.0 / mass.inertia
        if body >= len(self._origins):
            self._origins = np.concatenate([self._origins, np.zeros_like(self._origins)])
            self._masses = np.concatenate([self._masses, np.zeros_like(self._masses)])
        self._origins[body] = -cx, -cy
        has_chain = any(part.kind == state.SEGMENT for part, _ in parts)
        self._masses[body] = (0.0, 0.0) if has_chain else (mass.mass, mass.inertia)
        for part, shape in parts:
            self._add_part(body, part, shape, cx, cy)
        self._changed()
        return body

    def _check_dynamic(self, parts: list[Part], mass: float, inertia: float) -> None:
        if any(part.kind == state.SEGMENT for part in parts):
            raise ValueError("shapes: a chain belongs to a fixed or key-framed body")
        if not (mass > 1e-200 and inertia > 1e-200 and math.isfinite(mass + inertia)):
            raise ValueError("shapes: too small or too large to have a mass and an inertia")

    def _add_part(self, body: int, part: Part, shape: Shape, cx: float, cy: float) -> None:
        corners = part.corners - (cx, cy)
        count = len(corners)
        runs = self._runs.get(count)
        start = runs.pop() if runs else self._pool.take_run(count)
        self.pool.corners[start : start + count] = corners
        self.pool.normals[start : start + count] = outward_normals(part.kind, corners)
        slot, rows = self._shapes.take(), self.shapes
        own = corners[1:3] if part.kind == state.SEGMENT else corners
        middle = 0.5 * (own.min(axis=0) + own.max(axis=0))
        rows = self.shapes
        rows.kinds[slot], rows.bodies[slot] = part.kind, body
        rows.starts[slot], rows.counts[slot], rows.radii[slot] = start, count, part.radius
        material = shape.material
        rows.frictions[slot], rows.restitutions[slot] = material.friction, material.restitution
        rows.densities[slot] = material.density
        rows.categories[slot], rows.masks[slot] = material.category, material.mask
        rows.sizes[slot] = part.radius + float(elementwise.hypot(*(own - middle).T).max())
        reach = part.radius + float(elementwise.hypot(*own.T).max())
        self.bodies.reaches[body] = max(float(self.bodies.reaches[body]), reach)
        core = _core(part)
        before = float(self.bodies.cores[body])
        self.bodies.cores[body] = core if before == 0.0 else min(before, core)

    def remove_body(self, body: int) -> None:
        """Take a body away, with its shapes. ValueError for an id that none has."""
        self._known(body)
        contacts = self.contacts
        touching = contacts.bodies[contacts.marks[:, state.TOUCHING] == 1]
        self.bodies.flags[touching[(touching == body).any(axis=1)].ravel()] |= state.WAKING
        gone = self.shapes_of(body)
        for slot in gone.tolist():
            self._runs.setdefault(int(self.shapes.counts[slot]), []).append(int(self.shapes.starts[slot]))
            self._shapes.release(slot)
        self._forget_contacts(gone)
        self._bodies.release(body)
        self._changed()

    def _forget_contacts(self, gone: NDArray[np.int64]) -> None:
        """Drop the pairs of shapes that are gone; the next step orders those that are left."""
        contacts = self.contacts
        left = ~np.isin(contacts.shapes, gone).any(axis=1)
        count = int(left.sum())
        for mine, rows in zip(arrays_of(self._contacts)[1:], arrays_of(contacts)[1:], strict=True):
            mine[:count] = rows[left]
        self._contacts.count[0] = count

    def set_kind(self, body: int, kind: str) -> None:
        """Make a body dynamic, fixed or key-framed; pose, velocity and spin are kept, but a fixed one stops.

        ValueError for a kind that there is not, or a dynamic body without mass.
        """
        self._known(body)
        if kind not in KINDS:
            raise ValueError(f"kind = {kind!r}: expected one of {', '.join(KINDS)}")
        rows = self.bodies
        mass, inertia = self._masses[body]
        if kind == "dynamic" and not (mass > 0.0 and inertia > 0.0):
            raise ValueError(f"body {body}: its shapes have no mass, so it cannot be dynamic")
        rows.flags[body] = KINDS[kind] | (rows.flags[body] & state.RESTLESS)
        dynamic = kind == "dynamic"
        rows.inverse_masses[body] = 1.0 / mass if dynamic else 0.0
        rows.inverse_inertias[body] = 1.0 / inertia if dynamic else 0.0
        if kind == "fixed":
            rows.velocities[body], rows.spins[body] = 0.0, 0.0
        self._stale = True
        self.wake(body)

    def set_material(
        self,
        body: int,
        *,
        density: float | None = None,
        friction: float | None = None,
        restitution: float | None = None,
    ) -> None:
        """Another density of its first shape (kg/m²; the others keep their ratios to it), friction (1), or
        restitution (1) of all shapes. None: as it is. Velocity and spin are kept. ValueError.
        """
        self._known(body)
        shapes, rows, slots = self.shapes, self.bodies, self.shapes_of(body)
        if density is not None:
            wanted = checked_number("density", density, 0.0, 1e12, above=True)
            times = wanted / float(shapes.densities[slots[0]])
            mass, inertia = (self._masses[body] * times).tolist()
            if rows.flags[body] & state.DYNAMIC:
                if not (min(mass, inertia) > 1e-200 and math.isfinite(mass + inertia)):
                    raise ValueError(f"density = {density!r}: too small or too large for a mass")
                rows.inverse_masses[body], rows.inverse_inertias[body] = 1.0 / mass, 1.0 / inertia
            shapes.densities[slots] *= times
            shapes.densities[slots[0]] = wanted
            self._masses[body] = mass, inertia
        if friction is not None:
            shapes.frictions[slots] = checked_number("friction", friction, 0.0, 1e9)
        if restitution is not None:
            shapes.restitutions[slots] = checked_number("restitution", restitution, 0.0, 1.0)
        self.wake(body)

    def set_pose(self, body: int, position: ArrayLike, angle: float) -> None:
        """Put a body elsewhere at once: centre of mass m, angle rad. ValueError."""
        self._known(body)
        self.bodies.positions[body] = checked_pair("position", position)
        turn = checked_number("angle", angle, -LARGEST, LARGEST)
        self.bodies.angles[body] = turn
        self.bodies.rotations[body] = elementary.cos(turn), elementary.sin(turn)
        contacts = self.contacts
        contacts.marks[(contacts.bodies == body).any(axis=1), state.FOUND] = (
            0  # what overlaps now was put there
        )
        self.wake(body)

    def set_velocity(self, body: int, velocity: ArrayLike, spin: float = 0.0) -> None:
        """Velocity m/s of the centre of mass and spin rad/s; of a key-framed body: until it is told
        otherwise.
        """
        self._known(body)
        if not self.bodies.flags[body] & (state.DYNAMIC | state.KEY_FRAMED):
            raise ValueError(f"body {body}: it is fixed")
        self.bodies.velocities[body] = checked_pair("velocity", velocity, FASTEST)
        self.bodies.spins[body] = checked_number("spin", spin, -FASTEST, FASTEST)
        self.wake(body)

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike) -> None:
        """An impulse (2,) N s at a point (2,) m of the world; nothing to what is not dynamic. ValueError."""
        self._known(body)
        x, y = checked_pair("point", point)
        jx, jy = checked_pair("impulse", impulse, 1e12)
        rows = self.bodies
        rx, ry = x - rows.positions[body, 0], y - rows.positions[body, 1]
        rows.velocities[body] += rows.inverse_masses[body] * np.array([jx, jy])
        rows.spins[body] += rows.inverse_inertias[body] * (rx * jy - ry * jx)
        self.wake(body)

    def add_force(self, body: int, force: ArrayLike, torque: float = 0.0) -> None:
        """A force N and torque N m, of the next step only. ValueError."""
        self._known(body)
        fx, fy = checked_pair("force", force, 1e12)
        self.bodies.forces[body] += fx, fy, checked_number("torque", torque, -1e12, 1e12)
        self.wake(body)

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """1/m (1/kg), 1/I (1/(kg m²)) and the centre of mass (m)."""
        self._known(body)
        x, y = self.bodies.positions[body].tolist()
        return float(self.bodies.inverse_masses[body]), float(self.bodies.inverse_inertias[body]), (x, y)

    def wake(self, body: int) -> None:
        """Wake a body and all that touch it, or each other, or are joined to it, at the next step."""
        self._known(body)
        self.bodies.flags[body] |= state.WAKING


def _core(part: Part) -> float:
    """Half the least width of a part, m."""
    if len(part.corners) == 1:
        return part.radius
    if part.kind == state.SEGMENT:
        return 0.0
    normals = outward_normals(part.kind, part.corners)
    heights = (normals * part.corners).sum(axis=1)[:, None] - linear.product(normals, part.corners.T)
    return part.radius + 0.5 * float(heights.max(axis=1).min())
