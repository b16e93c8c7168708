"""The lecture's table: its ball, its walls and its collisions, stepped in time."""
