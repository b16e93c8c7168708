"""A painted picture behind a scene: each pixel shows the cell it lies on, however the view moves."""

from __future__ import annotations

import numpy as np

from game.worlds.painting.backdrops import Painted, Seen
from tests.ui.canvas.test_canvas import begun

HIGH, WIDE, CELL = 30, 50, 0.1
PAINTED = Painted(-2.0, 1.5, CELL)


def layers():
    rng = np.random.default_rng(2)
    return rng.integers(0, 1 << 32, (HIGH, WIDE), np.uint32), rng.integers(0, 256, (HIGH, WIDE), np.uint8)


def plainly(canvas, layer):
    """Of each pixel the cell below its middle."""
    (height, width), camera = canvas.raster_target[0].shape, canvas.camera
    found = np.zeros((height, width), layer.dtype)
    for y in range(height):
        for x in range(width):
            at = camera.to_world(x + 0.5, y + 0.5)
            column = int((at[0] - PAINTED.left) / CELL) if at[0] > PAINTED.left else 0
            row = int((PAINTED.top - at[1]) / CELL) if at[1] < PAINTED.top else 0
            found[y, x] = layer[min(row, HIGH - 1), min(column, WIDE - 1)]
    return found


def test_each_pixel_shows_the_cell_that_it_lies_on():
    canvas, seen, (colors, light) = begun((80, 40)), Seen(), layers()
    for _ in range(2):
        found = seen.of(canvas, PAINTED, (colors, light))
        assert found[0].dtype == np.uint32 and found[1].dtype == np.uint8
        # a middle on a seam of cells may round either way
        assert (found[0] == plainly(canvas, colors)).mean() > 0.97
        assert (found[1] == plainly(canvas, light)).mean() > 0.97


def test_it_follows_the_view_and_the_picture():
    canvas, seen, (colors, light) = begun((80, 40)), Seen(), layers()
    before = seen.of(canvas, PAINTED, (colors, light))[0].copy()
    canvas.camera.pan(11.0, -6.0)
    canvas._look_through(canvas.camera)
    moved = seen.of(canvas, PAINTED, (colors, light))[0].copy()
    assert (moved == plainly(canvas, colors)).mean() > 0.97 and (moved != before).mean() > 0.5
    other = np.ascontiguousarray(colors[::-1])
    assert (seen.of(canvas, PAINTED, (other, light))[0] == plainly(canvas, other)).mean() > 0.97
    assert (seen.of(begun((60, 50)), PAINTED, (other, light))[0].shape) == (50, 60)


def test_what_stands_is_not_gathered_again():
    canvas, seen, (colors, light) = begun((80, 40)), Seen(), layers()
    first = seen.of(canvas, PAINTED, (colors, light))[0]
    kept = first.copy()
    colors[:] = 0
    assert (seen.of(canvas, PAINTED, (colors, light))[0] == kept).all()


def test_beyond_its_edges_the_nearest_cells_go_on():
    canvas, seen, (colors, light) = begun((80, 40)), Seen(), layers()
    canvas.camera.pan(-4000.0, 0.0)
    canvas._look_through(canvas.camera)
    found = seen.of(canvas, PAINTED, (colors, light))[0]
    assert np.isin(found, colors[:, -1]).all()
