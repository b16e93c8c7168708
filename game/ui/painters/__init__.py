"""Pictures of one thing each: ball, table, cue, disc."""
