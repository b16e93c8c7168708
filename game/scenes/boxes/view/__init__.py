"""How the broad-phase scenes are drawn."""
