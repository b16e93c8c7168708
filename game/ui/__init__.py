"""Everything that needs pygame: drawing, text, controls."""
