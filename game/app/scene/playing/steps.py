"""The steps of a scene in play: as many as are due in a frame, and what is kept of the scene after them."""

from __future__ import annotations

from game.app.scene.in_play import InPlay
from game.app.scene.keeping import Keeper
from game.app.scene.playing.gate import Gate
from game.app.screens.host import Host
from game.app.stagehand.career_keeper import CareerKeeper
from game.app.stagehand.challenge import ChallengeKeeper
from game.app.stagehand.practice import PracticeKeeper
from game.app.stagehand.stars import StarKeeper
from game.stage import Scene, Stage

METER_BUDGET_S = 0.0004  # s a frame for measuring what effects cost
MOST_STEPS = 15  # in a frame
STEPS_BUDGET_S = 0.05  # s a frame for steps; one that takes longer is made in the background


class Steps:
    """Lets one scene go on. ``seen``: whether the present state has been drawn."""

    def __init__(self, record: InPlay, host: Host, gate: Gate) -> None:
        self._record = record
        self._host = host
        self._gate = gate
        self._stars = StarKeeper()
        self._practice = PracticeKeeper()
        self._career = CareerKeeper()
        self._challenge = ChallengeKeeper()
        keeps = type(record.stage.scene).worth_keeping is not Scene.worth_keeping
        self._keeper = Keeper(record.stage.scene_type.name) if keeps else None
        self.seen = True

    def go_on(self, elapsed_s: float, measuring: bool) -> None:
        """What the hand has done, then the steps; what is won or worth keeping is kept.

        ``measuring``: whether the costs of effects are wanted, whose measuring compiles variants of the step.
        """
        record = self._record
        self._gate.post_hand()
        if record.script is not None:
            record.script.advance(elapsed_s)
            if ending := record.ending():
                self._host.tell(ending[0], "", ending[1])
        else:
            if not record.scripted:
                self._gate.listen()
            if not self._make(elapsed_s):
                return
            if not record.borrowed:
                self._keep(record.stage)
        if measuring and not record.stage.paused:
            record.meter.slice(METER_BUDGET_S)

    def _keep(self, stage: Stage) -> None:
        """What is worth keeping, and what has been won."""
        if self._keeper is not None:
            self._keeper.update(stage)
        if complaint := self._stars.update(stage):
            self._host.tell("Stars.", complaint, "warning")
        answer = self._challenge.update(stage, self._record.guest)
        if answer is not None:
            self._record.guest = False
            self._host.tell(answer.cause, answer.consequence)
            if answer.complaint:
                self._host.tell("Challenge.", answer.complaint, "warning")
        news = self._career.update(stage)
        if news.cause:
            key = self._host.keys.label("career")
            self._host.tell(news.cause, f"{news.consequence} {key}: your career.".strip())
        if news.complaint:
            self._host.tell("Career.", news.complaint, "warning")
        if complaint := self._practice.update(stage):
            self._host.tell("Practice.", complaint, "warning")

    def close(self) -> None:
        """Write what is still to be kept."""
        if self._keeper is not None:
            self._keeper.close()

    def _make(self, elapsed_s: float) -> bool:
        """Make the steps that are due, no more than a frame has time for; False if a thread makes them.

        A thread makes one step at a time, and each is shown, if they take longer than that.
        """
        record, stage = self._record, self._record.stage
        cost_s, slow = stage.last_step_s, False
        if record.errands.in_background and not stage.paused and stage.fault is None:
            stage.clock.max_steps = min(max(int(STEPS_BUDGET_S / max(cost_s, 1e-9)), 1), MOST_STEPS)
            slow = cost_s > STEPS_BUDGET_S or (record.untried > 0 and stage.scene.takes_long(None))
        if not slow:
            self._advance(elapsed_s)
        elif self.seen:
            self.seen = False
            record.errands.work_inside(lambda: self._advance(elapsed_s))
            return False
        return True

    def _advance(self, elapsed_s: float) -> None:
        """Make the steps that are due; any thread may do it."""
        record = self._record
        record.untried = max(record.untried - record.stage.advance(elapsed_s), 0)
