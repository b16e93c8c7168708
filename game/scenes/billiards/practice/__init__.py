"""Practice: the log of a game, the map of a position, landing clouds, drills of one's own, what is kept."""
