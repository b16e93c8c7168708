"""Which scenes open at once: those whose kernels were compiled from the very sources that are here now.

Code for this very processor is in the cache folder; code for a generic one may have come with Carom. A note
in the cache folder says that the former is all there. It is named by a hash of the sources of the scene's
module and of the canvas. Wrong notes are harmless: the scene then compiles when it is opened or drawn.
"""

from __future__ import annotations

import contextlib
from pathlib import Path

from game.compiler.prebuilt import prebuilt, shipped_file
from game.folders import cache_folder
from game.stage.catalogue import Entry


def _note(entry: Entry) -> Path:
    """Where the note of a scene lies; asking for it imports the compiler."""
    from importlib.util import find_spec

    from game.compiler.sources import source_digest

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


def opens_at_once(entry: Entry) -> bool:
    """Whether nothing is left to compile before the scene is seen, be it for a generic processor."""
    if is_ready(entry):
        return True
    shipped = prebuilt()
    return shipped is not None and entry.name in shipped.scenes


def any_code() -> bool:
    """Whether any scene's code may be here: if not, there is no use in importing the compiler."""
    if shipped_file() is not None:
        return True
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
