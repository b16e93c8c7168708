"""What is measured of water in a channel, and the hand's tools."""

from __future__ import annotations

import math

import numpy as np

from game.physics.waves import AiryTank, DamBreak
from game.scenes.waves.world import NOWHERE, THIN, WavesWorld
from game.stage import Readout
from game.worlds.hands.hand import Hand, Use

DENSITY = 1000.0  # kg/m³
FASTEST_HAND = 10.0  # m/s
HAND_RATE = 30.0  # 1/s: speed for a move of the hand


def readouts(model: WavesWorld) -> list[Readout]:
    """Front and depths beside the exact ones, then what is kept."""
    water = model.water
    depth, bed = water.depth[0], water.bed[0]
    speed = np.abs(water.velocity()[0][0])
    wet = depth > THIN
    gravity = water.settings.gravity
    froude = float(np.max(speed[wet] / np.sqrt(gravity * depth[wet]))) if wet.any() and gravity else 0.0
    theory, expected = model.theory, model.expected()
    off = float(np.mean(np.abs(depth - expected))) if expected is not None else math.nan
    airy, front, known = isinstance(theory, AiryTank), model.front(), math.nan
    if expected is not None and isinstance(theory, DamBreak):
        known = front_by_law(theory, water.time)
    middle = len(depth) // 2
    start, poured = model.volume.tolist()
    came, volume = poured + float(np.sum(water.came)), water.volume()
    return [
        Readout("front", front, "m"), Readout("exact front", known, "m"),
        Readout("depth error", math.nan if airy else off, "m"),
        Readout("beside Airy", off if airy else math.nan, "m"),
        Readout("level in the middle", float(bed[middle] + depth[middle]), "m"),
        Readout("depth in the middle", float(depth[middle]), "m"),
        Readout("deepest", float(np.max(depth)), "m"),
        Readout("thinnest", float(np.min(depth)), "m"),
        Readout("fastest", float(np.max(speed, initial=0.0)), "m/s"),
        Readout("Froude number", froude),
        Readout("volume", volume, "m²"), Readout("let in", came, "m²"),
        Readout("volume lost", abs(volume - start - came) / max(start + abs(came), 1e-12)),
        Readout("energy", DENSITY * (water.energy() - gravity * volume * float(np.min(bed))), "J/m"),
        Readout("steps", model.steps),
    ]  # fmt: skip


def front_by_law(dam: DamBreak, time: float) -> float:
    """Where a dam's water is ``THIN`` deep, m; on a wet bed the place of the bore."""
    if dam.right > 0.0:
        return dam.bore * time
    return (2.0 * math.sqrt(dam.gravity * dam.left) - 3.0 * math.sqrt(dam.gravity * THIN)) * time


def _pour(hand: Hand) -> str:
    hand.model.pour(hand.at[0])
    return ""


def _push(hand: Hand) -> str:
    speed = min(max(HAND_RATE * hand.moved[0], -FASTEST_HAND), FASTEST_HAND)
    hand.model.push(hand.at[0], speed)
    return ""


def _bed(hand: Hand) -> str:
    stretch = hand.model.content.stretch
    (x0, y0), (x1, y1) = hand.before, hand.at
    hand.model.draw_bed((x0, y0 / stretch), (x1, y1 / stretch))
    return ""


def _stop(hand: Hand) -> None:
    hand.model.pour(NOWHERE)


def waves_hand(model: WavesWorld) -> Hand:
    """Pours, pushes, draws the bed; the right button pours."""
    half, view, stretch = 0.5 * float(model.parameters.length), model.content.view, model.content.stretch
    return Hand(
        model,
        {"pour": Use(_pour, _pour), "push": Use(move=_push), "bed": Use(_bed, _bed)},
        (-half, stretch * view.bottom), (half, stretch * view.top), right="pour", drop=_stop,
    )  # fmt: skip
