"""Barred zones on the cloth: lines, boxes and anchors, and the one that both object balls lie in."""

from __future__ import annotations

import numpy as np

from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_zones import shared_zones
from game.billiards.table.balk import Zone
from game.billiards.table.carom import BALL_RADIUS
from game.scenes.carom.course import Course
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_LINE, FELT_WARM


def draw_zones(canvas: Canvas, course: Course) -> None:
    """The lines of the game's zones; the zone that counts is lit, with what is left in it said."""
    frame = course.model.frame
    barred = frame.game.rule.barred
    if barred.strokes is None:
        return
    for zone in (*barred.boxes, *barred.anchors):
        _outline(canvas, zone)
    if course.phase != "aiming":
        return
    for zone, count in shared_zones(barred, frame.game.counts, frame.positions, frame.game.cue):
        if not count:  # the opening: nothing has entered yet
            continue
        due = count > barred.strokes
        canvas.polygon(
            np.array(zone.corners), fill=FELT_WARM, fill_alpha=0.2 if due else 0.1, outline=FELT_WARM,
            width=1.5, alpha=0.9 if due else 0.6,
        )  # fmt: skip
        x, y = np.mean(zone.corners, axis=0).tolist()
        low = x + 3.0 * BALL_RADIUS, y
        canvas.label(low, zone_words(frame.game, count), FELT_WARM, 12, "semibold")


def zone_words(game: Carom, count: int) -> str:
    """What the next point must do in a zone. count: ENTERED or INSIDE."""
    return "one must leave" if count > (game.rule.barred.strokes or 0) else "one more point in here"


def _outline(canvas: Canvas, zone: Zone) -> None:
    """A zone's border, drawn thinly."""
    canvas.polyline(np.array(zone.corners), FELT_LINE, 1.0, closed=True, alpha=0.4)
