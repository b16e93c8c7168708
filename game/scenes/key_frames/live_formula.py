"""The formula of the chosen interpolation with the numbers that it has now."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.scenes.key_frames.animation import PLACE
from game.scenes.key_frames.model import KeyFrameModel
from game.ui.canvas.canvas import Canvas

LINE = 22.0  # design px


class Piece(NamedTuple):
    """The piece between two keys that is played: the first key's number, u within it, weights and the x (m)
    that they weigh."""

    number: int
    u: float
    weights: tuple[float, ...]
    places: tuple[float, ...]

    @property
    def x(self) -> float:
        """What comes out, m."""
        return float(np.dot(self.weights, self.places))


def piece_of(model: KeyFrameModel) -> Piece | None:
    """The piece that is shown now; None before the first key, after the last, and for a single key."""
    animation = model.animation()
    track = animation.track
    time = float(animation.playback.key_times(np.array([model.player.shown_part()]))[0])
    times = track.times
    i = int(np.searchsorted(times, time, side="right")) - 1
    if not 0 <= i < len(times) - 1:
        return None
    u = float((time - times[i]) / (times[i + 1] - times[i]))
    a, b = float(track.values[i, 0]), float(track.values[i + 1, 0])
    if track.interpolation == "nearest":
        return Piece(i, u, (1.0, 0.0) if u < 0.5 else (0.0, 1.0), (a, b))
    if track.interpolation == "linear":
        return Piece(i, u, (1.0 - u, u), (a, b))
    controls = track.path(PLACE).controls[i, :, 0]
    bernstein = ((1.0 - u) ** 3, 3.0 * u * (1.0 - u) ** 2, 3.0 * u * u * (1.0 - u), u**3)
    return Piece(i, u, bernstein, tuple(controls.tolist()))


def draw_live_formula(canvas: Canvas, model: KeyFrameModel, corner: tuple[float, float]) -> None:
    """In the upper right corner (m): the formula, u, and the sum."""
    piece = piece_of(model)
    if piece is None:
        return
    kind = model.animation().track.interpolation
    if kind == "nearest":
        markup = r"x = x_i  \text{ or }  x_{i+1}"
    elif kind == "linear":
        markup = r"x = (1-u) x_i + u x_{i+1}"
    else:
        markup = r"x = (1-u)^3 P_0 + 3u(1-u)^2 P_1 + 3u^2(1-u) P_2 + u^3 P_3"
    canvas.formula(corner, markup, "text1", 16, "topright", (-14.0, 12.0))
    sum_of = " + ".join(f"{w:.2f}·{_bracketed(x)}" for w, x in zip(piece.weights, piece.places, strict=True))
    lines = (
        f"piece {piece.number + 1},  u = {piece.u:.2f}",
        f"x = {sum_of} = {piece.x:.2f} m".replace("-", "−"),
    )
    for i, words in enumerate(lines):
        canvas.label(corner, words, "text2", 12, "medium", "topright", (-14.0, 40.0 + LINE * i))


def _bracketed(x: float) -> str:
    return f"({x:.2f})" if x < 0.0 else f"{x:.2f}"
