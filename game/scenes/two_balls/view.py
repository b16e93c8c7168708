"""How the two-ball program is drawn: the window, and the last collision magnified, step by step."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.scenes.two_balls import record
from game.scenes.two_balls.level import HEIGHT, WIDTH
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_WARM
from game.ui.painters.ball import BallPainter

if TYPE_CHECKING:
    from game.scenes.two_balls.scene import LectureBalls

Array = NDArray[np.float64]

FRAME = Frame(-14.0, -52.0, 1000.0, 448.0)
HEADING = -44.0  # px, top of the words over the magnified collision; its step stands 24 below
LENS = (826.0, 128.0)  # px, middle of the magnified collision
ROWS = 262.0  # px, of the head of what was computed in it
LENS_RADIUS = 43.0  # px, of the larger ball in it
LENS_ARROW = 62.0  # px, of the fastest velocity in it
NUMBERS = np.array([3, 2], dtype=np.int64)
COLORS = ("vermilion", "chalk")
SUBSCRIPTS = "₀₁₂"
WALL_S = 1.2  # s that an overshoot is shown
PASSED_S = 3.0  # s that a contact is shown that was not noticed
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
    _draw_balls(scene, canvas, places)
    _draw_walls(scene, canvas)
    _draw_passed(scene, canvas)
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
    """Overshoot: how deep a ball was beyond the wall, beside where it was."""
    for ball, row in zip(scene.balls, scene.walls.tolist(), strict=True):
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


def _draw_passed(scene: LectureBalls, canvas: Canvas) -> None:
    """Where both balls were when they went through each other between two frames."""
    if not scene.passed:
        return
    frame, x1, y1, x2, y2 = scene.passed
    strength = 1.0 - (scene.frames - frame) * scene.dt / PASSED_S
    if strength <= 0.0:
        return
    for ball, place in zip(scene.balls, ((x1, y1), (x2, y2)), strict=True):
        canvas.circle(place, ball.radius, outline=FELT_WARM, width=1.6, dash=(4.0, 3.0), alpha=strength)
    above = (0.5 * (x1 + x2), min(y1, y2) - max(ball.radius for ball in scene.balls) - 14.0)
    canvas.label(above, "passed unseen", FELT_WARM, 13, "semibold", alpha=strength)


# -- the last collision -------------------------------------------------------------------------------


def _draw_last_collision(scene: LectureBalls, canvas: Canvas) -> None:
    row = scene.last
    left = WIDTH + 26.0
    canvas.label((left, HEADING), "The last collision", "text1", 15, "semibold", anchor="topleft")
    if row[record.OVERLAP] <= 0.0:
        words = "None yet. Drag a ball or its arrow."
        if scene.unseen:
            words = f"None noticed; {scene.unseen} passed unseen."
        canvas.label((left, HEADING + 28.0), words, "text3", 13, anchor="topleft")
        y = HEADING + 78.0
        canvas.label((left, y), "When they touch, five steps are shown:", "text3", 13, anchor="topleft")
        for n, step in enumerate(STEPS):
            canvas.label((left, y + 28.0 + 24.0 * n), step, "text3", 13, anchor="topleft")
        return
    phase = _phase(scene)
    color = "amber" if scene.hold_s > 0.0 else "text3"
    canvas.label((left, HEADING + 24.0), STEPS[phase], color, 13, anchor="topleft")
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
                phase == 2,
            )
        _draw_incoming(canvas, centres[index], scale * old[index], COLORS[index], phase < 4, index + 1)
        if phase == 4:
            canvas.arrow(centres[index], new[index], "green", f"v_{index + 1}'", scale=scale)


def _draw_incoming(canvas: Canvas, centre: Array, way: Array, color: str, strong: bool, number: int) -> None:
    """A velocity before the collision: it comes in, and ends at the centre."""
    length = math.sqrt(float(way @ way))
    if length < 1.0:
        return
    alpha = 1.0 if strong else 0.35
    canvas.arrow(centre - way, way, color, alpha=alpha)
    canvas.label(centre - (1.0 + 12.0 / length) * way, f"v{SUBSCRIPTS[number]}", color, alpha=alpha)


def _draw_angle(canvas: Canvas, centre: Array, angle: float) -> None:
    """The angle of the line of centres at ball 2, from the x axis; the number away from ball 1."""
    canvas.line(centre, centre + np.array((46.0, 0.0)), "text3", 1.0)
    canvas.arc(centre, 34.0, 0.0, angle, "amber", 1.6)
    place = centre + np.array((0.0, -math.copysign(LENS_RADIUS + 14.0, angle)))
    canvas.label(place, f"α {math.degrees(angle):.0f}°".replace("-", "−"), "amber")


def _draw_parts(canvas: Canvas, centre: Array, parts: Array, n: Array, scale: float, incoming: bool) -> None:
    """A velocity's parts along the line of centres and across it; those before come in."""
    for way, color, width in (
        (scale * parts[0] * n, "amber", 2.4),
        (scale * parts[1] * np.array((-n[1], n[0])), "text1", 1.6),
    ):
        canvas.arrow(centre - way if incoming else centre, way, color, width=width)


def _draw_numbers(scene: LectureBalls, canvas: Canvas, phase: int, left: float) -> None:
    """What was computed, in rows: before, after."""
    row = scene.last
    unit, momentum_unit, _, speed, _ = scene.measures()
    parts = row[record.PARTS].reshape(2, 2) * speed
    new = row[record.NEW_PARTS].reshape(2, 2) * speed
    px, py, qx, qy = row[record.MOMENTA] * speed
    lost = record.momentum_lost((px, py, qx, qy))
    gone = (
        1.0 - float(row[record.NEW_ENERGY]) / float(row[record.ENERGY]) if row[record.ENERGY] > 0.0 else 0.0
    )
    x1, x2, x3 = left, left + 190.0, left + 268.0
    y = ROWS
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
    verdict = f"momentum lost: {lost:.3g} {momentum_unit}" if lost else "momentum kept to rounding"
    canvas.label((x1, y), verdict, "vermilion" if lost else "green", 13, "semibold", anchor="left")
    canvas.label(
        (x1, y + 19.0),
        f"energy {'lost' if gone >= 0 else 'gained'}: {abs(gone) * 100:.1f} %",
        "text2",
        13,
        anchor="left",
    )
    canvas.label((x1, y + 36.0), f"velocities in {unit}", "text3", 11, anchor="left")


def _number(value: float) -> str:
    text = f"{value:.2f}".replace("-", "−")
    return text.removeprefix("−") if float(f"{value:.2f}") == 0.0 else text
