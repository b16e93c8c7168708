"""The laws of the exact table: the state of a ball, how it moves, what a contact does."""
