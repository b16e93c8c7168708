"""A match of two tables far apart: each stroke travels as a text."""
