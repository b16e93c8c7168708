"""What is in play on a scene's screen: one record, on which gate, shelf, steps and picture do their work."""

from __future__ import annotations

from collections.abc import Callable

from game.app.scene.errands import Errands
from game.app.scene.variants import Variants
from game.app.stagehand.script import Script
from game.stage import EffectMeter, Recording, Stage
from game.stage.story.runner import Runner

TRIALS = 2  # steps


class InPlay:
    """The stage in play and what belongs to it; all of that changes together.

    ``script``: the recording that is watched, if one is, of ``recorded_steps`` steps. ``borrowed``: the
    session began as a recording, so that nothing in it is won by who sits here. ``untried``: how many steps
    are still to be made before it is known how long a step takes.
    """

    def __init__(self, stage: Stage, recording: Recording | None, in_background: bool) -> None:
        """``in_background``: whether threads may do what takes long."""
        self.errands = Errands(in_background)
        self.runner: Runner | None = None  # of the story that plays
        self.script: Script | None = None
        self.later: list[Callable[[], object]] = []  # to be done when the scene is on top again
        self.show(stage, recording)

    def show(self, stage: Stage, recording: Recording | None = None) -> None:
        """Another stage of the same scene from now on, on which a recording is played if there is one."""
        self.stage = stage
        self.variants = Variants(stage)
        self.meter = EffectMeter(stage)
        end = (recording.steps, recording.digest) if recording is not None else None
        self.script = Script(stage, recording.events, end=end) if recording is not None else None
        self.borrowed = recording is not None
        self.guest = False  # the stroke that was played last came from somebody else
        self.recorded_steps = recording.steps if recording is not None else 0
        self.try_steps()

    @property
    def scripted(self) -> bool:
        """Whether a story is played, so that the scene's own players are not asked."""
        return self.runner is not None and self.runner.playing

    @property
    def repeating(self) -> bool:
        """Whether a recording is being played, which a new event would end."""
        return self.script is not None and not self.script.finished

    def take_over(self) -> int:
        """The recording that is watched ends here, and what its hand held is let go; the present step."""
        self.script = None
        self.stage.let_go()
        return self.stage.step_number

    @property
    def watched(self) -> str:
        """What is seen of a recording, in words; empty where none is watched, and after its end."""
        step = self.stage.step_number
        if self.script is None or step >= self.recorded_steps:
            return ""
        return f"Replay, step {step} of {self.recorded_steps}"

    def ending(self) -> tuple[str, str] | None:
        """How a recording that was watched has ended, in words and kind, once; None while there is no end.

        From then on the scene is the viewer's.
        """
        if self.script is None or self.script.same is None:
            return None
        same, self.script = self.script.same, None
        if same:
            return "The replay came to the recorded digest.", "info"
        return "The replay ended otherwise: its digest is not the recorded one.", "warning"

    def begin_level(self) -> None:
        """The stage has begun with another level: nothing of what was before is gone on with."""
        self.script, self.borrowed = None, False
        self.try_steps()

    def try_steps(self) -> None:
        """Something has changed by which steps may have become slow."""
        self.untried = TRIALS
