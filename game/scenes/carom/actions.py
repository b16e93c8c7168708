"""Keys and gestures of carom."""

from __future__ import annotations

from game.stage import Hint, SceneAction

HINTS = (
    Hint(("Drag a ball",), "move it"),
    Hint(("Click a way",), "see it"),
    Hint(("Again",), "play it"),
    Hint(("Move",), "aim"),
    Hint(("Drag",), "pull back, let go"),
    Hint(("Enter",), "strike"),
    Hint(("X",), "play the chosen one"),
    Hint(("V",), "map"),
    Hint(("H",), "explain"),
    Hint(("D",), "plays itself"),
    Hint(("U",), "undo"),
    Hint(("N",), "new game"),
)
ACTIONS = (
    SceneAction("strike", "strike with the power that is set, or skip to the end", "return"),
    SceneAction("play", "play the chosen stroke of the map", "X"),
    SceneAction("safety", "strike, announced as a safety", "B"),
    SceneAction("undo", "undo the last stroke, or moving balls", "U"),
    SceneAction("next", "the next game, or this one again", "N"),
    SceneAction("map", "show the map, or hide it", "V"),
    SceneAction("explain", "the first three choices in words", "H"),
    SceneAction("ends", "where the balls end after the chosen stroke", "E"),
    SceneAction("demo", "plays itself", "D"),
    SceneAction("centre", "strike the middle of the ball", "C"),
    SceneAction("left", "turn the cue left", "left"),
    SceneAction("right", "turn the cue right", "right"),
    SceneAction("first", "take the first option", "1"),
    SceneAction("second", "take the second option", "2"),
)
