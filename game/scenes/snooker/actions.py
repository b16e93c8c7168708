"""Keys and gestures of snooker."""

from __future__ import annotations

from game.stage import Hint, SceneAction

HINTS = (
    Hint(("Move",), "aim"),
    Hint(("Click",), "lock aim"),
    Hint(("Drag",), "pull back, let go"),
    Hint(("Ctrl", "Wheel"), "power"),
    Hint(("Enter",), "strike"),
    Hint(("Click a colour",), "nominate it"),
    Hint(("Click a name",), "computer player"),
    Hint(("Wheel",), "turn by 0.05°"),
    Hint(("Shift",), "fine aim"),
    Hint(("N",), "next frame"),
    Hint(("D",), "plays itself"),
    Hint(("U",), "undo"),
    Hint(("R",), "replay"),
    Hint(("V",), "guide"),
)
ACTIONS = (
    SceneAction("strike", "strike with the power that is set, or skip to the end", "return"),
    SceneAction("undo", "undo the last stroke", "U"),
    SceneAction("replay", "replay of the last stroke", "R"),
    SceneAction("view", "guide: whole path, to the first ball, none", "V"),
    SceneAction("rack", "next frame, or the same again", "N"),
    SceneAction("demo", "plays itself", "D"),
    SceneAction("centre", "strike the middle of the ball", "C"),
    SceneAction("concede", "concede the frame, or claim it", "Q"),
    SceneAction("restart", "agree on a stalemate: the frame begins again", "T"),
    SceneAction("lock", "lock or free the aim", "K"),
    SceneAction("left", "turn the cue left", "left"),
    SceneAction("right", "turn the cue right", "right"),
    SceneAction("harder", "more power", "up"),
    SceneAction("softer", "less power", "down"),
    SceneAction("spin-up", "tip up: follow", "W"),
    SceneAction("spin-down", "tip down: draw", "S"),
    SceneAction("spin-left", "tip to the left", "Z"),
    SceneAction("spin-right", "tip to the right", "X"),
    SceneAction("first", "take the first option", "1"),
    SceneAction("second", "take the second option", "2"),
    SceneAction("third", "take the third option", "3"),
    SceneAction("nominate-2", "nominate yellow", "4"),
    SceneAction("nominate-3", "nominate green", "5"),
    SceneAction("nominate-4", "nominate brown", "6"),
    SceneAction("nominate-5", "nominate blue", "7"),
    SceneAction("nominate-6", "nominate pink", "8"),
    SceneAction("nominate-7", "nominate black", "9"),
)  # fmt: skip
