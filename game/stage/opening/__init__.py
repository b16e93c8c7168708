"""How a scene is opened from a level."""
