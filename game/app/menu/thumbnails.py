"""Live pictures for the menu's cards: the scenes themselves, drawn small; the chosen one moves.

Only scenes whose kernels are ready are drawn, so that the menu never waits for the compiler. What was drawn
is kept in the cache folder: the next start shows it at once, before the compiler is even imported.
"""

from __future__ import annotations

import contextlib
import os
import queue
import threading
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from game.app.compile.readiness import any_notes, is_ready
from game.app.screens.host import Host
from game.app.window.guard import Failure
from game.app.window.pictures import write_png
from game.folders import cache_folder
from game.stage.catalogue import Entry
from game.trust import is_private_file, make_private_folder, reason_to_distrust
from game.ui.look.look import Look

if TYPE_CHECKING:
    from game.app.menu.live import LiveScene

Key = tuple[str, str, int, int]  # scene, theme, width, height


class Thumbnails:
    """Pictures by scene; ``update`` once a frame, ``picture`` when one is wanted."""

    def __init__(self, host: Host):
        self._host = host
        self._catalogue = host.catalogue
        self._canvas = host.canvas_warming
        self._pictures: dict[Key, pygame.Surface | None] = {}
        self._live: dict[str, LiveScene] = {}
        self._drawn: set[Key] = set()
        self._made: queue.SimpleQueue[LiveScene] = queue.SimpleQueue()
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None
        self._asked = False

    def picture(self, name: str, size: tuple[int, int], look: Look) -> pygame.Surface | None:
        """The picture of a scene in that size and theme, or None if there is none yet."""
        key = (name, look.theme.name, *size)
        if key not in self._pictures:
            self._pictures[key] = _load(key)
        return self._pictures[key]

    def update(self, elapsed_s: float, sizes: dict[str, tuple[int, int]], look: Look, moving: str) -> bool:
        """Let time pass; ``moving`` is the card that lives. True if pictures of others have changed."""
        with contextlib.suppress(queue.Empty):
            live = self._made.get_nowait()
            self._live[live.entry.name] = live
        if moving in self._live and moving in sizes:
            live = self._live[moving]
            with self._watch(live):
                live.advance(elapsed_s)
                self._draw(live, sizes[moving], look)
        return self._draw_one_more(sizes, look)

    def begin(self) -> None:
        """Start to build the scenes that are ready, if that has not been done yet."""
        busy = self._thread is not None and self._thread.is_alive()
        if not self._asked and not busy and any_notes():
            self._asked = True
            self._thread = threading.Thread(target=self._prepare, name="thumbnails", daemon=True)
            self._thread.start()

    def _draw_one_more(self, sizes: dict[str, tuple[int, int]], look: Look) -> bool:
        """Draw one picture that was not drawn in this size and theme yet."""
        for name, live in list(self._live.items()):
            if name in sizes and (name, look.theme.name, *sizes[name]) not in self._drawn:
                with self._watch(live):
                    self._draw(live, sizes[name], look)
                return True
        return False

    def _draw(self, live: LiveScene, size: tuple[int, int], look: Look) -> None:
        key = (live.entry.name, look.theme.name, *size)
        picture = live.draw(size, look)
        if key not in self._drawn:
            _keep(key, picture)
        self._drawn.add(key)
        self._pictures[key] = picture

    def _watch(self, live: LiveScene) -> AbstractContextManager[None]:
        """Within this a scene is at work; if it raises, its card keeps the drawing that it has."""

        def drop(failure: Failure) -> None:
            del self._live[live.entry.name]
            self._host.tell_of(failure, "cannot be shown")

        return self._host.guard.over(f"The picture of {live.entry.title}", drop)

    def _prepare(self) -> None:
        """Build the scenes that are ready, one after another, and let them come to something worth seeing."""
        while not self._canvas.wait(0.05):
            if self._stop.is_set():
                return
        for entry in self._catalogue:
            if self._stop.is_set():
                return
            if entry.name not in self._live and is_ready(entry):
                live = _build(entry)
                if live is not None:
                    self._made.put(live)

    def wake(self) -> None:
        """The menu is on top again: what was opened meanwhile may be ready now."""
        self._asked = False

    def close(self) -> None:
        """Let the thread end after the scene that it is building."""
        self._stop.set()


def _build(entry: Entry) -> LiveScene | None:
    """A scene for its card, or None if it cannot be built: opening it will say why."""
    from game.app.menu.live import LiveScene

    try:
        return LiveScene(entry)
    except Exception:  # a scene's own code may raise anything; its card then keeps its drawing
        return None


def _path(key: Key) -> Path:
    name, theme, width, height = key
    return cache_folder() / "thumbnails" / f"{name}-{theme}-{width}x{height}.png"


def _load(key: Key) -> pygame.Surface | None:
    """A picture of an earlier session, if it is whole and nobody else can have put it there.

    A decoder of pictures is C code: it is given nothing that another user may have written.
    """
    path = _path(key)
    try:
        if reason_to_distrust(path.parent):
            return None
        with path.open("rb") as file:
            if not is_private_file(os.fstat(file.fileno())):
                return None
            picture = pygame.image.load(file, path.name)
    except (pygame.error, OSError):
        return None
    return picture if picture.get_size() == key[2:] else None


def _keep(key: Key, picture: pygame.Surface) -> None:
    path = _path(key)
    with contextlib.suppress(OSError):
        make_private_folder(path.parent)
        write_png(picture, path)
        path.chmod(0o600)  # else the mask of a group could make it one that is not read again
