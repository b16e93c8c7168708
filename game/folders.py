"""Where Carom finds its data and keeps what it writes.

Data (assets, levels) lies beside the package in a checkout and inside it (``game/data``) when installed.
What is written goes to the user's own folders; ``CAROM_HOME`` puts all of it but the cache under one
folder, ``CAROM_CACHE_DIR`` moves the cache. No folder is made here: who writes makes it.
"""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import platformdirs

PACKAGE = Path(__file__).resolve().parent
DATA_KINDS = ("assets", "levels")


def data_folder(kind: str) -> Path:
    """Folder of the data of that kind, ``"assets"`` or ``"levels"``; ValueError for any other kind.

    FileNotFoundError if an installation lost it.
    """
    if kind not in DATA_KINDS:
        raise ValueError(f"data folder {kind!r}: expected one of {', '.join(DATA_KINDS)}")
    places = (PACKAGE / "data" / kind, PACKAGE.parent / kind)
    for place in places:
        if place.is_dir():
            return place
    raise FileNotFoundError(f"no folder of {kind} at {' or '.join(map(str, places))}")


def user_folder() -> Path:
    """Where settings, recordings and the user's own levels are kept: ``CAROM_HOME`` or the system's place."""
    return _chosen("CAROM_HOME") or _absolute(
        lambda: platformdirs.user_data_dir("carom", appauthor=False), "data"
    )


def pictures_folder() -> Path:
    """Where screenshots go: ``pictures`` in ``CAROM_HOME``, or ``Carom`` in the user's pictures."""
    home = _chosen("CAROM_HOME")
    return home / "pictures" if home else _absolute(platformdirs.user_pictures_dir, "pictures") / "Carom"


def cache_folder() -> Path:
    """What can be made again at any time (machine code, thumbnails).

    ``CAROM_CACHE_DIR`` or the system's place.
    """
    return _chosen("CAROM_CACHE_DIR") or _absolute(
        lambda: platformdirs.user_cache_dir("carom", appauthor=False), "cache"
    )


@contextmanager
def home_at(folder: Path) -> Iterator[None]:
    """Everything that is written, but for the cache, goes to this folder for a while."""
    before = os.environ.get("CAROM_HOME")
    os.environ["CAROM_HOME"] = str(folder)
    try:
        yield
    finally:
        if before is None:
            del os.environ["CAROM_HOME"]
        else:
            os.environ["CAROM_HOME"] = before


def _chosen(variable: str) -> Path | None:
    value = os.environ.get(variable, "")
    return Path(value).absolute() if value else None


def _absolute(ask: Callable[[], str], kind: str) -> Path:
    """The folder the system names; or, for a user without a home, one of the same kind among the temporary
    files.

    Without a home the system's answer begins with "~" or at the folder the program stands in, where nothing
    must be made. Newer versions of platformdirs raise RuntimeError.
    """
    try:
        path = Path(ask())
    except RuntimeError:
        path = Path()
    return path if path.is_absolute() else _temporary_home() / kind


def _temporary_home() -> Path:
    """A folder among the temporary files that is this user's alone.

    The cache holds machine code, so a folder that somebody else made or may write to is not taken: then a
    fresh one is made for this process alone.
    """
    name = f"carom-{os.getuid()}" if hasattr(os, "getuid") else "carom"
    folder = Path(tempfile.gettempdir()) / name
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.lstat()
    except OSError:
        return Path(tempfile.mkdtemp(prefix="carom-"))
    ours = stat.S_ISDIR(found.st_mode) and (not hasattr(os, "getuid") or found.st_uid == os.getuid())
    if ours and (os.name == "nt" or not found.st_mode & 0o022):
        return folder
    return Path(tempfile.mkdtemp(prefix="carom-"))
