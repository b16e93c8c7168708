"""What is measured of runs between recorded ones, and the hand's tools."""

from __future__ import annotations

import math

from game.scenes.blend.world import BlendWorld
from game.stage import Readout
from game.worlds.hands.hand import Hand, Use

REACH = 1e3  # m


def readouts(model: BlendWorld) -> list[Readout]:
    """Areas now, then each of the nine beside a true run, then what it took."""
    aligned, plain, mean = model.areas()
    off = [one / mean - 1.0 if mean > 0.0 else math.nan for one in (aligned, plain)]
    rows = [
        Readout("area now", aligned, "m²"), Readout("error, aligned", off[0]),
        Readout("error, plain", off[1]), Readout("weighted area", mean, "m²"),
    ]  # fmt: skip
    for one in model.squares:
        if 1.0 not in one.weights:
            place = f"{one.across:g}" if len(model.runs) == 2 else f"{one.across:g} {one.up:g}"
            rows += [Readout(f"area off, {place}", one.area), Readout(f"misplaced, {place}", one.misplaced)]
    return [
        *rows, Readout("matched points", sum(len(pairs) for pairs in model.blend.pairs)),
        Readout("links", len(model.links)), Readout("recording took", model.recorded, "s"),
        Readout("preparing took", model.prepared, "s"),
    ]  # fmt: skip


def _link(hand: Hand) -> str:
    if hand.start is None or hand.point is None:
        return ""
    return str(hand.model.link(hand.start, hand.point))


def _forget(hand: Hand) -> str:
    return str(hand.model.forget())


def blend_hand(model: BlendWorld) -> Hand:
    """The hand of a world."""
    uses = {"hint": Use(release=_link), "forget": Use(press=_forget)}
    return Hand(model, uses, (-REACH, -REACH), (REACH, REACH), right="forget")
