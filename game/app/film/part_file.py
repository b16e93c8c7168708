"""The file in which a film grows: under a hidden name, which becomes its own when all of it is on disk.

A process that is killed leaves such a file behind. The next film in that folder removes it: a file of that
form that is not locked belongs to a film that is no longer made.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path
from typing import IO

try:
    import fcntl
except ImportError:  # Windows: there an open file cannot be removed, which serves as the lock
    fcntl = None  # type: ignore[assignment]

PREFIX, ENDING = ".carom-film-", ".part"


class PartFile:
    """A new file beside ``path``, with the methods that PyAV asks of a file.

    ``problem`` holds the first error of a write. It is kept, because a packer passes over some of them.
    """

    def __init__(self, path: Path) -> None:
        """Raises OSError if no file can be made there."""
        self.path = path
        self.problem: OSError | None = None
        _remove_left(path.parent)
        handle, name = tempfile.mkstemp(prefix=PREFIX, suffix=ENDING, dir=path.parent)
        self.part = Path(name)
        self._file: IO[bytes] = os.fdopen(handle, "w+b", buffering=0)
        if fcntl is not None:
            with contextlib.suppress(OSError):  # no locks on this file system: nothing is removed there
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)

    def write(self, data: bytes) -> int:
        """Write all bytes; OSError, also if an earlier write failed."""
        if self.problem is not None:
            raise self.problem
        rest = memoryview(data)
        try:
            while rest:
                rest = rest[self._file.write(rest) :]
        except OSError as error:
            self.problem = error
            raise
        return len(data)

    def read(self, size: int = -1) -> bytes:
        """Bytes from the present place."""
        return self._file.read(size)

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        """Go to a place; the new one."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """The present place."""
        return self._file.tell()

    def keep(self) -> None:
        """Bring all to disk and give the file its name. OSError if any write failed; no file is left then."""
        try:
            if self.problem is not None:
                raise self.problem
            os.fsync(self._file.fileno())
            self._file.close()
            self.part.chmod(0o666 & ~_umask())
            self.part.replace(self.path)
        except OSError:
            self.drop()
            raise

    def drop(self) -> None:
        """Leave no file."""
        with contextlib.suppress(OSError):
            self._file.close()
        self.part.unlink(missing_ok=True)


def _remove_left(folder: Path) -> None:
    """Remove what films that were killed have left in a folder."""
    for path in folder.glob(f"{PREFIX}*{ENDING}"):
        with contextlib.suppress(OSError):
            if path.is_file() and not path.is_symlink() and _is_left(path):
                path.unlink()


def _is_left(path: Path) -> bool:
    """Whether no process makes a film in that file; OSError if that cannot be found out."""
    if fcntl is None:
        return True
    with path.open("rb") as file:
        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    return True


def _umask() -> int:
    """The mask for new files; there is no way to read it but to set it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
