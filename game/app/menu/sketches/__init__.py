"""Quiet drawings for the cards of scenes whose kernels are not compiled yet."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import pygame

from game.app.menu.sketches.animation import draw_key_frames, draw_reaching, draw_skeleton
from game.app.menu.sketches.billiards import (
    draw_billiards,
    draw_lecture_table,
    draw_three_tables,
    draw_two_balls,
)
from game.app.menu.sketches.bounds import (
    draw_capsules,
    draw_oriented_boxes,
    draw_simplexes,
    draw_voronoi_walk,
)
from game.app.menu.sketches.broad_phase import draw_grid, draw_grids_of_sizes, draw_race, draw_sweep
from game.app.menu.sketches.particles import draw_cloth, draw_fountain, draw_jelly
from game.app.menu.sketches.rigid import draw_cradle, draw_rigid_body
from game.ui.canvas.pen import Pen
from game.ui.look.look import Look

SKETCHES: dict[str, Callable[[Pen], None]] = {
    "billiards": draw_billiards,
    "lecture-balls": draw_two_balls,
    "lecture-table": draw_lecture_table,
    "three-tables": draw_three_tables,
    "c01": draw_key_frames,
    "c02": draw_skeleton,
    "c03": draw_reaching,
    "c04": draw_fountain,
    "c05": draw_grid,
    "c06": draw_grids_of_sizes,
    "c07": draw_sweep,
    "broad-phase-race": draw_race,
    "c08": draw_oriented_boxes,
    "c09": draw_capsules,
    "c10": draw_voronoi_walk,
    "c11": draw_simplexes,
    "c12": draw_rigid_body,
    "c13": draw_cradle,
    "c14": draw_cloth,
    "c15": draw_jelly,
}


MOST_KEPT = 64  # drawings: two sizes of all cards, or two themes


@lru_cache(maxsize=MOST_KEPT)
def sketch(name: str, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The drawing of a scene in that size, window px; of one without a drawing a thrown ball."""
    pen = Pen((max(1, size[0]), max(1, size[1])), look)
    SKETCHES.get(name, _draw_thrown_ball)(pen)
    return pen.finished()


def _draw_thrown_ball(pen: Pen) -> None:
    """A thrown ball in a grid: for a scene that has no drawing of its own."""
    pen.fill("stage")
    for x in range(-80, 241, 20):
        pen.line(((x, -40.0), (x, 144.0)), "grid", 0.6)
    for y in range(-38, 144, 20):
        pen.line(((-80.0, y), (240.0, y)), "grid", 0.6)
    path = [(20.0 + 6.0 * t, 84.0 - 9.6 * t + 0.42 * t * t) for t in range(21)]
    pen.line(path, "ghost", 1.0)
    for t in (3, 7, 11):
        pen.disc(*path[t], 6.0, "line2", ring=0.9)
    pen.disc(*path[15], 6.5, "body")
    pen.disc(*path[15], 6.5, "chalk", ring=1.5)
