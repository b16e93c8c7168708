"""Whatever a hand, a file or a number may do to the program: random, counted, the same for the same seed."""
