"""A game under way, and what was built in a scene, are kept as a level, from which it goes on.

A game goes on after the program was closed, or killed; what was built is kept when its scene is left. A
thread writes games, whole files or none, while the main one goes on drawing; of several states that wait only
the newest is written.
"""

from __future__ import annotations

import contextlib
import threading
from pathlib import Path
from typing import TYPE_CHECKING

from game.app.stagehand.files import present_level
from game.folders import user_folder
from game.levels import Level, save_level
from game.stage.events import Action, Pointer, SetParameter

if TYPE_CHECKING:
    from game.stage import Stage

TITLE, BUILT_TITLE = "Game in progress", "As it was left"


def kept_path(scene_name: str) -> Path:
    """Where the game of a scene is kept."""
    return user_folder() / "levels" / scene_name / "autosave.toml"


def presses(stage: Stage) -> list[tuple[int, int]]:
    """Step, and number of events before it, of each deed of the hand since the scene began: a press of a
    button, an action that edits, a parameter that edits. Values of one parameter in a row are one deed.
    """
    edits, found, before = stage.scene_type.edits, [], ""
    for number, stamped in enumerate(stage.recording.events):
        event = stamped.event
        if isinstance(event, Pointer):
            if event.kind == "down":
                found.append((stamped.step, number))
                before = ""
        elif isinstance(event, SetParameter | Action) and event.name in edits:
            if not (isinstance(event, SetParameter) and event.name == before):
                found.append((stamped.step, number))
            before = event.name if isinstance(event, SetParameter) else ""
    return found


def keep_built(stage: Stage) -> str:
    """Keep what was built by hand since the scene began, if anything was; why it could not be, or ""."""
    if not stage.scene_type.builds or stage.fault is not None or not presses(stage):
        return ""
    try:
        save_level(present_level(stage, BUILT_TITLE), kept_path(stage.scene.name))
    except (ValueError, OSError) as error:
        return str(error)
    return ""


class Keeper:
    """Keeps the game of one scene."""

    def __init__(self, scene_name: str) -> None:
        self.path = kept_path(scene_name)
        self._token: object = None
        self._waiting: Level | None = None
        self._wake = threading.Condition()
        self._closing = False
        self._thread: threading.Thread | None = None

    def update(self, stage: Stage) -> None:
        """Hand over the game as it is, if it has changed since."""
        token = stage.scene.worth_keeping()
        if token is None or token == self._token:
            return
        self._token = token
        with self._wake:
            self._waiting = present_level(stage, TITLE)
            if self._thread is None:
                self._thread = threading.Thread(target=self._write, name="keeper", daemon=True)
                self._thread.start()
            self._wake.notify()

    def close(self) -> None:
        """Write what still waits."""
        with self._wake:
            self._closing = True
            self._wake.notify()
        if self._thread is not None:
            self._thread.join()

    def _write(self) -> None:
        while True:
            with self._wake:
                while self._waiting is None:
                    if self._closing:
                        return
                    self._wake.wait()
                level, self._waiting = self._waiting, None
            with contextlib.suppress(ValueError, OSError):  # a full disk costs the kept game and nothing else
                save_level(level, self.path)
