"""Marks on the cloth: the head string, rings of goals, what is called, the cue ball in hand."""

from __future__ import annotations

from game.billiards.game.games import Drill
from game.billiards.game.games.eight_ball import EIGHT
from game.billiards.game.rules import CUE_BALL, Game
from game.billiards.table.rack import HEAD_SPOT
from game.scenes.billiards.play import AIMING, SET_UP, Play
from game.scenes.shared.tables.lessons.rings import draw_goals
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT_COOL, FELT_LINE, FELT_WARM

OWN_RING = 1.32  # of the light round a ball, in its radii


def draw_marks(canvas: Canvas, play: Play) -> None:
    """All of them, as far as game and phase have them."""
    frame, aiming = play.model.frame, play.phase == AIMING
    table, game = frame.table, frame.game
    if game.in_hand == "behind the line" and aiming:
        y = HEAD_SPOT * table.length
        canvas.line((0.0, y), (table.width, y), FELT_LINE, 1.25, dash=(6.0, 6.0), alpha=0.6)
    if isinstance(game, Drill) and play.phase != SET_UP:
        draw_goals(canvas, (game.goal, *game.more), table)
    if play.may_aim:
        _draw_own(canvas, play)
    _draw_call(canvas, play)
    if aiming and play.may_aim and play.aiming.locked and frame.cue_ball is not None:
        canvas.circle(
            frame.cue_ball, 1.4 * float(frame.layout.balls.radii[CUE_BALL]), outline=FELT_WARM, width=2.0
        )
    if game.in_hand and aiming and frame.cue_ball is not None and play.person_plays:
        radius = 1.7 * float(frame.layout.balls.radii[CUE_BALL])
        canvas.circle(frame.cue_ball, radius, outline=FELT_WARM, width=1.5, dash=(4.0, 3.0))


def own_balls(game: Game) -> tuple[int, ...]:
    """The balls that the player at turn may hit first; none if those are all, or all but the 8."""
    own = game.legal_first()
    return () if len(own) > 1 and set(game.on_table) <= {*own, EIGHT} else own


def _draw_own(canvas: Canvas, play: Play) -> None:
    """A soft light round the own balls of the player at turn.

    Solids have a whole ring and stripes a broken one: a stripe that is turned to its pole looks like a solid.
    """
    frame = play.model.frame
    own = own_balls(frame.game)
    for number, x, y in frame.layout.places:
        if number in own:
            radius = OWN_RING * float(frame.layout.balls.radii[number])
            dash = (3.0, 3.0) if number > EIGHT else None
            canvas.circle((x, y), radius, fill=FELT_LINE, fill_alpha=0.16, outline=FELT_LINE, width=1.25,
                          dash=dash, alpha=0.75)  # fmt: skip


def _draw_call(canvas: Canvas, play: Play) -> None:
    """The pocket and the ball that are called."""
    frame, call = play.model.frame, play.aiming.call
    if call.pocket is not None and call.pocket < len(frame.table.pockets):
        x, y, radius = frame.table.pockets[call.pocket].tolist()
        canvas.circle((x, y), radius + canvas.px(3.0), outline=FELT_COOL, width=2.5)
    for number, x, y in frame.layout.places:
        if number == call.ball and play.phase == AIMING:
            radius = 1.35 * float(frame.layout.balls.radii[number])
            canvas.circle((x, y), radius, outline=FELT_COOL, width=2.0)
