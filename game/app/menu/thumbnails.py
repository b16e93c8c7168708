"""Live pictures for the menu's cards: the scenes themselves, drawn small; the chosen one moves.

Only scenes that are in view and whose kernels are ready are built and drawn, one after another. So the menu
waits neither for the compiler nor for scenes out of sight. What was drawn is kept in the cache folder: the
next start shows it at once, before the compiler is even imported.
"""

from __future__ import annotations

import contextlib
import os
import queue
import threading
from collections import OrderedDict
from collections.abc import Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from game.app.compile.readiness import any_code, opens_at_once
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
Place = tuple[str, tuple[int, int]]  # scene, and size of its card's picture
MOST_LIVE = 24  # scenes kept built: those in view, and some that were
MOST_PIXELS = 24_000_000  # of pictures kept, about 96 MB: two hundred at the largest scale


class Thumbnails:
    """Pictures by scene; ``update`` once a frame with what is seen, ``kept`` or ``load`` for one picture."""

    def __init__(self, host: Host):
        self._host = host
        self._catalogue = host.catalogue
        self._canvas = host.canvas_warming
        self._pictures: OrderedDict[Key, pygame.Surface] = OrderedDict()
        self._live: dict[str, LiveScene] = {}
        self._drawn: set[Key] = set()
        self._made: queue.SimpleQueue[LiveScene | str] = queue.SimpleQueue()
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None
        self._seen: tuple[Place, ...] = ()
        self._moving: Place | None = None
        self._refused: set[str] = set()  # not ready, or cannot be built

    def kept(self, name: str, size: tuple[int, int], look: Look) -> pygame.Surface | None:
        """The picture of a scene in that size and theme, if there is one in memory."""
        return self._pictures.get((name, look.theme.name, *size))

    def load(self, name: str, size: tuple[int, int], look: Look) -> pygame.Surface | None:
        """The same, from the cache folder if there is one of an earlier session."""
        key = (name, look.theme.name, *size)
        picture = self._pictures.get(key) or _load(key)
        if picture is not None:
            self._keep(key, picture)
        return picture

    def update(self, elapsed_s: float, seen: Sequence[Place], look: Look, moving: Place | None) -> bool:
        """Let time pass; ``seen`` are the cards in view, ``moving`` is the one that lives.

        True if pictures of others have changed.
        """
        self._seen, self._moving = tuple(seen), moving
        self._take()
        if moving is not None and moving[0] in self._live:
            live = self._live[moving[0]]
            with self._watch(live):
                live.advance(elapsed_s)
                self._draw(live, moving[1], look)
        return self._draw_one_more(seen, look)

    def _take(self) -> None:
        """Take in what the thread has built; let go of what was seen longest ago."""
        with contextlib.suppress(queue.Empty):
            made = self._made.get_nowait()
            if isinstance(made, str):
                self._refused.add(made)
                return
            self._live[made.entry.name] = made
        names = {name for name, _ in self._seen}
        unseen = [name for name in self._live if name not in names]
        for name in unseen[: max(0, len(self._live) - MOST_LIVE)]:
            del self._live[name]

    def begin(self, look: Look) -> None:
        """Build the next scene in view that has no picture of this session, or is to move."""
        if (self._thread is not None and self._thread.is_alive()) or not self._made.empty():
            return
        name = self._next(look)
        if name and any_code():
            entry = self._catalogue[name]
            self._thread = threading.Thread(
                target=self._build_next, args=(entry,), name="thumbnails", daemon=True
            )
            self._thread.start()

    def _next(self, look: Look) -> str:
        first = () if self._moving is None else (self._moving,)
        for name, size in (*first, *self._seen):
            wanted = (name, size) == self._moving or (name, look.theme.name, *size) not in self._drawn
            if wanted and name not in self._live and name not in self._refused:
                return name
        return ""

    def _draw_one_more(self, seen: Sequence[Place], look: Look) -> bool:
        """Draw one picture that was not drawn in this size and theme yet."""
        for name, size in seen:
            live = self._live.get(name)
            if live is not None and (name, look.theme.name, *size) not in self._drawn:
                with self._watch(live):
                    self._draw(live, size, look)
                return True
        return False

    def _draw(self, live: LiveScene, size: tuple[int, int], look: Look) -> None:
        key = (live.entry.name, look.theme.name, *size)
        picture = live.draw(size, look)
        if key not in self._drawn:
            _write(key, picture)
        self._drawn.add(key)
        self._keep(key, picture)

    def _keep(self, key: Key, picture: pygame.Surface) -> None:
        """In memory; those asked for longest ago go first."""
        self._pictures[key] = picture
        self._pictures.move_to_end(key)
        pixels = sum(one.get_width() * one.get_height() for one in self._pictures.values())
        while pixels > MOST_PIXELS and len(self._pictures) > 1:
            gone, old = self._pictures.popitem(last=False)
            pixels -= old.get_width() * old.get_height()
            self._drawn.discard(gone)

    def _watch(self, live: LiveScene) -> AbstractContextManager[None]:
        """Within this a scene is at work; if it raises, its card keeps the drawing that it has."""

        def drop(failure: Failure) -> None:
            del self._live[live.entry.name]
            self._refused.add(live.entry.name)
            self._host.tell_of(failure, "cannot be shown")

        return self._host.guard.over(f"The picture of {live.entry.title}", drop)

    def _build_next(self, entry: Entry) -> None:
        """Build a scene, if it is ready, and let it come to something worth seeing."""
        while not self._canvas.wait(0.05):
            if self._stop.is_set():
                return
        live = _build(entry) if opens_at_once(entry) else None
        if not self._stop.is_set():
            self._made.put(entry.name if live is None else live)

    def wake(self) -> None:
        """The menu is on top again: what was opened meanwhile may be ready now."""
        self._refused.clear()

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
    """A picture of an earlier session, if it is whole and only this user can have put it there.

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


def _write(key: Key, picture: pygame.Surface) -> None:
    path = _path(key)
    with contextlib.suppress(OSError):
        make_private_folder(path.parent)
        write_png(picture, path)
        path.chmod(0o600)  # else the mask of a group could make it one that is not read again
