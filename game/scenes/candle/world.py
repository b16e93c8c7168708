"""The world of the candle: gas, wick and glass; what is heard as the glass or the flame comes and goes."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.arrays import Floats, Point
from game.physics.combustion.effects import COMBUSTION
from game.physics.effects import EffectSet
from game.physics.gas.effects import GAS
from game.scenes.candle.air import (
    AIR,
    FRESH,
    LIGHTING,
    LIVED,
    NEVER,
    OXYGEN,
    PER_VOLUME,
    POWER,
    RIM,
    SEALED,
    SUPPLY,
    USED,
    Air,
)
from game.scenes.candle.parameters import CandleContent, CandleParameters
from game.worlds.hearing import Heard
from game.worlds.members.burning_air import AirState
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import World

GLASS, PUFF, MATCH = range(3)  # sounds
NAMES = {GLASS: "glass", PUFF: "wind", MATCH: "rustle"}
CLINK, STRUCK = 3.0, 2.0  # m/s of impacts that are as loud as a glass put down, and as a match that is struck


class CandleState(NamedTuple):
    """heard (k, HEARD_WIDTH)."""

    air: AirState
    heard: Floats


class CandleWorld(World):
    """``air`` has flame and glass; ``watch``: what a step takes.

    lives: of each glass under which a flame went out, litres of cold air (of a
    metre of glass) that held its oxygen, and s it lived.
    """

    state_type = CandleState
    content: CandleContent
    parameters: CandleParameters

    def __init__(self, content: CandleContent, parameters: CandleParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.air, self.heard, self.watch = Air(content, parameters, active), Heard(), Stopwatch()
        self.members = (self.air, self.heard)
        self.lives: list[Point] = []

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self.air.set_effects(active & COMBUSTION.known, active & GAS.known)

    def change_parameter(self, name: str) -> None:
        if name == "cycles":
            self.air.set_cycles(int(self.parameters.cycles))

    def advance(self, dt: float) -> str:
        burnt, high, lived = self.burns(), float(self.air.flows[RIM]), self.lived()
        with self.watch.time("step"):
            said = super().advance(dt)
        rim = float(self.air.flows[RIM])
        self.heard.forget(self.time - dt)
        if rim == 0.0 < high:
            self.heard.add(self.time, GLASS, CLINK, 0.0)
        if burnt != self.burns():
            self.heard.add(self.time, PUFF, 0.6 if burnt else 1.0, 0.0)
        if math.isnan(lived) and not math.isnan(self.lived()):
            self.lives.append((self.cold_air(), self.lived()))
        return said

    def light(self) -> str:
        """Hold a match to the wick; why not, or ""."""
        if self.sealed():
            return "The glass is in the way."
        if self.burns() or self.air.flows[LIGHTING] > 0.0:
            return "It burns." if self.burns() else "A match comes."
        self.air.light()
        self.heard.add(self.time, MATCH, STRUCK, 0.1)
        return ""

    def move_glass(self) -> None:
        """Down if it is up, else up."""
        self.air.lead(math.inf if float(self.air.flows[RIM]) < 0.1 else 0.0)

    # -- what there is ----------------------------------------------------------------------------------

    def burns(self) -> bool:
        """Whether the wick gives vapour that burns."""
        return bool(self.air.flows[SUPPLY] > 0.0)

    def power(self) -> float:
        """W/m of the flame, the mean of the last 0.3 s."""
        return float(self.air.flows[POWER])

    def flame_height(self) -> float:
        """m above the wick."""
        return self.air.flame_height()

    def sealed(self) -> bool:
        """Whether the glass stands on the table."""
        return bool(self.air.flows[SEALED] != NEVER)

    def shut_for(self) -> float:
        """s that it has stood there; NaN if it does not."""
        return self.air.time - float(self.air.flows[SEALED]) if self.sealed() else math.nan

    def oxygen_at_first(self) -> float:
        """kg/m under the glass as it was put down; NaN if it is up."""
        return float(self.air.flows[OXYGEN]) if self.sealed() else math.nan

    def cold_air(self) -> float:
        """Litres of cold air that hold the oxygen that was under a metre of the glass; NaN if it is up."""
        return 1e3 * self.oxygen_at_first() / FRESH

    def lived(self) -> float:
        """s that the flame lived under the glass; NaN while it does."""
        lived = float(self.air.flows[LIVED])
        return lived if self.sealed() and lived != NEVER else math.nan

    def to_limit(self) -> float:
        """kg/m of the oxygen at first that can burn until all gas under the glass, mixed, is at the limit."""
        left = self.parameters.limit / PER_VOLUME * (FRESH / AIR) * self.air.inside("air")
        return max(self.oxygen_at_first() - left, 0.0)

    def unaccounted(self) -> float:
        """% of the oxygen at first that has neither burnt nor is still there; NaN if the glass is up."""
        first = self.oxygen_at_first()
        used = self.air.used - float(self.air.flows[USED])
        return 100.0 * abs(first - used - self.air.inside("oxygen")) / first if self.sealed() else math.nan
