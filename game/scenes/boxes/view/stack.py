"""Hierarchical grids as a stack of tilted sheets, one for each level, each with its hash table beside it."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from game.physics.broadphase.hash_levels import MASK
from game.physics.broadphase.walks.hash import Tables
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel
from game.scenes.boxes.model.names import LETTERS, named
from game.scenes.boxes.sheets import LEFT, Sheet
from game.scenes.boxes.view.levels_look import Look
from game.scenes.boxes.view.look import outline
from game.scenes.boxes.view.world import Places
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si
from game.ui.painters.boxes import paint_raster, shades

TABLE_LEFT, TABLE_RIGHT = 8.1, 11.1  # m
MOST_LINES = 64  # cells across that are drawn
ROW = 16  # buckets in a row of a table
MOST_BUCKETS = 32  # whose chains are drawn box by box


def draw_stack(
    model: HierarchicalGridModel, canvas: Canvas, places: Places, sheets: list[Sheet], seen: Look | None
) -> None:
    """All sheets from the farthest, with what one box does on each."""
    tables = model.grid.tables()
    levels, corners = model.grid.cells()
    low, high = places
    if seen is not None:
        _draw_plumb_lines(canvas, sheets, low[seen.box])
    overlapping = set(model.pairs.ravel().tolist())
    for sheet in sheets[::-1]:
        mine = np.flatnonzero(levels == sheet.level)
        _draw_sheet(canvas, sheet, model.grid.cell_size(sheet.level), np.unique(corners[mine], axis=0))
        if seen is not None:
            _draw_looks(canvas, sheet, model.grid.cell_size(sheet.level), seen)
        for box in mine.tolist():
            _draw_box(model, canvas, sheet, box, low[box], high[box], box in overlapping)
        if seen is not None:
            canvas.polygon(sheet.box(low[seen.box], high[seen.box]), outline="amber", width=2.0)
        draw_table(model, canvas, sheet, tables, seen)


def _draw_sheet(canvas: Canvas, sheet: Sheet, edge: float, occupied: Any) -> None:
    """A sheet with its cells, those with boxes shaded."""
    size = format_si(edge, "m")
    top = sheet.place(0.0, HEIGHT)
    canvas.label(
        (LEFT, float(top[1])), f"Cells of {size}", sheet.color, 12, "semibold", "bottomleft", (0.0, 0.0)
    )
    for lower in occupied:
        canvas.polygon(sheet.box(lower, lower + edge), fill=sheet.color, fill_alpha=0.2)
    if WIDTH / edge <= MOST_LINES:
        x, y = np.arange(0.0, WIDTH, edge), np.arange(0.0, HEIGHT, edge)
        canvas.segments(sheet.place(x, 0.0 * x), sheet.place(x, 0.0 * x + HEIGHT), "grid2", 1.0)
        canvas.segments(sheet.place(0.0 * y, y), sheet.place(0.0 * y + WIDTH, y), "grid2", 1.0)
    canvas.polygon(sheet.box((0.0, 0.0), (WIDTH, HEIGHT)), outline="line2", width=1.5)


def _draw_box(
    model: HierarchicalGridModel, canvas: Canvas, sheet: Sheet, box: int, lower: Any, upper: Any, pair: bool
) -> None:
    corners = sheet.box(lower, upper)
    color = "vermilion" if pair else "text3"
    canvas.polygon(corners, fill=color, fill_alpha=0.4 if pair else 0.25, outline=color, width=1.4)
    if named(model.boxes):
        canvas.label(corners.mean(axis=0), LETTERS[box], "text1", 11, "semibold")


def _draw_looks(canvas: Canvas, sheet: Sheet, edge: float, seen: Look) -> None:
    """The cells of a sheet in which a box looks."""
    for visit in seen.visits:
        for column, row in visit.cells if visit.level == sheet.level else ():
            lower = np.array([column * edge, row * edge])
            if (lower < (WIDTH, HEIGHT)).all() and (lower + edge > 0.0).all():
                cell = sheet.box(lower, lower + edge)
                canvas.polygon(cell, fill="amber", fill_alpha=0.22, outline="amber", width=1.0)


def _draw_plumb_lines(canvas: Canvas, sheets: list[Sheet], lower: Any) -> None:
    """The lower corner of a box, from sheet to sheet."""
    if np.isfinite(lower).all():
        for below, above in pairwise(sheets):
            ends = [sheet.place(*lower) for sheet in (below, above)]
            canvas.line(ends[0], ends[1], "amber", 1.2, dash=(4.0, 4.0))


def draw_table(
    model: HierarchicalGridModel, canvas: Canvas, sheet: Sheet, tables: Tables, seen: Look | None
) -> None:
    """A level's hash table: its buckets, and upon each the chain of its boxes."""
    buckets = int(tables.layout[sheet.level, MASK]) + 1
    top = sheet.base + sheet.height
    canvas.label((TABLE_LEFT, top), f"{buckets} buckets", "text2", 11, anchor="bottomleft", halo=False)
    looked = (
        {b for v in seen.visits if v.level == sheet.level for b in v.buckets} if seen is not None else set()
    )
    if buckets > MOST_BUCKETS:
        _draw_loads(canvas, sheet, tables, buckets)
        return
    rows = -(-buckets // ROW)
    wide, high = (TABLE_RIGHT - TABLE_LEFT) / ROW, sheet.height / rows
    for bucket, chain in enumerate(tables.chains(sheet.level)):
        x = TABLE_LEFT + (bucket % ROW) * wide
        y = sheet.base + (rows - 1 - bucket // ROW) * high
        outline(canvas, (x, y), (x + 0.9 * wide, y + 0.12 * wide), "line2", 1.0)
        if bucket in looked:
            square = np.array([(x, y), (x + wide, y), (x + wide, y + 0.9 * high), (x, y + 0.9 * high)])
            canvas.polygon(square, fill="amber", fill_alpha=0.2)
        _draw_chain(model, canvas, sheet.color, chain, (x, y + 0.15 * wide), wide, 0.8 * high)


def _draw_chain(
    model: HierarchicalGridModel, canvas: Canvas, color: str, chain: tuple[int, ...],
    corner: tuple[float, float], wide: float, high: float,
) -> None:  # fmt: skip
    """The boxes of a bucket, one upon the other, lower ones the smaller ids; as low as they must be."""
    step = min(wide, high / max(len(chain), 1))
    for i, box in enumerate(chain):
        x, y = corner[0], corner[1] + i * step
        square = np.array(
            [(x, y), (x + 0.9 * wide, y), (x + 0.9 * wide, y + 0.88 * step), (x, y + 0.88 * step)]
        )
        canvas.polygon(square, fill=color, fill_alpha=0.75)
        if named(model.boxes) and step >= 0.9 * wide and wide / canvas.px(1.0) >= 9.0:
            canvas.label(square.mean(axis=0), LETTERS[box], "stage", 11, "semibold", halo=False)


def _draw_loads(canvas: Canvas, sheet: Sheet, tables: Tables, buckets: int) -> None:
    """A large table: a block for each bucket, the darker the longer its chain."""
    loads = np.array([len(chain) for chain in tables.chains(sheet.level)], dtype=np.float64)
    across = 1 << ((buckets.bit_length() + 1) // 2)
    colors = shades(canvas, loads.reshape(-1, across) / 3.0, sheet.color, "inset")
    paint_raster(canvas, colors, (TABLE_LEFT, sheet.base), (TABLE_RIGHT, sheet.base + 0.85 * sheet.height))
