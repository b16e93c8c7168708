"""What can stand beside the table: names and words."""

NONE, LOG, MAP, RECORD = "none", "log", "map", "record"
BESIDE = (NONE, LOG, MAP, RECORD)
BESIDE_LABELS = ("Nothing", "Log of the game", "Map of the position", "Practice record")
