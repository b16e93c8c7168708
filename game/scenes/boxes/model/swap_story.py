"""Sweep and prune in words: the swaps of a step one by one."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.broadphase.walks.swap import ALIKE, APART, BEGINS, Swap, walk_swaps
from game.scenes.boxes.model.arrays import BoxArrays
from game.scenes.boxes.model.names import AXES, apart_on, name_of


def swap_sentences(boxes: BoxArrays, orders: list[tuple[Any, Any]], pairs_before: Any) -> list[str]:
    """The swaps of the last step as sentences, in the order in which they were made.

    ``orders``: for each axis ids (2n,) and whether each is an upper end, before the step. ``pairs_before``:
    (m, 2) ids.
    """
    lowers, uppers = boxes.covered()
    corners = np.concatenate([lowers, uppers], axis=1).tolist()
    present = {(a, b) for a, b in pairs_before.tolist()}
    sentences = []
    for axis, (who, upper) in enumerate(orders):
        for swap in walk_swaps(list(zip(who.tolist(), upper.tolist(), strict=True)), corners, axis):
            sentences.append(_sentence(boxes, swap, present))
            pair = min(swap.mover, swap.other), max(swap.mover, swap.other)
            if swap.result == BEGINS:
                present.add(pair)
            elif swap.result not in (ALIKE, APART):
                present.discard(pair)
    return sentences


def _sentence(boxes: BoxArrays, swap: Swap, present: set[tuple[int, int]]) -> str:
    """One swap in words; ``present``: the pairs when it is made."""
    axis, across = AXES[swap.axis], AXES[1 - swap.axis]
    mover, other = name_of(boxes, swap.mover), name_of(boxes, swap.other)
    pair = min(swap.mover, swap.other), max(swap.mover, swap.other)
    if swap.result == ALIKE:
        ends = "maxima" if swap.mover_upper else "minima"
        return f"{mover}'s and {other}'s {ends} change places on {axis}: nothing to test."
    if swap.result == BEGINS:
        then = "the pair is known already." if pair in present else "pair begins."
        return f"{other}'s maximum passes {mover}'s minimum on {axis}; on {across} they overlap too: {then}"
    if swap.result == APART:
        apart = apart_on(boxes, *pair)
        why = f"on {across} they are apart" if across in apart.split() else "but the two have passed already"
        return f"{other}'s maximum passes {mover}'s minimum on {axis}; {why}: no pair."
    then = "pair ends." if pair in present else "they were no pair."
    return f"{other}'s minimum passes {mover}'s maximum on {axis}, so they separate: {then}"
