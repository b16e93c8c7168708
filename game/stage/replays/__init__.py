"""A session made again from what was recorded of it."""
