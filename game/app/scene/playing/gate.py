"""The gate of a scene in play: what hand, panel, keys and players do comes in by it, each in its turn.

An event that leads to a variant of the step that has not been compiled yet waits until a thread has done so.
What the scene takes longer for than a frame may last is done by a thread as well.
"""

from __future__ import annotations

from collections.abc import Callable

from game.app.scene.in_play import InPlay
from game.app.scene.keeping import presses
from game.app.scene.playing.pointer import ScenePointer
from game.app.screens.host import Host
from game.stage import ParameterError, Pointer, SetParameter, StageEvent


class Gate:
    """What comes in to one scene; the user is told what is refused."""

    def __init__(self, record: InPlay, host: Host, hand: ScenePointer) -> None:
        self._record = record
        self._host = host
        self.touched: Callable[[StageEvent], bool] | None = None  # told of each event; False drops it
        self._hand = hand

    def post(self, event: StageEvent) -> bool:
        """Let an event act when it is its turn; False if it is refused at once."""
        record, taken = self._record, [True]
        if self.touched is not None and not self.touched(event):
            return False
        watching = record.script is not None
        if watching and isinstance(event, Pointer) and event.kind == "move" and not event.button:
            return False  # a hand that only passes over what is watched is none of the recording's
        try:
            event = record.stage.check(event)
        except ParameterError as error:
            self._refuse(error)
            return False
        if watching:
            record.errands.act(self._take_over)
        errands, name = record.errands, event.name if isinstance(event, SetParameter) else ""
        if errands.in_background and record.variants.concerns(event):
            errands.work(lambda: record.variants.prepare([event]))
            name = ""
        if errands.in_background and record.stage.scene.takes_long(event):
            errands.work_inside(lambda: self._let_in_from_thread(event), name)
        else:
            errands.act(lambda: taken.append(self._let_in(event)), name)
        return taken[-1]

    def _take_over(self) -> None:
        """Let the recording that is watched end here, and say so."""
        if self._record.script is None:
            return
        step, key = self._record.take_over(), self._host.keys.label("copy")
        self._host.tell(
            f"The run is yours from step {step} on.",
            f"The rest of the recording is left out; {key} copies the new run.",
        )

    def _let_in_from_thread(self, event: StageEvent) -> Callable[[], object] | None:
        """Let a checked event act, in a thread; what is then to be said, if it is refused."""
        self._record.try_steps()
        try:
            self._record.stage.let_in(event)
        except ParameterError as error:
            refusal = error
            return lambda: self._refuse(refusal)
        return None

    def _let_in(self, event: StageEvent) -> bool:
        """Let a checked event act; False if the scene refuses it."""
        try:
            self._record.stage.let_in(event)
        except ParameterError as error:
            self._refuse(error)
            return False
        return True

    def _refuse(self, error: ValueError, cause: str = "Not taken.") -> None:
        self._host.tell(cause, str(error), "warning")

    def post_hand(self) -> None:
        """Post what the hand has done since."""
        for event in self._hand.take():
            self.post(event)

    def listen(self) -> None:
        """Let the scene's own players have their say."""
        try:
            self._record.stage.listen()
        except ParameterError as error:
            self._refuse(error)

    # -- commands -----------------------------------------------------------------------------------

    def set_defaults(self) -> None:
        """All parameters as the level has them, or as declared."""
        stage = self._record.stage
        given = dict(stage.level.parameters) if stage.level is not None else {}
        for name, parameter in stage.scene.declared_parameters().items():
            value = parameter.check(given.get(name, parameter.default))
            if name not in stage.scene_type.edits and stage.scene.values[name] != value:
                self.post(SetParameter(name, value))

    def pause(self) -> None:
        """Stand still, or go on."""
        self._record.errands.act(self._pause)

    def _pause(self) -> None:
        """Stand still, or go on; a recording that is played goes on or stands as a whole."""
        self._record.stage.play_or_pause(own=not self._record.repeating)

    def step(self) -> None:
        """One step, after what the hand has done before it."""
        self._make(self._step)

    def step_back(self) -> None:
        """One step back."""
        self._make(self._step_back)

    def undo(self) -> None:
        """Stand where the last press of a button came, without it and whatever came later."""
        if self._hand.cancel():
            self.post_hand()
        self._hand.take()
        self._record.errands.act(self._undo)

    def _undo(self) -> None:
        record = self._record
        stage, done = record.stage, presses(record.stage)
        if not stage.scene_type.builds or record.script is not None:
            self._host.tell("Not undone.", "Here one goes back step by step.")
            return
        if not done:
            self._host.tell("Nothing to undo.", "Nothing has been done by hand in the scene since it began.")
            return
        step, events = done[-1]
        if step < stage.first_step:
            self._host.tell("Not undone.", "That is further back than is remembered.")
            return
        stage.return_to(step, events)

    def _make(self, step: Callable[[], Callable[[], object] | None]) -> None:
        """Make a step, which gives what is then to be said; in a thread if it takes long."""
        errands = self._record.errands
        if errands.in_background and self._record.stage.scene.takes_long(None):
            self.post_hand()
            errands.work_inside(step)
        else:
            errands.act(lambda: self._make_now(step))

    def _make_now(self, step: Callable[[], Callable[[], object] | None]) -> None:
        self.post_hand()
        complaint = step()
        if complaint is not None:
            complaint()

    def _step(self) -> None:
        """One step, with what a recording that is watched has at both ends of it."""
        record = self._record
        if record.script is not None:
            record.script.post_due()
        record.stage.step()
        if record.script is not None:
            record.script.post_due()
            if ending := record.ending():
                self._host.tell(ending[0], "", ending[1])

    def _step_back(self) -> Callable[[], object] | None:
        if self._record.stage.step_back():
            return None
        return lambda: self._host.tell("No further back.", "This is the first step that is remembered.")

    def reset(self) -> None:
        """Build the scene again with its present parameters; what the hand was doing is dropped."""
        self._hand.cancel()
        self._hand.take()
        self._record.errands.act(self._reset)

    def _reset(self) -> None:
        self._record.script, self._record.borrowed = None, False
        try:
            self._record.stage.reset()
        except ValueError as error:
            self._refuse(error, "Not reset.")
