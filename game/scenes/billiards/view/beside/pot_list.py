"""The pots of the map as a list, the surest first."""

from __future__ import annotations

import numpy as np

from game.billiards.game.rules import listed
from game.billiards.map.pool import Pot
from game.billiards.map.words import tip_words
from game.scenes.billiards import layout
from game.scenes.billiards.play import SET_UP
from game.scenes.billiards.practice.advisor import Drawn, PoolAdvisor
from game.scenes.billiards.practice.columns import COLUMN, ROWS
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.shared.tables.beside.rows import Row, draw_ground, draw_rows
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look


def draw_pots(canvas: Canvas, look: Look, advisor: PoolAdvisor, drawn: Drawn | None) -> None:
    """The list, or why there is none."""
    draw_ground(canvas, look, COLUMN, *heading(advisor, drawn))
    if drawn is None:
        return
    chosen = advisor.chosen
    rows = [row_of(pot, pot is chosen, not advisor.fresh) for pot in drawn.map.pots[:ROWS]]
    draw_rows(canvas, look, COLUMN, rows)


def heading(advisor: PoolAdvisor, drawn: Drawn | None) -> tuple[str, str]:
    """Two lines over the list."""
    if drawn is None:
        waits = "It is being drawn …" if advisor.active else "It is drawn when you may play, and in set-up."
        return "Every pot", waits
    scoring, tried = int(np.count_nonzero(drawn.map.keys)), len(drawn.map.strokes)
    hand = hand_of(advisor.play).words
    click = (
        "A click plays it." if advisor.play.phase == SET_UP else "A click aims a pot, another one plays it."
    )
    said = f"{hand}. Light: where the cue ball may end. {click}"
    return f"Every pot: {scoring} of {tried} strokes", said


def row_of(pot: Pot, lit: bool, faint: bool) -> Row:
    """One way to pot a ball: how often a hand makes it, by which balls, how it is struck."""
    between = pot.chain[1:-1]
    by = f" by {listed(between)}".replace(" or ", " and ") if between else ""
    off = f", {pot.cushions} cushion{'s' * (pot.cushions != 1)}" if pot.cushions else ""
    return Row(
        f"{round(100.0 * pot.chance)} %", f"{pot.ball}, {layout.POCKETS[pot.pocket]}{by}{off}",
        f"{power_of(pot.stroke.cue_speed):.1f} m/s, {tip_words(pot.stroke, brief=True)}",
        lit=lit, faint=faint, share=pot.chance,
    )  # fmt: skip
