"""What is chosen before a game of carom begins: parameters of the scene, in few words."""

from game.scenes.shared.tables.furnishing.choices import CAROM_FELT_LINE
from game.scenes.shared.tables.minds.hurry import THEIR_STROKES_LINE
from game.scenes.shared.tables.seats.hot_seat import HAND_OVER_LINE
from game.scenes.shared.tables.through.choices import START_LINE
from game.stage.declarations import StartLine

START = (
    StartLine(
        "second_player", "Opponent", "a person, or the computer",
        (("person", "Person"), ("novice", "Novice"), ("club", "Club player"), ("expert", "Expert"),
         ("master", "Master")),
        "club",
    ),
    HAND_OVER_LINE,
    THEIR_STROKES_LINE,
    StartLine(
        "game", "Game", "cushions needed, or boxes",
        (("three-cushion", "3-cushion"), ("one-cushion", "1-cushion"),
         ("straight-rail", "Straight rail"), ("balkline-47-2", "47/2"),
         ("balkline-47-1", "47/1"), ("balkline-71-2", "71/2"), ("artistic", "Artistic")),
        "three-cushion",
    ),
    StartLine("cloth", "Cloth", "of the table", (("heated", "Heated"), ("club", "Club")), "heated"),
    CAROM_FELT_LINE,
    START_LINE,
    StartLine(
        "hand", "Your hand", "how much it shakes",
        (("none", "Not at all"), ("steady", "Steady"), ("average", "Average")), "none",
    ),
)  # fmt: skip
