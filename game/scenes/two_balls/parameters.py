"""The parameters of the two-ball program: its collision, its balls, its window, and what is shown."""

from __future__ import annotations

from game.billiards.lecture.settings import RULES
from game.stage import Choice, Param, Parameters, Toggle


class LectureBallsParameters(Parameters):
    """What of the program can be chosen."""

    rule = Choice(
        "conserving",
        RULES,
        labels=("Conserving", "Scaled", "As printed"),
        group="Collision",
        help="restitution on the normal part; both velocities scaled; or the printed listing",
    )
    restitution = Param(
        0.9,
        0.0,
        1.0,
        group="Collision",
        help="of the normal speed, kept in a collision (bounce_loss in the listing)",
    )
    hold = Param(
        2.5,
        0.0,
        10.0,
        unit="s",
        group="Collision",
        label="Hold",
        help="how long a collision is held to be looked at",
    )
    radius_1 = Param(34.0, 5.0, 90.0, unit="px", group="Balls", label="Radius of 1", rebuild=True)
    radius_2 = Param(34.0, 5.0, 90.0, unit="px", group="Balls", label="Radius of 2", rebuild=True)
    mass_ratio = Param(
        1.0, 0.01, 100.0, log=True, group="Balls", rebuild=True, help="mass of ball 2 over mass of ball 1"
    )
    acceleration = Param(
        0.0,
        0.0,
        5.0,
        unit="px/frame²",
        group="Motion",
        help="added to the velocity of both balls in every frame",
    )
    direction = Param(
        90.0, -180.0, 180.0, unit="°", group="Motion", label="Its direction",
        help="of the acceleration, from the x axis; y points down, so 90° is downwards",
    )  # fmt: skip
    deceleration = Param(
        0.0, 0.0, 5.0, unit="px/frame²", group="Motion",
        help="taken from the speed in every frame, until the ball stands",
    )  # fmt: skip
    bounce = Param(0.9, 0.0, 1.0, group="Window", label="Bounce factor", help="speed kept at a wall")
    friction = Param(
        0.996, 0.8, 1.0, group="Window", label="Friction factor", help="speed kept from frame to frame"
    )
    minimum_speed = Param(0.15, 0.0, 5.0, unit="px/frame", group="Window", help="what is slower stops")
    units = Choice(
        "pixels", ("pixels", "metres"), group="Shown", help="pixels per frame as in the lecture, or SI"
    )
    vectors = Toggle(True, group="Shown", label="Velocities", help="arrows; drag their heads")
    again = Toggle(True, group="Shown", label="Start again", help="set off again when both balls rest")
