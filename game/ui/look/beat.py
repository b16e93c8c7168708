"""When measured numbers change: everywhere in the window in the same picture, four times a second.

A quantity may stand in the bar, the legend, the panel, a chart and the picture of the scene. Numbers that
change in every picture cannot be read, and those that change each in its own time contradict one another.
"""

from __future__ import annotations

import math

BEAT_S = 0.25  # s between changes of the shown numbers


class Beat:
    """Says in which pictures numbers are taken again: ``fresh``."""

    def __init__(self) -> None:
        self.fresh = True
        self._since_s = math.inf
        self._step = 0

    def pass_time(self, dt_s: float, step: int = 0, still: bool = False) -> bool:
        """Let time pass; whether numbers change now.

        At once after a step back, a reset and another level (the ``step`` is a former one), and after each
        step of a scene that stands ``still``.
        """
        self._since_s += dt_s
        jumped = step < self._step or (still and step != self._step)
        self._step = step
        self.fresh = jumped or self._since_s >= BEAT_S
        if self.fresh:
            self._since_s = 0.0
        return self.fresh
