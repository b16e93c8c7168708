"""Whether kernels take Carom's own compilation target, or plain ``numba.njit``.

The target stands on inner parts of numba, which change without notice. It is used with the versions that it
was tried with. With others kernels are plain ones: they take twice as long to compile, are not kept on disk,
and give the same numbers. ``CAROM_PLAIN_NUMBA=1`` asks for that with any version.
"""

from __future__ import annotations

import os
from functools import cache

import numba

TRIED = ((0, 68),)  # versions of numba (major, minor) that all tests were run with
VARIABLE = "CAROM_PLAIN_NUMBA"


def fits(version: str) -> bool:
    """Whether the target was tried with a version of numba, such as ``0.68.1``; not with one under way."""
    parts = version.split(".")
    numbers = [int(part) if part.isdecimal() else -1 for part in parts]
    return len(numbers) >= 2 and tuple(numbers[:2]) in TRIED and -1 not in numbers


@cache
def is_plain() -> bool:
    """Whether kernels of this process are plain ones; decided once."""
    return os.environ.get(VARIABLE, "0") not in ("", "0") or not fits(numba.__version__)
