"""What is chosen before a game of billiards begins: parameters of the scene, in few words."""

from game.scenes.shared.tables.furnishing.choices import FELT_LINE, TABLE_LINE
from game.scenes.shared.tables.minds.hurry import THEIR_STROKES_LINE
from game.scenes.shared.tables.seats.hot_seat import HAND_OVER_LINE
from game.scenes.shared.tables.through.choices import START_LINE
from game.stage.declarations import StartLine

ALONE = ("game", "practice")
START = (
    StartLine(
        "second_player", "Opponent", "a person, or the computer",
        (("person", "Person"), ("novice", "Novice"), ("club", "Club player"), ("expert", "Expert"),
         ("master", "Master")),
        "novice", idle=ALONE,
    ),
    HAND_OVER_LINE,
    THEIR_STROKES_LINE,
    StartLine(
        "game", "Game", "of the pool table",
        (("eight-ball", "8-ball"), ("nine-ball", "9-ball"), ("ten-ball", "10-ball"),
         ("straight-pool", "Straight pool"), ("combination", "Combination"),
         ("ghost-nine-ball", "Ghost"), ("practice", "Practice")),
        "eight-ball",
    ),
    StartLine(
        "race", "Race to", "racks that win the match",
        (("1", "1"), ("3", "3"), ("5", "5"), ("7", "7"), ("open", "No end")), "1", idle=ALONE,
    ),
    StartLine(
        "guide", "Guide", "what is shown of your stroke",
        (("auto", "Suits the game"), ("whole", "Full path"), ("first", "To the first ball"),
         ("none", "None")),
        "auto",
    ),
    START_LINE,
    FELT_LINE,
    TABLE_LINE,
    StartLine(
        "hand", "Your hand", "how much it shakes",
        (("none", "Not at all"), ("steady", "Steady"), ("average", "Average")), "none",
    ),
)  # fmt: skip
