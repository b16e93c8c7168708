"""Pictures in few numbers: another one for another picture, and the same where pixels are rounded otherwise.

Each part of a picture is added up with a sign for each pixel and colour, as if by chance (Johnson and
Lindenstrauss 1984). Rounding cancels in such a sum, and what is drawn elsewhere or otherwise does not.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np
import pygame

from game.app.stagehand.view import StageView
from game.stage import Stage
from game.ui.look.look import Look
from game.ui.look.theme import DARK

SIZE = (640, 360)  # px
PARTS = (8, 5)  # across and down
NEAR = 2.5  # of a sum over the root of its terms: rounding of all pixels by 1 of 255 is 0.8
_MIXING = np.uint32(2654435761)  # Knuth, The Art of Computer Programming, vol. 3, 6.4


def sums_of(surface: pygame.Surface) -> str:
    """The sums of the parts of a picture of 32 bits, line by line; its sides are multiples of `PARTS`."""
    (across, down), (width, height) = PARTS, surface.get_size()
    pixels = np.frombuffer(surface.get_buffer(), np.uint8).reshape(height, 4 * width)
    signs = _signs(height // down, 4 * width // across)
    sums = []
    for row in range(down):
        band = pixels[row * len(signs) : (row + 1) * len(signs)].astype(np.float32)
        sums.append(np.einsum("yxc,yc->x", band.reshape(len(signs), across, -1), signs, optimize=False))
    return " ".join(f"{value:.1f}" for value in (np.concatenate(sums) / math.sqrt(signs.size) + 0.0).tolist())


def picture_of(stage: Stage) -> str:
    """The sums of what a scene shows now of the whole of its frame, painted as on the screen."""
    surface = pygame.Surface(SIZE, 0, 32)
    look = Look(DARK)
    surface.fill(look.theme.bg)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    view.draw(surface, alpha=1.0)
    return sums_of(surface)


def other_parts(kept: str, now: str) -> Iterator[str]:
    """Where two pictures differ, by the parts' columns and rows, and by how much."""
    pairs = zip(kept.split(), now.split(), strict=True)
    for number, (one, other) in enumerate(pairs):
        apart = abs(float(one) - float(other))
        if apart > NEAR:
            yield f"column {number % PARTS[0] + 1}, row {number // PARTS[0] + 1}: {apart:.1f}"


@functools.cache
def _signs(rows: int, columns: int) -> np.ndarray:
    """1 or -1 for each number of a part, 0 for each fourth one, which is no colour."""
    mixed = np.arange(1, rows * columns + 1, dtype=np.uint32) * _MIXING
    signs = np.where(mixed >> np.uint32(17) & np.uint32(1), 1.0, -1.0).astype(np.float32)
    signs[3::4] = 0.0
    return signs.reshape(rows, columns)
