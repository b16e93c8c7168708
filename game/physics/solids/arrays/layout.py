"""What joints are made of: one row for each, whatever its kind, and the lines that solvers read of it.

A line is one scalar condition: along (UX, UY) at b's point and against it at a's, with the torques LA and LB
for each newton (LA = ra x u for a's lever ra. A turning line has u = 0 and LA = LB = 1). Its speed is u . (vb
- va) + LB wb - LA wa, its gap is what should be zero (EQUAL), not negative (ONE_SIDED), or is nothing (DRIVE:
it asks for a speed, by no more than so much force). An impulse j along it pushes b by j u.
"""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats, Ints

NO_JOINT = -1
PIN, SLIDER, WELD, DISTANCE, ROPE, SPRING, MOTOR, MOUSE = range(8)
JOINT_NAMES = ("pin", "slider", "weld", "distance", "rope", "spring", "motor", "mouse")
# flags; JUST_BROKEN: in the last step
COLLIDING, LIMITED, DRIVEN, BROKEN, JUST_BROKEN = 1, 2, 4, 8, 16
# columns of Joints.parameters: angle (rad) and axis (in the frame of a) at rest; length m; limits m or rad;
# compliance as frequency (Hz, 0: as stiff as the solver makes joints) and damping (of critical); drive:
# speed m/s or rad/s and most force N or torque N m; breaking loads N and N m; where a mouse pulls to, m
(
    ANGLE, AXIS_X, AXIS_Y, LENGTH, LOWER, UPPER, HERTZ, DAMPING, SPEED, MOST, BREAK_FORCE, BREAK_TORQUE,
    TARGET_X, TARGET_Y,
) = range(14)  # fmt: skip
PARAMETERS = 14
# lines of a joint, and columns of Joints.impulses (N s and N m s of the last substep): two along x and y (or
# across the axis, or along the rod), turning, drive, limits from below and above
PULL_X, PULL_Y, TURN, DRIVE, LOW, HIGH = range(6)
IMPULSES = 6
# columns of Joints.rows: levers (world frame, of the step's beginning), offset of b's centre from a's,
# inverse masses; rate, mass and give of its spring (see `settings.soft`); angle of b against a beyond that at
# rest; a slider's axis. OWN: 1 where the compliance is the joint's own. WITH_A: 0 where a has no part in it.
# SUBSTEP: s, its length; negative: switched off in this step
(
    JAX, JAY, JBX, JBY, OFFSET_X, OFFSET_Y, JIMA, JIIA, JIMB, JIIB, RATE, MASS, GIVE, TURNED,
    AXIS_NOW_X, AXIS_NOW_Y, OWN, WITH_A, SUBSTEP,
) = range(19)  # fmt: skip
JOINT_ROW = 19
# kinds of lines, and columns of a line
OFF, EQUAL, ONE_SIDED, DRIVING = 0.0, 1.0, 2.0, 3.0
LINE, UX, UY, LA, LB, LINE_GAP = range(6)
LINE_WIDTH = 6
LINES = IMPULSES * LINE_WIDTH


class Joints(NamedTuple):
    """j joints; a slot that is not in use has the kind NO_JOINT."""

    kinds: Ints  # (j,)
    flags: Ints  # (j,)
    bodies: Ints  # (j, 2)
    anchors: Floats  # (j, 4) m, in the frames of both bodies
    parameters: Floats  # (j, PARAMETERS)
    impulses: Floats  # (j, IMPULSES)
    stiffnesses: Floats  # (j, IMPULSES) N/m that solvers by penalty have come to
    starts: Floats  # (j, IMPULSES) m or rad, gaps when a substep began
    rows: Floats  # (j, JOINT_ROW) work of one step
    lines: Floats  # (j, LINES) work of one sweep
