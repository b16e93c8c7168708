"""An inset: what is too small to be seen, in a corner of the picture as through a lens."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Literal

import msgspec
import numpy as np

from game.stage import Frame
from game.ui.canvas.canvas import Canvas

Metre = Annotated[float, msgspec.Meta(ge=-10_000.0, le=10_000.0)]
SIDE, MARGIN = 0.36, 0.03  # of the height in view
SMALLEST = 4.0  # design px: a region is marked no smaller than that


class Zoom(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True, omit_defaults=True):
    """What an inset shows: a place (m), how many times larger, and in which corner it stands."""

    centre: tuple[Metre, Metre]
    times: Annotated[float, msgspec.Meta(ge=1.5, le=1e6)]
    corner: Literal["topleft", "topright", "bottomleft", "bottomright"] = "topright"


def draw_inset(canvas: Canvas, view: Frame, zoom: Zoom, draw: Callable[[], None]) -> None:
    """Draw again by ``draw`` in a corner of ``view``, larger, and mark in the picture where that is."""
    height = view.top - view.bottom
    side, margin = SIDE * height, MARGIN * height
    left = view.right - margin - side if zoom.corner.endswith("right") else view.left + margin
    low = view.top - margin - side if zoom.corner.startswith("top") else view.bottom + margin
    high = (left + side, low + side)
    with canvas.magnified((left, low), high, zoom.centre, zoom.times):
        canvas.fill()
        draw()
    canvas.polygon(_square((left + 0.5 * side, low + 0.5 * side), 0.5 * side), outline="line2", width=1.4)
    seen = max(0.5 * side / zoom.times, 0.5 * canvas.px(SMALLEST))
    canvas.polygon(_square(zoom.centre, seen), outline="accent", width=1.2)
    canvas.label((left, low), f"{zoom.times:g} times", "text2", 12, anchor="bottomleft", offset=(8.0, -6.0))


def _square(centre: tuple[float, float], half: float) -> np.ndarray:
    """Corners (4, 2) m."""
    (x, y), h = centre, half
    return np.array([(x - h, y - h), (x + h, y - h), (x + h, y + h), (x - h, y + h)])
