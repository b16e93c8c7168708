"""Sweep and prune in words: the swaps of a step one by one, and what a box overlaps on each axis."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from game.physics.broadphase.walks.swap import ALIKE, APART, BEGINS, Swap, walk_swaps
from game.scenes.boxes import look
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.view import Column
from game.ui.canvas.canvas import Canvas

if TYPE_CHECKING:
    from game.scenes.boxes.base import BoxesScene

MOST_KEPT = 5  # sentences
LEAST_ROOM = 30  # design px that a sentence takes
BANDS = -0.42  # m, where the bands of a box's intervals begin, below the axes
NEAR_ROW, FAR_ROW = -0.50, -0.68  # m, where the letters of lower and of upper ends stand beside the axes


def tell_swaps(scene: BoxesScene, orders: list[tuple[Any, Any]], pairs_before: Any) -> list[str]:
    """The swaps of the last step as sentences, in the order in which they were made.

    ``orders``: for each axis ids (2n,) and whether each is an upper end, before the step. ``pairs_before``:
    (m, 2) ids.
    """
    lowers, uppers = scene.covered()
    boxes = np.concatenate([lowers, uppers], axis=1).tolist()
    present = {(a, b) for a, b in pairs_before.tolist()}
    told = []
    for axis, (who, upper) in enumerate(orders):
        for swap in walk_swaps(list(zip(who.tolist(), upper.tolist(), strict=True)), boxes, axis):
            told.append(_sentence(scene, swap, present))
            pair = min(swap.mover, swap.other), max(swap.mover, swap.other)
            if swap.result == BEGINS:
                present.add(pair)
            elif swap.result not in (ALIKE, APART):
                present.discard(pair)
    return told


def _sentence(scene: BoxesScene, swap: Swap, present: set[tuple[int, int]]) -> str:
    """One swap in words; ``present``: the pairs when it is made."""
    axis, across = look.AXES[swap.axis], look.AXES[1 - swap.axis]
    mover, other = look.name_of(scene, swap.mover), look.name_of(scene, swap.other)
    pair = min(swap.mover, swap.other), max(swap.mover, swap.other)
    if swap.result == ALIKE:
        ends = "maxima" if swap.mover_upper else "minima"
        return f"{mover}'s and {other}'s {ends} change places on {axis}: nothing to test."
    if swap.result == BEGINS:
        then = "the pair is known already." if pair in present else "pair begins."
        return f"{other}'s maximum passes {mover}'s minimum on {axis}; on {across} they overlap too: {then}"
    if swap.result == APART:
        apart = look.apart_on(scene, *pair)
        why = f"on {across} they are apart" if across in apart.split() else "but the two have passed already"
        return f"{other}'s maximum passes {mover}'s minimum on {axis}; {why}: no pair."
    then = "pair ends." if pair in present else "they were no pair."
    return f"{other}'s minimum passes {mover}'s maximum on {axis}, so they part: {then}"


class Seen(NamedTuple):
    """The other boxes that a box overlaps on x, on y, and on both."""

    box: int
    on: tuple[list[int], list[int]]
    partners: list[int]


def look_into(scene: BoxesScene, box: int) -> Seen:
    """What a box overlaps, axis by axis."""
    lowers, uppers = scene.covered()
    meet = (lowers[scene.ids] <= uppers[box]) & (lowers[box] <= uppers[scene.ids])
    meet[scene.ids == box] = False
    x, y = (scene.ids[meet[:, axis]].tolist() for axis in range(2))
    return Seen(box, (x, y), scene.ids[meet.all(axis=1)].tolist())


def draw_look(scene: BoxesScene, canvas: Canvas, alpha: float, seen: Seen) -> None:
    """The box, its intervals on both axes as bands, and lines to what it overlaps on an axis."""
    lowers, uppers = scene.lowers[seen.box], scene.uppers[seen.box]
    (x0, y0), (x1, y1) = lowers, uppers
    for left, bottom, right, top in ((x0, BANDS, x1, HEIGHT), (BANDS, y0, WIDTH, y1)):
        band = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
        if np.isfinite(band).all():
            canvas.polygon(band, fill="amber", fill_alpha=0.1)
    others = list(dict.fromkeys([*seen.on[0], *seen.on[1]]))
    look.draw_tests(
        scene, canvas, alpha, seen.box, others if len(others) <= look.FEW_TESTS else seen.partners
    )


def tell_look(scene: BoxesScene, column: Column, seen: Seen) -> None:
    """Rows: whom a box overlaps on each axis; a pair is in both."""
    column.head(f"Box {look.name_of(scene, seen.box)} overlaps")
    for axis in range(2):
        column.row(f"on {look.AXES[axis]}", look.listed_names(scene, seen.on[axis]) or "none")
    column.row("on both: pairs", look.listed_names(scene, seen.partners) or "none", "vermilion")


def tell_story(column: Column, story: list[str], fresh: int) -> None:
    """The last swaps in words, the newest first and those of this step in amber."""
    column.head("Swap by swap", "newest first")
    for i, sentence in enumerate(story[::-1]):
        if column.room_px < LEAST_ROOM:
            return
        column.words(sentence, "amber" if i < fresh else "text2")
        column.space(3)


def draw_ends(canvas: Canvas, axis: int, values: Any, who: Any, upper: Any) -> None:
    """The letter of each end beside its tick, lower ends nearer; those far out are left out."""
    limit = (WIDTH, HEIGHT)[axis]
    free = {False: -99.0, True: -99.0}  # where the next letter of a row may stand
    for value, box, is_upper in zip(values.tolist(), who.tolist(), upper.tolist(), strict=True):
        if 0.0 <= value <= limit:
            row = FAR_ROW if is_upper else NEAR_ROW
            place = max(value, free[is_upper])
            free[is_upper] = place + canvas.px(11)
            at = (place, row) if axis == 0 else (row, place)
            color = "pink" if is_upper else "chalk"
            canvas.label(at, look.LETTERS[box], color, 11, "semibold", halo=False)
