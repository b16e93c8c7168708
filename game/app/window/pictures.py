"""Pictures of what is shown, in the user's pictures folder."""

from __future__ import annotations

import contextlib
import re
import threading
from collections.abc import Callable
from datetime import datetime
from io import BytesIO
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import NamedTuple

import pygame

from game.files import FileProblem, write_bytes
from game.folders import pictures_folder


class SavedPicture(NamedTuple):
    """A picture or a film that was written, or why it was not (``problem``, else empty)."""

    path: Path
    problem: str
    what: str = "Picture"


class PictureSaver:
    """Writes pictures in threads: packing one takes as long as several frames."""

    def __init__(self) -> None:
        self._done: SimpleQueue[SavedPicture] = SimpleQueue()
        self._threads: list[threading.Thread] = []

    def save(self, surface: pygame.Surface, title: str) -> None:
        """Begin to write what a surface shows now. OSError if there is no folder for it."""
        path = _free_path(title)
        path.touch()  # the name is taken from now on
        arguments = (surface.copy(), path)
        thread = threading.Thread(target=self._write, args=arguments, name="picture", daemon=True)
        self._threads = [*(one for one in self._threads if one.is_alive()), thread]
        thread.start()

    def finish(self, path: Path, work: Callable[[], object]) -> None:
        """Let a thread make a film whole; ``work`` raises OSError or RuntimeError if it cannot."""
        arguments = (path, work)
        thread = threading.Thread(target=self._finish, args=arguments, name=str(path), daemon=True)
        self._threads = [*(one for one in self._threads if one.is_alive()), thread]
        thread.start()

    def at_work(self, path: Path) -> bool:
        """Whether a film of that name is still being made whole."""
        return any(one.name == str(path) and one.is_alive() for one in self._threads)

    def _finish(self, path: Path, work: Callable[[], object]) -> None:
        try:
            work()
        except (OSError, RuntimeError) as error:
            self._done.put(SavedPicture(path, str(error), "Film"))
        else:
            self._done.put(SavedPicture(path, "", "Film"))

    def _write(self, picture: pygame.Surface, path: Path) -> None:
        try:
            write_png(picture, path)
        except OSError as error:
            with contextlib.suppress(OSError):
                path.unlink()
            self._done.put(SavedPicture(path, str(error.strerror or error)))
        else:
            self._done.put(SavedPicture(path, ""))

    def take(self) -> list[SavedPicture]:
        """What has been done since the last call."""
        taken: list[SavedPicture] = []
        with contextlib.suppress(Empty):
            while True:
                taken.append(self._done.get_nowait())
        return taken

    def wait(self) -> None:
        """Wait until all is written."""
        for thread in self._threads:
            thread.join()


def save_picture(surface: pygame.Surface, title: str) -> Path:
    """Write a PNG named by the title and the time; its path. OSError if it cannot be written."""
    path = _free_path(title)
    write_png(surface, path)
    return path


def _free_path(title: str) -> Path:
    """A name that no picture has yet, in a folder that is there. OSError if there is none."""
    folder = pictures_folder()
    folder.mkdir(parents=True, exist_ok=True)
    word = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "carom"
    stamp = datetime.now().strftime("%Y-%m-%d-%H%M%S")
    path = folder / f"carom-{word}-{stamp}.png"
    number = 2
    while path.exists():
        path = folder / f"carom-{word}-{stamp}-{number}.png"
        number += 1
    return path


def write_png(surface: pygame.Surface, path: Path) -> None:
    """Write a PNG to exactly this path, whole or not at all; OSError if it cannot be written."""
    packed = BytesIO()  # the toolkit itself would pass over a full disk
    try:
        pygame.image.save(surface, packed, "png")
        write_bytes(path, packed.getvalue())
    except (pygame.error, FileProblem) as error:
        raise OSError(f"{path}: {error}") from None
