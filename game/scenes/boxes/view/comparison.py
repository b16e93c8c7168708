"""A broad phase beside the naive one, in times and tests."""

from __future__ import annotations

import math

from game.lab.studies.broadphase.count import METHOD_COLORS
from game.scenes.boxes.model.compared import ComparedModel
from game.scenes.boxes.numbers import grouped, seconds_text
from game.scenes.boxes.view.column import Column


def draw_comparison(model: ComparedModel, column: Column, name: str, words: str) -> None:
    """Times of both, as bars, and whether they found the same."""
    mine, naive = model.watch.median(name), model.watch.median("naive")
    n = len(model.boxes)
    verdict = ("same pairs" if model.same else "pairs differ") if model.compared else "not compared"
    column.head("Update and all pairs", verdict)
    longest = max([time for time in (mine, naive) if math.isfinite(time)], default=1.0)
    column.bar(words, seconds_text(mine), mine / longest if mine > 0.0 else 0.0, METHOD_COLORS[name])
    if model.compared:
        tests = f"Naive, {grouped(n * (n - 1) // 2)} tests"
        column.bar(tests, seconds_text(naive), naive / longest, METHOD_COLORS["naive"])
    else:
        column.bar("Naive", "left out", 0.0, METHOD_COLORS["naive"])
