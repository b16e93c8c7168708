"""Many spheres that collide by impulses."""
