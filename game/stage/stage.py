"""The stage: plays a scene in real time, lets events in and keeps a recording.

real time -> clock -> steps -> session (states, events, snapshots) -> picture and readouts
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from game.stage.playing.past import RememberingStage


class Stage(RememberingStage):
    """One scene in play. ``cue``: asked before each step, if there is one.

    ``level`` None: the scene's defaults. ``parameters`` and ``seed`` stand in for the level's,
    ``effects_off`` are switched off beside the level's, ``effects`` are exactly those active. ``dt``: s, else
    the scene's own. ``record``: keep all events for a recording. ``snapshot_bytes``: what snapshots may take.
    ``max_steps``: the most steps that one frame makes. ``charts``: take readouts for strip charts on the way.

    Raises ParameterError, LevelError or ValueError for what the scene refuses.
    """

    def advance(self, elapsed_s: float) -> int:
        """Make the steps that a frame of ``elapsed_s`` real seconds asks for; returns how many were made.

        ValueError if ``elapsed_s`` is not a number.
        """
        if math.isnan(elapsed_s):
            raise ValueError("elapsed_s is not a number")
        if self._paused or self._session.fault is not None:
            self.clock.hold()
            return 0
        due = self.clock.advance(elapsed_s * self._speed)
        return self._make(due)

    def run(
        self, steps: int, progress: Callable[[int, int], Any] | None = None, players: bool = False
    ) -> int:
        """Make so many steps as fast as it goes; returns how many were made (fewer after a fault).

        ValueError unless it is a whole number from 0 on.

        ``progress(done, total)`` is called about a hundred times; if it returns False the run stops.
        ``players``: before each step the scene's own players are listened to. Simulated time stands still
        while they think, so that what they do does not depend on the machine.
        """
        if isinstance(steps, bool) or not isinstance(steps, int) or steps < 0:
            raise ValueError(f"steps = {steps!r}: expected a whole number, 0 or more")
        self._sampling.skip_to(self.step_number + steps, self.dt)
        made = 0
        portion = max(1, steps // 100) if progress is not None else steps
        while made < steps:
            asked = min(portion, steps - made)
            done = self._make(asked, players)
            made += done
            if done < asked or (progress is not None and progress(made, steps) is False):
                break
        self._sampling.skip_no_more(self.step_number)
        return made

    def _make(self, steps: int, players: bool = False) -> int:
        """Make steps until one fails; returns how many were made."""
        session = self._session
        if session.fault is not None:
            return 0
        made = 0
        while made < steps:
            if self.cue is not None:
                self.cue.before_step()
                session = self._session
                if session.fault is not None:
                    break
            if players:
                self.listen(at_once=True)
            if made == steps - 1:
                session.keep_previous()
            if not session.advance():
                break
            made += 1
            if session.step >= self._sampling.due:
                self._sample()
            if session.dt != self.clock.dt:
                self.clock.change_dt(session.dt)
        self.clock.steps = session.step
        return made

    def step(self) -> None:
        """One step, and pause."""
        self.paused = True
        self._make(1)

    def listen(self, at_once: bool = False) -> None:
        """Post what the scene's own players have decided, unless a remembered future will say it.

        ``at_once``: wait for those that think, see `Scene.decisions`. ParameterError for what is refused.
        """
        if self._paused or self._session.fault is not None or self._session.repeating:
            return
        for event in self.scene.decisions(at_once):
            self.post(event)
