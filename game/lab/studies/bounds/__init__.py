"""Studies of bounding volumes."""
