"""Machine code kept on disk: one file for each kernel, argument types, processor and closure.

    <cache>/kernels/game.billiards.lecture.table-4f1c.../step_lecture-88-9a0b....py311.code

There is no index and nothing is locked. A file's name says all that its content depends on. It is written
beside its place and then moved there, so a reader finds a whole file or none. Of two processes that compile
the same kernel the later one writes the same again. A checksum is read with the code: a damaged file counts
as none, and is written again. No failure here does more than cost time.

What is read is machine code (and a pickle that says how it is called), so it is run whatever its format: it
is taken only from folders that only this user can change (see game/trust.py), from the root down. Otherwise
kernels are compiled again, and that is said once.

What is not there is looked for in the machine code that came with Carom (see prebuilt.py), for a generic
processor. What comes from there is not written again: a look for code of this very processor finds none, and
compiles it.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
import shutil
import sys
import tempfile
import time
from functools import cache
from pathlib import Path

from game.compiler.prebuilt import no_file
from game.compiler.sources import module_name, source_digest
from game.folders import cache_folder
from game.trust import is_private_file, make_private_folder, reason_to_distrust

SUFFIX = f".py{sys.version_info[0]}{sys.version_info[1]}.code"
STALE_AFTER_S = 7 * 86_400.0  # s; a folder of other sources that another checkout may still use is younger
MAX_BYTES = 512 << 20  # of all folders together
_CHECKSUM = 16  # bytes at the head of a file
_used: dict[Path, None] = {}


def files_used() -> list[Path]:
    """Files of machine code that this process has read from the cache folder or written there, in order."""
    return list(_used)


def code_in(path: Path) -> bytes:
    """The code in a file of the cache folder. ValueError if it is damaged; OSError if it cannot be read."""
    data = _read(path)
    if _checksum(data[_CHECKSUM:]) != data[:_CHECKSUM]:
        raise ValueError(f"{path}: damaged")
    return data[_CHECKSUM:]


def take_code(path: Path) -> bytes | None:
    """The code in a file of the cache folder, for a kernel that will run it; None if it cannot be trusted.

    ValueError if it is damaged; OSError if it is not there or cannot be read.
    """
    if not _is_trusted(path.parent):
        return None
    wrong = no_file(path) if path.exists() else ""
    if wrong:
        _tell_once(f"{path}: {wrong}")
        return None
    code = code_in(path)
    _mark_used(path.parent)
    _used[path] = None
    return code


def keep_code(path: Path, code: bytes) -> None:
    """Write code to a file of the cache folder, unless it cannot be trusted there; OSError if that fails."""
    make_private_folder(path.parent)
    if _is_trusted(path.parent):
        _write(path, _checksum(code) + code)
        _used[path] = None
        remove_old_folders(path.parent)


def code_folder(file: Path) -> Path | None:
    """Folder of the machine code of the kernels that stand in ``file``; None if theirs cannot be kept."""
    try:
        return cache_folder() / "kernels" / f"{module_name(file)}-{source_digest(file)}"
    except (OSError, ValueError):  # not of this package, no readable sources (in a zip file), or just edited
        return None


def can_keep_code() -> bool:
    """Whether there is a place where the code of kernels can be kept, and taken from again."""
    folder = cache_folder() / "kernels"
    try:
        make_private_folder(folder)
        return os.access(folder, os.W_OK) and not reason_to_distrust(folder)
    except OSError:
        return False


def _checksum(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=_CHECKSUM).digest()


@cache
def _is_trusted(folder: Path) -> bool:
    """Once in a process and folder: whether code may be taken from it; OSError if it is not there (yet).

    Once is enough: where only this user can change anything, the answer cannot be changed from outside.
    """
    reason = reason_to_distrust(folder)
    if reason:
        _tell_once(reason)
    return not reason


def _tell_once(reason: str) -> None:
    """Say why kernels are compiled in each process, in one line of a process."""
    global _told
    if not _told:
        _told = True
        logging.getLogger("carom").warning(
            "carom: machine code is not kept, %s (CAROM_CACHE_DIR names another folder)", reason
        )


_told = False


def _read(path: Path) -> bytes:
    """A file's content; OSError for a link, and for a file that another user may have written."""
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    with os.fdopen(os.open(path, flags | getattr(os, "O_BINARY", 0)), "rb") as file:
        if not is_private_file(os.fstat(file.fileno())):
            raise PermissionError(f"{path}: another user may have written it")
        return file.read()


def _write(path: Path, data: bytes) -> None:
    """Write a file whole or not at all."""
    handle, name = tempfile.mkstemp(prefix=".", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


@cache
def _mark_used(folder: Path) -> None:
    """Once in a process: folders are given up by when they were last used."""
    with contextlib.suppress(OSError):
        os.utime(folder)


@cache
def remove_old_folders(current: Path) -> None:
    """Once in a process and folder: remove what is stale, then what is too much, never the current folder.

    Stale is a folder of the same module with other sources that was not used for `STALE_AFTER_S`. The folders
    used longest ago go first until all take less than `MAX_BYTES`.
    """
    with contextlib.suppress(OSError):
        os.utime(current)
        stem = current.name.rpartition("-")[0]
        found = []
        for folder in current.parent.iterdir():
            used = folder.stat().st_mtime
            if folder == current or not folder.is_dir():
                continue
            if folder.name.rpartition("-")[0] == stem and used < time.time() - STALE_AFTER_S:
                shutil.rmtree(folder, ignore_errors=True)
            else:
                found.append((used, folder, _weight(folder)))
        total = _weight(current) + sum(weight for _, _, weight in found)
        for _, folder, weight in sorted(found):
            if total <= MAX_BYTES:
                break
            shutil.rmtree(folder, ignore_errors=True)
            total -= weight


def _weight(folder: Path) -> int:
    """Bytes of the files in a folder; one that vanishes meanwhile counts as far as it was seen."""
    total = 0
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            total += entry.stat().st_size
    return total
