"""Calls of kernels with many arrays, without finding out the types of all of them each time.

numba looks at every array of every NamedTuple before it enters a kernel, to choose among the machine code
that there is: with a hundred of them 15 to 20 us a call, while to unpack them takes one. Where the types
cannot change, as in a world that makes all of its arrays itself, they are looked at once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import config

from game.compiler.tried import is_plain


class Entrances:
    """Machine code of kernels, for arguments of the types that they had when each was first called.

    It takes any argument for what it was made for: `forget` it where types may have become others.
    """

    def __init__(self) -> None:
        self._known: dict[Any, Callable[..., Any]] = {}

    def call(self, kernel: Any, *arguments: Any) -> Any:
        """What the kernel returns for these arguments."""
        enter = self._known.get(kernel)
        if enter is None:
            enter = self._known[kernel] = _entrance(kernel, arguments)
        return enter(*arguments)

    def forget(self) -> None:
        """Look at types anew in the next call of each kernel."""
        self._known.clear()


def _entrance(kernel: Any, arguments: tuple[Any, ...]) -> Callable[..., Any]:
    if config.DISABLE_JIT or is_plain() or not hasattr(kernel, "typeof_pyval"):
        return kernel
    return kernel.compile(tuple(kernel.typeof_pyval(argument) for argument in arguments))
