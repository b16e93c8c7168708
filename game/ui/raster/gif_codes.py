"""The compression of GIF files: codes of 9 to 12 bits for strings of colours that have been met before.

T. A. Welch, A Technique for High-Performance Data Compression, IEEE Computer 17(6), 1984, as GIF89a has it
(CompuServe 1990): the table is emptied when it is full, and a code for that is written.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel

CLEAR, END, FIRST, MOST_CODES = 256, 257, 258, 4096
_SLOTS = 16384  # of the table of strings, a power of two above MOST_CODES


@lean_kernel
def pack_codes(colors: Any, out: Any, keys: Any, codes: Any) -> int:
    """Write the codes of ``colors`` (n,) uint8 into ``out`` (at least 2 n + 16,) uint8; how many bytes.

    ``keys``, ``codes``: (_SLOTS,) int64, scratch. Nothing is written for no colours.
    """
    if colors.size == 0 or out.size < 2 * colors.size + 16:
        return 0
    keys[:] = -1
    size, free, bits, held, end = 9, FIRST, 0, 0, 0
    held |= CLEAR << bits
    bits += size
    prefix: Any = np.int64(colors[0])
    for i in range(1, colors.size):
        color: Any = np.int64(colors[i])
        key = prefix * 256 + color
        slot = (key * 40503) & (_SLOTS - 1)
        while keys[slot] != key and keys[slot] >= 0:
            slot = (slot + 1) & (_SLOTS - 1)
        if keys[slot] == key:
            prefix = codes[slot]
            continue
        held |= prefix << bits
        bits += size
        if free < MOST_CODES:
            keys[slot], codes[slot] = key, free
            if free == 1 << size and size < 12:
                size += 1
            free += 1
        else:
            held |= CLEAR << bits
            bits += size
            keys[:] = -1
            size, free = 9, FIRST
        prefix = color
        while bits >= 8:
            out[end] = held & 255
            end += 1
            held >>= 8
            bits -= 8
    held |= prefix << bits
    bits += size
    if free == 1 << size and size < 12:
        size += 1
    held |= END << bits
    bits += size
    while bits > 0:
        out[end] = held & 255
        end += 1
        held >>= 8
        bits -= 8
    return end


def packed_codes(colors: NDArray[np.uint8]) -> bytes:
    """The codes of a row of colours, none of them empty."""
    out = np.empty(2 * colors.size + 16, np.uint8)
    keys, codes = np.empty(_SLOTS, np.int64), np.empty(_SLOTS, np.int64)
    return out[: pack_codes(colors, out, keys, codes)].tobytes()
