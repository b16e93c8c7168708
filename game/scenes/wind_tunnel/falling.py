"""How the flights are drawn: shapes that fall through a shaft of still air, with where they were."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.scenes.wind_tunnel import flights as f
from game.scenes.wind_tunnel.flights import FlightsState
from game.scenes.wind_tunnel.model import WindTunnelModel
from game.stage import Frame
from game.ui.canvas.canvas import Canvas

COLORS = {f.DEFAULT: "text2", f.FITTED: "chalk", f.SERIES: "amber"}
WORDS = {f.DEFAULT: "the law as it is", f.FITTED: "the law, fitted", f.SERIES: "as measured"}
WIDE = 26.0  # half chords across the shaft
START = 0.08  # of the shaft's height, below its top


def draw_shaft(canvas: Canvas, box: Frame) -> None:
    """The ground on which they are seen."""
    corners = ((box.left, box.bottom), (box.right, box.bottom), (box.right, box.top), (box.left, box.top))
    canvas.polygon(np.array(corners), "panel", 0.7)


def draw_flights(
    canvas: Canvas, model: WindTunnelModel, box: Frame, previous: FlightsState | None, alpha: float
) -> None:
    """All that fly; what falls out below comes in again above, in the picture only."""
    flights = model.flights
    scale = (box.right - box.left) / (WIDE * flights.half)
    poses = flights.poses()
    if previous is not None and len(flights.kinds) == previous.flashes.shape[2]:
        poses = poses + (1.0 - alpha) * (_poses_of(previous) - poses)
    with canvas.within((box.left, box.bottom), (box.right, box.top)):
        _draw_flashes(canvas, model, box, scale)
        for k, kind in enumerate(flights.kinds):
            outline = _outline(model, poses[:, k], box, scale)
            canvas.polygon(outline, COLORS[kind], 0.9, "text1", 1.2)
    for x in (box.left, box.right):
        canvas.line((x, box.bottom), (x, box.top), "line2", 1.0)
    _draw_words(canvas, model, box)


def _poses_of(state: FlightsState) -> Floats:
    found = state.plates.rows[:3]
    if state.coefficients.shape[1]:
        found = np.concatenate([found, state.row[:3, None]], axis=1)
    return np.asarray(found)


def _places(poses: Floats, box: Frame, scale: float) -> Floats:
    """Of poses (n, 3) in the picture (n, 2), come round at both sides and at the bottom."""
    size = np.array((box.right - box.left, box.top - box.bottom))
    start = size * (0.5, 1.0 - START)
    corner = np.array((box.left, box.bottom))
    return np.asarray(corner + np.mod(start + scale * poses[:, :2], size))


def _outline(model: WindTunnelModel, pose: Floats, box: Frame, scale: float) -> Floats:
    """Corners (n, 2) in the picture."""
    made = model.tunnel.outline
    corners = made.corners * (2.0 * model.flights.half * scale / made.chord)
    c, s = math.cos(float(pose[2])), math.sin(float(pose[2]))
    x, y = corners[:, 0], corners[:, 1]
    at = _places(pose[None], box, scale)[0]
    return np.stack([at[0] + c * x - s * y, at[1] + s * x + c * y], axis=1)


def _draw_flashes(canvas: Canvas, model: WindTunnelModel, box: Frame, scale: float) -> None:
    """The chord at each flash, the newer the stronger."""
    flights = model.flights
    count = int(flights.clock[1])
    order = np.arange(max(count - f.FLASHES, 0), count) % f.FLASHES
    half = flights.half * scale
    for k, kind in enumerate(flights.kinds):
        for part, chosen in enumerate(np.array_split(order, 4)):
            poses = flights.flashes[chosen, :, k]
            if not len(poses):
                continue
            at = _places(poses, box, scale)
            way = half * np.stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])], axis=1)
            canvas.segments(at - way, at + way, COLORS[kind], 1.3, 0.16 + 0.16 * part)


def _draw_words(canvas: Canvas, model: WindTunnelModel, box: Frame) -> None:
    corner = (box.left, box.top)
    canvas.label(corner, "Let it fly", "text1", 13, "semibold", anchor="topleft", offset=(8.0, 8.0))
    for k, kind in enumerate(model.flights.kinds):
        offset = (8.0, -8.0 - 17.0 * (len(model.flights.kinds) - 1 - k))
        low = (box.left, box.bottom)
        canvas.label(low, WORDS[kind], COLORS[kind], 12, "semibold", anchor="bottomleft", offset=offset)
    if model.series is None:
        middle = (0.5 * (box.left + box.right), box.bottom)
        words = "After a sweep, two more fly."
        canvas.label(middle, words, "text3", 11, anchor="bottom", offset=(0.0, -30.0))
