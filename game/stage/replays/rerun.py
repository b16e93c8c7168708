"""The last part of a session once more, from a kept state on, beside the session that goes on.

Nothing of the session is touched: another scene is built, made what it was then, and goes the same way by the
events that acted since. It comes to the same digest.
"""

from __future__ import annotations

from typing import NamedTuple

from game.stage.events import Stamped
from game.stage.scene import Scene
from game.stage.session import Build, Session
from game.stage.states.snapshots import Snapshot


class Kept(NamedTuple):
    """What a rerun begins with, and where it ends; good for as long as one likes."""

    scene_type: type[Scene]
    build: Build
    snapshot: Snapshot
    events: tuple[Stamped, ...]  # that have acted since, those at its own step included
    first: int  # step from which on it is wanted
    last: int
    digest: str  # at the last step, after its events
    dt: float  # s, of the last step


class Rerun:
    """A second scene on its way from a kept state to the present. ``alpha``: as `Stage.alpha`, to be set.

    Building it may take long; any thread may do it. ValueError for what cannot be built again.
    """

    def __init__(self, kept: Kept) -> None:
        self.kept = kept
        self.scene_type = kept.scene_type
        self.alpha = 0.0
        scene = kept.build(kept.snapshot.values, kept.snapshot.active)
        self._session = Session(scene, kept.build, kept.snapshot.dt, record=False, snapshot_bytes=0)
        self._session.resume(kept.snapshot, kept.events)
        self.advance_to(kept.first)

    @property
    def scene(self) -> Scene:
        """The scene as it was at `step`."""
        return self._session.scene

    @property
    def step(self) -> int:
        """The step at which it stands."""
        return self._session.step

    @property
    def time_s(self) -> float:
        """Simulated time, s."""
        return self._session.time_s

    @property
    def dt(self) -> float:
        """Length of a step now, s."""
        return self._session.dt

    @property
    def failed(self) -> bool:
        """Whether a step failed, which none did the first time."""
        return self._session.fault is not None

    def advance_to(self, step: int) -> None:
        """Make the steps up to that one, no further than to the end."""
        end = min(step, self.kept.last)
        while self._session.step < end and not self.failed:
            self._session.keep_previous()
            self._session.advance()

    @property
    def finished(self) -> bool:
        """Whether it has come to the end."""
        return self.failed or self.step >= self.kept.last

    @property
    def same(self) -> bool:
        """Whether it has come to where the session was."""
        return self.step == self.kept.last and self._session.digest() == self.kept.digest
