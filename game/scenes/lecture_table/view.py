"""How the lecture's table is drawn: balls between two steps, the contacts of the last moments, the cues."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.table.aim import first_contact
from game.billiards.table.table import CUSHION_DEPTH, Table
from game.scenes.lecture_table.marks import MARK_S
from game.scenes.lecture_table.model import SUNK_S, LectureTableModel, LectureTableState
from game.scenes.lecture_table.turns import Turns
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import STRIKING
from game.scenes.shared.tables.view import CUE_LENGTH, WOOD, Balls
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_WARM

PASSED_S = 3.0  # s that a contact is shown that was not noticed
TELEPORT = 0.25  # m; a ball that moved farther in one step was put there, and is not drawn in between
RING_AT = 0.05  # m along the table, of the legend above it
TAKE_OVER = "The table plays itself. Press on it to take the cue."
CUE_WORDS = -28.0  # px above the cue ball, of the speed of the stroke


def draw(
    canvas: Canvas,
    model: LectureTableModel,
    turns: Turns,
    previous: LectureTableState | None,
    alpha: float,
) -> None:
    """The table, the share ``alpha`` between the previous state and the present one."""
    table, cue = model.table.table, turns.cue
    table_view.draw_table(canvas, table)
    canvas.halo = FELT
    balls = _balls_of(model, previous, alpha)
    _draw_marks(canvas, model)
    _draw_passed(canvas, model)
    aiming = model.cue_ball_ready and not turns.plays_itself and cue.phase != STRIKING
    if aiming and model.parameters.aim_line:
        in_play = model.table.state.in_play
        first = first_contact(0, cue.aim, balls.positions, balls.radii, in_play, table)
        table_view.draw_aim(canvas, first, balls.positions[0], float(balls.radii[0]), cue)
        if first.kind == "ball":
            table_view.draw_split(canvas, table, first, balls, cue)
    table_view.draw_balls(canvas, balls, table)
    if model.cue_ball_ready and (aiming or cue.phase == STRIKING):
        table_view.draw_cue_behind(canvas, table, balls.positions[0], float(balls.radii[0]), cue, CUE_WORDS)
    _write_velocity(canvas, model, balls)
    _draw_resting_cue(canvas, model, turns.player)
    _draw_words(canvas, table, turns)


def velocity_words(model: LectureTableModel) -> tuple[str, str]:
    """Of the cue ball: speed and direction (from the table's length, counter-clockwise), and components.

    Empty where there is none, or it is at rest.
    """
    across, along = model.table.velocities[0].tolist()
    speed = math.hypot(across, along)
    if not (model.has_cue_ball and model.table.state.in_play[0] and speed > 0.0):
        return "", ""
    angle = round(math.degrees(math.atan2(-across, along)))
    across, along = (round(part, 2) + 0.0 for part in (across, along))  # no sign before a zero
    words = f"{speed:.2f} m/s at {angle}°", f"along {along:.2f}, across {across:.2f}"
    return words[0].replace("-", "−"), words[1].replace("-", "−")


def _write_velocity(canvas: Canvas, model: LectureTableModel, balls: Balls) -> None:
    """Speed, direction and components of the cue ball beside it, while it moves."""
    for line, words in enumerate(velocity_words(model)):
        if words:
            shown = canvas.figure(("velocity", line), words)
            offset = (0.0, 24.0 + 16.0 * line)
            canvas.label(balls.positions[0], shown, FELT_WARM, 12, "semibold", "center", offset)


def _balls_of(model: LectureTableModel, previous: LectureTableState | None, alpha: float) -> Balls:
    """Balls between the two states; those that have just fallen fade in their pocket."""
    state = model.table.state
    before, then = (
        (state.offsets, state.in_play) if previous is None else (previous.offsets, previous.in_play)
    )
    jump = np.abs(state.offsets - before).max(axis=1) > TELEPORT
    share = np.where(jump | (then != state.in_play), 1.0, alpha)[:, None]
    positions = before + share * (state.offsets - before) + model.table.middle
    fading = 1.0 - model.sunk_s / SUNK_S
    opacities = np.where(state.in_play, 1.0, np.clip(fading, 0.0, 1.0))
    fallen = ~state.in_play & (opacities > 0.0)
    for ball in np.flatnonzero(fallen):
        hole = int(state.pocketed_by[ball])
        if hole >= 0:
            middle = model.table.table.pockets[hole, :2]
            positions[ball] += (1.0 - opacities[ball]) * (middle - positions[ball])
    radii = state.radii * np.where(fallen, 0.8 + 0.2 * opacities, 1.0)
    return Balls(positions, radii, model.numbers, rotation_matrices(state.orientations), opacities)


def _draw_marks(canvas: Canvas, model: LectureTableModel) -> None:
    """Contacts of the last moments as amber rings that fade."""
    mx, my = model.table.middle.tolist()
    for x, y, age, impulse in model.marks.rows.tolist():
        strength = 1.0 - age / MARK_S
        if strength > 0.0:
            size = 3.0 + 9.0 * min(abs(impulse) / 0.8, 1.0) + 6.0 * (1.0 - strength)
            canvas.ring((x + mx, y + my), size, FELT_WARM, 1.5, alpha=0.8 * strength)


def _draw_words(canvas: Canvas, table: Table, turns: Turns) -> None:
    """Above the table: what the amber rings mean, and that it plays itself."""
    x = 0.02 - table_view.SURROUND
    canvas.ring((x, RING_AT), 6.0, "amber", 1.5)
    words = "contact, the wider the harder"
    canvas.label((x, RING_AT), words, "text2", 12, anchor="left", offset=(14.0, 0.0), halo=False)
    if turns.plays_itself:
        canvas.label((x, table.length), TAKE_OVER, "text1", 13, "semibold", anchor="right", halo=False)


def _draw_passed(canvas: Canvas, model: LectureTableModel) -> None:
    """Where two balls went through each other between two steps, unnoticed."""
    if not model.marks.passed:
        return
    when, first, second, *places = model.marks.passed
    strength = 1.0 - (model.played_s - when) / PASSED_S
    if not 0.0 < strength <= 1.0:
        return
    middle, radii = model.table.middle, model.table.state.radii
    for ball, place in ((first, places[:2]), (second, places[2:])):
        ring = (place[0] + middle[0], place[1] + middle[1])
        canvas.circle(
            ring, float(radii[int(ball)]), outline=FELT_WARM, width=1.6, dash=(4.0, 3.0), alpha=strength
        )
    canvas.label(ring, "passed unseen", FELT_WARM, 13, "semibold", offset=(0.0, -26.0), alpha=strength)


def _draw_resting_cue(canvas: Canvas, model: LectureTableModel, player: int) -> None:
    """The other player's cue, laid beside the table."""
    table = model.table.table
    x = table.width + CUSHION_DEPTH + WOOD + 0.035
    y = 0.5 * table.length + (1 - 2 * player) * 0.5 * CUE_LENGTH
    table_view.draw_stick(canvas, table, (x, y), (0.0, 1.0 - 2 * player))
