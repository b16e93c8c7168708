"""What joints are made of: one row for each, whatever its kind."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

NO_JOINT = -1
PIN, SLIDER, WELD, DISTANCE, ROPE, SPRING, MOTOR, MOUSE = range(8)
JOINT_NAMES = ("pin", "slider", "weld", "distance", "rope", "spring", "motor", "mouse")
# flags
COLLIDING, LIMITED, DRIVEN, BROKEN = 1, 2, 4, 8
# columns of Joints.parameters: angle (rad) and axis (in the frame of a) at rest; length m; limits m or rad;
# compliance as frequency (Hz, 0: as stiff as the solver makes joints) and damping (of critical); drive:
# speed m/s or rad/s and most force N or torque N m; breaking loads N and N m; where a mouse pulls to, m
(
    ANGLE, AXIS_X, AXIS_Y, LENGTH, LOWER, UPPER, HERTZ, DAMPING, SPEED, MOST, BREAK_FORCE, BREAK_TORQUE,
    TARGET_X, TARGET_Y,
) = range(14)  # fmt: skip
PARAMETERS = 14
# columns of Joints.impulses, N s and N m s of the last substep: along x, y (or the axis), turning, drive,
# limits
PULL_X, PULL_Y, TURN, DRIVE, LOW, HIGH = range(6)
IMPULSES = 6
# columns of Joints.rows: levers (world frame, of the step's beginning), offset of b's centre from a's, and
# inverse masses; rate, mass and give of its spring; from FREE on, each kind's own
JAX, JAY, JBX, JBY, OFFSET_X, OFFSET_Y, JIMA, JIIA, JIMB, JIIB, RATE, MASS, GIVE, FREE = range(14)
SUBSTEP = 19  # s, length of a substep; negative: switched off in this step
JOINT_ROW = 20


class Joints(NamedTuple):
    """j joints; a slot that is not in use has the kind NO_JOINT."""

    kinds: Ints  # (j,)
    flags: Ints  # (j,)
    bodies: Ints  # (j, 2)
    anchors: Floats  # (j, 4) m, in the frames of both bodies
    parameters: Floats  # (j, PARAMETERS)
    impulses: Floats  # (j, IMPULSES)
    rows: Floats  # (j, JOINT_ROW) work of one step
