"""A stroke by the hand: the pointer draws the cue back and pushes it through the ball."""
