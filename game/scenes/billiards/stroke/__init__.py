"""A stroke: how it is aimed, called and foreseen, and how the cue moves."""
