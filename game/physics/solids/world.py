"""A world of solids: owns the arrays, checks what comes in, steps."""

from __future__ import annotations

import contextlib
import dataclasses
import math
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.compiler.entrances import Entrances
from game.physics.kernels import elementary
from game.physics.kernels.limits import LimitError
from game.physics.solids import memory, stepping
from game.physics.solids.arrays import layout
from game.physics.solids.arrays.layout import JOINT_NAMES
from game.physics.solids.arrays.plan import plan_joints
from game.physics.solids.arrays.state import (
    ASLEEP,
    DYNAMIC,
    KEY_FRAMED,
    WAKING,
)
from game.physics.solids.bodies import FASTEST, SolidBodies
from game.physics.solids.effects import JOINTS, WIND_BIT
from game.physics.solids.energy import Energy, energy_of
from game.physics.solids.joints.lines import load_of
from game.physics.solids.joints.options import JointOptions
from game.physics.solids.settings import GOVERNED, SolidSettings
from game.physics.solids.shapes import (
    checked_number,
    checked_pair,
)
from game.physics.solids.solvers import LIMITED, SOLVERS, UNJOINED
from game.physics.solids.stepping import begin_step, fill_rows, finish_step, renew_pairs
from game.physics.solids.store import arrays_of

TRIED_S = 1.0 / 60.0  # of the step that tries a solver


class Air(Protocol):
    """A field of velocities of the air, such as those of physics.surfaces."""

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """Velocities (n, 2) m/s at points (n, 2) m."""
        ...


class NotFiniteError(ArithmeticError):
    """A step made a number that is not finite; the message names the body, the quantity and the step."""


class RunawayError(ArithmeticError):
    """A step made a body faster than any can be; the message names the body, its speed and the step."""


class SolidWorld(SolidBodies):
    """Bodies of any shape that touch, are joined, and move.

    Ids of bodies, shapes and joints stay what they are until these are removed. A body's position is its
    centre of mass; ``origin(body)`` is where the origin of its shapes' coordinates is. settings:
    `SolidSettings`.
    """

    def __init__(self, settings: SolidSettings | None = None):
        super().__init__()
        self._air: Air | None = None
        self._entrances = Entrances()
        self.settings = settings or SolidSettings()

    # ------------------------------------------------------------------ what there is

    @property
    def settings(self) -> SolidSettings:
        """What a step does; may be replaced at any time.

        ValueError for a solver that there is not, LimitError for one that cannot take what touches now.
        """
        return self._settings

    @settings.setter
    def settings(self, settings: SolidSettings) -> None:
        if settings.solver not in SOLVERS:
            raise ValueError(f"solver = {settings.solver!r}: expected one of {', '.join(SOLVERS)}")
        before = getattr(self, "_settings", settings)
        self._settings = settings
        if settings.solver != before.solver:
            try:
                self.check_solver()
            except LimitError:
                self._settings = before
                raise
        if settings.solver != GOVERNED:
            self.bodies.stored[:] = 0.0  # no other solver knows of it
        self.bodies.flags[self.ids()] |= WAKING
        self._numbers: Any = None
        self._fitting = False

    def check_solver(self) -> None:
        """LimitError if the solver cannot take what touches now: found by a step of another such world."""
        if self._settings.solver in LIMITED and len(self.ids()):
            other = SolidWorld(self._settings)
            other.restore(self.state())
            with contextlib.suppress(NotFiniteError):  # that is another matter, said by the step itself
                other.step(TRIED_S)

    def set(self, **changes: Any) -> None:
        """Change some of the settings. ValueError, naming the field, for nonsense."""
        self.settings = dataclasses.replace(self._settings, **changes)

    def set_air(self, air: Air | None) -> None:
        """How the air moves, felt by way of drag while the effect of wind is on; None: it is still."""
        self._air = air
        for body in self.ids().tolist():
            self.wake(body)

    # ------------------------------------------------------------------ joints

    def add_joint(
        self,
        kind: str,
        body_a: int,
        body_b: int,
        anchor_a: ArrayLike,
        anchor_b: ArrayLike | None = None,
        **options: Any,
    ) -> int:
        """Join two bodies; the joint's id.

        kind: of JOINT_NAMES. anchors: points of the world, m, as the bodies stand now (anchor_b: where
        anchor_a
        is). options: of `JointOptions`. ValueError: a body with itself, two that nothing moves, nonsense.
        """
        given = JointOptions(**options)
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
        rows.kinds[slot] = JOINT_NAMES.index(kind)
        rows.bodies[slot] = body_a, body_b
        try:
            given.write(rows, slot)
        except ValueError:
            self._joints.release(slot)
            raise
        rows.anchors[slot] = *self.local(body_a, a), *self.local(body_b, b)
        own = rows.parameters[slot]
        own[layout.ANGLE] = self.bodies.angles[body_b] - self.bodies.angles[body_a]
        own[layout.LENGTH] = elementary.dist(a, b) if given.length is None else given.length
        (c, s), (x, y) = self.bodies.rotations[body_a].tolist(), given.direction()
        own[layout.AXIS_X], own[layout.AXIS_Y] = c * x + s * y, c * y - s * x
        own[layout.TARGET_X], own[layout.TARGET_Y] = b
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

    def joint_options(self, joint: int) -> JointOptions:
        """What a joint has besides its kind, bodies and anchors. ValueError for an id that none has."""
        self._known_joint(joint)
        return JointOptions.of(self.joints, joint)

    def change_joint(self, joint: int, **changes: Any) -> None:
        """Other limits, compliance, drive or breaking loads: fields of `JointOptions`, but for length and
        axis, which stay. ValueError, and nothing is changed, for nonsense and for what its kind has not.
        """
        changed = dataclasses.replace(self.joint_options(joint), **changes)
        broken = self.joints.flags[joint] & (layout.BROKEN | layout.JUST_BROKEN)
        changed.write(self.joints, joint)
        self.joints.flags[joint] |= broken
        for body in self.joints.bodies[joint].tolist():
            self.wake(body)
        self._exclude()

    def drive(self, joint: int, speed: float, most: float | None = None) -> None:
        """Another speed (m/s, rad/s) of a joint that is driven, and most force or torque. ValueError."""
        self._known_joint(joint)
        if not self.joints.flags[joint] & layout.DRIVEN:
            raise ValueError(f"joint {joint}: it has no drive")
        own = self.joints.parameters[joint]
        own[layout.SPEED] = checked_number("speed", speed, -FASTEST, FASTEST)
        if most is not None:
            own[layout.MOST] = checked_number("most", most, 0.0, math.inf)
        for body in self.joints.bodies[joint].tolist():
            self.wake(body)

    def joints_broken(self) -> NDArray[np.int64]:
        """Ids of the joints that broke in the last step."""
        return np.flatnonzero(self.joints.flags & layout.JUST_BROKEN)

    def remove_body(self, body: int) -> None:
        """Take a body away, with its shapes and joints. ValueError for an id that none has."""
        self._known(body)
        own = (self.joints.bodies == body).any(axis=1) & (self.joints.kinds != layout.NO_JOINT)
        for joint in np.flatnonzero(own).tolist():
            self.remove_joint(joint)
        super().remove_body(body)

    def drag_to(self, joint: int, target: ArrayLike) -> None:
        """Where a mouse pulls to, m. ValueError."""
        self._known_joint(joint)
        own = self.joints.parameters[joint]
        own[layout.TARGET_X], own[layout.TARGET_Y] = checked_pair("target", target)
        self.wake(int(self.joints.bodies[joint, 1]))

    def joint_load(self, joint: int) -> tuple[float, float]:
        """Force N and torque N m that a joint carried in the last substep in which its bodies were awake."""
        self._known_joint(joint)
        h = self._numbers.h if self._numbers else 1.0
        whole = not self.joints.flags[joint] & layout.BROKEN and JOINTS in self._settings.effects
        flags = self.bodies.flags[self.joints.bodies[joint]]
        awake = (flags & (DYNAMIC | ASLEEP)) == DYNAMIC
        force, torque = load_of(self.joints, joint, bool(whole and not awake.any()))
        return float(force / h), float(torque / h)

    def _exclude(self) -> None:
        """Pairs of bodies that joints keep from touching, as sorted keys."""
        rows = self.joints
        shy = (rows.kinds != layout.NO_JOINT) & (rows.flags & (layout.COLLIDING | layout.BROKEN) == 0)
        low, high = rows.bodies[shy].min(axis=1), rows.bodies[shy].max(axis=1)
        self._excluded = np.unique(low.astype(np.int64) << 32 | high)
        self._stale, self._fitting = True, False

    # ------------------------------------------------------------------ steps

    def step(self, dt: float) -> None:
        """One step of dt (s). ValueError for dt or the air; NotFiniteError if a body is no longer finite,
        RunawayError if its solver has made it faster than `RUNAWAY`.
        """
        if self._numbers is None or self._numbers.dt != dt:
            self._numbers = self._settings.numbers(checked_number("dt", dt, 0.0, 1e3, above=True))
            self._entrances.forget()
        if not self._fitting:
            self._fit()
        numbers = self._numbers
        call, joints = self._entrances.call, self._joints.rows
        parts = self._bodies.rows, self._shapes.rows, self._pool.rows
        if self._stale or not call(
            begin_step, *parts, self._contacts, self._rows, joints, self._scratch, numbers
        ):
            self._renew()
            call(begin_step, *parts, self._contacts, self._rows, joints, self._scratch, numbers)
        if not numbers.abreast:
            call(fill_rows, self._rows, self._scratch)
        if numbers.drag > 0.0 or numbers.spin_drag > 0.0:
            self._feel_air(numbers.mask)
        name = self._settings.solver
        solve = SOLVERS[name] if self._joints.top else UNJOINED.get(name, SOLVERS[name])
        call(solve, self._bodies.rows, self._contacts, self._rows, joints, self._scratch, numbers)
        call(finish_step, *parts, self._contacts, self._rows, joints, self._scratch, numbers)
        self.time += dt
        self.steps += 1
        if self._scratch.events[stepping.SNAPPED]:
            self._exclude()
        if self._scratch.events[stepping.WRONG] != stepping.NOTHING_WRONG:
            raise self._wrong(int(self._scratch.events[stepping.WRONG]))

    def _wrong(self, body: int) -> ArithmeticError:
        """What a step has made of a body: a quantity that is not finite, or a speed that runs away."""
        rows = self.bodies
        for name in ("positions", "angles", "velocities", "spins"):
            if not np.isfinite(getattr(rows, name)[body]).all():
                return NotFiniteError(f"body {body}: {name} not finite after step {self.steps}")
        (x, y), spin = np.abs(rows.velocities[body]).tolist(), abs(float(rows.spins[body]))
        found = f"{max(x, y):.3g} m/s" if max(x, y) > stepping.RUNAWAY else f"{spin:.3g} rad/s"
        return RunawayError(
            f"body {body}: {found} after step {self.steps}: the solver {self._settings.solver} runs away"
        )

    def _feel_air(self, mask: int) -> None:
        """Velocities of the air about all bodies, as they are when a step begins."""
        self._scratch.air[:, :2] = 0.0
        if self._air is None or not mask & WIND_BIT:
            return
        rows = self.ids()
        speeds = np.asarray(self._air.sample(self.bodies.positions[rows], self.time), dtype=np.float64)
        if speeds.shape != (len(rows), 2) or not np.isfinite(speeds).all():
            raise ValueError(f"air: expected finite velocities ({len(rows)}, 2)")
        self._scratch.air[rows, :2] = speeds

    def _renew(self) -> None:
        """Find pairs again; space for them doubles where it is too small."""
        while True:
            found = renew_pairs(
                self._bodies.rows, self._shapes.rows, self._pool.rows, self._contacts, self._spare,
                self._excluded, self._scratch, self._numbers,
            )  # fmt: skip
            if found <= len(self._contacts.shapes):
                break
            room = max(found, 2 * len(self._contacts.shapes))
            larger = memory.contacts_of(room)
            for new, old in zip(arrays_of(larger), arrays_of(self._contacts), strict=True):
                new[: len(old)] = old
            self._contacts, self._spare, self._rows = larger, memory.contacts_of(room), memory.rows_of(room)
            self._fit()
        self._stale = False

    def _fit(self) -> None:
        """Scratch memory that fits the tables."""
        self._scratch = memory.scratch_of(
            self._bodies.top, self._shapes.top, len(self._contacts.shapes), self._joints.top
        )
        if self._settings.joint_solver == "direct":
            moving = self.bodies.flags & (DYNAMIC | KEY_FRAMED) != 0
            self._scratch = self._scratch._replace(plan=plan_joints(self.joints, moving))
        self._fitting = True
        self._entrances.forget()

    # ------------------------------------------------------------------ events, measures, state

    def energy(self) -> Energy:
        """Of motion and of height, J."""
        return energy_of(self.bodies, self._settings.numbers(1.0))

    def contacts_begun(self) -> tuple[NDArray[np.int32], Floats]:
        """Contacts that began in the last step: shapes (e, 2); x, y m, impulse N s, speed m/s, s from
        the step's beginning (e, 5).
        """
        count = min(int(self._scratch.events[stepping.BEGUN]), memory.EVENTS)
        return self._scratch.begun[:count].copy(), self._scratch.begun_places[:count].copy()
