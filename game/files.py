"""Reading a file that may be anything, and writing one so that the old is never lost."""

from __future__ import annotations

import contextlib
import os
import stat
import tempfile
from pathlib import Path

MOST_BROKEN = 99  # files put aside; then the last one is written over


class FileProblem(ValueError):  # noqa: N818  a problem to be told, whatever caused it
    """A file that cannot be read or written; the message is the bare reason, in a few words."""


def read_text(path: Path, limit: int) -> str:
    """Text of a regular file of at most ``limit`` bytes.

    Raises FileProblem for what is missing, not a regular file, too long, empty or not UTF-8. Links are
    followed; a pipe or device is never waited for.
    """
    try:
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
        with os.fdopen(handle, "rb") as file:
            if not stat.S_ISREG(os.fstat(handle).st_mode):
                raise FileProblem("not a regular file")
            data = file.read(limit + 1)
    except OSError as error:
        raise FileProblem(_reason(error)) from None
    except ValueError as error:
        raise error if isinstance(error, FileProblem) else FileProblem("not a file name") from None
    if len(data) > limit:
        raise FileProblem(f"longer than {limit} bytes")
    if not data.strip():
        raise FileProblem("empty")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FileProblem(f"not UTF-8 text (byte {error.start})") from None


def write_text(path: Path, text: str) -> None:
    """Write a file whole or not at all: into a new one beside it, flushed to disk, then put in its place.

    Folders on the way are made. Raises FileProblem; the old file, if any, is then as it was. A link or
    anything else that is not a regular file is left alone.
    """
    write_bytes(path, text.encode("utf-8"))


def save_text(path: Path, text: str) -> None:
    """As `write_text`, but OSError says why it could not be written."""
    try:
        write_text(path, text)
    except FileProblem as problem:
        raise OSError(f"{path}: {problem}") from None


def write_bytes(path: Path, data: bytes) -> None:
    """As `write_text`, for what is no text."""
    try:
        if path.is_symlink():
            raise FileProblem("a symbolic link; not written over")
        if path.exists() and not path.is_file():
            raise FileProblem("there is something of that name that is not a regular file")
        if path.parent.exists() and not path.parent.is_dir():
            raise FileProblem("its folder is not a directory")
        path.parent.mkdir(parents=True, exist_ok=True)
        _replace(path, data)
    except OSError as error:
        raise FileProblem(_reason(error)) from None
    except ValueError as error:
        raise error if isinstance(error, FileProblem) else FileProblem("not a file name") from None


def _replace(path: Path, data: bytes) -> None:
    """Put a new file holding ``data`` in the place of ``path``; OSError if that fails anywhere on the way."""
    handle, name = tempfile.mkstemp(prefix=".", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        Path(name).chmod(stat.S_IMODE(path.stat().st_mode) if path.exists() else 0o666 & ~_umask())
        Path(name).replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            Path(name).unlink()
        raise
    _flush_folder(path.parent)


def _umask() -> int:
    """The mask for new files; there is no way to read it but to set it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def _flush_folder(folder: Path) -> None:
    """Bring the new name to disk as well, where folders can be opened (not on Windows)."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def put_aside(path: Path) -> str:
    """Rename a broken file, not onto an earlier one, so that nothing in it is lost; words that say so."""
    names = [
        path.with_name(f"{path.stem}.broken{number}{path.suffix}")
        for number in ("", *range(2, MOST_BROKEN + 1))
    ]
    aside = next((name for name in names if not name.exists()), names[-1])
    with contextlib.suppress(OSError):
        path.replace(aside)
        return f"; the file is kept as {aside.name}"
    return ""


def _reason(error: OSError) -> str:
    return (error.strerror or type(error).__name__).lower()
