"""How the window of the two-ball program is drawn: balls, arrows, overshoots and contacts not noticed."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.scenes.two_balls.hand import ARROW
from game.scenes.two_balls.lens import draw_last_collision
from game.scenes.two_balls.level import FRAME_RATE, HEIGHT, WIDTH
from game.scenes.two_balls.model import NOTHING, Grasp, LectureBallsState, TwoBalls
from game.scenes.two_balls.readouts import velocity_words
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_WARM
from game.ui.painters.ball import BallPainter, ScreenBalls

FRAME = Frame(-14.0, -52.0, 1000.0, 448.0)
NUMBERS = np.array([3, 2], dtype=np.int64)
WALL_S = 1.2  # s that an overshoot is shown
PASSED_S = 3.0  # s that a contact is shown that was not noticed
JUMP = 120.0  # px; a ball that moved farther in a frame was put there, and is not drawn in between

_ball_painter = BallPainter(FELT)


def draw(
    canvas: Canvas, model: TwoBalls, grasp: Grasp, previous: LectureBallsState | None, alpha: float
) -> None:
    """The window on the left; on the right the last collision and what was computed in it."""
    corners = np.array([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])
    canvas.polygon(corners, fill=FELT, outline="line2", width=1.5)
    canvas.halo = FELT
    still = model.hold_s > 0.0 or grasp != NOTHING
    places = _places(model, None if still else previous, alpha)
    _draw_balls(model, canvas, places)
    _draw_walls(model, canvas)
    _draw_passed(model, canvas)
    if model.parameters.vectors:
        _draw_arrows(model, canvas, places)
    canvas.halo = canvas.theme.stage
    _write_velocities(model, canvas, grasp)
    draw_last_collision(model, canvas)


def _places(model: TwoBalls, previous: LectureBallsState | None, alpha: float) -> Floats:
    """Positions between two frames; without a previous one as they are."""
    now = np.array([ball.position for ball in model.balls])
    if previous is None:
        return now
    jumped = np.abs(now - previous.positions).max(axis=1) > JUMP
    return previous.positions + np.where(jumped, 1.0, alpha)[:, None] * (now - previous.positions)


def _draw_balls(model: TwoBalls, canvas: Canvas, places: Floats) -> None:
    pixels, clip = canvas.raster_target
    points = np.array([canvas.place(place) for place in places])
    scale = canvas.pixels_per_unit
    radii = np.array([ball.radius for ball in model.balls])
    # a ball rolls by distance over radius about the axis across its path; the window has no memory of it, so
    # the turn is taken from the place: it looks rolled and costs no state
    turns = np.array([_rolled(places[i] / radii[i]) for i in range(2)])
    metre = 640.0 / 2.54  # px of the window to a metre of the table whose lamps shine here
    balls = ScreenBalls(points, radii * scale, NUMBERS, turns)
    _ball_painter.draw(pixels, clip, balls, canvas.place((WIDTH / 2, HEIGHT / 2)), scale * metre)


def _rolled(moved: Floats) -> Floats:
    """Rotation matrix of a ball that has rolled ``moved`` radii (right, down) from the corner."""
    cx, sx, cy, sy = math.cos(moved[0]), math.sin(moved[0]), math.cos(moved[1]), math.sin(moved[1])
    about_y = np.array([[cx, 0.0, sx], [0.0, 1.0, 0.0], [-sx, 0.0, cx]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cy, -sy], [0.0, sy, cy]])
    return np.ascontiguousarray(about_x @ about_y)


def _draw_arrows(model: TwoBalls, canvas: Canvas, places: Floats) -> None:
    """Velocities, with heads to drag."""
    for index, ball in enumerate(model.balls):
        if ball.speed > 0.2:
            canvas.arrow(places[index], ball.velocity, FELT_COOL, f"v_{index + 1}", scale=ARROW)


def _write_velocities(model: TwoBalls, canvas: Canvas, grasp: Grasp) -> None:
    """Speed, direction and components of both, below the window, where no ball comes over them."""
    for index in range(2):
        words = f"Ball {index + 1}: {velocity_words(model, index)}"
        if grasp == NOTHING:  # what a hand changes is followed at once
            words = canvas.figure(("velocity", index), words)
        place = (0.0, HEIGHT)
        offset = (0.0, 8.0 + 20.0 * index)
        canvas.label(place, words, "text1", 13, "medium", anchor="topleft", offset=offset)


def _draw_walls(model: TwoBalls, canvas: Canvas) -> None:
    """Overshoot: how deep a ball was beyond the wall, beside where it was."""
    for ball, row in zip(model.balls, model.walls.tolist(), strict=True):
        deep_x, deep_y, age, x, y = row
        strength = 1.0 - age / WALL_S
        if strength <= 0.0:
            continue
        aside = ball.radius + 14.0
        if deep_x != 0.0:
            wall, inward = (WIDTH, -10.0) if deep_x > 0.0 else (0.0, 10.0)
            place = (wall + inward, y + (aside if y < HEIGHT / 2 else -aside))
            anchor = "right" if deep_x > 0.0 else "left"
            _draw_depth(canvas, (wall, y), (wall + deep_x, y), place, anchor, abs(deep_x), strength)
        if deep_y != 0.0:
            wall, inward = (HEIGHT, -12.0) if deep_y > 0.0 else (0.0, 12.0)
            left = x < WIDTH / 2
            place = (x + (aside if left else -aside), wall + inward)
            anchor = "left" if left else "right"
            _draw_depth(canvas, (x, wall), (x, wall + deep_y), place, anchor, abs(deep_y), strength)


def _draw_depth(
    canvas: Canvas, wall: tuple[float, float], end: tuple[float, float], place: tuple[float, float],
    anchor: str, depth: float, strength: float,
) -> None:  # fmt: skip
    canvas.line(wall, end, FELT_WARM, 3.0, alpha=strength)
    canvas.label(place, f"overshoot {depth:.1f}", FELT_WARM, anchor=anchor, alpha=strength)


def _draw_passed(model: TwoBalls, canvas: Canvas) -> None:
    """Where both balls were when they went through each other between two frames."""
    if not model.passed:
        return
    frame, x1, y1, x2, y2 = model.passed
    strength = 1.0 - (model.frames - frame) / (FRAME_RATE * PASSED_S)
    if strength <= 0.0:
        return
    for ball, place in zip(model.balls, ((x1, y1), (x2, y2)), strict=True):
        canvas.circle(place, ball.radius, outline=FELT_WARM, width=1.6, dash=(4.0, 3.0), alpha=strength)
    above = (0.5 * (x1 + x2), min(y1, y2) - max(ball.radius for ball in model.balls) - 14.0)
    canvas.label(above, "passed unseen", FELT_WARM, 13, "semibold", alpha=strength)
