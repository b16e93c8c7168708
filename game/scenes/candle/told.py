"""What the candle tells: readouts beside theory, places for stories, names, sounds; its hand."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.scenes.candle.air import (
    FRESH,
    GOAL,
    HIGH,
    PER_VOLUME,
    RADIUS,
    RIM,
    SINCE,
    SMOKE_S,
    SPEED,
    TOP,
    VAPOUR,
)  # fmt: skip
from game.scenes.candle.world import NAMES, CandleWorld
from game.stage import Comparison, Hearing, Readout, Steady
from game.worlds.hands.hand import Hand, Use
from game.worlds.hearing import ROOM, fire, wind

LOUD, GRIP = (
    6e4,
    0.03,
)  # W/m of a flame that is as loud as can be: a candle is hardly heard; m beside the glass that still take it
WIDEST = 18.0  # l of air, to which the law is drawn
OF_A_CANDLE = 77.0  # W: Hamins, Bundy and Dillon 2005, Characterization of candle flames


def readouts(model: CandleWorld) -> list[Readout]:
    """Of the flame, then of the glass: oxygen beside what full consumption would leave."""
    air, nan, sealed = model.air, math.nan, model.sealed()
    first, gone = model.oxygen_at_first(), model.shut_for()
    rate = VAPOUR["oxygen"] * model.parameters.supply
    now = air.inside("oxygen") if sealed else nan
    whole = air.share(air.under()) / now if sealed else nan  # % for a kg/m of oxygen under the glass
    lived, law = model.lived(), model.to_limit() / rate if sealed else nan
    return [
        Readout("burns", int(model.burns())), Readout("power", model.power(), "W/m"),
        Readout("candles a metre", model.power() / OF_A_CANDLE),
        Readout("flame height", model.flame_height(), "m"), Readout("oxygen beside it", air.fed(), "%"),
        Readout("shut", int(sealed)), Readout("shut for", gone, "s"),
        Readout("oxygen in all", whole * now, "%"),
        Readout("oxygen by the law", whole * max(first - rate * gone, 0.0) if sealed else nan, "%"),
        Readout("oxygen left", 100.0 * now / first if sealed else nan, "%"),
        Readout("flame lived", lived, "s"), Readout("time by the law", law, "s"),
        Readout("lived over law", lived / law if law else nan), Readout("oxygen for", first / rate, "s"),
        Readout("oxygen unaccounted", model.unaccounted(), "%"),
        Readout("smoke", 1e6 * air.inside("soot") if sealed else nan, "mg/m"),
        Readout("air in the glass", model.cold_air(), "l"),
        Readout("glass", float(air.flows[RIM]), "m"), Readout("hottest", float(air.temperature.max()), "K"),
        Readout("a step", model.watch.median("step"), "s"),
    ]  # fmt: skip


def targets(model: CandleWorld) -> dict[str, Point]:
    """Wick, flame, glass; where smoke gathers under it."""
    rim, high = float(model.air.flows[RIM]), float(model.air.flows[HIGH])
    return {
        "wick": (0.0, TOP), "flame": (0.0, TOP + 0.03), "glass": (0.0, rim + 0.5 * high),
        "smoke": (0.0, rim + 0.8 * high), "middle": (0.0, 0.5 * high),
    }  # fmt: skip


def sizes(model: CandleWorld) -> dict[str, float]:
    """The flame as it is seen, and the glass, m."""
    return {"flame": max(model.flame_height() - TOP, 0.0), "glass": float(model.air.flows[HIGH])}


def charts(model: CandleWorld) -> dict[str, Comparison]:
    """How long flames lived under glasses, over the air in them, beside the law for gas that is mixed."""
    rate = VAPOUR["oxygen"] * model.parameters.supply
    second = 1e-3 * FRESH * (1.0 - model.parameters.limit / PER_VOLUME) / rate  # s for a litre of air
    points = np.array(model.lives, dtype=np.float64).reshape(-1, 2)
    law = np.array([(0.0, 0.0), (WIDEST, second * WIDEST)])
    both = ("it lived", "by the law")
    return {"lives": Comparison(points, law, both, "s", "cold air in the glass", "l", single=True)}


def names(model: CandleWorld) -> list[tuple[Point, str]]:
    """Flame and glass by what is measured at them."""
    places, found = targets(model), []
    if model.burns():
        found.append((places["flame"], f"{model.power() / 1000.0:.1f} kW a metre"))
    if model.sealed():
        found.append((places["smoke"], f"{model.air.share(model.air.under()):.0f} % oxygen"))
    return found


def hearing(model: CandleWorld) -> Hearing:
    """The flame, a wick that smokes, a glass on its way; it on the table, puffs of a match and of the end."""
    flows, burns = model.air.flows, model.burns()
    hiss = 0.0 if burns else 0.2 * elementary.exp(-float(flows[SINCE]) / SMOKE_S)
    steady = (
        ROOM,
        fire(model.power() if burns else 0.0, LOUD),
        Steady("hiss", hiss),
        wind(20.0 * flows[SPEED]),
    )
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
