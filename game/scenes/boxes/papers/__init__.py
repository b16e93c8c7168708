"""The pages of the papers that the race shows."""
