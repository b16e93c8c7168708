"""How fast a stage plays, when it stands still, and which moment its picture shows."""

from __future__ import annotations

from game.stage.events import Action
from game.stage.playing.begun import BegunStage

SLOWEST = 1.0 / 16.0
FASTEST = 4.0
NEWEST = 1.0 - 2.0**-53  # alpha that shows the newest state


class PacedStage(BegunStage):
    """Real time goes through a clock that can be slowed down, hurried and held."""

    @property
    def paused(self) -> bool:
        """True while it stands still and shows the newest state."""
        return self._paused

    @paused.setter
    def paused(self, value: bool) -> None:
        if value != self._paused:
            self._paused = value
            self.clock.hold()
            self._session.keep_previous()  # the picture goes on from the state it shows

    @property
    def still(self) -> bool:
        """True while it stands still, or a timeline of the scene's own is paused."""
        return self._paused or self.scene.resting

    def play_or_pause(self, own: bool = True) -> None:
        """Go on if it is `still`, else stand still.

        Of a scene that has a ``play_action`` its own timeline pauses, and steps are made all the same. But it
        does not while remembered events act again, which an action would end, nor if it is not to (``own``).
        """
        own = own and not self._session.repeating and bool(self.scene.play_action)
        rests = own and self.scene.resting
        if self._paused or rests:
            self.resume()
            if rests:
                self.post(Action(self.scene.play_action))
        elif own:
            self.post(Action(self.scene.play_action))
        else:
            self.pause()

    def pause(self) -> None:
        """Stand still."""
        self.paused = True

    def resume(self) -> None:
        """Go on from the state that is shown."""
        self.paused = False

    @property
    def speed(self) -> float:
        """Simulated seconds for each real one, 1/16 to 4; ValueError for anything else."""
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        if not SLOWEST <= value <= FASTEST:
            raise ValueError(f"speed = {value!r}: outside 1/16 to 4")
        self._speed = float(value)

    @property
    def alpha(self) -> float:
        """How far the picture is between the last two states; the newest one when it stands still."""
        return NEWEST if self._paused or self._session.fault is not None else self.clock.alpha

    @property
    def dropped_s(self) -> float:
        """Real time that was dropped because the steps took too long, s."""
        return self.clock.dropped_s
