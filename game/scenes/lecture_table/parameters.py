"""The parameters of the lecture's model of a table, and the settings that they make together."""

from __future__ import annotations

from game.billiards.lecture.state import (
    FRICTION_LAWS,
    LECTURE_EFFECTS,
    ORDERS,
    REPOSITIONINGS,
    RULES,
    LectureSettings,
)
from game.stage import Choice, Param, Scene


class LectureTableModel(Scene):
    """Base of the scene: what of the model can be chosen."""

    effects = LECTURE_EFFECTS

    rule = Choice(
        "conserving",
        RULES,
        labels=("Conserving", "Scaled", "As printed"),
        group="Collision",
        help="restitution on the normal part; both velocities scaled; the printed listing",
    )
    order = Choice(
        "joint",
        ORDERS,
        labels=("Jointly", "Pair by pair"),
        group="Collision",
        help="contacts of one moment solved together, or one pair after the other by number",
    )
    restitution = Param(0.95, 0.0, 1.0, group="Collision", help="normal speed kept when two balls part")
    passes = Param(4, 1, 50, whole=True, group="Collision", help="rounds of moving overlapping balls apart")

    bounce = Param(0.8, 0.0, 1.0, group="Cushions", label="Bounce factor", help="speed kept at a cushion")
    repositioning = Choice(
        "exact",
        REPOSITIONINGS,
        group="Cushions",
        help="where a ball is put that overshot: where it would be, mirrored, or at the wall",
    )

    friction = Param(
        0.992,
        0.9,
        1.0,
        group="Cloth",
        label="Friction factor",
        help="speed kept from frame to frame, at 60 frames a second",
    )
    friction_law = Choice(
        "consistent",
        FRICTION_LAWS,
        labels=("Per second", "Per frame"),
        group="Cloth",
        help="the same slowing at any step length, or the factor once each step as printed",
    )
    minimum_speed = Param(0.02, 0.0, 0.5, unit="m/s", group="Cloth", help="what is slower stops")

    step_length = Param(1 / 120, 1 / 2000, 1 / 20, unit="s", log=True, group="Time", label="Step")
    substeps = Param(
        0,
        0,
        64,
        whole=True,
        group="Time",
        help="parts of a step; 0: as many as keep a ball from moving over half its radius in one",
    )

    radius_spread = Param(0.0, 0.0, 0.4, group="Balls", rebuild=True, help="how much the radii differ")
    mass_spread = Param(0.0, 0.0, 0.9, group="Balls", rebuild=True, help="how much the densities differ")

    def settings(self) -> LectureSettings:
        return LectureSettings(
            bounce=self.bounce,
            restitution=self.restitution,
            friction=self.friction,
            minimum_speed=self.minimum_speed,
            substeps=int(self.substeps),
            passes=int(self.passes),
            rule=self.rule,
            # a joint solution is one of impulses, which only the conserving rule knows
            order=self.order if self.rule == "conserving" else "pairwise",
            repositioning=self.repositioning,
            friction_law=self.friction_law,
        )
