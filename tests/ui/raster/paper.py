"""A small black picture to draw on, and the plain truth about coverage by counting samples."""

import numpy as np

from game.ui.raster import Scratch

SAMPLES = 12


class Paper:
    """White on black, so that a channel / 255 is the coverage that was drawn."""

    def __init__(self, width=40, height=30, clip=None):
        self.pixels = np.full((height, width), 0xFF000000, np.uint32)
        self.clip = np.array(clip or (0, 0, width, height), np.int64)
        extent = np.empty((height, 2), np.int64)
        extent[:, 0], extent[:, 1] = 1 << 30, -1
        self.scratch = Scratch(
            np.zeros((height, width), np.uint8), np.zeros((height, width + 2), np.float32), extent
        )

    @property
    def coverage(self):
        """What has been drawn, (height, width), 0 to 1."""
        return (self.pixels & 0xFF) / 255.0

    def is_clean(self):
        """Whether the scratch is in its resting state."""
        rest = (self.scratch.extent[:, 0] == 1 << 30).all() and (self.scratch.extent[:, 1] == -1).all()
        return bool(rest and not self.scratch.cover.any() and not self.scratch.area.any())

    def untouched_outside(self):
        """Whether every pixel outside of the clip is still black."""
        left, top, right, bottom = self.clip
        copy = self.pixels.copy()
        copy[max(0, top) : max(0, bottom), max(0, left) : max(0, right)] = 0xFF000000
        return bool((copy == 0xFF000000).all())


def sampled(inside, width=40, height=30):
    """Coverage by counting samples in each pixel; ``inside`` (x, y) -> bool on arrays."""
    offsets = (np.arange(SAMPLES) + 0.5) / SAMPLES
    x = (np.arange(width)[:, None] + offsets).reshape(-1)
    y = (np.arange(height)[:, None] + offsets).reshape(-1)
    grid = inside(x[None, :], y[:, None]).astype(float)
    return grid.reshape(height, SAMPLES, width, SAMPLES).mean(axis=(1, 3))


def segment_distance(x, y, x0, y0, x1, y1):
    """Distance of points from a segment."""
    dx, dy = x1 - x0, y1 - y0
    t = np.clip(((x - x0) * dx + (y - y0) * dy) / max(dx * dx + dy * dy, 1e-300), 0, 1)
    return np.hypot(x - x0 - t * dx, y - y0 - t * dy)


def in_polygon(points):
    """Function that tells whether points lie in a polygon, by the parity of crossings."""

    def inside(x, y):
        result = np.zeros(np.broadcast(x, y).shape, bool)
        for (x0, y0), (x1, y1) in zip(points, np.roll(points, -1, axis=0), strict=True):
            if y0 != y1:
                crosses = (y0 > y) != (y1 > y)
                result ^= crosses & (x < x0 + (y - y0) / (y1 - y0) * (x1 - x0))
        return result

    return inside
