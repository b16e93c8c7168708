"""Billiards: the lecture's table stepped in time, and the exact table from event to event."""
