"""Which scenes open at once: those whose kernels were compiled from the very sources that are here now.

A note in the cache folder, named by a hash of the sources of the scene's module and of the canvas, says so.
Wrong notes are harmless: the scene then compiles when it is opened or drawn.
"""

from __future__ import annotations

import contextlib
from pathlib import Path

from game.folders import cache_folder
from game.stage.catalogue import Entry


def _note(entry: Entry) -> Path:
    """Where the note of a scene lies; asking for it imports the compiler."""
    from importlib.util import find_spec

    from game.physics.kernels.jit import source_digest

    digests = []
    for module in (entry.module, "game.ui.canvas.canvas"):
        spec = find_spec(module)
        if spec is None or spec.origin is None:
            raise FileNotFoundError(module)
        digests.append(source_digest(Path(spec.origin)))
    return cache_folder() / "ready" / f"{entry.name}-{'-'.join(digests)}"


def is_ready(entry: Entry) -> bool:
    """Whether the scene's kernels lie compiled in the cache."""
    with contextlib.suppress(OSError, ValueError, ImportError):
        return _note(entry).exists()
    return False


def any_notes() -> bool:
    """Whether any scene was ever compiled here: if not, there is no use in importing the compiler."""
    with contextlib.suppress(OSError):
        return any((cache_folder() / "ready").iterdir())
    return False


def mark_ready(entry: Entry) -> None:
    """Note that all kernels of the scene have been compiled; older notes of it go."""
    with contextlib.suppress(OSError, ValueError, ImportError):
        note = _note(entry)
        note.parent.mkdir(parents=True, exist_ok=True)
        for old in note.parent.glob(f"{entry.name}-*"):
            tail = old.name.removeprefix(f"{entry.name}-")
            if old != note and tail.count("-") == 1:
                old.unlink()
        note.touch()
