"""`kernel` under its old name, for modules that have not moved to `game.compiler.decorator` yet."""

from game.compiler.decorator import kernel
from game.compiler.progress import compiling

__all__ = ["compiling", "kernel"]
