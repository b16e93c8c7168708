"""A fountain of particles over stones (C04)."""
