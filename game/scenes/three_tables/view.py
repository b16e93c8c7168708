"""How the three tables are drawn: one in each quarter of the picture, and the chart of their differences."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.laws.state import BALL_POCKET
from game.billiards.table.aim import first_contact
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import STRIKING
from game.scenes.shared.tables.view import Balls
from game.scenes.three_tables import places
from game.scenes.three_tables.chart import draw_chart
from game.scenes.three_tables.hand import ThreeTablesHand
from game.scenes.three_tables.model import ThreeTablesModel
from game.scenes.three_tables.places import ORIGINS
from game.scenes.three_tables.readouts import difference_now
from game.scenes.three_tables.shot import MODELS
from game.scenes.three_tables.state import TIME, ThreeTablesState
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_LINE

FRAME = Frame(-0.30, -0.21, places.ACROSS + places.WIDTH + 0.19, places.ALONG + places.LENGTH + 0.21)
TITLES = ("The lecture's table", "Stepped, all of the physics", "Exact, from event to event")
SEEN_APART = 0.003  # m; from there on an outline stands out beside its ball
CUE_WORDS = -24.0  # px above the cue ball, of the speed of the stroke


def draw(
    canvas: Canvas,
    model: ThreeTablesModel,
    hand: ThreeTablesHand,
    previous: ThreeTablesState | None,
    alpha: float,
) -> None:
    """All tables at one moment between two steps, and the chart up to it."""
    canvas.fill("bg")
    time = _moment(model, previous, alpha)
    striking = hand.cue.phase == STRIKING
    for origin, title, name in zip(ORIGINS, TITLES, MODELS, strict=True):
        table_view.draw_table(canvas, model.bed, origin, alone=False)
        canvas.halo = canvas.theme.bg
        off = f": {_length(difference_now(model, name))} off" if model.playing and name != "exact" else ""
        canvas.label((origin[0] - 0.19, origin[1] - 0.1), title + off, "text1", 13, "semibold", anchor="left")
        canvas.halo = FELT
        balls = _balls_at(model, name, time)
        table_view.draw_balls(canvas, balls, model.bed, origin)
        if model.playing and name != "exact":
            for place, radius in outlines_of(balls, _balls_at(model, "exact", time)):
                canvas.circle(place + origin, radius, outline=FELT_LINE, width=1.25, alpha=0.75)
        if model.playing or (hand.plays_itself and not striking):
            continue
        if model.parameters.prediction and not striking:
            _draw_aim(canvas, model, hand, balls, origin)
        ball, radius = balls.positions[0] + origin, float(balls.radii[0])
        table_view.draw_cue_behind(canvas, model.bed, ball, radius, hand.cue, CUE_WORDS)
    draw_chart(canvas, model, time)


def _moment(model: ThreeTablesModel, previous: ThreeTablesState | None, alpha: float) -> float:
    """Time of the shot that is shown: the tables are known at every moment, not only at steps.

    What is not known yet is computed, a slice in each picture.
    """
    if not model.playing:
        return 0.0
    time = float(model.shot[TIME])
    if previous is not None and previous.shot[TIME] <= time:
        before = float(previous.shot[TIME])
        time = before + alpha * (time - before)
    played = model.played
    played.compute(min(time, played.reached_s + played.steps.slice_s))
    return min(time, played.reached_s)


def _balls_at(model: ThreeTablesModel, name: str, time: float) -> Balls:
    """The balls of one table at a time of the shot, s; those in a pocket by then cannot be seen."""
    rows = np.flatnonzero(model.in_play)
    played = model.played.tables[name]
    gone = np.zeros(len(rows), dtype=bool)
    fallen = (played.rows[:, 1] == BALL_POCKET) & (played.rows[:, 0] <= time)
    gone[played.rows[fallen, 2].astype(np.int64)] = True
    return Balls(
        played.state_at(time).positions,
        model.radii[rows],
        model.numbers[rows],
        played.orientations_at(time),
        np.where(gone, 0.0, 1.0),
    )


def outlines_of(balls: Balls, exact: Balls) -> list[tuple[Floats, float]]:
    """Where (m) the exact table has those balls, with what radius (m), that are seen to lie elsewhere.

    One that the exact table has lost to a pocket has no outline.
    """
    apart = np.sqrt(((balls.positions - exact.positions) ** 2).sum(axis=1))
    rows = np.flatnonzero((exact.opacities > 0.0) & ((apart > SEEN_APART) | (balls.opacities == 0.0)))
    return [(exact.positions[row], float(exact.radii[row])) for row in rows.tolist()]


def _draw_aim(
    canvas: Canvas,
    model: ThreeTablesModel,
    hand: ThreeTablesHand,
    balls: Balls,
    origin: tuple[float, float],
) -> None:
    in_play = np.ones(len(balls.radii), dtype=bool)
    first = first_contact(0, hand.cue.aim, balls.positions, balls.radii, in_play, model.bed)
    moved = first._replace(ghost=(first.ghost[0] + origin[0], first.ghost[1] + origin[1]))
    table_view.draw_aim(canvas, moved, balls.positions[0] + origin, float(balls.radii[0]), hand.cue)


def _length(metres: float) -> str:
    """A distance in words."""
    for factor, unit in ((1.0, "m"), (1e3, "mm"), (1e6, "µm"), (1e9, "nm")):
        if metres * factor >= 1.0:
            return f"{metres * factor:.3g} {unit}"
    return f"{metres * 1e12:.2g} pm" if metres >= 1e-14 else "nothing"
