"""What accuracy costs for things that burn."""
