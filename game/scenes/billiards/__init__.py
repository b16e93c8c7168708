"""The billiard game on the exact table."""
