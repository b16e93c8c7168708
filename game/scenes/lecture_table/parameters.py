"""The parameters of the lecture's model of a table, and the settings that they make together."""

from __future__ import annotations

from game.billiards.lecture.settings import (
    CONSERVING,
    DEFAULTS,
    FRICTION_LAWS,
    ORDERS,
    PAIRWISE,
    REPOSITIONINGS,
    RULES,
    LectureSettings,
    lecture_settings,
)
from game.stage import Choice, Param, Parameters, Toggle


class LectureTableParameters(Parameters):
    """What of the model can be chosen; the defaults are those of the settings of the lecture's table."""

    rule = Choice(
        RULES[DEFAULTS.rule],
        RULES,
        labels=("Conserving", "Scaled", "As printed"),
        group="Collision",
        help="restitution on the normal part; both velocities scaled; the printed listing",
    )
    order = Choice(
        ORDERS[DEFAULTS.order],
        ORDERS,
        labels=("Jointly", "Pair by pair"),
        group="Collision",
        help="contacts of one moment solved together, or one pair after the other by number",
    )
    restitution = Param(
        DEFAULTS.restitution, 0.0, 1.0, group="Collision", help="normal speed kept when two balls collide"
    )
    passes = Param(
        DEFAULTS.passes, 1, 50, whole=True, group="Collision", help="rounds of moving overlapping balls apart"
    )

    bounce = Param(
        DEFAULTS.bounce, 0.0, 1.0, group="Cushions", label="Bounce factor", help="speed kept at a cushion"
    )
    repositioning = Choice(
        REPOSITIONINGS[DEFAULTS.repositioning],
        REPOSITIONINGS,
        group="Cushions",
        help="where a ball is put that overshot: where it would be, mirrored, or at the wall",
    )

    friction = Param(
        DEFAULTS.friction,
        0.9,
        1.0,
        group="Cloth",
        label="Friction factor",
        help="speed kept from frame to frame, at 60 frames a second",
    )
    friction_law = Choice(
        FRICTION_LAWS[DEFAULTS.friction_law],
        FRICTION_LAWS,
        labels=("Per second", "Per frame"),
        group="Cloth",
        help="the same slowing at any step length, or the factor once each step as printed",
    )
    minimum_speed = Param(
        DEFAULTS.minimum_speed, 0.0, 0.5, unit="m/s", group="Cloth", help="what is slower stops"
    )

    step_length = Param(1 / 120, 1 / 2000, 1 / 20, unit="s", log=True, group="Time", label="Step")
    substeps = Param(
        DEFAULTS.substeps,
        0,
        64,
        whole=True,
        group="Time",
        help="parts of a step; 0: as many as keep a ball from moving over half its radius in one",
    )

    radius_spread = Param(0.0, 0.0, 0.4, group="Balls", rebuild=True, help="how much the radii differ")
    mass_spread = Param(0.0, 0.0, 0.9, group="Balls", rebuild=True, help="how much the densities differ")

    aim_line = Toggle(
        True, group="Balls", label="Aim line", help="ghost ball and the straight lines after it"
    )

    @property
    def settings(self) -> LectureSettings:
        """What is chosen, as the table takes it."""
        chosen = {name: value for name, value in self.values.items() if name in LectureSettings._fields}
        if (
            self.rule != RULES[CONSERVING]
        ):  # a joint solution is one of impulses, which other rules do not know
            chosen["order"] = ORDERS[PAIRWISE]
        return lecture_settings(**chosen)
