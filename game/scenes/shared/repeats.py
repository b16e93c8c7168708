"""A level that is over soon begins again by itself, as long as no person takes part in it."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.stage import Part

Period = Annotated[float, msgspec.Meta(ge=0.0, le=600.0)]  # s; 0: never


class Repeat(Part):
    """Counts the time to the next beginning. period: s, or 0. played: s since the last one."""

    def __init__(self, period: float):
        self.period, self.played = period, 0.0

    @property
    def left(self) -> float | None:
        """Time (s) until it begins again; None if it does not."""
        return self.period - self.played if self.period > 0.0 else None

    def end(self) -> None:
        """Somebody takes part: what comes goes on from there."""
        self.period = 0.0

    def advance(self, dt: float) -> bool:
        """Let a step of dt (s) pass; True if it is to begin again before that step."""
        if not self.period > 0.0:
            return False
        due = self.played > self.period - 0.5 * dt
        self.played = dt if due else self.played + dt
        return due
