"""Kernels that neither allocate nor count references.

numba counts the references to every array that a compiled function gets, by an atomic addition when it
enters and another when it leaves: 100 to 200 clock cycles for each call with ten arrays. The exact table
makes about ten calls an event, so that this cost a fifth of its time, and code that counts takes longer to
compile. Such a kernel must not create arrays; views of given ones are fine.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from game.physics.jit import kernel


def lean_kernel(function: Any = None, **options: Any) -> Any:
    """`kernel`, without numba's run-time for memory. Use bare, or with numba's options."""
    if function is None:
        return partial(lean_kernel, **options)
    return kernel(_nrt=False, **options)(function)
