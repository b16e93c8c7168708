"""A bar that tells how far a long work is, in one line that is written over; silent without a terminal."""

from __future__ import annotations

import sys
import time

WIDTH = 28


class Progress:
    """``tell(done, total)`` as often as one likes; it writes a few times a second."""

    def __init__(self, words: str) -> None:
        self._words = words
        self._began = time.monotonic()
        self._told = 0.0
        self._shown = sys.stderr.isatty()

    def tell(self, done: int, total: int) -> None:
        """So much is done."""
        now = time.monotonic()
        if not self._shown or (done < total and now - self._told < 0.2):
            return
        self._told = now
        share = done / max(total, 1)
        left = (now - self._began) * (1.0 / share - 1.0) if share > 0.0 else 0.0
        bar = "█" * round(WIDTH * share) + "░" * (WIDTH - round(WIDTH * share))
        line = f"\r{self._words} {bar} {100 * share:3.0f} %  {int(left) // 60}:{int(left) % 60:02d} left"
        print(f"{line:<78}", end="" if done < total else "\n", file=sys.stderr, flush=True)
