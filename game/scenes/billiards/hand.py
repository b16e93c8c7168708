"""The hand at the billiard table: what pointer and wheel do, in each phase of the game."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from game.billiards.game.rules import CUE_BALL
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import buttons, calling, layout, modes
from game.scenes.billiards import play as moves
from game.scenes.billiards import round as rounds
from game.scenes.billiards.buttons import POWER_STEP
from game.scenes.billiards.play import AIMING, REPLAY, SET_UP
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.cue import STRIKING as LET_GO
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

NOTCH = math.radians(0.05)  # rad, that a notch of the wheel turns the cue
FINER = 0.1  # of it while Shift is held
STICKY = math.radians(2.0)  # the pointer turns so far before an aim that was made finely is given up
LARGEST_TIP = 0.6


# -- the pointer --------------------------------------------------------------------------------------


def pointer(scene: Billiards, event: Pointer) -> None:
    """A pointer event."""
    if event.kind == "cancel" or (event.kind == "down" and event.button == 3):
        let_go(scene)
    elif event.kind == "down" and event.button == 1 and not scene.grip:
        down(scene, event)
    elif event.kind == "up" and event.button == 1:
        up(scene, event)
    elif event.kind == "move":
        move(scene, event)
    elif event.kind == "wheel":
        wheel(scene, event)


def let_go(scene: Billiards) -> None:
    """Take back what is held."""
    if scene.grip == "cue":
        scene.power = scene.power_before
        scene.cue.let_go()
    scene.grip = ""


def down(scene: Billiards, event: Pointer) -> None:
    """Take hold of what lies under the pointer."""
    x, y = event.x, event.y
    name = buttons.button_at(scene, x, y)
    if name:
        scene.grip = f"button {name}"
    elif scene.phase == REPLAY:
        if layout.SCRUBBER.holds(x, y):
            scene.grip = "scrub"
            move(scene, event)
    elif scene.phase == SET_UP:
        ball = modes.ball_to_place(scene, x, y)
        scene.grip = f"ball {ball}" if ball >= 0 else ""
    elif scene.plays_itself:
        scene.plays_itself = False
        scene.told.append("The cue is yours. Pull back and let go.")
    elif scene.person_plays:
        take_instrument(scene, event)


def take_instrument(scene: Billiards, event: Pointer) -> None:
    """Power bar, spin, elevation; or on the table the white ball in hand, a pocket to be called, the cue."""
    x, y = event.x, event.y
    if layout.POWER.holds(x, y):
        scene.grip = "power"
    elif layout.on_spin(x, y):
        scene.grip = "spin"
    elif layout.on_dial(x, y):
        scene.grip = "elevation"
    if scene.grip:
        move(scene, event)
        return
    white = scene.round.white
    if scene.phase != AIMING or not scene.round.playable or white is None:
        return
    if scene.round.game.in_hand and layout.near(white, x, y, float(scene.round.conditions.radii[0])):
        scene.grip = "white"
    elif scene.round.game.needs_call() and call_at(scene, x, y):
        return
    elif layout.TABLE.holds(x, y):
        scene.grip, scene.power_before = "cue", scene.power
        scene.cue.pointer(event, *white, ready=True)


def call_at(scene: Billiards, x: float, y: float) -> bool:
    """Call the pocket or the ball at a point; False if there is none to be called."""
    table, call = scene.round.conditions.table, scene.call
    for row, (px, py, radius) in enumerate(table.pockets.tolist()):
        if layout.near((px, py), x, y, radius):
            scene.call = call._replace(pocket=None if call.pocket == row else row, safety=False)
            return True
    for number, bx, by in scene.round.places:
        if number != CUE_BALL and layout.near((bx, by), x, y, 0.8 * BALL_RADIUS):
            scene.call = call._replace(ball=None if call.ball == number else number, safety=False)
            return True
    return False


def up(scene: Billiards, event: Pointer) -> None:
    """Let go: a button acts, the cue strikes."""
    grip, scene.grip = scene.grip, ""
    if grip.startswith("button "):
        name = grip.removeprefix("button ")
        if buttons.button_at(scene, event.x, event.y) == name:
            buttons.press(scene, name)
    elif grip.startswith("ball "):
        modes.put_down(scene, int(grip.removeprefix("ball ")), event.x, event.y)
    elif grip == "cue":
        release_cue(scene, event)


def release_cue(scene: Billiards, event: Pointer) -> None:
    """Strike with the pull, or take it as a change of mind."""
    white = scene.round.white
    if white is None or scene.phase != AIMING:
        scene.cue.let_go()
        return
    scene.cue.pointer(event, *white, ready=True)
    if scene.cue.phase != LET_GO:
        scene.power = scene.power_before
        return
    scene.power = min(max(scene.cue.speed, 0.1), MAX_SPEED)
    scene.cue.data[2] = 0.0
    stroke = moves.aimed_stroke(scene)
    moves.begin_stroke(scene, stroke, calling.call_for(scene, stroke), practised=False)
    scene.pulled = scene.power


def move(scene: Billiards, event: Pointer) -> None:
    """What is held follows the pointer; else the cue turns to it."""
    x, y, grip = event.x, event.y, scene.grip
    if grip == "power":
        scene.power = max(layout.power_at(x, MAX_SPEED), 0.1)
    elif grip == "spin":
        scene.tip_left, scene.tip_up = layout.spin_at(x, y, LARGEST_TIP)
    elif grip == "elevation":
        scene.elevation = min(math.degrees(layout.elevation_at(x, y)), 80.0)
    elif grip == "scrub":
        scene.clock[moves.REPLAY_S] = layout.share_of_scrubber(y) * moves.shown_s(scene)
    elif grip == "white":
        if scene.round.game.in_hand and scene.phase == AIMING:
            scene.round = rounds.white_moved(scene.round, x, y)
            moves.lay_out(scene)
    elif grip.startswith("ball "):
        modes.drag_ball(scene, int(grip.removeprefix("ball ")), x, y)
    elif scene.phase == AIMING and scene.person_plays and scene.round.playable:
        aim(scene, event)


def aim(scene: Billiards, event: Pointer) -> None:
    """Turn the cue to the pointer, or draw it back."""
    white = scene.round.white
    if white is None:
        return
    if scene.grip == "cue":
        scene.cue.pointer(event, *white, ready=True)
        scene.power = min(max(scene.cue.speed, 0.1), MAX_SPEED)
        return
    if not layout.TABLE.holds(event.x, event.y):
        return
    bearing = math.atan2(event.y - white[1], event.x - white[0])
    if event.shift:
        scene.fine_at = bearing
    elif abs(math.remainder(bearing - scene.fine_at, 2.0 * math.pi)) < STICKY:
        scene.cue.data[5] = bearing  # a pointer that only trembles does not spoil a fine aim
        return
    else:
        scene.fine_at = math.nan
    scene.cue.pointer(event, *white, ready=True)


def wheel(scene: Billiards, event: Pointer) -> None:
    """The wheel turns the cue finely; over the power bar, or with Control, it sets the power."""
    if scene.phase != AIMING or not scene.person_plays:
        return
    if event.control or layout.POWER.holds(event.x, event.y):
        scene.power = min(max(scene.power + POWER_STEP * event.wheel, 0.1), MAX_SPEED)
    elif not scene.grip:
        scene.cue.point_to(scene.cue.aim - NOTCH * event.wheel * (FINER if event.shift else 1.0))
        white = scene.round.white
        if white is not None:
            scene.fine_at = math.atan2(event.y - white[1], event.x - white[0])
