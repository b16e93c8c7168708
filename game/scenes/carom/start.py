"""What is chosen before a game of carom begins: parameters of the scene, in few words."""

from game.scenes.shared.tables.through.choices import START_LINE
from game.stage.declarations import StartLine

START = (
    StartLine(
        "second_player", "Opponent", "a person, or the computer",
        (("person", "Person"), ("novice", "Novice"), ("club", "Club player"), ("expert", "Expert"),
         ("master", "Master")),
        "club",
    ),
    StartLine(
        "game", "Game", "how many cushions a point needs",
        (("three-cushion", "Three-cushion"), ("one-cushion", "One-cushion"),
         ("straight-rail", "Straight rail")),
        "three-cushion",
    ),
    StartLine("cloth", "Cloth", "of the table", (("heated", "Heated"), ("club", "Club")), "heated"),
    START_LINE,
    StartLine(
        "hand", "Your hand", "how much it shakes",
        (("none", "Not at all"), ("steady", "Steady"), ("average", "Average")), "none",
    ),
)  # fmt: skip
