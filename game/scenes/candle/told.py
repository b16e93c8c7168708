"""What the candle tells: readouts beside theory, places for stories, names, sounds; its hand."""

from __future__ import annotations

import math

from game.arrays import Point
from game.scenes.candle.air import FRESH, GOAL, HIGH, LIVED, NEVER, RADIUS, RIM, TOP, VAPOUR
from game.scenes.candle.world import NAMES, CandleWorld
from game.stage import Hearing, Readout
from game.worlds.hands.hand import Hand, Use
from game.worlds.hearing import ROOM, fire

LOUD, GRIP = 40e3, 0.03  # W/m of a flame that is as loud as can be; m beside the glass that still take it


def readouts(model: CandleWorld) -> list[Readout]:
    """Of the flame, then of the glass: oxygen beside what full consumption would leave."""
    air, nan, sealed = model.air, math.nan, model.sealed()
    first, gone = model.oxygen_at_first(), model.shut_for()
    here = air.inside("oxygen") if sealed else nan
    rate = VAPOUR["oxygen"] * model.parameters.supply
    lived = float(air.flows[LIVED])
    return [
        Readout("burns", int(model.burns())), Readout("power", model.power(), "W/m"),
        Readout("flame height", model.flame_height(), "m"),
        Readout("oxygen at the wick", 100.0 * air.at_wick(), "%"),
        Readout("shut", int(sealed)), Readout("shut for", gone, "s"),
        Readout("oxygen under the glass", 1e3 * here, "g/m"),
        Readout("oxygen by the law", 1e3 * max(first - rate * gone, 0.0) if sealed else nan, "g/m"),
        Readout("oxygen left", 100.0 * here / first if sealed else nan, "%"),
        Readout("flame lived", lived if lived != NEVER else nan, "s"),
        Readout("time by the law", first / rate if sealed else nan, "s"),
        Readout("oxygen unaccounted", model.unaccounted(), "%"),
        Readout("soot under the glass", 1e6 * air.inside("soot") if sealed else nan, "mg/m"),
        Readout("air in the glass", 1e4 * first / FRESH if sealed else nan, "cm²"),
        Readout("glass", float(air.flows[RIM]), "m"), Readout("hottest", float(air.temperature.max()), "K"),
        Readout("a step", model.watch.median("step"), "s"),
    ]  # fmt: skip


def targets(model: CandleWorld) -> dict[str, Point]:
    """Wick, flame, glass; where smoke gathers under it."""
    rim, high = float(model.air.flows[RIM]), float(model.air.flows[HIGH])
    return {
        "wick": (0.0, TOP), "flame": (0.0, TOP + 0.03), "glass": (0.0, rim + 0.5 * high),
        "smoke": (0.0, rim + 0.8 * high), "rim": (0.0, rim),
    }  # fmt: skip


def names(model: CandleWorld) -> list[tuple[Point, str]]:
    """Flame and glass by what is measured at them."""
    places, found = targets(model), []
    if model.burns():
        found.append((places["flame"], f"{model.power() / 1000.0:.1f} kW/m"))
    if model.sealed():
        found.append((places["smoke"], f"oxygen {1e3 * model.air.inside('oxygen'):.1f} g/m"))
    return found


def hearing(model: CandleWorld) -> Hearing:
    """The flame; glass on the table, the puff of a match and of a flame that goes out."""
    steady = (ROOM, fire(model.power() if model.burns() else 0.0, LOUD))
    return Hearing("candle", model.time, model.heard.sounds(NAMES, 0.3), steady)


def _take(hand: Hand) -> str:
    """The glass, where it is taken."""
    model: CandleWorld = hand.model
    rim, high, wide = (float(model.air.flows[k]) for k in (RIM, HIGH, RADIUS))
    x, y = hand.at
    if abs(x) > wide + GRIP or not rim - GRIP < y < rim + high + GRIP:
        hand.point = None
        return "There is no glass."
    hand.held = 0
    return ""


def _lead(hand: Hand) -> str:
    """The glass follows the hand up and down."""
    flows = hand.model.air.flows
    hand.model.air.lead(float(flows[GOAL]) + hand.moved[1])
    return ""


def candle_hand(model: CandleWorld) -> Hand:
    """Drags the glass; the right button holds a match to the wick."""
    uses = {"drag": Use(_take, _lead), "light": Use(lambda hand: model.light())}
    return Hand(model, uses, (-0.5, -0.1), (0.5, 0.6), left="drag", right="light")
