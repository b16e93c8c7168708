"""What a stroke would do, seen before it is played: the exact ways of the balls up to the n-th event."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
)
from game.scenes.billiards import play as moves
from game.scenes.billiards.paths import Ways
from game.scenes.billiards.round import Places, Struck, trajectory_of
from game.scenes.shared.tables.view import cut_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters.aim import draw_cloth_label

if TYPE_CHECKING:
    from game.billiards.game.arrangement import Stroke
    from game.billiards.search.finding import FoundShot
    from game.billiards.table.table import Table
    from game.scenes.billiards.scene import Billiards

Array = NDArray[np.float64]

DASH = (8.0, 6.0)  # design px
MOST_EVENTS = 200  # of a hint: to the end of its shot
LEAST_WAY = 0.004  # m; a ball that moves less is not shown to move


class Way(NamedTuple):
    """The way of one ball: its number, points (n, 2) m, and whether it ends in a pocket."""

    number: int
    points: Array
    potted: bool


class Sight(NamedTuple):
    """What is foreseen. approach: of the white ball to its first ball; after: from there on.

    ghost: where the white ball then is; target: the ball it meets, None if none; cut: rad. others: ways of
    the balls that move. bounces: where the white ball meets cushions. last: where it comes to rest, None if
    that is later than is shown, or in a pocket.
    """

    approach: Array
    after: Array
    ghost: tuple[float, float] | None
    target: int | None
    target_place: tuple[float, float]
    cut: float
    others: tuple[Way, ...]
    bounces: tuple[tuple[float, float], ...]
    last: tuple[float, float] | None


def foresee(struck: Struck, events: int) -> Sight:
    """The ways of a stroke up to its n-th contact. ValueError if it cannot be played."""
    trajectory = trajectory_of(struck)
    rows = trajectory.rows
    contacts = rows[rows[:, 1] <= BALL_POCKET]
    whole = len(contacts) < events
    until = trajectory.end_time if whole else float(contacts[events - 1, 0])
    numbers = [number for number, _, _ in struck.places]
    cue = numbers.index(CUE_BALL)
    seen = contacts[contacts[:, 0] <= until]
    first = next((row for row in seen.tolist() if row[1] == BALL_BALL and cue in row[2:]), None)
    meets = first[0] if first is not None else until
    ways = Ways(trajectory)
    ghost, target, cut, place = None, None, 0.0, (0.0, 0.0)
    if first is not None:
        other = int(first[3] if int(first[2]) == cue else first[2])
        ghost, target = ways.arriving(cue, meets)[0], numbers[other]
        place = ways.arriving(other, meets)[0]
        cut = _cut(ways.way(cue, 0.0, meets), ghost, place)
    sunk = {int(i): t for t, e, i, _ in seen.tolist() if e == BALL_POCKET}
    others = tuple(
        Way(numbers[ball], points, ball in sunk)
        for ball in range(len(numbers))
        if ball != cue and ways.moves(ball) and _length(points := ways.way(ball, 0.0, until)) > LEAST_WAY
    )
    bounces = tuple(
        ways.arriving(cue, t)[0]
        for t, e, i, _ in seen.tolist()
        if e in (BALL_CUSHION, BALL_JAW) and int(i) == cue
    )
    last = ways.arriving(cue, until + 1e-9)[0] if whole and cue not in sunk else None
    return Sight(
        ways.way(cue, 0.0, meets),
        ways.way(cue, meets, until),
        ghost,
        target,
        place,
        cut,
        others,
        bounces,
        last,
    )


def _cut(approach: Array, ghost: tuple[float, float], place: tuple[float, float]) -> float:
    """Angle between the way at the contact and the line of centres, rad."""
    if len(approach) < 2:
        return 0.0
    way = approach[-1] - approach[-2]
    normal = np.array(place) - ghost
    size = math.sqrt(float(way @ way) * float(normal @ normal))
    return math.acos(min(max(float(way @ normal) / size, -1.0), 1.0)) if size > 0.0 else 0.0


def _length(points: Array) -> float:
    """How far the end of a way, or its middle, is from its beginning, m."""
    (x, y), (mx, my), (ex, ey) = points[0].tolist(), points[len(points) // 2].tolist(), points[-1].tolist()
    return max(abs(mx - x), abs(my - y), abs(ex - x), abs(ey - y))


def aim_words(azimuth: float) -> str:
    """A direction (rad from x) in degrees of the picture: 0 to the right, against the clock."""
    degrees = math.degrees(math.remainder(0.5 * math.pi - azimuth, 2.0 * math.pi))
    return f"{-degrees if degrees else 0.0:.2f}°".replace("-", "\u2212")


def stroke_words(stroke: Stroke) -> tuple[str, ...]:
    """How a stroke is set, in lines: power, and where the tip strikes; aim, and how far the cue is raised.

    Nothing is left out that the instruments show as other than 0.
    """
    offsets = [
        f"{abs(value):.2f} R {more if value > 0.0 else less}"
        for value, more, less in ((stroke.tip_up, "above", "below"), (stroke.tip_left, "left", "right"))
        if abs(value) >= 0.005
    ]
    power = f"{stroke.cue_speed * moves.speed_ratio():.1f} m/s, {' and '.join(offsets) or 'in the middle'}"
    degrees = math.degrees(stroke.elevation)
    raised = f", cue raised by {degrees:.0f}°" if degrees >= 0.5 else ""
    return power, f"aim {aim_words(stroke.azimuth)}{raised}"


def sight_of(scene: Billiards, struck: Struck) -> Sight | None:
    """What is foreseen of the stroke aimed at; kept while nothing changes."""
    scene.kept.sight = _kept(scene.kept.sight, struck, int(scene.events))
    return scene.kept.sight[1]


def hint_of(scene: Billiards, struck: Struck) -> Sight | None:
    """What is foreseen of a puzzle's solution; kept likewise."""
    scene.kept.hint = _kept(scene.kept.hint, struck, MOST_EVENTS)
    return scene.kept.hint[1]


def _kept(kept: Any, struck: Struck, events: int) -> Any:
    key = (struck.places, struck.stroke, struck.conditions, events)
    if kept is not None and kept[0] == key:
        return kept
    try:
        return key, foresee(struck, events)
    except ValueError:
        return key, None


def draw_sight(canvas: Canvas, sight: Sight, radius: float, target_radius: float, foul: bool = False) -> None:
    """The lines on the cloth. foul: the ball that is met first must not be."""
    for way in sight.others:
        own = way.number == sight.target
        canvas.polyline(way.points, FELT_COOL, 2.0 if own else 1.5, dash=DASH, alpha=0.9 if own else 0.55)
        if way.potted:
            canvas.ring(way.points[-1], 5.0, FELT_COOL, 1.5)
    if len(sight.after) > 1:
        canvas.polyline(sight.after, FELT_LINE, 1.5, dash=DASH, alpha=0.9)
    canvas.polyline(sight.approach, FELT_LINE, 1.5)
    for place in sight.bounces:
        canvas.dot(place, 3.0, FELT)
        canvas.ring(place, 3.0, FELT_LINE, 1.25)
    if sight.ghost is not None:
        canvas.circle(sight.ghost, radius, fill=FELT_LINE, fill_alpha=0.22, outline=FELT_LINE, width=1.5)
        ring = (FELT_WARM, 2.5) if foul else (FELT_COOL, 1.5)
        canvas.circle(sight.target_place, target_radius + canvas.px(4.0), outline=ring[0], width=ring[1])
    if sight.last is not None:
        canvas.circle(
            sight.last, radius, fill=FELT_LINE, fill_alpha=0.16, outline=FELT_LINE, width=1.0, alpha=0.7
        )


def draw_label(canvas: Canvas, sight: Sight, places: Places, table: Table, radius: float, foul: str) -> None:
    """The cut, or why the stroke is a foul, on a plate on the cloth beside the ghost ball where no ball is
    covered.
    """
    if sight.ghost is None:
        return
    gx, gy = sight.ghost
    tx, ty = sight.target_place
    apart = math.sqrt((tx - gx) ** 2 + (ty - gy) ** 2) or 1.0
    ux, uy = (tx - gx) / apart, (ty - gy) / apart
    best = (-1.0, gx, gy)
    high, wide = canvas.px(20.0), canvas.px(46.0)  # the plate is wide along y
    for ring in range(1, 4):
        side = (1.6 * radius + canvas.px(34.0)) * (0.6 + 0.4 * ring)
        for ax, ay in ((-uy, ux), (uy, -ux), (-ux, -uy)):
            x, y = gx + side * ax, gy + side * ay
            if not (high < x < table.width - high and wide < y < table.length - wide):
                continue
            clear = min(max(abs(bx - x) / high, abs(by - y) / wide) for _, bx, by in places)
            if min(clear, 1.0) > best[0]:
                best = (min(clear, 1.0), x, y)
    words = foul or cut_words(sight.cut)
    draw_cloth_label(canvas.surface, canvas.fonts, words, canvas.camera.to_screen(*best[1:]))


def draw_considered(
    canvas: Canvas, shots: tuple[FoundShot, ...], places: Places, table: Table, played: bool
) -> None:
    """Shots that a computer player considered: from the white ball to the ball and on to its pocket.

    The best is strongest, with the chance that it was given; ``played``: that is the one being played.
    """
    where = {number: (x, y) for number, x, y in places}
    white = where.get(CUE_BALL)
    if white is None:
        return
    named = {shot.ball: rank for rank, shot in reversed(list(enumerate(shots)))}  # the best for each ball
    for rank, shot in reversed(list(enumerate(shots))):
        strong = rank == 0
        color, alpha = (FELT_WARM, 0.95 if strong else 0.4)
        width = 2.0 if strong else 1.25
        reach = 0.25
        way = (math.cos(shot.stroke.azimuth), math.sin(shot.stroke.azimuth))
        ball = where.get(shot.ball) if shot.ball is not None else None
        first = where.get(shot.via) if shot.via is not None else ball
        if first is not None and shot.kind != "kick":
            reach = math.hypot(first[0] - white[0], first[1] - white[1])
        end = (white[0] + reach * way[0], white[1] + reach * way[1])
        canvas.line(white, end, color, width, alpha=alpha)
        if ball is None or shot.pocket is None:
            continue
        if shot.via is not None and first is not None:
            canvas.line(first, ball, color, width, dash=DASH, alpha=alpha)
        canvas.line(ball, table.pockets[shot.pocket, :2], color, width, dash=DASH, alpha=alpha)
        if strong or (not played and named[shot.ball] == rank):
            words = f"{shot.kind} {100.0 * shot.chance:.0f} %"
            canvas.label(
                ball, words, color, 11, "semibold", offset=(0.0, -18.0), alpha=1.0 if strong else 0.7
            )
