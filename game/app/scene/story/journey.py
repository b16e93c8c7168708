"""Going to another moment of a story: back to a state that is remembered, then on by steps, with a bar."""

from __future__ import annotations

from collections.abc import Sequence

from game.app.scene.in_play import InPlay
from game.stage import StageEvent
from game.stage.story.rehearsal import Rehearsal
from game.stage.story.runner import Runner

PART = 16  # steps between two looks how far it is


class Journey:
    """Jumps of one story. ``share``: how far the present one has come, 0 to 1; None if there is none."""

    def __init__(self, runner: Runner, record: InPlay) -> None:
        self._runner = runner
        self._record = record
        self.share: float | None = None

    def to_step(self, step: int) -> None:
        """Stand at a step that was passed; the script goes on from there."""
        self._begin(lambda: self._go(step, None))

    def to_change(self, step: int, events: Sequence[StageEvent]) -> None:
        """Stand at a step that was passed, taken over there, with one thing changed."""

        def go() -> None:
            self._go(step, None)
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
        self.share = 0.0
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
        begun = stage.step_number
        while stage.step_number < step and stage.fault is None and not runner.finished:
            if not stage.run(min(PART, step - stage.step_number)):
                break
            self.share = min((stage.step_number - begun) / max(step - begun, 1), 1.0)
        while film_s is not None and runner.film_s < film_s and not runner.finished:
            if not stage.run(1):
                break


def step_at(runner: Runner, found: Rehearsal | None, film_s: float) -> int:
    """The last step not after a moment of the film, as far as is known of it."""
    paces = found.paces if found is not None else runner.course.paces()
    time_s, at_s, speed = [pace for pace in paces if pace[1] <= film_s][-1]
    return max(int((time_s + (film_s - at_s) * speed) / runner.stage.dt + 1e-9), 0)
