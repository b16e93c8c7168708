"""Lean kernels under their old names, for modules that have not moved to `game.compiler.decorator` yet."""

from game.compiler.decorator import inner_kernel, lean_kernel, linked_kernel

__all__ = ["inner_kernel", "lean_kernel", "linked_kernel"]
