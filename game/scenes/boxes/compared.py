"""A broad phase beside the naive one: the same boxes, the same pairs, and what each takes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.broadphase import HashedPairs, MatrixPairs, NaiveBroadPhase, PairManager
from game.physics.broadphase.effects import BOUNDARY, MOTION, NAIVE
from game.scenes.boxes import view
from game.scenes.boxes.base import BoxesScene
from game.stage import Choice

MOST_NAIVE = 4_000  # boxes; the naive way takes some 10 ms there, and four times as much at twice as many
MOST_IN_MATRIX = 4_096  # boxes; the matrix takes 32 MB there


def manager_for(rows: int, kind: str) -> PairManager:
    """An empty pair manager with room for so many ids; a hash table where the matrix would be too large."""
    if kind == "matrix" and rows <= MOST_IN_MATRIX:
        return MatrixPairs(max(1 << max(rows - 1, 1).bit_length(), 256))
    return HashedPairs()


class ComparedScene(BoxesScene):
    """Base of scenes that hold one broad phase against testing every box against every other."""

    effects = MOTION | BOUNDARY | NAIVE
    naive: NaiveBroadPhase

    manager = Choice(
        "matrix",
        ("matrix", "hash"),
        labels=("Full matrix", "Hash table"),
        group="Pairs",
        label="Pair manager",
        help="where pairs are kept from step to step; above 4096 boxes always a hash table",
    )

    def compare(self) -> None:
        """Find the pairs the naive way, too, if that is asked for and not too much."""
        self.compared = NAIVE in self.active and len(self.ids) <= MOST_NAIVE
        if not self.compared:
            self.watch.forget("naive")
            self.same = True
            return
        if len(self.naive) != len(self.ids) or not np.array_equal(self.naive.ids(), self.ids):
            self.naive = NaiveBroadPhase()
            lowers, uppers = self.covered()
            self.naive.add_boxes(lowers[self.ids], uppers[self.ids], ids=self.ids)
        with self.watch.time("naive"):
            self.update(self.naive)
            pairs = self.naive.pairs()
        self.same = np.array_equal(pairs, self.pairs)

    def make_naive(self) -> None:
        """Begin without the naive broad phase; it takes the boxes when it is wanted."""
        self.naive = NaiveBroadPhase()
        self.compared, self.same = False, True

    def parameter_changed(self, name: str) -> None:
        super().parameter_changed(name)
        if name in self.shaping():
            counts = self.begun, self.ended
            self.begin_anew()
            self.begun, self.ended = counts

    def why_idle(self, name: str) -> str:
        if name == "manager" and len(self.alive) > MOST_IN_MATRIX:
            return f"Above {view.grouped(MOST_IN_MATRIX)} boxes pairs are kept in a hash table."
        return super().why_idle(name)

    def shaping(self) -> tuple[str, ...]:
        """Parameters that the structures are made by."""
        return ("manager",)

    def draw_comparison(self, column: view.Column, name: str, words: str, color: str) -> None:
        """Times of both, as bars, and whether they found the same."""
        mine, naive = self.watch.median(name), self.watch.median("naive")
        n = len(self.ids)
        column.head(
            "Update and all pairs",
            ("same pairs" if self.same else "pairs differ") if self.compared else "not compared",
        )
        longest = max([time for time in (mine, naive) if math.isfinite(time)], default=1.0)
        column.bar(words, view.seconds_text(mine), mine / longest if mine > 0.0 else 0.0, color)
        if self.compared:
            column.bar(
                f"Naive, {view.grouped(n * (n - 1) // 2)} tests",
                view.seconds_text(naive),
                naive / longest,
                "green",
            )
        else:
            column.bar("Naive", "left out", 0.0, "green")

    def legend_rows(self) -> list[tuple[str, str, str]]:
        """Rows that all these scenes have."""
        return [
            ("box:vermilion", "overlapping", view.grouped(self.overlapping())),
            ("box:ghost", "boxes", view.grouped(len(self.ids))),
            ("line:vermilion", "pairs", view.grouped(len(self.pairs))),
        ]


def sketch(canvas: Any, scene: ComparedScene, alpha: float) -> None:
    """World and boxes."""
    view.draw_ground(canvas)
    view.draw_boxes(scene, canvas, alpha)
