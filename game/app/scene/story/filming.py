"""Films of a story, made by a second process while the window goes on."""

from __future__ import annotations

import subprocess
import sys
from datetime import datetime
from pathlib import Path

from game.app.compile.second_process import with_this_game
from game.app.screens.host import Host
from game.app.window.children import start
from game.folders import pictures_folder
from game.stage.script.lines import Story
from game.ui.widgets.list_row import ListRow

LAST_S = 10.0


class Filming:
    """Asks what is to be filmed, has it filmed, and says where the film is."""

    def __init__(self, host: Host, story: Story) -> None:
        self._host = host
        self._story = story
        self.process: subprocess.Popen[str] | None = None
        self._path = Path()

    def ask(self, film_s: float) -> None:
        """Offer the films that there can be at a moment of the story, s of film."""
        if self.process is not None:
            self._host.tell("One film at a time.", f"{self._path.name} is being made.")
            return
        begin_s = max(film_s - LAST_S, 0.0)
        part = ("--from", f"{begin_s:.3f}", "--seconds", f"{max(film_s - begin_s, 0.5):.3f}")
        rows = [
            ListRow("This story", "MP4 with sound, chapters and subtitles", "mp4", value=("mp4", ())),
            ListRow("The last ten seconds", "as the story has them", "mp4", value=("mp4", part)),
            ListRow("The last ten seconds, small", "without sound", "gif", value=("gif", part)),
        ]
        self._host.cards.open_choices("Film", rows, lambda value: self.begin(*value))

    def begin(self, kind: str, part: tuple[str, ...] = ()) -> None:
        """Begin a film; ``kind``: mp4 or gif, ``part``: options of the command ``record``."""
        folder = pictures_folder()
        folder.mkdir(parents=True, exist_ok=True)
        self._path = folder / f"{self._story.scene}-{datetime.now():%Y-%m-%d-%H%M%S}.{kind}"
        path = self._story.level.path
        small = ("--size", "640x360", "--fps", "20") if kind == "gif" else ()
        command = [
            sys.executable, "-m", "game", "record", self._story.scene, "--out", str(self._path),
            "--story", str(path) if path is not None else self._story.name,
            "--theme", self._host.settings.theme, *part, *small,
        ]  # fmt: skip
        quiet, pipe = subprocess.DEVNULL, subprocess.PIPE
        self.process = start(command, env=with_this_game(), stdin=quiet, stdout=quiet, stderr=pipe, text=True)
        self._host.tell("Filming", f"{self._path}")

    def update(self) -> None:
        """Say so when a film is there, or why there is none."""
        process = self.process
        if process is None or process.poll() is None:
            return
        assert process.stderr is not None
        with process.stderr:
            words = process.stderr.read().strip().splitlines()
        self.process = None
        if process.returncode == 0:
            self._host.tell("Film saved", str(self._path))
        else:
            self._host.tell("No film.", words[-1] if words else f"status {process.returncode}", "warning")

    def close(self) -> None:
        """The story is left; what is being made is finished all the same."""
        if self.process is not None and self.process.stderr is not None:
            self.process.stderr.close()
        self.process = None
