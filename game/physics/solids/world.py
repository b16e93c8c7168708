"""A world of solids: owns the arrays, checks what comes in, steps."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.solids import memory
from game.physics.solids.joints.layout import (
    ANGLE,
    BREAK_FORCE,
    BREAK_TORQUE,
    BROKEN,
    COLLIDING,
    DAMPING,
    HERTZ,
    JOINT_NAMES,
    LENGTH,
    LOWER,
    MOST,
    NO_JOINT,
    PULL_X,
    PULL_Y,
    SPEED,
    TARGET_X,
    TARGET_Y,
    TURN,
    UPPER,
    Joints,
)
from game.physics.solids.outlines import LARGEST
from game.physics.solids.settings import SolidSettings
from game.physics.solids.shapes import (
    Part,
    Shape,
    checked_number,
    checked_pair,
    outward_normals,
    parts_mass,
)
from game.physics.solids.solvers import SOLVERS
from game.physics.solids.state import (
    DYNAMIC,
    KEY_FRAMED,
    NONE,
    RESTLESS,
    SEGMENT,
    TOUCHING,
    USED,
    WAKING,
    Bodies,
    Contacts,
    Pool,
    Shapes,
)
from game.physics.solids.stepping import (
    BEGUN,
    NOTHING_WRONG,
    SNAPPED,
    WRONG,
    begin_step,
    finish_step,
    renew_pairs,
)

Floats = NDArray[np.float64]
KINDS = {"fixed": USED, "dynamic": USED | DYNAMIC, "key-framed": USED | KEY_FRAMED}
FASTEST = 1e6  # m/s, rad/s


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


class NotFiniteError(ArithmeticError):
    """A step made a number that is not finite; the message names the body, the quantity and the step."""


class SolidWorld:
    """Bodies of any shape that touch, are joined, and move.

    Ids of bodies, shapes and joints stay what they are until these are removed. A body's position is its
    centre
    of mass; ``origin(body)`` is where the origin of its shapes' coordinates is. settings: `SolidSettings`.
    """

    def __init__(self, settings: SolidSettings | None = None):
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
        self.settings = settings or SolidSettings()

    # ------------------------------------------------------------------ what there is

    @property
    def settings(self) -> SolidSettings:
        """What a step does; may be replaced at any time. ValueError for a solver that there is not."""
        return self._settings

    @settings.setter
    def settings(self, settings: SolidSettings) -> None:
        if settings.solver not in SOLVERS:
            raise ValueError(f"solver = {settings.solver!r}: expected one of {', '.join(SOLVERS)}")
        self._settings = settings
        self.bodies.flags[self.ids()] |= WAKING
        self._numbers: Any = None

    def set(self, **changes: Any) -> None:
        """Change some of the settings. ValueError, naming the field, for nonsense."""
        self.settings = dataclasses.replace(self._settings, **changes)

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
        return Contacts(self._contacts.count, *(array[:count] for array in _arrays(self._contacts)[1:]))

    def ids(self) -> NDArray[np.int64]:
        """Of all bodies, ascending."""
        return np.flatnonzero(self.bodies.flags & USED)

    def shapes_of(self, body: int) -> NDArray[np.int64]:
        """Ids of a body's shapes."""
        self._known(body)
        return np.flatnonzero((self.shapes.bodies == body) & (self.shapes.kinds != NONE))

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
        if self.shapes.kinds[shape] == SEGMENT:
            local = local[1:3]
        body = int(self.shapes.bodies[shape])
        c, s = self.bodies.rotations[body].tolist()
        turned: Floats = local @ np.array([[c, s], [-s, c]]) + self.bodies.positions[body]
        return turned

    # ------------------------------------------------------------------ bodies

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
        c, s = math.cos(turn), math.sin(turn)
        rows.flags[body] = KINDS[kind] | (RESTLESS if restless else 0)
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
        has_chain = any(part.kind == SEGMENT for part, _ in parts)
        self._masses[body] = (0.0, 0.0) if has_chain else (mass.mass, mass.inertia)
        for part, shape in parts:
            self._add_part(body, part, shape, cx, cy)
        self._changed()
        return body

    def _check_dynamic(self, parts: list[Part], mass: float, inertia: float) -> None:
        if any(part.kind == SEGMENT for part in parts):
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
        own = corners[1:3] if part.kind == SEGMENT else corners
        middle = 0.5 * (own.min(axis=0) + own.max(axis=0))
        rows = self.shapes
        rows.kinds[slot], rows.bodies[slot] = part.kind, body
        rows.starts[slot], rows.counts[slot], rows.radii[slot] = start, count, part.radius
        material = shape.material
        rows.frictions[slot], rows.restitutions[slot] = material.friction, material.restitution
        rows.densities[slot] = material.density
        rows.categories[slot], rows.masks[slot] = material.category, material.mask
        rows.sizes[slot] = part.radius + float(np.hypot(*(own - middle).T).max())
        reach = part.radius + float(np.hypot(*own.T).max())
        self.bodies.reaches[body] = max(float(self.bodies.reaches[body]), reach)
        core = _core(part)
        before = float(self.bodies.cores[body])
        self.bodies.cores[body] = core if before == 0.0 else min(before, core)

    def remove_body(self, body: int) -> None:
        """Take a body away, with its shapes and joints. ValueError for an id that none has."""
        self._known(body)
        for joint in np.flatnonzero(
            (self.joints.bodies == body).any(axis=1) & (self.joints.kinds != NO_JOINT)
        ):
            self.remove_joint(int(joint))
        contacts = self.contacts
        touching = contacts.bodies[contacts.marks[:, TOUCHING] == 1]
        self.bodies.flags[touching[(touching == body).any(axis=1)].ravel()] |= WAKING
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
        for mine, rows in zip(_arrays(self._contacts)[1:], _arrays(contacts)[1:], strict=True):
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
        rows.flags[body] = KINDS[kind] | (rows.flags[body] & RESTLESS)
        dynamic = kind == "dynamic"
        rows.inverse_masses[body] = 1.0 / mass if dynamic else 0.0
        rows.inverse_inertias[body] = 1.0 / inertia if dynamic else 0.0
        if kind == "fixed":
            rows.velocities[body], rows.spins[body] = 0.0, 0.0
        self._stale = True
        self.wake(body)

    def set_pose(self, body: int, position: ArrayLike, angle: float) -> None:
        """Put a body elsewhere at once: centre of mass m, angle rad. ValueError."""
        self._known(body)
        self.bodies.positions[body] = checked_pair("position", position)
        turn = checked_number("angle", angle, -LARGEST, LARGEST)
        self.bodies.angles[body] = turn
        self.bodies.rotations[body] = math.cos(turn), math.sin(turn)
        self.wake(body)

    def set_velocity(self, body: int, velocity: ArrayLike, spin: float = 0.0) -> None:
        """Velocity m/s of the centre of mass and spin rad/s; of a key-framed body: until it is told
        otherwise.
        """
        self._known(body)
        if not self.bodies.flags[body] & (DYNAMIC | KEY_FRAMED):
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
        self.bodies.flags[body] |= WAKING

    # ------------------------------------------------------------------ joints

    def add_joint(
        self,
        kind: str,
        body_a: int,
        body_b: int,
        anchor_a: ArrayLike,
        anchor_b: ArrayLike | None = None,
        *,
        length: float | None = None,
        limits: tuple[float, float] = (-math.inf, math.inf),
        hertz: float = 0.0,
        damping: float = 1.0,
        speed: float = 0.0,
        most: float = math.inf,
        break_force: float = math.inf,
        break_torque: float = math.inf,
        colliding: bool = False,
    ) -> int:
        """Join two bodies; the joint's id.

        kind: of JOINT_NAMES. anchors: points of the world, m, as the bodies stand now (anchor_b: where
        anchor_a
        is). length m of a distance (None: as it is now). hertz Hz and damping (of critical): compliance, 0
        for stiff. most: force N (or torque) of a mouse or motor. break_force N, break_torque N m. colliding:
        the two also touch. ValueError: a body with itself, two that nothing moves, nonsense.
        """
        if kind not in JOINT_NAMES:
            raise ValueError(f"kind = {kind!r}: expected one of {', '.join(JOINT_NAMES)}")
        self._known(body_a)
        self._known(body_b)
        if body_a == body_b:
            raise ValueError(f"body_b = {body_b}: a joint joins two different bodies")
        if not (self.bodies.flags[body_a] | self.bodies.flags[body_b]) & DYNAMIC:
            raise ValueError("bodies: one of a joint's two must be dynamic")
        a = checked_pair("anchor_a", anchor_a)
        b = a if anchor_b is None else checked_pair("anchor_b", anchor_b)
        slot = self._joints.take()
        rows = self.joints
        rows.kinds[slot], rows.flags[slot] = JOINT_NAMES.index(kind), COLLIDING if colliding else 0
        rows.bodies[slot] = body_a, body_b
        rows.anchors[slot] = *self.local(body_a, a), *self.local(body_b, b)
        own = rows.parameters[slot]
        own[ANGLE] = self.bodies.angles[body_b] - self.bodies.angles[body_a]
        own[LENGTH] = math.dist(a, b) if length is None else checked_number("length", length, 0.0, LARGEST)
        own[LOWER], own[UPPER] = limits
        own[HERTZ] = checked_number("hertz", hertz, 0.0, 1e6)
        own[DAMPING] = checked_number("damping", damping, 0.0, 1e3)
        own[SPEED] = checked_number("speed", speed, -FASTEST, FASTEST)
        own[MOST] = checked_number("most", most, 0.0, math.inf)
        own[BREAK_FORCE] = checked_number("break_force", break_force, 0.0, math.inf, above=True)
        own[BREAK_TORQUE] = checked_number("break_torque", break_torque, 0.0, math.inf, above=True)
        own[TARGET_X], own[TARGET_Y] = b
        self.wake(body_a)
        self.wake(body_b)
        self._exclude()
        return slot

    def remove_joint(self, joint: int) -> None:
        """Take a joint away. ValueError for an id that none has."""
        self._known_joint(joint)
        for body in self.joints.bodies[joint].tolist():
            self.wake(body)
        self._joints.release(joint)
        self._exclude()

    def drag_to(self, joint: int, target: ArrayLike) -> None:
        """Where a mouse pulls to, m. ValueError."""
        self._known_joint(joint)
        own = self.joints.parameters[joint]
        own[TARGET_X], own[TARGET_Y] = checked_pair("target", target)
        self.wake(int(self.joints.bodies[joint, 1]))

    def joint_load(self, joint: int) -> tuple[float, float]:
        """Force N and torque N m that a joint carried in the last substep."""
        self._known_joint(joint)
        held, h = self.joints.impulses[joint], self._numbers.h if self._numbers else 1.0
        return float(math.hypot(held[PULL_X], held[PULL_Y]) / h), float(abs(held[TURN]) / h)

    def local(self, body: int, point: tuple[float, float]) -> tuple[float, float]:
        """A point of the world (m) in the frame of a body."""
        rows = self.bodies
        c, s = rows.rotations[body].tolist()
        x, y = point[0] - float(rows.positions[body, 0]), point[1] - float(rows.positions[body, 1])
        return c * x + s * y, c * y - s * x

    def _exclude(self) -> None:
        """Pairs of bodies that joints keep from touching, as sorted keys."""
        rows = self.joints
        shy = (rows.kinds != NO_JOINT) & (rows.flags & (COLLIDING | BROKEN) == 0)
        low, high = rows.bodies[shy].min(axis=1), rows.bodies[shy].max(axis=1)
        self._excluded = np.unique(low.astype(np.int64) << 32 | high)
        self._stale = True

    # ------------------------------------------------------------------ steps

    def step(self, dt: float) -> None:
        """One step of dt (s). ValueError for dt; NotFiniteError if the state is no longer finite."""
        if self._numbers is None or self._numbers.dt != dt:
            self._numbers = self._settings.numbers(checked_number("dt", dt, 0.0, 1e3, above=True))
        if not self._fitting:
            self._fit()
        numbers = self._numbers
        parts, joints = (self._bodies.rows, self._shapes.rows, self._pool.rows), self._joints.rows
        if self._stale or not begin_step(*parts, self._contacts, self._rows, joints, self._scratch, numbers):
            self._renew()
            begin_step(*parts, self._contacts, self._rows, joints, self._scratch, numbers)
        SOLVERS[self._settings.solver](self._bodies.rows, self._rows, joints, self._scratch, numbers)
        finish_step(*parts, self._contacts, self._rows, joints, self._scratch, numbers)
        self.time += dt
        self.steps += 1
        if self._scratch.events[SNAPPED]:
            self._exclude()
        if self._scratch.events[WRONG] != NOTHING_WRONG:
            raise NotFiniteError(f"body {self._scratch.events[WRONG]}: not finite after step {self.steps}")

    def _renew(self) -> None:
        """Find pairs again; room for them doubles where it is too small."""
        while True:
            found = renew_pairs(
                self._bodies.rows, self._shapes.rows, self._pool.rows, self._contacts, self._spare,
                self._excluded, self._scratch, self._numbers,
            )  # fmt: skip
            if found <= len(self._contacts.shapes):
                break
            room = max(found, 2 * len(self._contacts.shapes))
            larger = memory.contacts_of(room)
            for new, old in zip(_arrays(larger), _arrays(self._contacts), strict=True):
                new[: len(old)] = old
            self._contacts, self._spare, self._rows = larger, memory.contacts_of(room), memory.rows_of(room)
            self._fit()
        self._stale = False

    def _changed(self) -> None:
        """Bodies or shapes have come or gone."""
        self._stale, self._fitting = True, False

    def _fit(self) -> None:
        """Scratch memory that fits the tables."""
        self._scratch = memory.scratch_of(self._bodies.top, self._shapes.top, len(self._contacts.shapes))
        self._fitting = True

    # ------------------------------------------------------------------ events, measures, state

    def contacts_begun(self) -> tuple[NDArray[np.int32], Floats]:
        """Contacts that began in the last step: shapes (e, 2); x, y m, impulse N s, speed m/s, s from
        the step's beginning (e, 5).
        """
        count = min(int(self._scratch.events[BEGUN]), memory.EVENTS)
        return self._scratch.begun[:count].copy(), self._scratch.begun_places[:count].copy()

    def _tables(self) -> tuple[Any, ...]:
        return self._bodies, self._shapes, self._pool, self._joints

    def state(self) -> SolidState:
        """Copies of all that later steps depend on."""
        tables: list[Any] = [table.copy() for table in self._tables()]
        contacts = Contacts(*(array.copy() for array in _arrays(self.contacts)))
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
        for own, kept in zip(_arrays(self._contacts)[1:], _arrays(state.contacts)[1:], strict=True):
            own[:count] = kept
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
        rows, used = self.bodies, self.bodies.flags & USED != 0
        for name, array in rows._asdict().items():
            assert np.isfinite(array).all(), f"{name} are finite"
        lengths = np.hypot(rows.rotations[used, 0], rows.rotations[used, 1])
        assert np.abs(lengths - 1.0).max(initial=0.0) < 1e-9, "rotations have length 1"
        still = rows.flags & DYNAMIC == 0
        assert not rows.inverse_masses[still].any(), "what is not dynamic has no inverse mass"
        assert (rows.flags[self.shapes.bodies[self.shapes.kinds != NONE]] & USED != 0).all(), (
            "shapes have bodies"
        )

    # ------------------------------------------------------------------ checks

    def _known(self, body: int) -> None:
        if not (0 <= body < self._bodies.top and self._bodies.rows.flags[body] & USED):
            raise ValueError(f"body {body!r}: there is none of this number")

    def _known_shape(self, shape: int) -> None:
        if not (0 <= shape < self._shapes.top and self._shapes.rows.kinds[shape] != NONE):
            raise ValueError(f"shape {shape!r}: there is none of this number")

    def _known_joint(self, joint: int) -> None:
        if not (0 <= joint < self._joints.top and self._joints.rows.kinds[joint] != NO_JOINT):
            raise ValueError(f"joint {joint!r}: there is none of this number")


def _arrays(rows: Any) -> tuple[NDArray[Any], ...]:
    """The arrays of a NamedTuple, whatever their kinds."""
    return tuple(rows)


def _core(part: Part) -> float:
    """Half the least width of a part, m."""
    if len(part.corners) == 1:
        return part.radius
    if part.kind == SEGMENT:
        return 0.0
    normals = outward_normals(part.kind, part.corners)
    heights = (normals * part.corners).sum(axis=1)[:, None] - normals @ part.corners.T
    return part.radius + 0.5 * float(heights.max(axis=1).min())
