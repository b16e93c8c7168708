"""How snooker is drawn."""
