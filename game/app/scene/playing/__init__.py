"""What lets a scene in play go on: the gate of its events, its pointer, its steps, its picture."""
