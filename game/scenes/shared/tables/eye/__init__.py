"""A table seen in perspective: from behind the cue ball, from a stroke's best side, on the deciding ball."""
