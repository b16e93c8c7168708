"""What happens on the billiard table: strokes, their ends, undo, racks, and what players decide.

Functions of the scene; they alone change it.
"""

from __future__ import annotations

import hashlib
import math
from functools import lru_cache
from typing import TYPE_CHECKING

import msgspec
import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.shot.cue import strike as struck_ball
from game.scenes.billiards import round as rounds
from game.scenes.billiards.level import game_of, lie_of
from game.scenes.billiards.round import Round
from game.scenes.billiards.stroke_motion import StrokeMotion, stroke_motion
from game.scenes.shared.tables.cue import MAX_SPEED

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

AIMING, STRIKING, ROLLING, REPLAY, SET_UP = "aiming", "striking", "rolling", "replay", "set-up"
AT_THE_RACK = 0.5 * math.pi  # azimuth of a cue that points along the table, rad
PHASE_S, REPLAY_S = range(2)


@lru_cache(maxsize=1)
def speed_ratio() -> float:
    """Speed of a ball struck in its middle over that of the cue (Alciatore, TP A-30)."""
    vx, vy, _ = struck_ball(1.0, 0.0).velocity
    return math.sqrt(vx * vx + vy * vy)


def lay_out(scene: Billiards) -> None:
    """The places of the state follow the round."""
    for number, x, y in scene.round.places:
        scene.places[number] = x, y


def word_of(round_: Round) -> str:
    """A hash of all that a round says, but for what came before it."""
    last = round_.last
    said = (
        msgspec.to_builtins(round_.game), round_.places, round_.conditions, round_.call, round_.strokes,
        None if last is None else (last.places, last.stroke, last.call, last.conditions),
    )  # fmt: skip
    return hashlib.blake2b(repr(said).encode(), digest_size=8).hexdigest()


def start_phase(scene: Billiards, phase: str) -> None:
    """Go over to a phase, its clock at 0."""
    scene.phase = phase
    scene.clock[PHASE_S] = 0.0
    scene.rest_s = 0.0


# -- a stroke -----------------------------------------------------------------------------------------


def aimed_stroke(scene: Billiards) -> Stroke:
    """The stroke that cue and instruments are set to."""
    return Stroke(
        scene.power / speed_ratio(),
        scene.cue.aim,
        math.radians(scene.elevation),
        scene.tip_left,
        scene.tip_up,
    )


def motion_of(scene: Billiards) -> StrokeMotion:
    """How the cue moves for the pending or the last stroke."""
    stroke = scene.pending
    if stroke is None:
        stroke = scene.round.last.stroke if scene.round.last is not None else Stroke(1.0, 0.0)
    return _motion(stroke.cue_speed * speed_ratio(), scene.practised)


@lru_cache(maxsize=8)
def _motion(speed: float, practised: bool) -> StrokeMotion:
    return stroke_motion(speed, practised)


def begin_stroke(scene: Billiards, stroke: Stroke, call: Call, practised: bool) -> None:
    """The cue starts to swing. ValueError if no stroke may be played now."""
    if scene.phase != AIMING or not scene.round.playable:
        raise ValueError("stroke: none may be played now")
    scene.pending, scene.practised = stroke, practised
    scene.call = call
    scene.grip = ""
    scene.cue.let_go()
    scene.cue.point_to(stroke.azimuth)
    start_phase(scene, STRIKING)


def swing(scene: Billiards) -> None:
    """When the tip has met the ball, the stroke is played."""
    motion = motion_of(scene)
    late = float(scene.clock[PHASE_S]) - motion.hit_s
    if late < 0.0 or scene.pending is None:
        return
    stroke, scene.pending = scene.pending, None
    call, scene.call = scene.call, Call()
    before = scene.round
    scene.round = rounds.strike(before, stroke, call)
    try:
        played = scene.played
    except ValueError as error:
        scene.round = before
        scene.told.append(f"The stroke cannot be played. {error}")
        start_phase(scene, AIMING)
        return
    assert played is not None
    scene.turns_before[:] = scene.turns
    start_phase(scene, ROLLING)
    scene.clock[PHASE_S] = late
    roll(scene)


def roll(scene: Billiards) -> None:
    """The balls where they are by now; at the end of the shot the verdict holds."""
    played = scene.played
    assert played is not None
    time = float(scene.clock[PHASE_S])
    numbers = rows_of(scene)
    scene.places[numbers] = played.trajectory.state_at(time).positions
    if time >= shown_s(scene):
        settle(scene)


def shown_s(scene: Billiards) -> float:
    """How long the last stroke is shown: to its end, and until the cue has gone, s."""
    played = scene.played
    motion = motion_of(scene)
    return max(played.trajectory.end_time if played is not None else 0.0, motion.end_s - motion.hit_s) + 0.05


def rows_of(scene: Billiards) -> list[int]:
    """Numbers of the balls of the last stroke, in its trajectory's order."""
    last = scene.round.last
    return [number for number, _, _ in last.places] if last is not None else []


def settle(scene: Billiards) -> None:
    """The shot is over: the verdict is told, and the next player aims."""
    played = scene.played
    assert played is not None
    numbers = rows_of(scene)
    end = played.trajectory.orientations_at(played.trajectory.end_time, scene.turns_before[numbers])
    scene.turns[numbers] = end
    scene.round = played.after
    if scene.power == scene.pulled:  # the next line is shown for what is set, not for how hard this one was
        scene.power = scene.power_before
    scene.pulled = math.nan
    lay_out(scene)
    start_phase(scene, AIMING)


def skip(scene: Billiards) -> None:
    """On to the end of the shot."""
    if scene.phase == ROLLING:
        scene.clock[PHASE_S] = shown_s(scene)
        roll(scene)


# -- back, on, and anew -------------------------------------------------------------------------------


def undo(scene: Billiards) -> None:
    """Before the last stroke of a person, aimed as it was."""
    if scene.phase == STRIKING:
        scene.pending = None
        start_phase(scene, AIMING)
        return
    taken = scene.round
    if taken.earlier is None:
        scene.told.append("Nothing to undo. No stroke has been played.")
        return
    while taken.earlier is not None:
        stroke = taken.last
        taken = taken.earlier
        if scene.grade_of(taken.game.turn) == "person" or scene.plays_itself:
            break
    scene.round = taken
    scene.turns[:] = scene.turns_before
    if stroke is not None and scene.grade_of(taken.game.turn) == "person":
        aim_as(scene, stroke.stroke)
    scene.call = Call()
    lay_out(scene)
    start_phase(scene, AIMING)


def aim_as(scene: Billiards, stroke: Stroke) -> None:
    """Set cue and instruments to a stroke."""
    scene.cue.let_go()
    scene.cue.point_to(stroke.azimuth)
    scene.power = min(max(stroke.cue_speed * speed_ratio(), 0.1), MAX_SPEED)
    scene.tip_left = min(max(stroke.tip_left, -0.6), 0.6)
    scene.tip_up = min(max(stroke.tip_up, -0.6), 0.6)
    scene.elevation = min(max(math.degrees(stroke.elevation), 0.0), 80.0)


def rack(scene: Billiards) -> None:
    """The next rack if the game is over, else this game, or this drill, from its beginning."""
    scene.racks += 1
    seed = scene.seed * 1000 + scene.racks
    round_ = scene.round
    if round_.game.over and not isinstance(round_.game, Drill):
        scene.round = rounds.next_rack(round_, seed)
    else:
        content = scene.content
        if not isinstance(round_.game, Drill):
            content = msgspec.structs.replace(content, balls=[], saved={})
        game = game_of(content)
        lie = lie_of(content, game, round_.conditions.table, round_.conditions.balls, seed)
        frame = round_.frame._replace(game=game, lie=lie)
        scene.round = rounds.begin(frame, round_.conditions)
    if not isinstance(round_.game, Drill):  # a shot that is tried again is aimed as it was
        scene.cue.point_to(AT_THE_RACK)
    scene.pending, scene.call, scene.grip = None, Call(), ""
    scene.cue.let_go()
    lay_out(scene)
    start_phase(scene, AIMING)


def take_option(scene: Billiards, row: int) -> None:
    """The player at turn chooses one of the options, counted from 0; nothing if there is no such."""
    options = scene.round.game.options
    if scene.phase != AIMING or not 0 <= row < len(options):
        return
    scene.racks += 1
    scene.round = rounds.choose(scene.round, options[row].name, scene.seed * 1000 + scene.racks)
    lay_out(scene)
    scene.rest_s = 0.0


def measures(scene: Billiards) -> tuple[float, float, int]:
    """Energy J (of motion along the cloth), speed of the white ball m/s, and events so far."""
    if scene.phase not in (ROLLING, REPLAY) or scene.played is None or scene.round.last is None:
        return 0.0, 0.0, 0
    time = float(scene.clock[PHASE_S if scene.phase == ROLLING else REPLAY_S])
    trajectory = scene.played.trajectory
    moving = trajectory.state_at(time).velocities
    numbers = rows_of(scene)
    masses = np.array(scene.round.last.conditions.masses)[numbers]
    energy = float((0.5 * masses * (moving * moving).sum(axis=1)).sum())
    white = moving[numbers.index(CUE_BALL)]
    count = int(np.searchsorted(trajectory.times, time, side="right"))
    return energy, math.sqrt(float(white @ white)), count


def warm_up(scene: Billiards) -> None:
    """Play one stroke, so that all kernels of the table are compiled."""
    begin_stroke(scene, Stroke(4.0, 0.5 * math.pi), Call(), practised=False)
    for _ in range(100):
        scene.advance(0.02)
    scene.readouts()
