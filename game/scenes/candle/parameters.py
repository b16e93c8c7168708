"""Level and controls of the candle."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters
from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations
from game.worlds.members.solids import choose_step
from game.worlds.quality import Quality

QUALITY = Quality(64, 96, 128, "cells across")


class CandleContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. lit: from the beginning; lowered: the glass stands on the table."""

    lit: bool = True
    lowered: bool = False
    expected: Expectations = ()
    view: View = View(left=-0.42, bottom=-0.06, right=0.42, top=0.43)


class CandleParameters(Parameters):
    """Glass, wick, gas, and what is shown of it."""

    half_width = Param(0.08, 0.035, 0.08, unit="m", group="Glass",
                       help="inside; a glass on its way up or down takes it on as it is up")  # fmt: skip
    height = Param(0.13, 0.1, 0.13, unit="m", group="Glass", help="inside, as long as the glass is up")
    supply = Param(40e-6, 30e-6, 120e-6, unit="kg/(s m)", log=True, group="Wick",
                   help="most that it carries up, for each metre of depth")  # fmt: skip
    feedback = Param(0.85, 0.1, 0.95, group="Wick",
                     help="share of the greatest power that keeps up the greatest supply")  # fmt: skip
    limit = Param(16.0, 0.0, 20.0, unit="%", group="Wick", label="Limit of oxygen",
                  help="by volume, in the air beside the flame: with less no candle burns")  # fmt: skip
    tier = QUALITY.choose("play", "Gas")
    cells = Param(64, 32, 160, step=16, whole=True, group="Gas", rebuild=True, help="across, with Own")
    cycles = Param(6, 3, 20, whole=True, group="Gas", label="V-cycles",
                   help="of the pressure in a step, at most")  # fmt: skip
    step_length = choose_step(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 30.0, "Gas")
    shown = Choice("flame", ("flame", "oxygen", "temperature"), group="Shown", label="Gas",
                   help="as the eye sees it, or what is measured")  # fmt: skip

    def cells_now(self) -> int:
        """By the quality that is chosen."""
        return QUALITY.parts(self.tier, self.cells)
