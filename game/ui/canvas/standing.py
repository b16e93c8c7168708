"""What stands still in a scene: painted once for a view, then laid again as it was."""

from __future__ import annotations

from collections.abc import Callable, Hashable

import numpy as np
from numpy.typing import NDArray

from game.ui.canvas.canvas import Canvas


class Standing:
    """Keeps the picture of a background as long as the view and what it is painted from stay the same.

    While the view moves, nothing is kept: only what is asked for twice the same way is.
    """

    def __init__(self) -> None:
        self._key: Hashable = None
        self._picture: NDArray[np.uint32] | None = None

    def draw(self, canvas: Canvas, paint: Callable[[Canvas], object], *depends: Hashable) -> None:
        """Let ``paint`` cover the whole canvas, or lay what it has painted before.

        depends: all that the picture is made of beside the view, the look and the size.
        """
        pixels, clip = canvas.raster_target
        left, top, right, bottom = (int(value) for value in clip)
        key = (canvas.camera.affine(), canvas.rect.size, (left, top, right, bottom), canvas.look,
               canvas.words, canvas.teaching, *depends)  # fmt: skip
        if key == self._key and self._picture is not None:
            pixels[top:bottom, left:right] = self._picture
            return
        paint(canvas)
        self._picture = pixels[top:bottom, left:right].copy() if key == self._key else None
        self._key = key
