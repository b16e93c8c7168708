"""Lean and inner kernels: see game/physics/kernels/lean.py."""

from game.physics.kernels.lean import inner_kernel, lean_kernel

__all__ = ["inner_kernel", "lean_kernel"]
