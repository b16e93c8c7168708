"""Keys and gestures that every cue table has; each table lists those that it offers."""

from __future__ import annotations

from game.stage import Hint, SceneAction

AIM, LOCK_AIM = Hint(("Move",), "aim"), Hint(("Click",), "lock aim")
PULL, POWER, ENTER = (
    Hint(("Drag",), "pull back, let go"),
    Hint(("Ctrl", "Wheel"), "power"),
    Hint(("Enter",), "strike"),
)
CLICK_A_NAME, WHEEL = Hint(("Click a name",), "computer player"), Hint(("Wheel",), "turn by 0.05°")
FINE_AIM, DEMO, UNDO = Hint(("Shift",), "fine aim"), Hint(("D",), "plays itself"), Hint(("U",), "undo")
PUSH, BREATH = Hint(("Drag back",), "and push through"), Hint(("F",), "hold your breath")
REPLAY, GUIDE = Hint(("R",), "replay"), Hint(("V",), "guide")
EYE, FROM_SIDE = Hint(("I",), "view from the cue"), Hint(("0",), "replay from the side")

STRIKE = SceneAction("strike", "strike with the power that is set, or skip to the end", "return")
SEE = SceneAction("eye", "view from the cue", "I")
SIDE = SceneAction("side", "replay from its best side", "0")
WATCH = SceneAction("replay", "replay of the last stroke", "R")
CHANGE_GUIDE = SceneAction("view", "guide: whole path, to the first ball, none", "V")
PLAY_ITSELF = SceneAction("demo", "plays itself", "D")
CENTRE = SceneAction("centre", "strike the middle of the ball", "C")
HOLD_BREATH = SceneAction("breath", "hold your breath: the aim sways less", "F")
THOUGHTS = SceneAction("thoughts", "what the computer player thought", "semicolon")
CHALK = SceneAction("chalk", "chalk the tip", "slash")
LOCK = SceneAction("lock", "lock or free the aim", "K")
TURNS = (
    SceneAction("left", "turn the cue left", "left"),
    SceneAction("right", "turn the cue right", "right"),
)
POWERS = (SceneAction("harder", "more power", "up"), SceneAction("softer", "less power", "down"))
SPINS = (
    SceneAction("spin-up", "tip up: follow", "W"),
    SceneAction("spin-down", "tip down: draw", "S"),
    SceneAction("spin-left", "tip to the left", "Z"),
    SceneAction("spin-right", "tip to the right", "X"),
)
OPTIONS = ("first", "second", "third", "fourth")


def options(count: int) -> tuple[SceneAction, ...]:
    """Keys 1, 2 and so on, which take one of so many options."""
    return tuple(
        SceneAction(name, f"take the {name} option", str(row))
        for row, name in enumerate(OPTIONS[:count], start=1)
    )
