"""Buttons and keys of the billiard game."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.scenes.billiards import calling, layout, modes
from game.scenes.billiards import play as moves
from game.scenes.billiards.play import AIMING, REPLAY, ROLLING, SET_UP
from game.scenes.billiards.players import GRADES
from game.scenes.shared.tables.cue import MAX_SPEED

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

POWER_STEP = 0.1  # m/s for a key or a notch of the wheel
OPTIONS = ("first", "second", "third", "fourth")


def buttons(scene: Billiards) -> list[tuple[str, str, bool]]:
    """Buttons right of the table, from below: action, words, whether it is on."""
    if scene.phase == SET_UP:
        return [("set-up", "Done", True), ("clear", "Clear", False), ("full", "Rack", False)]
    if scene.phase == REPLAY:
        return [("replay", "Back", True)]
    rows = [("set-up", "Set up", False), ("replay", "Replay", False), ("undo", "Undo", False),
            ("view", "Aim line", bool(scene.prediction))]  # fmt: skip
    game = scene.round.game
    if scene.content.solution is not None:
        rows.append(("hint", "Hint", scene.hint_shown))
    if game.over:
        rows.append(("rack", "Next rack", True))
    elif game.may_push_out():
        rows.append(("safety", "Push out", scene.call.push_out))
    elif game.needs_call():
        rows.append(("safety", "Safety", scene.call.safety))
    return rows


def button_at(scene: Billiards, x: float, y: float) -> str:
    """Name of the button, or of the option, at a point; empty if there is none."""
    for row, (name, _, _) in enumerate(buttons(scene)):
        if layout.button_box(row).holds(x, y):
            return name
    if len(scene.round.game.players) == 2:
        for player in range(2):
            if layout.card_box(player).holds(x, y):
                return f"card-{player}"
    if scene.phase == AIMING:
        options = scene.round.game.options
        for row in range(len(options)):
            if scene.person_plays and layout.option_box(row, len(options)).holds(x, y):
                return f"option-{row}"
    if scene.phase == REPLAY:
        if layout.PLAY.holds(x, y):
            return "replay-run"
        if layout.SPEED.holds(x, y):
            return "replay-speed"
    return ""


def press(scene: Billiards, name: str) -> None:
    """A button has been pressed and let go."""
    if name.startswith("option-"):
        moves.take_option(scene, int(name.removeprefix("option-")))
    elif name.startswith("card-"):
        change_player(scene, int(name.removeprefix("card-")))
    elif name == "replay-run":
        modes.toggle_replay(scene)
    elif name == "replay-speed":
        modes.change_replay_speed(scene)
    elif name in ("clear", "full"):
        modes.fill_table(scene, name == "full")
    else:
        action(scene, name)


def change_player(scene: Billiards, player: int) -> None:
    """The next grade for a player: a person, then computer players from weak to strong."""
    grades = ("person", *GRADES)
    following = grades[(grades.index(scene.grade_of(player)) + 1) % len(grades)]
    if player == 0:
        scene.first_player = following
    else:
        scene.second_player = following


def action(scene: Billiards, name: str) -> None:
    """A named action."""
    if name in OPTIONS:
        if scene.person_plays:
            moves.take_option(scene, OPTIONS.index(name))
    elif name == "strike":
        strike_or_skip(scene)
    elif name in ("undo", "rack") and scene.phase in (REPLAY, SET_UP):
        modes.leave(scene)
    elif name == "undo":
        moves.undo(scene)
    elif name == "replay":
        modes.watch(scene)
    elif name == "set-up":
        modes.set_up(scene)
    elif name == "rack":
        moves.rack(scene)
    elif name == "view":
        scene.prediction = not scene.prediction
    elif name == "safety":
        if scene.person_plays:
            calling.announce(scene)
    elif name == "demo":
        scene.plays_itself = not scene.plays_itself
        scene.cue.let_go()
        scene.grip = ""
        scene.rest_s = 0.0
        if scene.phase in (REPLAY, SET_UP):
            modes.leave(scene)
    elif name == "hint":
        scene.hint_shown = not scene.hint_shown
        if scene.content.solution is None:
            scene.hint_shown = False
            scene.told.append("No hint. Only puzzles and drills have one.")
    elif name == "centre":
        scene.tip_left = scene.tip_up = scene.elevation = 0.0
    elif name in ("left", "right"):
        if scene.person_plays and scene.phase == AIMING:
            scene.cue.nudge(name)
            scene.fine_at = float(scene.cue.data[5])
    else:
        step = POWER_STEP if name == "harder" else -POWER_STEP
        scene.power = min(max(round(scene.power + step, 3), 0.1), MAX_SPEED)


def strike_or_skip(scene: Billiards) -> None:
    """Strike with the power that is set; while balls roll, go to the end; in a replay, run or stand."""
    if scene.phase == REPLAY:
        modes.toggle_replay(scene)
    elif scene.phase == ROLLING:
        moves.skip(scene)
    elif scene.phase == AIMING and scene.round.game.over:
        moves.rack(scene)
    elif scene.phase == AIMING and scene.person_plays and scene.round.playable:
        stroke = moves.aimed_stroke(scene)
        moves.begin_stroke(scene, stroke, calling.call_for(scene, stroke), practised=False)
