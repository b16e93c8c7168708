"""Studies of the billiard tables."""
