"""A stroke and its record: what is played, as a file, and what became of it."""
