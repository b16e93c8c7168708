"""The goals of a lesson or a drill on the cloth: rings where balls must stop, pockets where they fall."""

from __future__ import annotations

from collections.abc import Sequence

from game.billiards.game.goals import Goal
from game.billiards.table.table import Table
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_WARM

STAR = "★"


def draw_goals(canvas: Canvas, goals: Sequence[Goal], table: Table) -> None:
    """All of them; each ring with the stars that it brings."""
    with canvas.within((0.0, 0.0), (table.width, table.length)):
        _draw_rings(canvas, goals, table)
    for pot in goals[0].pots:
        if pot.pocket is not None and pot.pocket < len(table.pockets):
            x, y, radius = table.pockets[pot.pocket].tolist()
            canvas.circle((x, y), radius + canvas.px(3.0), outline=FELT_WARM, width=2.0)


def _draw_rings(canvas: Canvas, goals: Sequence[Goal], table: Table) -> None:
    """Where a ball must stop, each ring with the stars that it brings at its end towards the middle."""
    middle = 0.5 * table.width
    for stars, goal in enumerate(goals, 1):
        for zone in goal.zones:
            inward = 1.0 if zone.x < middle else -1.0
            canvas.circle((zone.x, zone.y), zone.radius, fill=FELT_WARM, fill_alpha=0.08, outline=FELT_WARM,
                          width=1.5, dash=(5.0, 4.0))  # fmt: skip
            end = (zone.x + inward * zone.radius, zone.y)
            canvas.label(end, STAR * stars, FELT_WARM, 11, offset=(0.0, -9.0 * inward), halo=False)
