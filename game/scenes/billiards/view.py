"""How the billiard game is drawn: table, balls at any moment, cue, aim, and the instruments round them."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill
from game.billiards.game.rules import CUE_BALL, listed
from game.billiards.laws.state import BALL_POCKET
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table
from game.scenes.billiards import instruments, layout
from game.scenes.billiards import play as moves
from game.scenes.billiards import score_board as board
from game.scenes.billiards.play import AIMING, REPLAY, ROLLING, SET_UP, STRIKING
from game.scenes.billiards.prediction import (
    Sight,
    draw_considered,
    draw_label,
    draw_sight,
    hint_of,
    sight_of,
)
from game.scenes.billiards.round import Struck
from game.scenes.billiards.stroke_motion import pull_of
from game.scenes.shared.tables.cue import PULLING, REST_GAP
from game.scenes.shared.tables.view import Balls, draw_balls, draw_table
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM, Theme
from game.ui.painters.cue import draw_cue

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

Array = NDArray[np.float64]

FALL_S = 0.35  # s in which a ball drops out of sight
STAR = "★"
BANDS = ("amber", "chalk")  # of the two players' cues
BAND, BAND_RADIUS = (0.80, 0.845), 0.0088  # m from the tip, m


@lru_cache(maxsize=16)
def _look(theme: Theme, k: float, less_motion: bool) -> Look:
    return Look(theme, k, less_motion=less_motion)


def look_of(canvas: Canvas) -> Look:
    """Letters and lines in the measure of the table's picture."""
    k = min(max(round(canvas.pixels_per_unit / layout.PIXELS, 2), 0.5), 6.0)
    return _look(canvas.theme, k, canvas.look.less_motion)


def draw(scene: Billiards, canvas: Canvas, alpha: float) -> None:
    """The scene, ``alpha`` of the way from the state before to the state now."""
    table = scene.round.conditions.table
    draw_table(canvas, table)
    canvas.halo = FELT
    roomy = canvas.pixels_per_unit >= layout.LEAST_PIXELS
    _draw_marks(scene, canvas)
    time = _moment(scene, alpha)
    balls = balls_at(scene, time)
    aimed = scene.phase == AIMING and scene.person_plays and scene.round.playable
    sight = _draw_aim(scene, canvas) if aimed and scene.prediction and scene.grip != "white" else None
    if scene.hint_shown and scene.phase == AIMING and scene.content.solution is not None:
        _draw_hint(scene, canvas, scene.content.solution.stroke())
    draw_balls(canvas, balls, table)
    if sight is not None:
        draw_label(
            canvas, sight, scene.round.places, table, scene.round.conditions.radii[0],
            foul_of(scene, sight.target),
        )  # fmt: skip
    if scene.considered and scene.phase == STRIKING and not scene.person_plays:
        draw_considered(canvas, scene.kept.considered, scene.round.places, table, played=False)
    _draw_cue(scene, canvas, time, aimed)
    if roomy:
        look = look_of(canvas)
        board.draw_board(scene, canvas, look)
        instruments.draw_instruments(scene, canvas, look)


def _moment(scene: Billiards, alpha: float) -> float:
    """Time of the phase, or place in the replay, that is shown, s."""
    column = moves.REPLAY_S if scene.phase == REPLAY else moves.PHASE_S
    time = float(scene.clock[column])
    if scene.previous is None or scene.phase not in (STRIKING, ROLLING, REPLAY):
        return time
    before = float(scene.previous.clock[column])
    return before + alpha * (time - before) if before <= time <= before + 0.1 else time


def balls_at(scene: Billiards, time: float) -> Balls:
    """The balls as they are drawn: at rest, or on their ways at a time of the shot, s."""
    played = scene.played if scene.phase in (ROLLING, REPLAY) else None
    if played is None or scene.round.last is None:
        places = scene.round.places
        numbers = np.array([number for number, _, _ in places], dtype=np.int64)
        positions = np.array([(x, y) for _, x, y in places]).reshape(-1, 2)
        radii = np.array(scene.round.conditions.radii)[numbers]
        return Balls(positions, radii, numbers, scene.turns[numbers], np.ones(len(numbers)))
    last = scene.round.last
    numbers = np.array([number for number, _, _ in last.places], dtype=np.int64)
    positions = played.trajectory.state_at(time).positions.copy()
    turns = played.trajectory.orientations_at(time, scene.turns_before[numbers])
    opacities = np.ones(len(numbers))
    radii = np.array(last.conditions.radii)[numbers]
    pockets = last.conditions.table.pockets
    for at, code, ball, hole in played.trajectory.rows.tolist():
        if int(code) != BALL_POCKET or at > time:
            continue
        fallen = min((time - at) / FALL_S, 1.0)
        row = int(ball)
        opacities[row] = 1.0 - fallen
        radii[row] *= 1.0 - 0.2 * fallen
        positions[row] += min(2.0 * fallen, 1.0) * (pockets[int(hole), :2] - positions[row])
    return Balls(positions, radii, numbers, turns, opacities)


def _draw_marks(scene: Billiards, canvas: Canvas) -> None:
    """The head string while the white ball is in hand behind it, rings of goals, called ball and pocket."""
    table, game = scene.round.conditions.table, scene.round.game
    if game.in_hand == "behind the line" and scene.phase == AIMING:
        y = HEAD_SPOT * table.length
        canvas.line((0.0, y), (table.width, y), FELT_LINE, 1.25, dash=(6.0, 6.0), alpha=0.6)
    if isinstance(game, Drill) and scene.phase != SET_UP:
        with canvas.within((0.0, 0.0), (table.width, table.length)):
            _draw_rings(game, table, canvas)
        for pot in game.goal.pots:
            if pot.pocket is not None and pot.pocket < len(table.pockets):
                x, y, radius = table.pockets[pot.pocket].tolist()
                canvas.circle((x, y), radius + canvas.px(3.0), outline=FELT_WARM, width=2.0)
    call = scene.call
    if call.pocket is not None and call.pocket < len(table.pockets):
        x, y, radius = table.pockets[call.pocket].tolist()
        canvas.circle((x, y), radius + canvas.px(3.0), outline=FELT_COOL, width=2.5)
    for number, x, y in scene.round.places:
        if number == call.ball and scene.phase == AIMING:
            canvas.circle((x, y), 1.35 * scene.round.conditions.radii[number], outline=FELT_COOL, width=2.0)
    if game.in_hand and scene.phase == AIMING and scene.round.white is not None and scene.person_plays:
        canvas.circle(scene.round.white, 1.7 * scene.round.conditions.radii[0], outline=FELT_WARM, width=1.5,
                      dash=(4.0, 3.0))  # fmt: skip


def _draw_rings(game: Drill, table: Table, canvas: Canvas) -> None:
    """Where a ball must stop, each ring with the stars that it brings at its end towards the middle."""
    middle = 0.5 * table.width
    for stars, goal in enumerate((game.goal, *game.more), 1):
        for zone in goal.zones:
            inward = 1.0 if zone.x < middle else -1.0
            canvas.circle((zone.x, zone.y), zone.radius, fill=FELT_WARM, fill_alpha=0.08, outline=FELT_WARM,
                          width=1.5, dash=(5.0, 4.0))  # fmt: skip
            end = (zone.x + inward * zone.radius, zone.y)
            canvas.label(end, STAR * stars, FELT_WARM, 11, offset=(0.0, -9.0 * inward), halo=False)


def foul_of(scene: Billiards, first: int | None) -> str:
    """Why a stroke is a foul whose white ball meets that ball first, empty if it is none."""
    game = scene.round.game
    wanted = game.legal_first()
    if first is None or first in wanted or scene.call.push_out:
        return ""
    return f"foul: {listed(wanted)} first" if len(wanted) == 1 else f"foul: not the {first}"


def _draw_aim(scene: Billiards, canvas: Canvas) -> Sight | None:
    """Cue line and ways of the stroke that is set; what is foreseen, None if it cannot be played."""
    stroke = moves.aimed_stroke(scene)
    struck = Struck(scene.round.game, scene.round.places, scene.round.conditions, stroke)
    sight = sight_of(scene, struck)
    if sight is None:
        return None
    radii = scene.round.conditions.radii
    target = radii[sight.target] if sight.target is not None else 0.0
    draw_sight(canvas, sight, radii[0], target, bool(foul_of(scene, sight.target)))
    return sight


def _draw_hint(scene: Billiards, canvas: Canvas, stroke: Stroke) -> None:
    """The way of a puzzle's solution; the line below the table says in words how it is struck."""
    round_ = scene.round
    sight = hint_of(scene, Struck(round_.game, round_.places, round_.conditions, stroke))
    if sight is None or round_.white is None:
        return
    for way in (sight.approach, sight.after, *(other.points for other in sight.others)):
        if len(way) > 1:
            canvas.polyline(way, FELT_WARM, 2.0, alpha=0.75)


def _draw_cue(scene: Billiards, canvas: Canvas, time: float, aimed: bool) -> None:
    """The cue of who plays: at the ball, drawn back, in its swing, or after it."""
    motion = None
    gap, solid = REST_GAP, 1.0
    if scene.phase == STRIKING:
        motion, at = moves.motion_of(scene), time
        stroke, place = scene.pending, scene.round.white
    elif scene.phase in (ROLLING, REPLAY) and scene.round.last is not None:
        motion = moves.motion_of(scene)
        at = time + motion.hit_s
        stroke = scene.round.last.stroke
        place = next((x, y) for number, x, y in scene.round.last.places if number == CUE_BALL)
        if at > motion.end_s:
            return
    elif aimed and scene.grip != "white":
        stroke, place = moves.aimed_stroke(scene), scene.round.white
        gap = pull_of(scene.cue.speed) if scene.cue.phase == PULLING else REST_GAP
    else:
        return
    if motion is not None:
        gap, solid = motion.track.sample(at).tolist()
    if stroke is None or place is None or solid < 0.05:
        return
    last = scene.round.last
    game = last.game if last is not None and scene.phase in (ROLLING, REPLAY) else scene.round.game
    _draw_stick(scene, canvas, stroke, place, gap, BANDS[game.turn])
    if scene.cue.phase == PULLING:
        canvas.label(place, f"{scene.power:.1f} m/s", FELT_WARM, 13, "semibold", offset=(0.0, -28.0))


def _draw_stick(
    scene: Billiards, canvas: Canvas, stroke: Stroke, place: tuple[float, float], gap: float, color: str
) -> None:
    """A cue whose tip is ``gap`` m from the ball, aside and raised as the stroke says; a band says whose."""
    radius = scene.round.conditions.radii[0]
    ux, uy = math.cos(stroke.azimuth), math.sin(stroke.azimuth)
    aside = radius * stroke.tip_left
    depth = radius * math.sqrt(max(1.0 - stroke.tip_left**2 - stroke.tip_up**2, 0.0))
    flat = math.cos(stroke.elevation)
    back = (depth + gap) * flat - radius * stroke.tip_up * math.sin(stroke.elevation)
    tip = (place[0] - back * ux - aside * uy, place[1] - back * uy + aside * ux)
    table = scene.round.conditions.table
    pixels, clip = canvas.raster_target
    x, y = canvas.place(tip)
    far_x, far_y = canvas.place((tip[0] - ux, tip[1] - uy))
    scale = canvas.pixels_per_unit
    middle = canvas.place((0.5 * table.width, 0.5 * table.length))
    draw_cue(
        pixels, clip, (x, y), ((far_x - x) / scale, (far_y - y) / scale), scale, stroke.elevation, middle
    )
    ends = [(tip[0] - ux * d * flat, tip[1] - uy * d * flat) for d in BAND]
    canvas.line(ends[0], ends[1], color, 2.0 * BAND_RADIUS * scale / canvas.k)
