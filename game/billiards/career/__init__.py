"""A career: matches, ratings, tournaments and records of the players of this machine."""
