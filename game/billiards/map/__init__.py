"""Every stroke there is at a position: which score, by what way, how surely, and what they leave."""
