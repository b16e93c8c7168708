"""CPU time of a call, beside a window that draws."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

REPEATS = 3


def least_time(run: Callable[[], object], repeats: int = REPEATS) -> float:
    """Least CPU time of ``run()`` in the calling thread, s, over so many calls after one that is not timed.

    The first call of a kernel compiles it, or reads its machine code from the disk. ValueError without a
    call to time.
    """
    if repeats < 1:
        raise ValueError(f"repeats: must be at least 1, got {repeats!r}")
    run()
    least = math.inf
    for _ in range(repeats):
        begin = time.thread_time()
        run()
        least = min(least, time.thread_time() - begin)
    return least
