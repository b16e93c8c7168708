"""What a person says about a joint, checked."""

from __future__ import annotations

import math
from dataclasses import dataclass

from game.physics.kernels import elementary
from game.physics.solids.arrays import layout
from game.physics.solids.arrays.layout import Joints
from game.physics.solids.outlines import LARGEST
from game.physics.solids.shapes import checked_number, checked_pair

FASTEST = 1e6  # m/s, rad/s
WITH_LIMITS = (layout.PIN, layout.SLIDER, layout.MOTOR, layout.DISTANCE, layout.SPRING)


@dataclass(frozen=True, slots=True)
class JointOptions:
    """Beside kind, bodies and anchors. ValueError, naming the field, for nonsense.

    length: m, of a distance, rope or spring; None: as it is now. axis: of a slider, in the world, any length
    but 0. limits: lower and upper, rad of a pin or motor: turn of b against a, from how they stand now. In m
    of a slider (from its anchors on), of a distance and a spring (its length). hertz Hz and damping (of
    critical): compliance, by the masses of both bodies at the joint; 0: stiff; a spring needs one. speed m/s
    or rad/s and most N or N m: drive of a motor, and of a pin or slider if either is given (speed 0: a
    brake); most is also the force of a mouse. break_force N, break_torque N m. colliding: the two bodies also
    touch.
    """

    length: float | None = None
    axis: tuple[float, float] = (1.0, 0.0)
    limits: tuple[float, float] = (-math.inf, math.inf)
    hertz: float = 0.0
    damping: float = 1.0
    speed: float = 0.0
    most: float = math.inf
    break_force: float = math.inf
    break_torque: float = math.inf
    colliding: bool = False

    def __post_init__(self) -> None:
        if self.length is not None:
            checked_number("length", self.length, 0.0, LARGEST)
        if not elementary.length(*checked_pair("axis", self.axis)) > 0.0:
            raise ValueError(f"axis = {self.axis!r}: expected a direction")
        try:
            low, high = (float(limit) for limit in self.limits)
        except (TypeError, ValueError):
            raise ValueError(f"limits = {self.limits!r}: expected two numbers") from None
        if not low <= high:
            raise ValueError(f"limits = {self.limits!r}: expected lower, upper")
        checked_number("hertz", self.hertz, 0.0, 1e6)
        checked_number("damping", self.damping, 0.0, 1e3)
        checked_number("speed", self.speed, -FASTEST, FASTEST)
        checked_number("most", self.most, 0.0, math.inf)
        checked_number("break_force", self.break_force, 0.0, math.inf, above=True)
        checked_number("break_torque", self.break_torque, 0.0, math.inf, above=True)

    @classmethod
    def of(cls, joints: Joints, slot: int) -> JointOptions:
        """Those of a joint as it is now, with its length, and its axis in the frame of its first body."""
        own, flags = joints.parameters[slot], int(joints.flags[slot])
        rows = (layout.LOWER, layout.UPPER, layout.AXIS_X, layout.AXIS_Y)
        low, high, x, y = (float(own[row]) for row in rows)
        return cls(
            length=float(own[layout.LENGTH]), axis=(x, y), limits=(low, high),
            hertz=float(own[layout.HERTZ]), damping=float(own[layout.DAMPING]),
            speed=float(own[layout.SPEED]), most=float(own[layout.MOST]),
            break_force=float(own[layout.BREAK_FORCE]), break_torque=float(own[layout.BREAK_TORQUE]),
            colliding=bool(flags & layout.COLLIDING),
        )  # fmt: skip

    def direction(self) -> tuple[float, float]:
        """The axis, of length 1."""
        x, y = self.axis
        size = elementary.hypot(x, y)
        return x / size, y / size

    def write(self, joints: Joints, slot: int) -> None:
        """Into the row of a joint whose kind stands there. ValueError for what its kind does not have."""
        kind, own = int(joints.kinds[slot]), joints.parameters[slot]
        limited = math.isfinite(self.limits[0]) or math.isfinite(self.limits[1])
        if limited and kind not in WITH_LIMITS:
            raise ValueError("limits: only a pin, slider, motor, distance or spring has them")
        if kind == layout.SPRING and not self.hertz > 0.0:
            raise ValueError(f"hertz = {self.hertz!r}: expected above 0 for a spring")
        driven = kind == layout.MOTOR or (
            kind in (layout.PIN, layout.SLIDER) and (self.speed != 0.0 or math.isfinite(self.most))
        )
        joints.flags[slot] = (
            layout.COLLIDING * self.colliding + layout.LIMITED * limited + layout.DRIVEN * driven
        )
        own[layout.LOWER], own[layout.UPPER] = self.limits
        own[layout.HERTZ], own[layout.DAMPING] = self.hertz, self.damping
        own[layout.SPEED], own[layout.MOST] = self.speed, self.most
        own[layout.BREAK_FORCE], own[layout.BREAK_TORQUE] = self.break_force, self.break_torque
