"""The lecture's two balls and their one collision."""
