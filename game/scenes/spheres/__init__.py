"""Spheres that collide by impulses (C13)."""
