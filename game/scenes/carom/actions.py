"""Keys and gestures of carom."""

from __future__ import annotations

from game.scenes.shared.tables import actions as keys
from game.stage import Hint, SceneAction

HINTS = (
    Hint(("Drag a ball",), "move it"),
    Hint(("Click a way",), "see it"),
    Hint(("Again",), "play it"),
    keys.AIM,
    keys.PULL,
    keys.ENTER,
    Hint(("X",), "play the chosen one"),
    Hint(("V",), "map"),
    Hint(("H",), "explain"),
    keys.DEMO,
    keys.UNDO,
    Hint(("N",), "new game"),
    keys.REPLAY,
    keys.EYE,
    keys.FROM_SIDE,
    Hint(("Y",), "coach"),
)
ACTIONS = (
    keys.STRIKE,
    SceneAction("play", "play the chosen stroke of the map", "X"),
    SceneAction("safety", "strike, announced as a safety", "B"),
    SceneAction("undo", "undo the last stroke, or moving balls", "U"),
    SceneAction("next", "the next game, or this one again", "N"),
    SceneAction("lesson", "the next lesson", "O"),
    SceneAction("coach", "coach: what the stroke was worth, why it missed", "Y"),
    SceneAction("ask", "ask the coach before the stroke", "Q"),
    SceneAction("map", "show the map, or hide it", "V"),
    SceneAction("explain", "the first three choices in words", "H"),
    SceneAction("ends", "where the balls end after the chosen stroke", "E"),
    keys.WATCH,
    keys.SIDE,
    keys.SEE,
    keys.PLAY_ITSELF,
    keys.CENTRE,
    keys.HOLD_BREATH,
    keys.CHALK,
    keys.THOUGHTS,
    *keys.TURNS,
    *keys.options(2),
)
