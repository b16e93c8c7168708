"""What a hand does in several scenes, and the tools that it does it with."""
