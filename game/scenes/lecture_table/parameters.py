"""The parameters of the lecture's model of a table, and the settings that they make together."""

from __future__ import annotations

from game.billiards.lecture.settings import CONSERVING, ORDERS, PAIRWISE, RULES, LectureSettings
from game.settings import set_one, taken
from game.stage import Param, Parameters, Toggle, control_of


class LectureTableParameters(Parameters):
    """What of the model can be chosen; settings of the table as they are declared there."""

    rule = control_of(
        LectureSettings, "rule", labels=("Conserving", "Scaled", "As printed"), group="Collision"
    )
    order = control_of(LectureSettings, "order", labels=("Jointly", "Pair by pair"), group="Collision")
    restitution = control_of(LectureSettings, "restitution", group="Collision")
    passes = control_of(LectureSettings, "passes", maximum=50, group="Collision")

    bounce = control_of(LectureSettings, "bounce", group="Cushions", label="Bounce factor")
    repositioning = control_of(LectureSettings, "repositioning", group="Cushions")

    friction = control_of(LectureSettings, "friction", minimum=0.9, group="Cloth", label="Friction factor")
    friction_law = control_of(
        LectureSettings, "friction_law", labels=("Per second", "Per frame"), group="Cloth"
    )
    minimum_speed = control_of(LectureSettings, "minimum_speed", maximum=0.5, group="Cloth")

    step_length = Param(1 / 120, 1 / 2000, 1 / 20, unit="s", log=True, group="Time", label="Step")
    substeps = control_of(LectureSettings, "substeps", maximum=64, group="Time")

    radius_spread = Param(0.0, 0.0, 0.4, group="Balls", rebuild=True, help="how much the radii differ")
    mass_spread = Param(0.0, 0.0, 0.9, group="Balls", rebuild=True, help="how much the densities differ")

    aim_line = Toggle(
        True, group="Balls", label="Aim line", help="ghost ball and the straight lines after it"
    )

    @property
    def settings(self) -> LectureSettings:
        """What is chosen, as the table takes it: a joint solution is one of impulses, which rules other than
        the conserving one do not know.
        """
        joint = self.values["rule"] == RULES[CONSERVING]
        return taken(LectureSettings, self.values if joint else {**self.values, "order": ORDERS[PAIRWISE]})

    def settings_after(self, name: str, before: LectureSettings) -> LectureSettings:
        """These settings with the present value of one parameter; rule and order depend on one another."""
        return self.settings if name in ("rule", "order") else set_one(before, name, self.values[name])
