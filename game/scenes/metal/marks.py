"""What teaches: contacts, velocities, yards, and the least height for a loop."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.solids.tracks import DISC
from game.physics.solids.tracks.descent import loop_drop
from game.physics.solids.tracks.motion import RADIUS, VX, VY
from game.scenes.metal.balls import NOT_YET
from game.scenes.metal.gauges import VALUE
from game.scenes.metal.told import exact_now
from game.scenes.metal.world import MetalWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.worlds.painting.marks import draw_contacts, draw_velocities

SECONDS = 0.12  # s: a velocity is drawn as the way of this time
SLOW = 0.15  # m/s, no mark
BESIDE = 0.35  # m


def draw_marks(canvas: Canvas, model: MetalWorld, places: Floats) -> None:
    """All of them."""
    for one in model.content.yards:
        corners = np.array(
            [(one.left, one.bottom), (one.right, one.bottom), (one.right, one.top), (one.left, one.top)]
        )
        canvas.polygon(corners, outline="text3", width=1.0, dash=EXACT_DASH, alpha=0.6)
    draw_contacts(canvas, model.world, 2.6)
    rows, balls = model.balls.rows, model.balls
    fast = (np.hypot(rows[:, VX], rows[:, VY]) > SLOW) & (balls.table.freed != NOT_YET) & balls.there()
    draw_velocities(canvas, places[fast], rows[fast][:, [VX, VY]], SECONDS, 2.0)
    _draw_limits(canvas, model)
    _draw_times(canvas, model)


def _draw_limits(canvas: Canvas, model: MetalWorld) -> None:
    """From where a ball without slip would just come round each loop."""
    shown: set[int] = set()
    for gauge, ball in zip(model.content.gauges, model.measured, strict=True):
        if gauge.measure != "drop" or gauge.track >= len(model.content.tracks) or gauge.track in shown:
            continue
        shown.add(gauge.track)
        track = model.content.tracks[gauge.track]
        radius = float(model.balls.rows[ball, RADIUS])
        drop = loop_drop(track.size[0], radius, DISC)
        y, x = track.at[1] + radius + drop, track.at[0]
        left = x - 1.7 * track.size[1]
        canvas.line((left, y), (x + track.size[0], y), "text1", 1.4, dash=EXACT_DASH)
        words = f"11/4 (R − r) = {drop:.3f} m"
        canvas.label((x, y), words, "text1", 13, "semibold", "bottom", (0.0, -4.0), clear=True)


def _draw_times(canvas: Canvas, model: MetalWorld) -> None:
    """Times of a race beside the exact ones, where the tracks end."""
    tracks = model.content.tracks
    for gauge, ball, noted in zip(model.content.gauges, model.measured, model.machine.gauges, strict=True):
        if gauge.measure != "arrives" or gauge.track >= len(tracks):
            continue
        track = tracks[gauge.track]
        exact = exact_now(model, gauge, ball, noted)
        if not exact > 0.0:
            continue
        value = float(noted[VALUE])
        words = f"exact {exact:.4f} s" if value == NOT_YET else f"{value:.4f} s, exact {exact:.4f} s"
        place = (track.at[0] + 0.5 * track.size[0], track.at[1] + BESIDE)
        canvas.label(
            place, canvas.figure(gauge.name, words), "text1", 13, "semibold", "center", (0.0, 0.0), clear=True
        )
