"""Studies of broad phases."""
