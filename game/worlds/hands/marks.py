"""What is seen of a hand."""

from __future__ import annotations

import numpy as np

from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.worlds.hands.hand import NOBODY, Hand


def draw_track_hand(canvas: Canvas, hand: Hand, width: float) -> None:
    """The line that is drawn, ``width`` design px; the ball that is held, or how far a track is bent."""
    if len(hand.path) > 1:
        canvas.polyline(np.array(hand.path), "accent", width)
    if hand.point is None or hand.held == NOBODY:
        return
    if hand.verb != "bend":
        canvas.ring(hand.point, 9.0, "amber", 1.8)
    else:
        bending = hand.parameters.values["bending"]
        canvas.circle(hand.point, bending, outline="amber", width=1.2, dash=PREDICTION_DASH)
