"""What is kept of the strokes of a match: which of them counted, and films of those that decided it."""
