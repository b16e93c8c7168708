"""The canvas that scenes draw on, in world coordinates, and its camera."""
