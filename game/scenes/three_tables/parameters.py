"""The parameters of the three tables: the stroke, the steps, how far the cue ball is moved, what is shown."""

from __future__ import annotations

from game.billiards.lecture.shot import STEP as LECTURE_STEP
from game.billiards.stepped.play import PASSES
from game.billiards.stepped.play import STEP as STEPPED_STEP
from game.scenes.three_tables.shot import Steps
from game.stage import Choice, Param, Parameters, Toggle

PERTURBATIONS = ("none", "1e-15", "1e-12", "1e-9", "1e-6", "1e-3")  # m, of the cue ball


class ThreeTablesParameters(Parameters):
    """What of stroke and tables can be chosen; defaults of the steps are those of the tables."""

    tip_left = Param(0.0, -0.6, 0.6, unit="R", group="Stroke", label="Tip left")
    tip_up = Param(0.0, -0.6, 0.6, unit="R", group="Stroke", label="Tip up", help="follow above, draw below")
    elevation = Param(0.0, 0.0, 60.0, unit="°", group="Stroke", help="of the butt of the cue")
    lecture_step = Param(
        LECTURE_STEP, 1 / 2000, 1 / 20, unit="s", log=True, group="Steps", label="Lecture's step"
    )
    stepped_step = Param(
        STEPPED_STEP, 1 / 20000, 1 / 20, unit="s", log=True, group="Steps", label="Stepped table's"
    )
    passes = Param(PASSES, 1, 50, whole=True, group="Steps", help="rounds of moving overlapping balls apart")
    perturbation = Choice(
        "none",
        PERTURBATIONS,
        labels=("None", "1 fm", "1 pm", "1 nm", "1 µm", "1 mm"),
        group="Chaos",
        help="a second exact table, the cue ball moved",
    )
    prediction = Toggle(True, group="Shown", label="Aim line")

    @property
    def steps(self) -> Steps:
        """Steps of the tables that step."""
        return Steps(self.lecture_step, self.stepped_step, int(self.passes))
