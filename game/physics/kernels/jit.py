"""`kernel` under the name by which programs beside Carom import it."""

from game.compiler.decorator import kernel
from game.compiler.progress import compiling

__all__ = ["compiling", "kernel"]
