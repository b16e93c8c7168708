"""The parameters of the real table: which shot, the table's numbers, those of each model of its cushions."""

from __future__ import annotations

from game.billiards.fitting.tables import START_OF_CAROM as TRUE
from game.billiards.fitting.tables import FittedTable
from game.billiards.fitting.tracks import TableSize
from game.billiards.stepped.play import STEP as STEPPED_STEP
from game.stage import Param, Parameters, Toggle

CUSHIONS = {"han": "han-2005", "mathavan": "mathavan-2010", "stronge": "stronge-2000"}


class RealTableParameters(Parameters):
    """What can be chosen. Han's numbers made the shipped tracks, and Stronge's were fitted to them."""

    shot = Param(1, 1, 50, whole=True, help="the last one is shown for more than there are")
    tail = Toggle(True, group="Shown", label="Tracks", help="all samples, not only those up to now")
    stepped_step = Param(
        STEPPED_STEP, 1 / 20000, 1 / 50, unit="s", log=True, group="Shown", label="Stepped table's step"
    )
    sliding = Param(TRUE.sliding, 0.05, 0.6, group="Cloth")
    rolling = Param(TRUE.rolling, 0.001, 0.03, group="Cloth", log=True)
    spinning = Param(TRUE.spinning, 0.0003, 0.1, group="Cloth", log=True)
    ball_friction = Param(TRUE.ball_friction, 0.005, 0.3, group="Balls", label="Friction")
    ball_restitution = Param(TRUE.ball_restitution, 0.7, 1.0, group="Balls", label="Restitution")
    fall = Param(TRUE.cushion_restitution_fall, 0.0, 0.15, unit="s/m", group="Cushions",
                 label="Restitution falls", help="with the closing speed, in all models")  # fmt: skip
    han_restitution = Param(TRUE.cushion_restitution, 0.4, 1.0, group="Cushions", label="Han: restitution")
    han_friction = Param(TRUE.cushion_friction, 0.02, 0.8, group="Cushions", label="Han: friction")
    mathavan_restitution = Param(0.93, 0.4, 1.0, group="Cushions", label="Mathavan: restitution")
    mathavan_friction = Param(0.24, 0.02, 0.8, group="Cushions", label="Mathavan: friction")
    stronge_restitution = Param(0.835, 0.4, 1.0, group="Cushions", label="Stronge: restitution")
    stronge_friction = Param(0.256, 0.02, 0.8, group="Cushions", label="Stronge: friction")
    stronge_compliance = Param(0.12, 0.05, 10.0, group="Cushions", label="Stronge: compliance", log=True)

    def table(self, size: TableSize, model: str) -> FittedTable:
        """The table with the cushions of a model of CUSHIONS."""
        physics = TRUE._replace(
            cushion=CUSHIONS[model],
            sliding=self.sliding,
            rolling=self.rolling,
            spinning=self.spinning,
            ball_friction=self.ball_friction,
            ball_restitution=self.ball_restitution,
            cushion_restitution=getattr(self, f"{model}_restitution"),
            cushion_friction=getattr(self, f"{model}_friction"),
            cushion_restitution_fall=self.fall,
            cushion_compliance=self.stronge_compliance,
        )
        return FittedTable(size, physics)
