"""What is chosen before a game of snooker begins: parameters of the scene, in few words."""

from game.scenes.shared.tables.furnishing.choices import FELT_LINE, TABLE_LINE
from game.scenes.shared.tables.minds.hurry import THEIR_STROKES_LINE
from game.scenes.shared.tables.seats.hot_seat import HAND_OVER_LINE
from game.scenes.shared.tables.through.choices import START_LINE
from game.stage.declarations import StartLine

START = (
    StartLine(
        "second_player", "Opponent", "a person, or the computer",
        (("person", "Person"), ("novice", "Novice"), ("club", "Club player"), ("expert", "Expert"),
         ("master", "Master")),
        "novice",
    ),
    HAND_OVER_LINE,
    THEIR_STROKES_LINE,
    StartLine(
        "game", "Game", "how many reds there are",
        (("snooker", "15 reds"), ("six-red", "Six-red")), "snooker",
    ),
    StartLine(
        "best_of", "Best of", "frames of the match",
        (("1", "1"), ("3", "3"), ("5", "5"), ("7", "7"), ("open", "No end")), "1",
    ),
    StartLine(
        "miss", "Miss", "how strict the referee is",
        (("professional", "Professional"), ("club", "Club"), ("off", "None called")), "club",
    ),
    START_LINE,
    FELT_LINE,
    TABLE_LINE,
    StartLine(
        "hand", "Your hand", "how much it shakes",
        (("none", "Not at all"), ("steady", "Steady"), ("average", "Average")), "none",
    ),
)  # fmt: skip
