"""What a referee calls after a stroke, and the card at the end of a frame."""
