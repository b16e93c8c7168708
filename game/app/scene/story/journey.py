"""Going to another moment of a story: back to a state that is remembered, then on by steps.

On the way a picture is shown every tenth of a second.
"""

from __future__ import annotations

import time
from collections.abc import Sequence

from game.app.scene.in_play import InPlay
from game.stage import StageEvent
from game.stage.story.rehearsal import Rehearsal
from game.stage.story.runner import Runner

PART = 4  # steps between two looks how far it is
PICTURE_EVERY_S = 0.1  # of the clock on the wall


class Journey:
    """Jumps of one story. ``share``: how far the present one has come, 0 to 1; None if there is none."""

    def __init__(self, runner: Runner, record: InPlay) -> None:
        self._runner = runner
        self._record = record
        self.share: float | None = None
        self._stopped = False

    def stop(self) -> bool:
        """Stay where the present jump has come to; False if there is none."""
        self._stopped = self.share is not None
        return self._stopped

    def to_step(self, step: int) -> None:
        """Stand at a step that was passed; the script goes on from there."""
        self._begin(lambda: self._go(step, None))

    def to_change(self, step: int, events: Sequence[StageEvent]) -> None:
        """Stand at a step that was passed, taken over there, with one thing changed."""

        def go() -> None:
            self._go(step, None)
            if self._stopped:
                return
            self._runner.take_over()
            for event in events:
                self._record.stage.post(event)

        self._begin(go)

    def to_film(self, film_s: float, found: Rehearsal | None) -> None:
        """Stand at a moment of the film, s; ``found``: what is known of all of it."""
        step = step_at(self._runner, found, film_s)
        self._begin(lambda: self._go(step, film_s))

    def _begin(self, go: object) -> None:
        if self.share is not None:
            return
        self.share, self._stopped = 0.0, False
        self._record.errands.work_inside(go)  # type: ignore[arg-type]

    def _go(self, step: int, film_s: float | None) -> None:
        """Go back if need be, then on; a thread does this."""
        runner, stage = self._runner, self._record.stage
        try:
            known = stage.step_number if runner.stopped_at is None else runner.stopped_at
            if step < stage.step_number or runner.stopped_at is not None:
                runner.return_to(min(step, known))
            self._run(step, film_s)
        finally:
            self.share = None

    def _run(self, step: int, film_s: float | None) -> None:
        runner, stage = self._runner, self._record.stage
        begun, shown_s = stage.step_number, time.perf_counter()
        while not self._stopped and stage.fault is None and not runner.finished:
            if stage.step_number < step:
                steps = min(PART, step - stage.step_number)
            elif film_s is not None and runner.film_s < film_s:
                steps = 1
            else:
                return
            if not stage.run(steps):
                return
            self.share = min((stage.step_number - begun) / max(step - begun, 1), 1.0)
            if time.perf_counter() - shown_s >= PICTURE_EVERY_S:
                self._record.errands.rest()
                shown_s = time.perf_counter()


def step_at(runner: Runner, found: Rehearsal | None, film_s: float) -> int:
    """The last step not after a moment of the film, as far as is known of it."""
    paces = found.paces if found is not None else runner.course.paces()
    time_s, at_s, speed = [pace for pace in paces if pace[1] <= film_s][-1]
    return max(int((time_s + (film_s - at_s) * speed) / runner.stage.dt + 1e-9), 0)
