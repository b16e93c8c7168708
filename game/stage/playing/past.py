"""What a stage remembers: steps back, an earlier step as it was, and what it takes to go there once more."""

from __future__ import annotations

from game.stage.playing.paced import PacedStage
from game.stage.replays.rerun import Kept


class RememberingStage(PacedStage):
    """Snapshots and events of the session, from the earliest that is remembered on."""

    @property
    def first_step(self) -> int:
        """The earliest step that `step_back` can reach."""
        return self._session.first_step

    @property
    def snapshot_bytes(self) -> int:
        """What the snapshots take now."""
        return self._session.snapshot_bytes

    @property
    def events_acted(self) -> int:
        """How many events have acted since the beginning."""
        return self._session.timeline.acted

    def step_back(self) -> bool:
        """Undo one step and the events since, and pause; False at the first remembered step.

        Steps forward then repeat what was, events included, until a new event takes another way. A fault is
        undone by going back as well.
        """
        self.paused = True
        if not self._session.go_back():
            return False
        self._follow_session()
        self._sampling.go_back(self.step_number)
        return True

    def return_to(self, step: int, events: int | None = None) -> None:
        """Stand at an earlier step as it was, or at the beginning with what it began with; no later event is
        remembered. ``events``: only so many of all have acted then, of those at that step the first ones.

        ValueError unless it is `first_step` or later, or 0.
        """
        session = self._session
        if step and not session.first_step <= step <= session.step:
            raise ValueError(f"step {step}: outside {session.first_step} to {session.step}")
        if step < session.first_step:
            values, active, _ = session.start
            self._begin(self.build_scene(values, active))
            return
        session.return_to(step, events)
        session.keep_previous()
        self._follow_session()
        self.clock.hold()
        self._sampling.go_back(step)

    def kept_from(self, step: int) -> Kept:
        """What it takes to go once more from a step (or the first one that can be) to where it stands."""
        session = self._session
        snapshot, events = session.kept(step)
        first = max(step, snapshot.step)
        return Kept(
            self.scene_type, self.build_scene, snapshot, events, first, session.step, self.digest(), self.dt
        )

    def forget_future(self) -> None:
        """Drop the events that were remembered of later steps."""
        self._session.forget_future()
