"""Keys and gestures of snooker."""

from __future__ import annotations

from game.scenes.shared.tables import actions as keys
from game.stage import Hint, SceneAction

HINTS = (
    keys.AIM,
    keys.LOCK_AIM,
    keys.PULL,
    keys.POWER,
    keys.ENTER,
    Hint(("Click a colour",), "nominate it"),
    keys.CLICK_A_NAME,
    keys.WHEEL,
    keys.FINE_AIM,
    Hint(("N",), "next frame"),
    keys.DEMO,
    keys.UNDO,
    keys.REPLAY,
    keys.EYE,
    keys.FROM_SIDE,
    keys.GUIDE,
    Hint(("Y",), "coach"),
)
ACTIONS = (
    keys.STRIKE,
    SceneAction("undo", "undo the last stroke", "U"),
    keys.WATCH,
    keys.SIDE,
    keys.SEE,
    keys.CHANGE_GUIDE,
    SceneAction("rack", "next frame, or the same again", "N"),
    keys.PLAY_ITSELF,
    keys.CENTRE,
    keys.HOLD_BREATH,
    keys.CHALK,
    keys.THOUGHTS,
    SceneAction("concede", "concede the frame, or claim it", "Q"),
    SceneAction("coach", "coach: what the stroke was worth, why it missed", "Y"),
    SceneAction("ask", "ask the coach before the stroke", "G"),
    SceneAction("restart", "agree on a stalemate: the frame begins again", "T"),
    SceneAction("lesson", "the next lesson", "O"),
    keys.LOCK,
    *keys.TURNS,
    *keys.POWERS,
    *keys.SPINS,
    *keys.options(3),
    SceneAction("nominate-2", "nominate yellow", "4"),
    SceneAction("nominate-3", "nominate green", "5"),
    SceneAction("nominate-4", "nominate brown", "6"),
    SceneAction("nominate-5", "nominate blue", "7"),
    SceneAction("nominate-6", "nominate pink", "8"),
    SceneAction("nominate-7", "nominate black", "9"),
)  # fmt: skip
