"""What a key does in the billiard game, and the hints that say so."""

from game.stage import Hint, SceneAction

HINTS = (
    Hint(("Move",), "aim"),
    Hint(("Click",), "lock aim"),
    Hint(("Drag",), "pull back, let go"),
    Hint(("Right drag",), "spin"),
    Hint(("Ctrl", "Wheel"), "power"),
    Hint(("Enter",), "strike"),
    Hint(("Click a name",), "computer player"),
    Hint(("Wheel",), "turn by 0.05°"),
    Hint(("Shift",), "fine aim"),
    Hint(("N",), "new rack"),
    Hint(("D",), "plays itself"),
    Hint(("U",), "undo"),  # from here on there are buttons too; a narrow bar drops them
    Hint(("R",), "replay"),
    Hint(("E",), "set up"),
    Hint(("V",), "guide"),
)
ACTIONS = (
    SceneAction("strike", "strike with the power that is set, or skip to the end", "return"),
    SceneAction("undo", "undo the last stroke, aim as before", "U"),
    SceneAction("replay", "replay of the last stroke", "R"),
    SceneAction("view", "guide: whole path, to the first ball, none", "V"),
    SceneAction("set-up", "place the balls freely", "E"),
    SceneAction("rack", "next rack, or the same again", "N"),
    SceneAction("demo", "plays itself", "D"),
    SceneAction("centre", "strike the middle of the ball", "C"),
    SceneAction("safety", "announce a safety or a push-out", "B"),
    SceneAction("hint", "show how a puzzle is solved", "H"),
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
    SceneAction("fourth", "take the fourth option", "4"),
)  # fmt: skip
