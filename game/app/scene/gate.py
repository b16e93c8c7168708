"""The gate of a scene in play: what hand, panel, keys and players do comes in by it, each in its turn.

An event that leads to a variant of the step that has not been compiled yet waits until a thread has done so.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from game.stage import KnobError, SetKnob, StageEvent

if TYPE_CHECKING:
    from game.app.scene.play import ScenePlay


class Gate:
    """What comes in to one scene; a refusal is told."""

    def __init__(self, play: ScenePlay) -> None:
        self._play = play

    def post(self, event: StageEvent) -> bool:
        """Let an event act when it is its turn; False if it is refused at once."""
        play, taken = self._play, [True]
        if play.errands.behind and play.variants.concerns(event):
            play.errands.work(lambda: self._prepare(event))
        else:
            name = event.name if isinstance(event, SetKnob) else ""
            play.errands.act(lambda: taken.append(self._let_in(event)), name)
        return taken[-1]

    def _prepare(self, event: StageEvent) -> Callable[[], object]:
        """Compile what an event leads to; what is then to be done."""
        self._play.variants.prepare([event])
        return lambda: self._let_in(event)

    def _let_in(self, event: StageEvent) -> bool:
        try:
            self._play.stage.post(event)
        except KnobError as error:
            self._refuse(error)
            return False
        return True

    def _refuse(self, error: ValueError, cause: str = "Not taken.") -> None:
        self._play.app.tell(cause, str(error), "warning")

    def post_hand(self) -> None:
        """Post what the hand has done since."""
        for event in self._play.hand.take():
            self.post(event)

    def listen(self) -> None:
        """Let the scene's own players have their say."""
        try:
            self._play.stage.listen()
        except KnobError as error:
            self._refuse(error)

    def set_defaults(self) -> None:
        """All knobs as the level has them, or as declared."""
        stage = self._play.stage
        given = dict(stage.level.parameters) if stage.level is not None else {}
        for name, knob in stage.scene.knobs().items():
            value = knob.check(given.get(name, knob.default))
            if stage.scene.values[name] != value:
                self.post(SetKnob(name, value))

    def command(self, name: str) -> bool:
        """A command that steps the scene, or lets it stand; False if it is none."""
        act = {"pause": self._pause, "step": self._step, "step-back": self._step_back}.get(name)
        if act is not None:
            self._play.errands.act(act)
        return act is not None

    def reset(self) -> None:
        """Build the scene anew with its present knobs."""
        try:
            self._play.stage.reset()
        except ValueError as error:
            self._refuse(error, "Not reset.")

    def _pause(self) -> None:
        """Stand still, or go on."""
        stage = self._play.stage
        stage.paused = not stage.paused

    def _step(self) -> None:
        """One step, after what the hand has done before it."""
        self.post_hand()
        self._play.stage.step()

    def _step_back(self) -> None:
        """One step back."""
        if not self._play.stage.step_back():
            self._play.app.tell("No further back.", "This is the first step that is remembered.")
