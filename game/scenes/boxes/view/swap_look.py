"""Looking into sweep and prune: what a box overlaps on each axis, the last swaps, the letters of the ends."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.arrays import BoxArrays
from game.scenes.boxes.model.names import AXES, LETTERS, listed_names, name_of
from game.scenes.boxes.view.column import Column
from game.scenes.boxes.view.look import FEW_TESTS, draw_tests
from game.scenes.boxes.view.world import Places
from game.ui.canvas.canvas import Canvas

LEAST_ROOM = 30  # design px that a sentence takes
BANDS = -0.42  # m, where the bands of a box's intervals begin, below the axes
NEAR_ROW, FAR_ROW = -0.50, -0.68  # m, where the letters of lower and of upper ends stand beside the axes


class Seen(NamedTuple):
    """The other boxes that a box overlaps on x, on y, and on both."""

    box: int
    on: tuple[list[int], list[int]]
    partners: list[int]


def look_into(boxes: BoxArrays, box: int) -> Seen:
    """What a box overlaps, axis by axis."""
    lowers, uppers = boxes.covered()
    meet = (lowers[boxes.ids] <= uppers[box]) & (lowers[box] <= uppers[boxes.ids])
    meet[boxes.ids == box] = False
    x, y = (boxes.ids[meet[:, axis]].tolist() for axis in range(2))
    return Seen(box, (x, y), boxes.ids[meet.all(axis=1)].tolist())


def draw_look(boxes: BoxArrays, canvas: Canvas, places: Places, seen: Seen) -> None:
    """The box, its intervals on both axes as bands, and lines to what it overlaps on an axis."""
    (x0, y0), (x1, y1) = boxes.lowers[seen.box], boxes.uppers[seen.box]
    for left, bottom, right, top in ((x0, BANDS, x1, HEIGHT), (BANDS, y0, WIDTH, y1)):
        band = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
        if np.isfinite(band).all():
            canvas.polygon(band, fill="amber", fill_alpha=0.1)
    others = list(dict.fromkeys([*seen.on[0], *seen.on[1]]))
    tested = others if len(others) <= FEW_TESTS else seen.partners
    draw_tests(boxes, canvas, places, seen.box, tested)


def write_look(boxes: BoxArrays, column: Column, seen: Seen) -> None:
    """Rows: what a box overlaps on each axis; a pair is in both."""
    column.head(f"Box {name_of(boxes, seen.box)} overlaps")
    for axis in range(2):
        column.row(f"on {AXES[axis]}", listed_names(boxes, seen.on[axis]) or "none")
    column.row("on both: pairs", listed_names(boxes, seen.partners) or "none", "vermilion")


def write_story(column: Column, story: list[str], fresh: int) -> None:
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
            canvas.label(at, LETTERS[box], color, 11, "semibold", halo=False)
