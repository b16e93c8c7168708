"""How the two-ball program is drawn: the window, and the last collision magnified, step by step."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.scenes import lecture_balls_record as record
from game.scenes.lecture_balls_level import HEIGHT, WIDTH
from game.stage import Frame
from game.ui.canvas import Canvas
from game.ui.painters.ball import BallPainter
from game.ui.theme import FELT, FELT_COOL, FELT_WARM

if TYPE_CHECKING:
    from game.scenes.lecture_balls import LectureBalls

Array = NDArray[np.float64]

FRAME = Frame(-14.0, -14.0, 1000.0, 424.0)
LENS = (826.0, 148.0)  # px, middle of the magnified collision
LENS_RADIUS = 43.0  # px, of the larger ball in it
LENS_ARROW = 62.0  # px, of the fastest velocity in it
NUMBERS = np.array([3, 2], dtype=np.int64)
COLORS = ("vermilion", "chalk")
WALL_S = 1.2  # s that an overshoot is shown
STEPS = (
    "1  They overlap",
    "2  Each is moved by half of it",
    "3  Velocities along and across the line of centres",
    "4  The parts along the line change",
    "5  Turned back: the new velocities",
)

_ball_painter = BallPainter(FELT)


def draw(scene: LectureBalls, canvas: Canvas, alpha: float) -> None:
    """The window on the left; on the right the last collision and what was computed in it."""
    corners = np.array([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])
    canvas.polygon(corners, fill=FELT, outline="line2", width=1.5)
    canvas.halo = FELT
    places = _places(scene, alpha)
    _draw_walls(scene, canvas)
    _draw_balls(scene, canvas, places)
    if scene.vectors:
        _draw_arrows(scene, canvas, places)
    canvas.halo = canvas.theme.stage
    _draw_last_collision(scene, canvas)


def _places(scene: LectureBalls, alpha: float) -> Array:
    """Positions between two frames; a held or dragged ball is where it is."""
    now = np.array([ball.position for ball in scene.balls])
    if scene.previous is None or scene.hold_s > 0.0 or scene.dragged >= 0:
        return now
    before = scene.previous.positions
    still = np.abs(now - before).max(axis=1) > 120.0
    return before + np.where(still, 1.0, alpha)[:, None] * (now - before)


def _draw_balls(scene: LectureBalls, canvas: Canvas, places: Array) -> None:
    pixels, clip = canvas.raster_target
    points = np.array([canvas.place(place) for place in places])
    scale = canvas.pixels_per_unit
    radii = np.array([ball.radius for ball in scene.balls])
    # a ball rolls by way over radius about the axis across its way; the window has no memory of it, so the
    # turn is taken from the place: it looks rolled and costs no state
    turns = np.array([_rolled(places[i] / radii[i]) for i in range(2)])
    metre = 640.0 / 2.54  # px of the window to a metre of the table whose lamps shine here
    _ball_painter.draw(
        pixels,
        clip,
        points,
        radii * scale,
        NUMBERS,
        turns,
        canvas.place((WIDTH / 2, HEIGHT / 2)),
        scale * metre,
    )


def _rolled(way: Array) -> Array:
    """Rotation matrix of a ball that has rolled ``way`` radii (right, down) from the corner."""
    cx, sx, cy, sy = math.cos(way[0]), math.sin(way[0]), math.cos(way[1]), math.sin(way[1])
    about_y = np.array([[cx, 0.0, sx], [0.0, 1.0, 0.0], [-sx, 0.0, cx]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cy, -sy], [0.0, sy, cy]])
    return np.ascontiguousarray(about_x @ about_y)


def _draw_arrows(scene: LectureBalls, canvas: Canvas, places: Array) -> None:
    """Velocities, four pixels for each pixel per frame, with heads to drag."""
    for index, ball in enumerate(scene.balls):
        if ball.speed > 0.2:
            canvas.arrow(places[index], ball.velocity, FELT_COOL, f"v_{index + 1}", scale=4.0)


def _draw_walls(scene: LectureBalls, canvas: Canvas) -> None:
    """Overshoot: the outline of the ball where it was beyond the wall, and how deep."""
    for ball, (deep_x, deep_y, age) in zip(scene.balls, scene.walls.tolist(), strict=True):
        strength = 1.0 - age / WALL_S
        if strength <= 0.0:
            continue
        x, y = ball.position
        far_x = (WIDTH if deep_x > 0.0 else 0.0) + 0.0
        far_y = (HEIGHT if deep_y > 0.0 else 0.0) + 0.0
        if deep_x != 0.0:
            _draw_depth(canvas, (far_x, y), (far_x + deep_x, y), abs(deep_x), strength)
        if deep_y != 0.0:
            _draw_depth(canvas, (x, far_y), (x, far_y + deep_y), abs(deep_y), strength)


def _draw_depth(
    canvas: Canvas, wall: tuple[float, float], end: tuple[float, float], depth: float, strength: float
) -> None:
    canvas.line(wall, end, FELT_WARM, 3.0, alpha=strength)
    inward = (WIDTH / 2 - wall[0], HEIGHT / 2 - wall[1])
    length = math.sqrt(inward[0] ** 2 + inward[1] ** 2) or 1.0
    place = (wall[0] + 46.0 * inward[0] / length, wall[1] + 30.0 * inward[1] / length)
    canvas.label(place, f"overshoot {depth:.1f}", FELT_WARM, alpha=strength)


# -- the last collision -------------------------------------------------------------------------------


def _draw_last_collision(scene: LectureBalls, canvas: Canvas) -> None:
    row = scene.last
    left = WIDTH + 26.0
    canvas.label((left, 6.0), "The last collision", "text1", 15, "semibold", anchor="topleft")
    if row[record.OVERLAP] <= 0.0:
        canvas.label((left, 34.0), "None yet. Drag a ball or its arrow.", "text3", 13, anchor="topleft")
        return
    phase = _phase(scene)
    canvas.label((left, 30.0), STEPS[phase], "amber" if scene.hold_s > 0.0 else "text3", 13, anchor="topleft")
    _draw_lens(scene, canvas, phase)
    _draw_numbers(scene, canvas, phase, left)


def _phase(scene: LectureBalls) -> int:
    """Which of the five steps is shown: in turn while held, the last one afterwards."""
    if scene.hold_s <= 0.0 or scene.hold <= 0.0:
        return 4
    return min(int(5.0 * (1.0 - scene.hold_s / scene.hold)), 4)


def _draw_lens(scene: LectureBalls, canvas: Canvas, phase: int) -> None:
    row = scene.last
    magnification = LENS_RADIUS / max(ball.radius for ball in scene.balls)
    contact = row[record.CONTACT]
    pairs = row[record.POSITIONS if phase == 0 else record.NEW_POSITIONS].reshape(2, 2)
    centres = np.array(LENS) + (pairs - contact) * magnification
    before = np.array(LENS) + (row[record.POSITIONS].reshape(2, 2) - contact) * magnification
    for index, ball in enumerate(scene.balls):
        radius = ball.radius * magnification
        if phase == 1:
            canvas.ghost(before[index], radius, 1.0)
        canvas.circle(centres[index], radius, fill="body", fill_alpha=0.8, outline=COLORS[index], width=2.0)
    angle = float(row[record.ANGLE])
    n = np.array((math.cos(angle), math.sin(angle)))
    reach = 92.0
    if phase >= 1:
        canvas.line(
            np.array(LENS) - reach * n, np.array(LENS) + reach * n, "text1", 1.4, dash=(6.0, 6.0), alpha=0.75
        )
        _draw_angle(canvas, centres[1], angle)
    canvas.contact(LENS, chosen=True)
    fastest = max(float(np.abs(row[record.VELOCITIES.start : record.NEW_VELOCITIES.stop]).max()), 1e-9)
    scale = LENS_ARROW / (fastest * math.sqrt(2.0))
    new = row[record.NEW_VELOCITIES].reshape(2, 2)
    old = row[record.VELOCITIES].reshape(2, 2)
    for index in range(2):
        if phase in (2, 3):
            _draw_parts(
                canvas,
                centres[index],
                row[record.PARTS if phase == 2 else record.NEW_PARTS].reshape(2, 2)[index],
                n,
                scale,
            )
        canvas.arrow(
            centres[index],
            old[index],
            COLORS[index],
            f"v_{index + 1}",
            scale=scale,
            alpha=1.0 if phase < 4 else 0.35,
        )
        if phase == 4:
            canvas.arrow(centres[index], new[index], "green", f"v_{index + 1}'", scale=scale)


def _draw_angle(canvas: Canvas, centre: Array, angle: float) -> None:
    """The angle of the line of centres at ball 2, from the x axis."""
    canvas.line(centre, centre + np.array((46.0, 0.0)), "text3", 1.0)
    canvas.arc(centre, 34.0, 0.0, angle, "amber", 1.6)
    middle = 0.5 * angle
    place = centre + 52.0 * np.array((math.cos(middle), math.sin(middle)))
    canvas.label(place, f"α {math.degrees(angle):.0f}°".replace("-", "−"), "amber")


def _draw_parts(canvas: Canvas, centre: Array, parts: Array, n: Array, scale: float) -> None:
    """A velocity's parts along the line of centres and across it."""
    canvas.arrow(centre, n * parts[0], "amber", scale=scale)
    canvas.arrow(centre, np.array((-n[1], n[0])) * parts[1], "text1", scale=scale, width=1.6)


def _draw_numbers(scene: LectureBalls, canvas: Canvas, phase: int, left: float) -> None:
    """What was computed, in rows: before, after."""
    row = scene.last
    unit, momentum_unit, _, speed, _ = scene.measures()
    parts = row[record.PARTS].reshape(2, 2) * speed
    new = row[record.NEW_PARTS].reshape(2, 2) * speed
    px, py, qx, qy = row[record.MOMENTA] * speed
    lost = math.sqrt((qx - px) ** 2 + (qy - py) ** 2)
    size = math.sqrt(px * px + py * py) + math.sqrt(qx * qx + qy * qy)
    kept = lost <= 1e-12 * size
    gone = (
        1.0 - float(row[record.NEW_ENERGY]) / float(row[record.ENERGY]) if row[record.ENERGY] > 0.0 else 0.0
    )
    x1, x2, x3 = left, left + 190.0, left + 268.0
    y = 250.0
    canvas.label((x2, y), "before", "text3", 11, anchor="right", offset=(20.0, 0.0))
    canvas.label((x3, y), "after", "text3", 11, anchor="right", offset=(20.0, 0.0))
    lines = [
        ("ball 1 along the line", parts[0, 0], new[0, 0], "amber"),
        ("ball 2 along the line", parts[1, 0], new[1, 0], "amber"),
        ("ball 1 across it", parts[0, 1], new[0, 1], "text2"),
        ("ball 2 across it", parts[1, 1], new[1, 1], "text2"),
        ("momentum, right", px, qx, "text2"),
        ("momentum, down", py, qy, "text2"),
    ]
    for name, old, now, color in lines:
        y += 19.0
        canvas.label((x1, y), name, "text2", 12, anchor="left")
        canvas.label((x2, y), _number(old), color, 12, "semibold", anchor="right", offset=(20.0, 0.0))
        shown = _number(now) if phase >= 3 else "–"
        canvas.label((x3, y), shown, color, 12, "semibold", anchor="right", offset=(20.0, 0.0))
    y += 26.0
    verdict = "momentum kept to rounding" if kept else f"momentum lost: {lost:.3g} {momentum_unit}"
    canvas.label((x1, y), verdict, "green" if kept else "vermilion", 13, "semibold", anchor="left")
    canvas.label(
        (x1, y + 19.0),
        f"energy {'lost' if gone >= 0 else 'gained'}: {abs(gone) * 100:.1f} %",
        "text2",
        13,
        anchor="left",
    )
    canvas.label((x1, y + 36.0), f"velocities in {unit}", "text3", 11, anchor="left")


def _number(value: float) -> str:
    return f"{value:.2f}".replace("-", "−")
