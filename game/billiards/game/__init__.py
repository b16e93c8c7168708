"""Rules, goals and frames: billiards as a game."""
