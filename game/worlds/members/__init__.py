"""Members of a world: each steps, keeps its state and measures itself."""
