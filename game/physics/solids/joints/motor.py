"""Motor: a pin that turns b against a at a speed, by no more than a torque."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.joints.pin import write_pin


@inner_kernel
def write_motor(joints, k, motion):
    """A pin's lines: that it is driven is in its flags."""
    write_pin(joints, k, motion)
