"""The table, and below it the bar of the beat: what was tapped, what is heard, and how far apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.billiards.laws.state import BALL_POCKET, IN_RADIUS
from game.billiards.rhythm.hearing import TOGETHER
from game.billiards.shot.trajectory import Trajectory
from game.scenes.beat import state as s
from game.scenes.beat.model import SHOWN_S, BeatModel, Shown
from game.scenes.beat.state import BeatState
from game.scenes.shared.tables.view import Balls, draw_balls, draw_stick, draw_table
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si
from game.ui.look.theme import FELT, FELT_LINE
from game.worlds.expectations import Caption, draw_captions

RIM = 0.19  # m of wood and floor about the bed
WIDTH, LENGTH = 1.27, 2.54  # m, of the bed
PAD = Frame(
    WIDTH + RIM + 0.02, 0.0, WIDTH + RIM + 0.44, LENGTH
)  # the bar; x runs down the picture, y along it
BEATS, IMPACTS = PAD.left + 0.12, PAD.left + 0.26  # m down, of the two rows
CUE_S = 0.5  # before the stroke that the cue is seen
WORDS = {
    s.TAPPING: "Go on tapping; rest to have it played.",
    s.SEARCHING: "Searching: a ball for every beat.",
    s.SILENT: "Tap a beat: B, or a press on this bar.",
}


def frame_of(model: BeatModel) -> Frame:
    """The table and the bar."""
    return Frame(-RIM, -RIM, PAD.right + 0.06, model.table.length + RIM)


def draw(
    canvas: Canvas,
    model: BeatModel,
    previous: BeatState | None,
    alpha: float,
    captions: Sequence[Caption] = (),
) -> None:
    """A moment between two steps; what a level expects, beside what is measured."""
    canvas.fill("bg")
    time = model.clock
    if previous is not None and previous.numbers[s.CLOCK] <= time:
        time = float(previous.numbers[s.CLOCK]) + alpha * (time - float(previous.numbers[s.CLOCK]))
    draw_table(canvas, model.table, alone=False)
    shown = model.shown
    canvas.halo = FELT
    if shown is not None:
        draw_balls(canvas, balls_at(shown.trajectory, time), model.table)
        _draw_rings(canvas, shown, time)
        if -CUE_S < time < 0.06:
            _draw_cue(canvas, model, time)
    canvas.halo = canvas.theme.bg
    _draw_bar(canvas, model, time)
    draw_captions(canvas, (-RIM + 0.02, 0.5 * model.table.length), captions)


def balls_at(trajectory: Trajectory, time: float) -> Balls:
    """The balls at a moment (s); those in a pocket by then cannot be seen."""
    state = trajectory.state_at(time)
    gone = np.zeros(len(state.positions), dtype=bool)
    fallen = (trajectory.rows[:, 1] == BALL_POCKET) & (trajectory.rows[:, 0] <= time)
    gone[trajectory.rows[fallen, 2].astype(np.int64)] = True
    count = len(state.positions)
    radii = trajectory.shot.balls[:, IN_RADIUS].copy()
    turns = trajectory.orientations_at(time)
    return Balls(state.positions, radii, np.arange(count), turns, np.where(gone, 0.0, 1.0))


def _draw_rings(canvas: Canvas, shown: Shown, time: float) -> None:
    """A ring that spreads from where an impact was just heard."""
    trajectory = shown.trajectory
    for row in trajectory.rows[trajectory.rows[:, 1] <= BALL_POCKET].tolist():
        since = time - row[0]
        if 0.0 <= since < 0.35 and any(abs(row[0] - one) < 1e-9 for one in shown.clicks):
            place = trajectory.state_at(row[0]).positions[int(row[2])]
            canvas.circle(place, 0.04 + 0.25 * since, outline=FELT_LINE, width=1.6, alpha=1.0 - since / 0.35)


def _draw_cue(canvas: Canvas, model: BeatModel, time: float) -> None:
    speed, azimuth = float(model.data.layout[0]), float(model.data.layout[1])
    along = float(np.cos(azimuth)), float(np.sin(azimuth))
    gap = 0.03 + (
        0.25 * np.sin(np.pi * min(-time / CUE_S, 1.0)) * min(speed / 3.0, 1.0) if time < 0.0 else 0.0
    )
    x, y = model.data.layout[4:6].tolist()
    draw_stick(canvas, model.table, (x - gap * along[0], y - gap * along[1]), along)


def _draw_bar(canvas: Canvas, model: BeatModel, time: float) -> None:
    """Two rows over time: beats above, impacts below, joined where one meets the other."""
    last = (
        max(model.beats[-1] if model.beats else 1.0, model.clock if model.phase == s.TAPPING else 0.0)
        + SHOWN_S
    )
    left, right = 0.16, LENGTH - 0.04

    def at(moment: float) -> float:
        return left + (right - left) * min(max(moment, 0.0), last) / last

    for row, words in ((BEATS, "beats"), (IMPACTS, "impacts")):
        canvas.line((row, left), (row, right), "line", 1.4)
        canvas.label((row, left - 0.03), words, "text2", 12, anchor="right")
    for beat in model.beats:
        canvas.circle((BEATS, at(beat)), 0.016, "amber")
    shown = model.shown
    if shown is not None:
        for moment in shown.clicks:
            on = any(abs(moment - beat) < TOGETHER for beat in model.beats)
            canvas.line(
                (IMPACTS - 0.022, at(moment)),
                (IMPACTS + 0.022, at(moment)),
                "text1" if on else "vermilion",
                2.2,
            )
        for beat, miss in zip(model.beats, shown.rhythm.misses, strict=True):
            canvas.line((BEATS + 0.02, at(beat)), (IMPACTS - 0.025, at(beat + miss)), "text3", 1.0)
            if beat > 0.0:
                words = format_si(miss, "s") if abs(miss) > 1e-12 else "0 s"
                canvas.label((IMPACTS + 0.045, at(beat)), words, "text2", 11, anchor="center")
    if model.phase in (s.PLAYING, s.TAPPING):
        canvas.line((PAD.left + 0.03, at(time)), (PAD.right - 0.03, at(time)), "amber", 1.4, alpha=0.8)
    words = WORDS.get(model.phase, "")
    if not words and shown is not None:
        found = shown.rhythm
        off = f", {found.extras} off the beat" if found.extras else ""
        late = f", {shown.after} after the last" if shown.after else ""
        words = f"{len(found.impacts)} impacts for {len(found.beats)} beats{off}{late}"
    canvas.label((PAD.left + 0.035, left), words, "text1", 13, "semibold", anchor="left")
