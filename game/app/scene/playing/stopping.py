"""A scene that is stopped because something asked of it has raised: its readouts, say, or its picture.

From then on nothing is asked of it, until a step back or a new beginning takes the fault away.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.app.window.guard import Failure, method_of

if TYPE_CHECKING:
    from game.stage import Fault, Stage


class Stopping:
    """Which fault of a stage was raised by a callback, and what is known of it."""

    def __init__(self) -> None:
        self._fault: Fault | None = None
        self._undrawable = False  # it was the picture that failed
        self._details = ""  # where the traceback lies, in words

    def holds(self, stage: Stage) -> bool:
        """Whether the stage stands still because of a callback."""
        return self._fault is not None and stage.fault is self._fault

    def hides(self, stage: Stage) -> bool:
        """Whether not even the picture may be asked for."""
        return self.holds(stage) and self._undrawable

    def trouble(self, stage: Stage) -> str:
        """Why the scene stands still, if something went wrong."""
        if stage.fault is None:
            return ""
        words = f"Stopped: {stage.fault.message}."
        return f"{words} {self._details}".rstrip() if self.holds(stage) else words

    def stop(self, stage: Stage, failure: Failure) -> bool:
        """Stop the scene; False if it is stopped already, and so what fails now is what is round it."""
        callback = method_of(failure.error, stage.scene)
        if self.hides(stage):
            return False
        drawing = callback == "draw" or self.holds(stage)  # nothing but the picture is asked for then
        what = "the picture" if drawing else f"the scene's {callback}" if callback else "the scene"
        self._fault = stage.stop(what, failure.error)
        self._undrawable, self._details = drawing, failure.where
        return True
