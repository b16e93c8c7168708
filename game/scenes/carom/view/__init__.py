"""How carom is drawn: table, map, score board, the picture of the tip."""
