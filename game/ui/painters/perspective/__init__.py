"""A table and its balls as a pinhole camera sees them: cloth, cushions, spheres, cue."""
