"""A rigid body of spheres in space (C12)."""
