"""What is measured of the motion."""

from __future__ import annotations

import math

from game.scenes.key_frames.animation import TOP_SPEED
from game.scenes.key_frames.model import KeyFrameModel
from game.stage import Readout


def readouts_of(model: KeyFrameModel) -> list[Readout]:
    """What is measured, the speed first."""
    animation, player = model.animation(), model.player
    x, y, angle = model.pose.tolist()
    turned = math.degrees(angle)
    speed = float(animation.playback.speed(player.shown_part()))
    return [
        Readout("speed", min(speed, TOP_SPEED), "m/s"),
        Readout("on the slider", player.present(), "s"),
        Readout("angle", turned - 360.0 * math.ceil(turned / 360.0 - 0.5), "°"),
        Readout("frame", player.frame()),
        Readout("x", x, "m"),
        Readout("y", y, "m"),
        Readout("keys", len(model.motion.keys)),
        Readout("path length", animation.length, "m"),
        Readout("velocity jump", animation.velocity_jump, "m/s"),
        Readout("lines", sum(len(chain) - 1 for chain in animation.chains(model.parameters.tolerance))),
    ]
