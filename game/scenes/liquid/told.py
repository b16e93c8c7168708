"""What is measured of a tank of liquid, the hand's tools, and what is heard."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementary
from game.scenes.liquid.world import LiquidWorld
from game.stage import Hearing, Readout, Steady
from game.worlds.hands.grab import GRAB, body_at, let_loose
from game.worlds.hands.hand import NOBODY, Hand, Use

HAND_RATE = 30.0  # 1/s: speed for a move of the hand
TAP_RATE = 8.0  # 1/s: speed of a tap for the length of the stroke that makes it
LOUDEST = 3000.0  # W/m of flow at which water is as loud as can be


def readouts(model: LiquidWorld) -> list[Readout]:
    """Volume, energy, divergence, then what the method did."""
    model.water.measure()
    liquid, report = model.liquid, model.liquid.report
    moving, height = liquid.energy()
    put_in, gone, refused = liquid.account.tolist()
    area = liquid.wet_area()
    full = liquid.count * liquid.area
    speeds = liquid.speeds
    fastest = float(np.sqrt((speeds * speeds).sum(axis=1)).max()) if liquid.count else 0.0
    middle = float(liquid.places[:, 0].mean()) if liquid.count else math.nan
    return [
        Readout("volume", area, "m²"), Readout("poured in", full, "m²"),
        Readout("volume error", area / full - 1.0 if liquid.count else 0.0),
        Readout("kinetic energy", moving, "J/m"), Readout("energy", moving + height, "J/m"),
        Readout("divergence", report.outflow / liquid.grid.cell, "1/s"),
        Readout("fastest", fastest, "m/s"), Readout("level", level(model), "m"),
        Readout("middle", middle, "m"),
        Readout("particles", liquid.count), Readout("wet cells", report.wet),
        Readout("fullest cell", float(liquid.cells.fill.max())),
        Readout("put in", put_in * liquid.area, "m²"), Readout("gone", gone * liquid.area, "m²"),
        Readout("refused", refused * liquid.area, "m²"),
        Readout("solids", len(model.things)), Readout("highest solid", highest(model), "m"),
        Readout("part steps", model.water.parts), Readout("turns", report.turns),
        Readout("a step", model.water.watch.median("step"), "s"),
    ]  # fmt: skip


def level(model: LiquidWorld) -> float:
    """Height (m) of the surface in the mean over the tank: wet area over width, without what is in it."""
    grid = model.liquid.grid
    return model.liquid.wet_area() / (grid.nx * grid.cell)


def highest(model: LiquidWorld) -> float:
    """m, of the middle of the highest solid."""
    bodies = model.bodies()
    return float(model.solids.world.bodies.positions[bodies, 1].max()) if len(bodies) else math.nan


def hearing(model: LiquidWorld) -> Hearing | None:
    """Water in motion rushes."""
    moving, _ = model.liquid.energy()
    loud = math.sqrt(min(moving / LOUDEST, 1.0))
    return Hearing("liquid", model.time, (), (Steady("hiss", 0.25 * loud),)) if loud > 0.02 else None


def _pour(hand: Hand) -> str:
    hand.model.pours = hand.at
    return ""


def _stir(hand: Hand) -> str:
    hand.model.water.stir(
        hand.at, (HAND_RATE * hand.moved[0], HAND_RATE * hand.moved[1]), float(hand.parameters.size)
    )
    return ""


def _drop(hand: Hand) -> str:
    hand.model.water.let_fall(hand.at, float(hand.parameters.size))
    return ""


def _box(hand: Hand) -> str:
    return str(hand.model.add_solid(hand.at, False))


def _ball(hand: Hand) -> str:
    return str(hand.model.add_solid(hand.at, True))


def _scoop(hand: Hand) -> str:
    model = hand.model
    body = body_at(model.solids.world, model.bodies(), hand.at, 0.0)
    if body != NOBODY:
        model.remove_solid(body)
    else:
        model.scoops = hand.at
    return ""


def _go_on(hand: Hand) -> str:
    if hand.model.scoops is not None:
        hand.model.scoops = hand.at
    return ""


def _tap(hand: Hand) -> str:
    (x0, y0), (x1, y1) = hand.start or hand.at, hand.at
    speed = TAP_RATE * (x1 - x0), TAP_RATE * (y1 - y0)
    if elementary.hypot(*speed) < 0.2:
        speed = 0.0, -1.0
    return str(hand.model.mouths.add_tap((x0, y0), speed, float(hand.parameters.size)))


def _drain(hand: Hand) -> str:
    return str(hand.model.mouths.add_drain(hand.at, float(hand.parameters.size)))


def _let_go(hand: Hand) -> None:
    hand.model.pours = hand.model.scoops = None
    let_loose(hand)


def liquid_hand(model: LiquidWorld) -> Hand:
    """All tools; the right button pours."""
    uses = {
        "pour": Use(_pour, _pour), "stir": Use(move=_stir), "drop": Use(_drop), "grab": GRAB,
        "box": Use(_box), "ball": Use(_ball), "scoop": Use(_scoop, _go_on),
        "tap": Use(release=_tap), "drain": Use(_drain),
    }  # fmt: skip
    grid = model.liquid.grid
    return Hand(model, uses, grid.lower, grid.upper, right="pour", drop=_let_go)
