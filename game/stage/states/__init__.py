"""The state of a scene: its arrays, what is remembered of it, snapshots, and places between steps."""
