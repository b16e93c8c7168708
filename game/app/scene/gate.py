"""The gate of a scene in play: what hand, panel, keys and players do comes in by it, each in its turn.

An event that leads to a variant of the step that has not been compiled yet waits until a thread has done so.
What the scene takes longer for than a frame may last is done by a thread as well.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from game.stage import ParameterError, SetParameter, StageEvent
from game.stage.validation import checked_event

if TYPE_CHECKING:
    from game.app.scene.play import ScenePlay


class Gate:
    """What comes in to one scene; a refusal is told."""

    def __init__(self, play: ScenePlay) -> None:
        self._play = play

    def post(self, event: StageEvent) -> bool:
        """Let an event act when it is its turn; False if it is refused at once."""
        play, taken = self._play, [True]
        try:
            event = checked_event(event, play.stage.scene_type)
        except ParameterError as error:
            self._refuse(error)
            return False
        errands, name = play.errands, event.name if isinstance(event, SetParameter) else ""
        if errands.behind and play.variants.concerns(event):
            errands.work(lambda: play.variants.prepare([event]))
            name = ""
        if errands.behind and play.stage.scene.takes_long(event):
            errands.work_inside(lambda: self._let_in_behind(event), name)
        else:
            errands.act(lambda: taken.append(self._let_in(event)), name)
        return taken[-1]

    def _let_in_behind(self, event: StageEvent) -> Callable[[], object] | None:
        """Let an event act, in a thread; what is then to be told, if it is refused."""
        self._play.try_steps()
        try:
            self._play.stage.post(event)
        except ParameterError as error:
            refusal = error
            return lambda: self._refuse(refusal)
        return None

    def _let_in(self, event: StageEvent) -> bool:
        try:
            self._play.stage.post(event)
        except ParameterError as error:
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
        except ParameterError as error:
            self._refuse(error)

    def set_defaults(self) -> None:
        """All parameters as the level has them, or as declared."""
        stage = self._play.stage
        given = dict(stage.level.parameters) if stage.level is not None else {}
        for name, parameter in stage.scene.declared_parameters().items():
            value = parameter.check(given.get(name, parameter.default))
            if stage.scene.values[name] != value:
                self.post(SetParameter(name, value))

    def command(self, name: str) -> bool:
        """A command that steps the scene, or lets it stand; False if it is none."""
        errands = self._play.errands
        if name == "pause":
            errands.act(self._pause)
        elif name not in ("step", "step-back"):
            return False
        elif errands.behind and self._play.stage.scene.takes_long(None):
            self.post_hand()
            errands.work_inside(self._stepped if name == "step" else self._stepped_back)
        else:
            errands.act(self._step if name == "step" else self._step_back)
        return True

    def reset(self) -> None:
        """Build the scene anew with its present parameters."""
        try:
            self._play.stage.reset()
        except ValueError as error:
            self._refuse(error, "Not reset.")

    def _pause(self) -> None:
        """Stand still, or go on; a recording that is played goes on or stands as a whole."""
        self._play.stage.play_or_pause(own=not self._play.repeating)

    def _step(self) -> None:
        """One step, after what the hand has done before it."""
        self.post_hand()
        self._stepped()

    def _step_back(self) -> None:
        """One step back."""
        complaint = self._stepped_back()
        if complaint is not None:
            complaint()

    def _stepped(self) -> None:
        """One step; any thread may do it."""
        self._play.stage.step()

    def _stepped_back(self) -> Callable[[], object] | None:
        """One step back; what is to be told if there is none. Any thread may do it."""
        if self._play.stage.step_back():
            return None
        return lambda: self._play.app.tell("No further back.", "This is the first step that is remembered.")
