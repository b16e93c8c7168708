"""The script of a story as data: lines, the order that they are played in, deeds, readouts, camera."""
