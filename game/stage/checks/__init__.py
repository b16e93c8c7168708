"""What is asked of a scene before it is played: its declarations, and that its state is whole."""
