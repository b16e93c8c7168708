"""The last collision of the two-ball program, magnified, step by step, with what was computed in it."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.scenes.two_balls import record
from game.scenes.two_balls.level import WIDTH
from game.scenes.two_balls.model import TwoBalls
from game.scenes.two_balls.readouts import measures_in
from game.ui.canvas.canvas import Canvas

HEADING = -44.0  # px, top of the words over the magnified collision; its step stands 24 below
LENS = (826.0, 128.0)  # px, middle of the magnified collision
ROWS = 262.0  # px, of the head of what was computed in it
LENS_RADIUS = 43.0  # px, of the larger ball in it
LENS_ARROW = 62.0  # px, of the fastest velocity in it
NAME_SPACE = 36.0  # px, between the ends of two arrows whose names stand beside them
COLORS = ("vermilion", "chalk")
SUBSCRIPTS = "₁₂"
STEPS = (
    "1  They overlap",
    "2  Each is moved by half of it",
    "3  Velocities along and across the line of centres",
    "4  The parts along the line change",
    "5  Turned back: the new velocities",
)


def draw_last_collision(model: TwoBalls, canvas: Canvas) -> None:
    """Heading, picture and numbers; before the first collision, what there will be."""
    row = model.last
    left = WIDTH + 26.0
    canvas.label((left, HEADING), "The last collision", "text1", 15, "semibold", anchor="topleft")
    if row[record.OVERLAP] <= 0.0:
        words = "None yet. Drag a ball or its arrow."
        if model.unseen:
            words = f"None noticed; {model.unseen} passed unseen."
        canvas.label((left, HEADING + 28.0), words, "text3", 13, anchor="topleft")
        y = HEADING + 78.0
        canvas.label((left, y), "When they collide, five steps are shown:", "text3", 13, anchor="topleft")
        for n, step in enumerate(STEPS):
            canvas.label((left, y + 28.0 + 24.0 * n), step, "text3", 13, anchor="topleft")
        return
    phase = phase_of(model)
    color = "amber" if model.hold_s > 0.0 else "text3"
    canvas.label((left, HEADING + 24.0), STEPS[phase], color, 13, anchor="topleft")
    _draw_lens(model, canvas, phase)
    _draw_numbers(model, canvas, phase, left)


def phase_of(model: TwoBalls) -> int:
    """Which of the five steps is shown: in turn while held, the last one afterwards."""
    if model.hold_s <= 0.0 or model.parameters.hold <= 0.0:
        return 4
    return min(int(5.0 * (1.0 - model.hold_s / model.parameters.hold)), 4)


def _draw_lens(model: TwoBalls, canvas: Canvas, phase: int) -> None:
    row = model.last
    magnification = LENS_RADIUS / max(ball.radius for ball in model.balls)
    contact = row[record.CONTACT]
    pairs = row[record.POSITIONS if phase == 0 else record.NEW_POSITIONS].reshape(2, 2)
    centres = np.array(LENS) + (pairs - contact) * magnification
    before = np.array(LENS) + (row[record.POSITIONS].reshape(2, 2) - contact) * magnification
    for index, ball in enumerate(model.balls):
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
        if phase < 4:  # the new velocities take its place
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
        named = phase < 4 or label_is_free(centres, scale * old[index], scale * new, index)
        _draw_incoming(canvas, centres[index], scale * old[index], COLORS[index], phase < 4, index, named)
        if phase == 4:
            canvas.arrow(centres[index], new[index], "green", f"v_{index + 1}'", scale=scale)


def label_is_free(centres: Floats, incoming: Floats, new: Floats, index: int) -> bool:
    """True if the name of ball ``index``'s velocity before, (2,) px, keeps off those of the new ones (2, 2).

    centres (2, 2) px of both balls.
    """
    tail = centres[index] - incoming
    return bool(np.sqrt(((centres + new - tail) ** 2).sum(axis=1)).min() > NAME_SPACE)


def _draw_incoming(
    canvas: Canvas, centre: Floats, arrow: Floats, color: str, strong: bool, index: int, named: bool
) -> None:
    """A velocity before the collision: it comes in, and ends at the centre."""
    length = math.sqrt(float(arrow @ arrow))
    if length < 1.0:
        return
    alpha = 1.0 if strong else 0.35
    canvas.arrow(centre - arrow, arrow, color, alpha=alpha)
    if named:
        place = centre - (1.0 + 12.0 / length) * arrow
        canvas.label(place, f"v{SUBSCRIPTS[index]}", color, alpha=alpha)


def _draw_angle(canvas: Canvas, centre: Floats, angle: float) -> None:
    """The angle of the line of centres at ball 2, from the x axis; the number away from ball 1."""
    canvas.line(centre, centre + np.array((46.0, 0.0)), "text3", 1.0)
    canvas.arc(centre, 34.0, 0.0, angle, "amber", 1.6)
    place = centre + np.array((0.0, -math.copysign(LENS_RADIUS + 14.0, angle)))
    canvas.label(place, f"α {math.degrees(angle):.0f}°".replace("-", "−"), "amber")


def _draw_parts(
    canvas: Canvas, centre: Floats, parts: Floats, n: Floats, scale: float, incoming: bool
) -> None:
    """A velocity's parts along the line of centres and across it; those before come in."""
    for arrow, color, width in (
        (scale * parts[0] * n, "amber", 2.4),
        (scale * parts[1] * np.array((-n[1], n[0])), "text1", 1.6),
    ):
        canvas.arrow(centre - arrow if incoming else centre, arrow, color, width=width)


def _draw_numbers(model: TwoBalls, canvas: Canvas, phase: int, left: float) -> None:
    """What was computed, in rows: before, after."""
    row = model.last
    unit, momentum_unit, _, speed, _ = measures_in(model.parameters.units)
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
