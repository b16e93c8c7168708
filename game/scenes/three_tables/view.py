"""How the three tables are drawn: one in each quarter of the picture, and the chart of their differences."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.billiards.laws.state import BALL_POCKET
from game.billiards.table.aim import first_contact
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import PULLING, STRIKING
from game.scenes.shared.tables.view import Balls
from game.scenes.three_tables.readouts import difference_now
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_WARM

if TYPE_CHECKING:
    from game.scenes.three_tables.scene import ThreeTables

WIDTH, LENGTH = 1.27, 2.54  # m, of the bed
ACROSS, ALONG = 1.68, 2.98  # m from one table to the next
ORIGINS = ((0.0, 0.0), (0.0, ALONG), (ACROSS, 0.0))  # lecture, stepped, exact
CHART = (ACROSS - 0.08, ALONG - 0.02)  # m, top left corner of the chart
CHART_SIZE = (1.40, 2.50)  # m, down and to the right
FRAME = Frame(-0.30, -0.21, ACROSS + WIDTH + 0.19, ALONG + LENGTH + 0.21)
TITLES = ("The lecture's table", "Stepped, all of the physics", "Exact, from event to event")
SERIES = {"lecture": "chalk", "stepped": "green", "perturbed": "pink"}  # those of the strip
HIGHEST, LOWEST = 1.0, -16.0  # log10 m, of the chart


def table_at(x: float, y: float) -> int:
    """Which table a point of the world belongs to; the chart's quarter counts as the exact one's."""
    if x < ACROSS - 0.26:
        return 0 if y < ALONG - 0.24 else 1
    return 2


def draw(scene: ThreeTables, canvas: Canvas, alpha: float) -> None:
    """All tables at one moment between two steps, and the chart up to it."""
    canvas.fill("bg")
    time = _moment(scene, alpha)
    rows = np.flatnonzero(scene.in_play)
    for k, name in enumerate(("lecture", "stepped", "exact")):
        origin = ORIGINS[k]
        table_view.draw_table(canvas, scene.bed, origin, alone=False)
        canvas.halo = canvas.theme.bg
        words = (
            TITLES[k]
            if k == 2 or not scene.shot[0]
            else f"{TITLES[k]}: {_length(difference_now(scene, name))} off"
        )
        canvas.label((origin[0] - 0.19, origin[1] - 0.1), words, "text1", 13, "semibold", anchor="left")
        canvas.halo = FELT
        played = scene.played.tables[name]
        places = played.state_at(time).positions
        gone = _gone(scene, name, time)
        balls = Balls(
            places,
            scene.radii[rows],
            scene.numbers[rows],
            played.orientations_at(time),
            np.where(gone, 0.0, 1.0),
        )
        table_view.draw_balls(canvas, balls, scene.bed, origin)
        if not scene.shot[0] and not scene.plays_itself and scene.prediction and scene.cue.phase != STRIKING:
            _draw_aim(scene, canvas, balls, origin)
        if not scene.shot[0] and (not scene.plays_itself or scene.cue.phase == STRIKING):
            _draw_cue(scene, canvas, balls, origin)
    _draw_chart(scene, canvas, time)


def _moment(scene: ThreeTables, alpha: float) -> float:
    """Time of the shot that is shown: the tables are known at every moment, not only at steps.

    What is not known yet is computed, a slice in each picture.
    """
    if not scene.shot[0]:
        return 0.0
    time = float(scene.shot[1])
    if scene.previous is not None and scene.previous.shot[1] <= time:
        before = float(scene.previous.shot[1])
        time = before + alpha * (time - before)
    played = scene.played
    played.compute(min(time, played.reached_s + played.steps.slice_s))
    return min(time, played.reached_s)


def _gone(scene: ThreeTables, name: str, time: float) -> np.ndarray:
    """Balls that are in a pocket by now."""
    gone = np.zeros(int(scene.in_play.sum()), dtype=bool)
    rows = scene.played.tables[name].rows
    fallen = (rows[:, 1] == BALL_POCKET) & (rows[:, 0] <= time)
    gone[rows[fallen, 2].astype(np.int64)] = True
    return gone


def _draw_aim(scene: ThreeTables, canvas: Canvas, balls: Balls, origin: tuple[float, float]) -> None:
    in_play = np.ones(len(balls.radii), dtype=bool)
    first = first_contact(0, scene.cue.aim, balls.positions, balls.radii, in_play, scene.bed)
    moved = first._replace(ghost=(first.ghost[0] + origin[0], first.ghost[1] + origin[1]))
    table_view.draw_aim(canvas, moved, balls.positions[0] + origin, float(balls.radii[0]), scene.cue)


def _draw_cue(scene: ThreeTables, canvas: Canvas, balls: Balls, origin: tuple[float, float]) -> None:
    white = balls.positions[0] + origin
    back = float(balls.radii[0]) + scene.cue.gap
    way = (math.cos(scene.cue.aim), math.sin(scene.cue.aim))
    table_view.draw_stick(canvas, scene.bed, (white[0] - back * way[0], white[1] - back * way[1]), way)
    if scene.cue.phase == PULLING:
        canvas.label(white, f"{scene.cue.speed:.1f} m/s", FELT_WARM, 13, "semibold", offset=(0.0, -24.0))


# -- the chart ----------------------------------------------------------------------------------------


def _draw_chart(scene: ThreeTables, canvas: Canvas, time: float) -> None:
    """Distance from the exact table over time, in powers of ten."""
    x0, y0 = CHART
    down, right = CHART_SIZE
    canvas.halo = canvas.theme.bg
    canvas.label((x0 - 0.11, y0 + 0.02), "Off the exact table", "text1", 13, "semibold", anchor="left")
    behind = scene.shot[0] and scene.shown_s < scene.shot[1]
    if behind:
        words = f"computing: {scene.shown_s:.0f} of {scene.shot[1]:.0f} s"
        canvas.label((x0 - 0.11, y0 + right), words, "text2", 12, anchor="right")
    corners = np.array([(x0, y0), (x0, y0 + right), (x0 + down, y0 + right), (x0 + down, y0)])
    canvas.polygon(corners, fill="stage", outline="line", width=1.0)
    span = max(scene.played.least_end_s, 1.0) if scene.shot[0] else 10.0

    def place(seconds: float, logarithm: float) -> tuple[float, float]:
        share = (HIGHEST - min(max(logarithm, LOWEST), HIGHEST)) / (HIGHEST - LOWEST)
        return x0 + share * down, y0 + min(seconds / span, 1.0) * right

    for power, words in ((0, "1 m"), (-3, "1 mm"), (-6, "1 µm"), (-9, "1 nm"), (-12, "1 pm"), (-15, "1 fm")):
        canvas.line(place(0.0, power), place(span, power), "grid2", 1.0)
        canvas.label(place(0.0, power), words, "text3", 11, anchor="right", offset=(-6.0, 0.0))
    canvas.label(
        place(span, LOWEST), f"{span:.0f} s", "text3", 11, anchor="right", offset=(-6.0, -9.0), halo=False
    )
    if not scene.shot[0]:
        canvas.label(
            place(0.5 * span, -7.0), "Strike: the curves start with the shot", "text3", 12, halo=False
        )
        return
    canvas.halo = canvas.theme.stage
    ends = []
    for name, curve in scene.differences_until(time).items():
        points = np.array([place(i / 30.0, math.log10(max(d, 1e-17))) for i, d in enumerate(curve)])
        if len(points) > 1:
            canvas.polyline(points, SERIES[name], 1.8)
        if len(points):
            canvas.dot(points[-1], 3.5, SERIES[name])
            ends.append((points[-1], name))
    for point, name in _apart(ends, 16.0 / canvas.pixels_per_unit * canvas.k):
        near_end = point[1] > y0 + 0.72 * right
        canvas.label(
            point, name, SERIES[name], 12, "semibold", anchor="right" if near_end else "left",
            offset=(-8.0 if near_end else 8.0, 0.0),
        )  # fmt: skip


def _apart(ends: list[tuple[np.ndarray, str]], least: float) -> list[tuple[np.ndarray, str]]:
    """Labels pushed apart downwards, so that no two lie on each other."""
    spread: list[tuple[np.ndarray, str]] = []
    for point, name in sorted(ends, key=lambda end: float(end[0][0])):
        x = float(point[0]) if not spread else max(float(point[0]), float(spread[-1][0][0]) + least)
        spread.append((np.array((x, point[1])), name))
    return spread


def _length(metres: float) -> str:
    """A distance in words."""
    for factor, unit in ((1.0, "m"), (1e3, "mm"), (1e6, "µm"), (1e9, "nm")):
        if metres * factor >= 1.0:
            return f"{metres * factor:.3g} {unit}"
    return f"{metres * 1e12:.2g} pm" if metres >= 1e-14 else "nothing"
