"""Events posted at the very steps that they are stamped with: a demo, or a recording that is watched."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from game.stage import Scene, Stage, Stamped

AFTER_DEMO_S = 8.0  # s that a demo goes on after its last event
WITHOUT_DEMO_S = 12.0  # s that a scene without events of its own is shown


def demo_of(scene_type: type[Scene]) -> Sequence[Stamped]:
    """The events by which a scene shows itself, if it declares some as ``demo``."""
    return tuple(getattr(scene_type, "demo", ()))


def demo_steps(scene_type: type[Scene], dt: float) -> int:
    """How long a demo is worth watching, steps."""
    events = demo_of(scene_type)
    if not events:
        return round(WITHOUT_DEMO_S / dt)
    return events[-1].step + round(AFTER_DEMO_S / dt)


class Script:
    """Plays events into a stage. Steps are never anticipated: an event acts exactly at its stamp.

    ``players``: the scene's own players have their say before each step, see `Stage.run`.
    """

    def __init__(
        self,
        stage: Stage,
        events: Sequence[Stamped],
        players: bool = False,
        end: tuple[int, str] | None = None,
    ):
        """``end``: step and digest that are to be come to, if that is known."""
        self.stage = stage
        self.same: bool | None = None  # whether it came to that digest; None: that step has not come
        self._end = end
        self._players = players
        self._events = events
        self._next = 0

    @property
    def finished(self) -> bool:
        """Whether all events have been posted."""
        return self._next >= len(self._events)

    def advance(self, elapsed_s: float) -> int:
        """Like ``Stage.advance``, in slices of at most one step; the steps made."""
        stage = self.stage
        if stage.paused or stage.fault is not None:
            return stage.advance(elapsed_s)
        step_s = stage.dt / stage.speed
        left = min(max(elapsed_s, 0.0), stage.clock.max_steps * step_s)
        made = 0
        while left > 0.0:
            self.post_due()
            if self._players:
                stage.listen(at_once=True)
            part = min(left, 0.9 * step_s)
            made += stage.advance(part)
            left -= part
        self.post_due()
        return made

    def run(self, steps: int) -> None:
        """So many steps as fast as they go."""
        end = self.stage.step_number + steps
        while self.stage.step_number < end and self.stage.fault is None:
            self.post_due()
            upto = end if self.finished else min(end, self._events[self._next].step)
            self.stage.run(max(1, upto - self.stage.step_number), players=self._players)

    def post_due(self) -> None:
        """Post what is stamped with the present step; what lies behind is passed over."""
        while not self.finished and self._events[self._next].step <= self.stage.step_number:
            stamped = self._events[self._next]
            self._next += 1
            if stamped.step == self.stage.step_number:
                self.stage.post(stamped.event)
        if self._end is not None and self._end[0] == self.stage.step_number:
            self.same = self.stage.digest() == self._end[1]
