"""Players without a hand: computer players, and the table that plays by itself."""
