"""What a key does in the billiard game, and the hints that say so."""

from game.scenes.shared.tables import actions as keys
from game.stage import Hint, SceneAction

HINTS = (
    keys.AIM,
    keys.LOCK_AIM,
    keys.PULL,
    Hint(("Right drag",), "spin"),
    keys.POWER,
    keys.ENTER,
    keys.CLICK_A_NAME,
    keys.WHEEL,
    keys.FINE_AIM,
    Hint(("N",), "new rack"),
    keys.DEMO,
    keys.UNDO,  # from here on there are buttons too; a narrow bar drops them
    keys.REPLAY,
    Hint(("E",), "set up"),
    keys.GUIDE,
    Hint(("M",), "every pot"),
    Hint(("G",), "log"),
    Hint(("T",), "record"),
    Hint(("J",), "landing cloud"),
    Hint(("Y",), "coach"),
)
ACTIONS = (
    keys.STRIKE,
    SceneAction("undo", "undo the last stroke, aim as before", "U"),
    keys.WATCH,
    keys.CHANGE_GUIDE,
    SceneAction("set-up", "place the balls freely", "E"),
    SceneAction("rack", "next rack, or the same again", "N"),
    keys.PLAY_ITSELF,
    keys.CENTRE,
    keys.HOLD_BREATH,
    SceneAction("safety", "announce a safety or a push-out", "B"),
    SceneAction("hint", "show how a puzzle is solved", "H"),
    keys.LOCK,
    SceneAction("map", "map: every pot, and where the cue ball may end", "M"),
    SceneAction("log", "log: go back to any stroke", "G"),
    SceneAction("record", "what was practised, over time", "T"),
    SceneAction("coach", "coach: what the stroke was worth, why it missed", "Y"),
    SceneAction("ask", "ask the coach before the stroke", "Q"),
    SceneAction("lesson", "the next lesson", "O"),
    SceneAction("cloud", "landing cloud of a hand's noise", "J"),
    *keys.TURNS,
    *keys.POWERS,
    *keys.SPINS,
    *keys.options(4),
)  # fmt: skip
