"""Working memory of the kernels that cover a whole shape before they blend it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Scratch(NamedTuple):
    """Working memory of the kernels that lay a whole shape at once; in its resting state between calls."""

    cover: np.ndarray  # (h, w) uint8, zero
    area: np.ndarray  # (h, w + 2) float32, zero
    extent: np.ndarray  # (h, 2) int64, first and last touched column: none


_scratch = Scratch(np.zeros((0, 0), np.uint8), np.zeros((0, 2), np.float32), np.zeros((0, 2), np.int64))


def scratch_for(pixels: np.ndarray) -> Scratch:
    """Scratch at least as large as the picture; it grows and is shared, so use it on one thread."""
    global _scratch
    height, width = pixels.shape
    if height > _scratch.cover.shape[0] or width > _scratch.cover.shape[1]:
        height, width = max(height, _scratch.cover.shape[0]), max(width, _scratch.cover.shape[1])
        extent = np.empty((height, 2), np.int64)
        extent[:, 0], extent[:, 1] = 1 << 30, -1
        _scratch = Scratch(
            np.zeros((height, width), np.uint8), np.zeros((height, width + 2), np.float32), extent
        )
    return _scratch
