"""What a computer player does at the table while it thinks, and what it tells of it."""
