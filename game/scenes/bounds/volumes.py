"""How the volumes of two hierarchies are drawn: red ones, their ancestors in green, the rest in grey."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.bounds.building import DEPTH
from game.physics.bounds.query import ANCESTOR, OVERLAPPING, REST
from game.scenes.bounds.pair import Place, TreePair
from game.ui.canvas.canvas import Canvas
from game.ui.raster.threads import draw_threads

GREY_ALPHA, GREEN_DASH = 0.40, (7.0, 4.0)
MOST_GREEN, MOST_RED = 160, 120
SHORTEST = 4.0  # px; smaller green volumes have no dashes
LARGE = 60.0  # px; larger capsules have finer round ends


class Shown(NamedTuple):
    """What of the hierarchies is drawn."""

    grey: bool
    green: bool
    deepest: int


class VolumePainter:
    """Draws volumes; keeps the arrays that drawing needs."""

    def __init__(self) -> None:
        self._pairs = np.zeros((0, 2), dtype=np.int64)

    def draw_volumes(
        self, canvas: Canvas, pair: TreePair, places: list[Place], marks: Any, shown: Shown
    ) -> None:
        """Both hierarchies by their marks, down to a level; red ones always."""
        for i, tree in enumerate(pair.trees):
            depth = tree.links[:, DEPTH]
            if shown.grey:
                self.draw_grey(
                    canvas, pair, i, np.flatnonzero((marks[i] == REST) & (depth <= shown.deepest)), places[i]
                )
            if shown.green:
                nodes = np.flatnonzero((marks[i] == ANCESTOR) & (depth <= shown.deepest))[:MOST_GREEN]
                self._draw_green(
                    canvas,
                    self._outlines(canvas, pair, i, nodes, places[i]),
                    depth[nodes],
                    max(tree.depth, 1),
                )
        for i in range(len(pair.trees)):
            nodes = np.flatnonzero(marks[i] == OVERLAPPING)[:MOST_RED]
            for path in self._outlines(canvas, pair, i, nodes, places[i]):
                canvas.polygon(path, fill="vermilion", fill_alpha=0.28, outline="vermilion", width=2.0)

    def _outlines(self, canvas: Canvas, pair: TreePair, i: int, nodes: Any, place: Place) -> list[Floats]:
        """Outlines (p, 2) of volumes in the world, in the order of their nodes."""
        large = _are_large(canvas, pair, i, nodes, place)
        fine = iter(place.to_world(pair.fine[i].of(nodes[large])))
        rough = iter(place.to_world(pair.paths[i][nodes[~large]]))
        return [next(fine) if is_large else next(rough) for is_large in large.tolist()]

    def draw_grey(self, canvas: Canvas, pair: TreePair, i: int, nodes: Any, place: Place) -> None:
        """Volumes of a tree as hairlines."""
        large = _are_large(canvas, pair, i, nodes, place)
        self._draw_hairlines(canvas, place.to_world(pair.paths[i][nodes[~large]]))
        self._draw_hairlines(canvas, place.to_world(pair.fine[i].of(nodes[large])))

    def _draw_hairlines(self, canvas: Canvas, paths: Floats) -> None:
        """Many closed paths (m, p, 2) as hairlines."""
        m, p = paths.shape[:2]
        if m == 0:
            return
        if len(self._pairs) < m * p or self._pairs[p - 1, 1] != 0:
            start = np.arange(m * p)
            self._pairs = np.column_stack((start, np.where(start % p == p - 1, start - p + 1, start + 1)))
        pixels, clip = canvas.raster_target
        mapped = canvas.place_all(paths.reshape(-1, 2))
        colors = np.full(m * p, canvas.ink("ghost"), dtype=np.uint32)
        torn = np.zeros(m * p, dtype=np.int64)
        draw_threads(pixels, clip, mapped, self._pairs[: m * p], torn, colors, GREY_ALPHA)

    def _draw_green(self, canvas: Canvas, paths: list[Floats], depth: Any, deepest: int) -> None:
        for path, level in zip(paths, depth.tolist(), strict=True):
            plain = float(np.ptp(path, axis=0).max()) * canvas.pixels_per_unit < SHORTEST * canvas.k
            alpha = 0.5 + 0.5 * level / deepest
            canvas.polyline(path, "green", 1.5, closed=True, dash=None if plain else GREEN_DASH, alpha=alpha)


def _are_large(canvas: Canvas, pair: TreePair, i: int, nodes: Any, place: Place) -> Any:
    """Which volumes of a tree are capsules so large in the picture that the corners of round ends show."""
    if pair.options.kind != "capsule":
        return np.zeros(len(nodes), dtype=bool)
    return pair.trees[i].sizes[nodes] * place.scale * canvas.pixels_per_unit > LARGE * canvas.k


def warm_up() -> None:
    """Compile the hairlines, by drawing one on a tiny picture."""
    pixels, clip = np.zeros((4, 4), dtype=np.uint32), np.array((0, 0, 4, 4), dtype=np.int64)
    points, pairs = np.zeros((2, 2)), np.zeros((1, 2), dtype=np.int64)
    torn, colors = np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.uint32)
    draw_threads(pixels, clip, points, pairs, torn, colors, GREY_ALPHA)
