"""What a stage in play is made of: how it begins, its pace, and its past."""
