"""The lecture's pool table."""
