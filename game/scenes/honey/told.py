"""What is measured of liquids, and the hand's tools."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.honey.world import AIR_GONE, AIR_MADE, SCOOPED, HoneyWorld
from game.stage import Readout
from game.worlds.hands.hand import Hand, Use

HAND_RATE, FASTEST_HAND = 20.0, 5.0  # 1/s: speed for a move of the hand; m/s


def readouts(model: HoneyWorld) -> list[Readout]:
    """Density beside rest, energy, area and heat, then the ledger."""
    fluid, counts = model.fluid, model.counts
    count, cell = len(fluid.place), fluid.spacing * fluid.spacing
    motion, height = fluid.energy()
    speed = np.sqrt(np.max(np.sum(np.square(fluid.velocity), axis=1), initial=0.0))
    vapours = [one.vapour for one in fluid.liquids if one.vapour >= 0]
    gas = int(np.sum(np.isin(fluid.kind, vapours)))
    air = next((k for k, one in enumerate(fluid.liquids) if one.air), -1)
    known = float(np.sum(counts)) - 2.0 * float(counts[AIR_GONE] + counts[SCOOPED])
    warm = fluid.temperature() if count else np.zeros(1)
    first = fluid.place[fluid.kind == 0, 1]
    return [
        Readout("mean error", fluid.error), Readout("densest", fluid.worst),
        Readout("motion", motion, "J/m"), Readout("height energy", height, "J/m"),
        Readout("fastest", float(speed), "m/s"),
        Readout("area", count * cell, "m²"),
        Readout("mean height", float(np.mean(fluid.place[:, 1])) if count else math.nan, "m"),
        Readout("first's height", float(np.mean(first)) if len(first) else math.nan, "m"),
        Readout("front", float(np.max(fluid.place[:, 0])) if count else math.nan, "m"),
        Readout("warmest", float(np.max(warm)), "K"),
        Readout("heat", float(np.sum(fluid.heat)) * cell, "K m²"),
        Readout("vapour", gas * cell, "m²"),
        Readout("air", float(np.sum(fluid.kind == air)) * cell, "m²"),
        Readout("air made", int(counts[AIR_MADE])),
        Readout("particles", count), Readout("particles missing", known - count),
        Readout("springs", int(np.sum(fluid.partner >= 0))),
        Readout("iterations", fluid.iterations), Readout("substeps", model.substeps),
    ]  # fmt: skip


def _pour(hand: Hand) -> str:
    return str(hand.model.pour(hand.at))


def _stir(hand: Hand) -> str:
    velocity = [min(max(HAND_RATE * moved, -FASTEST_HAND), FASTEST_HAND) for moved in hand.moved]
    return str(hand.model.stir(hand.at, velocity))


def _scoop(hand: Hand) -> str:
    return str(hand.model.scoop(hand.at))


def _stop(hand: Hand) -> None:
    hand.model.pour(None)


def honey_hand(model: HoneyWorld) -> Hand:
    """Pours, stirs, scoops; the right button pours."""
    view = model.content.view
    return Hand(
        model,
        {"pour": Use(_pour, _pour), "stir": Use(move=_stir), "scoop": Use(_scoop, _scoop)},
        (view.left, view.bottom), (view.right, view.top), right="pour", drop=_stop,
    )  # fmt: skip
