"""A stroke that is handed to the other player as a text, and one of theirs that is taken."""

from __future__ import annotations

from collections.abc import Callable

from game.app.scene.in_play import InPlay
from game.app.screens.host import Host
from game.app.stagehand.challenge import best_of, day_of
from game.app.window import clipboard
from game.stage import StageEvent


class Passing:
    """Of one scene in play. post: lets an event act."""

    def __init__(self, host: Host, record: InPlay, post: Callable[[StageEvent], bool]) -> None:
        self._host = host
        self._record = record
        self._post = post

    def give(self) -> None:
        """Put the last stroke into the clipboard, for the other player to go on with."""
        stage = self._record.stage
        best = best_of(day_of(stage))
        try:
            text = best.text if best is not None else stage.scene.given_text()
        except ValueError as error:
            self._host.tell("Not copied.", str(error), "warning")
            return
        where = clipboard.put_or_keep(text)
        self._host.tell("The stroke is copied for the other player.", where or f"{len(text)} letters.")

    def take(self) -> None:
        """Play the stroke of the other player whose text lies in the clipboard; a run is watched."""
        try:
            decisions = self._record.stage.scene.take_text(clipboard.get())
        except ValueError as error:
            self._host.tell("Not played.", str(error), "warning")
            return
        if decisions is None:
            self._host.open_clipboard()
            return
        self._record.guest = True
        for decision in decisions:
            self._post(decision)
        self._host.tell("The stroke comes to the same end here.", "It is played.")
