"""The stepped table: all of the physics in fixed time steps."""
