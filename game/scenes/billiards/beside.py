"""What can stand beside the table: names and words."""

NONE, LOG, MAP, RECORD, COACH = "none", "log", "map", "record", "coach"
BESIDE = (NONE, LOG, MAP, RECORD, COACH)
BESIDE_LABELS = (
    "Nothing",
    "Log of the game",
    "Map of the position",
    "Practice record",
    "Coach",
)
