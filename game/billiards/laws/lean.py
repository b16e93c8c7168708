"""Lean and inner kernels: see game/compiler/decorator.py."""

from game.compiler.decorator import inner_kernel, lean_kernel

__all__ = ["inner_kernel", "lean_kernel"]
