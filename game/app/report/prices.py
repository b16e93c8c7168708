"""What each effect of a scene costs a step: with it, without it, and with none at all."""

from __future__ import annotations

import math
from time import perf_counter, sleep
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from game.stage import Scene

BEGUN_S = 1.0  # simulated time after which a scene does what it is about
SLICE_S = 0.02
LONGEST_S = 120.0  # real time; compiling the variants takes most of it


class Price(NamedTuple):
    """An effect, and what it costs: seconds of a step, NaN if it could not be measured."""

    label: str
    cost_s: float


class Prices(NamedTuple):
    """Of one scene: a step as it opens, a step with no effect at all, and each effect's price, s."""

    step_s: float
    bare_s: float
    effects: tuple[Price, ...]


def measure_prices(scene_type: type[Scene]) -> Prices:
    """Open a scene's first level, let it play, and measure a step with and without each effect."""
    from game.app.scene.opening import Opening
    from game.app.script import Script, demo_of
    from game.stage.effect_costs import EffectMeter

    stage = Opening().make_stage(scene_type)
    Script(stage, demo_of(scene_type)).run(max(1, round(BEGUN_S / stage.dt)))
    meter = EffectMeter(stage)
    end = perf_counter() + LONGEST_S
    while not meter.done and perf_counter() < end:
        before = len(meter.costs)
        meter.slice(SLICE_S)
        if len(meter.costs) == before:
            sleep(0.005)  # code compiles in a thread
    effects = tuple(
        Price(effect.label, meter.costs.get(effect.name, math.nan)) for effect in scene_type.effects
    )
    return Prices(stage.step_cost_s, meter.bare, effects)
