"""The menu: all scenes as cards, found by eye, by arrow keys or by typing."""
