"""Where a scene leads from itself: to another level of its own, or to the next round of a cup."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from game.app.scene.in_play import InPlay
from game.app.scene.shelf import Shelf
from game.app.screens.host import Host


class Leads:
    """Goes each way that the scene asks for, once."""

    def __init__(self, host: Host, record: InPlay, shelf: Shelf, open_file: Callable[[Path], object]) -> None:
        self._host, self._record, self._shelf, self._open_file = host, record, shelf, open_file
        self._wanted: Path | None = None  # level that the scene asked for last
        self._rounds = record.stage.scene.round_wanted

    def follow(self) -> bool:
        """Open what is asked for anew. True if this scene is left by that."""
        scene = self._record.stage.scene
        rounds, before_rounds = scene.round_wanted, self._rounds
        self._rounds = rounds
        if rounds > before_rounds and not self._record.borrowed:
            self._host.open_next_round()
            return True
        wanted, before = self._shelf.own_level(scene.level_wanted), self._wanted
        self._wanted = wanted
        if wanted is not None and wanted != before:
            self._open_file(wanted)
        return False
