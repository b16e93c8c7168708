"""The largest of the sizes of many numbers, found on their bits.

Of numbers without a sign the order is that of their bits. The largest of integers is found in vector
instructions, which the compiler may not do with floats for the sake of nan.
"""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.kernels.elementary.words import from_bits

MAGNITUDE = 0x7FFF_FFFF_FFFF_FFFF  # all bits of a number but its sign

__all__ = ["from_bits", "largest"]


@inner_kernel
def largest(row, most):
    """The larger of most and the bits of the largest of |row|, contiguous float64; nan is larger than all.

    Begin with most = 0; `from_bits` makes a number of it.
    """
    words = row.view(np.int64)
    for i in range(words.size):
        word = words[i] & MAGNITUDE
        most = word if word > most else most
    return most
