"""Many rigid bodies of spheres that collide: contacts, impulses, friction, resting contact."""

from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.smooth_spheres import SmoothSpheres
from game.physics.spheres.spheres import SphereBodies

__all__ = ["CollidingSpheres", "SmoothSpheres", "SphereBodies"]
