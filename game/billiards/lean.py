"""Lean and inner kernels: see game/physics/lean.py."""

from game.physics.lean import inner_kernel, lean_kernel

__all__ = ["inner_kernel", "lean_kernel"]
