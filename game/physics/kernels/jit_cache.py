"""Machine code kept on disk: one file for each kernel, argument types, processor and closure.

    <cache>/kernels/game.billiards.lecture.table-4f1c.../step_lecture-88-9a0b....py311.code

There is no index and nothing is locked. A file's name says all that its content depends on; it is written
beside its place and then moved there, so whoever reads finds a whole file or none, and of two processes
that compile the same kernel the later one writes the same again. A checksum is read with the code: a
damaged file counts as none, and is written again. No failure here does more than cost time.

What is read is machine code (and a pickle that says how it is called), so it is run whatever its format:
it is taken only from folders that nobody but this user can change (see game/trust.py), from the root down.
Otherwise kernels are compiled again, and that is said once.

What is not there is looked for in the machine code that came with Carom (see prebuilt.py), for a generic
processor. What comes from there is not written again: whoever looks for code of this very processor finds
none, and compiles it.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
import pickle
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import CodeType
from typing import Any

from numba.core.caching import NullCache
from numba.core.serialize import dumps

from game.folders import cache_folder
from game.physics.kernels.linking import kept_form, rebuilt
from game.physics.kernels.prebuilt import GENERIC, platform_name, prebuilt
from game.trust import is_private_file, make_private_folder, reason_to_distrust

SUFFIX = f".py{sys.version_info[0]}{sys.version_info[1]}.code"
STALE_AFTER_S = 7 * 86_400.0  # s; a folder of other sources that another checkout may still use is younger
MAX_BYTES = 512 << 20  # of all folders together
_CHECKSUM = 16  # bytes at the head of a file
BEFORE_LOADING: list[Callable[[str], None]] = []  # what makes a symbol known that machine code refers to
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


def can_keep_code() -> bool:
    """Whether there is a place where the code of kernels can be kept, and taken from again."""
    folder = cache_folder() / "kernels"
    try:
        make_private_folder(folder)
        return os.access(folder, os.W_OK) and not reason_to_distrust(folder)
    except OSError:
        return False


class KernelCache(NullCache):
    """Where a dispatcher of numba finds and keeps the machine code of one function.

    ``folder`` belongs to the function's module and sources; ``options``: what it was declared with.
    """

    def __init__(self, function: Callable[..., Any], folder: Path, options: str):
        code = function.__code__
        self._folder = folder
        self._stem = f"{re.sub(r'[^0-9A-Za-z_.]', '', function.__qualname__)}-{code.co_firstlineno}"
        cells = [
            (type(cell.cell_contents).__name__, cell.cell_contents) for cell in function.__closure__ or ()
        ]
        defaults = function.__defaults__, function.__kwdefaults__
        self._function_key = f"{_describe_code(code)}|{cells!r}|{defaults!r}|{options}"

    @property
    def cache_path(self) -> str:
        return str(self._folder)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The compiled function for these types, or None if there is none that can be used."""
        for read in (self._read_kept, self._read_prebuilt):
            try:
                data = read(sig, target_context.codegen())
                if data is not None:
                    symbols, kept = pickle.loads(data)
                    for symbol in symbols:
                        for prepare in BEFORE_LOADING:
                            prepare(symbol)
                    target_context.refresh()
                    return rebuilt(target_context, kept)
            except Exception:  # missing, unreadable, written by who knows what: compiling mends it
                continue
        return None

    def _read_kept(self, sig: Any, codegen: Any) -> bytes | None:
        """What an earlier process has compiled here for this processor."""
        path = self._path(sig, codegen.magic_tuple()[1:])
        if path is None or not _is_trusted(self._folder):
            return None
        code = code_in(path)
        _mark_used(self._folder)
        _used[path] = None
        return code

    def _read_prebuilt(self, sig: Any, codegen: Any) -> bytes | None:
        """What came with Carom, for any processor of this platform."""
        path, shipped = self._path(sig, GENERIC), prebuilt()
        return None if path is None or shipped is None else shipped.take(f"{path.parent.name}/{path.name}")

    def save_overload(self, sig: Any, cres: Any) -> None:
        """Keep a compiled function, if it can be kept and there is a place."""
        with contextlib.suppress(Exception):
            path = self._path(sig, cres.codegen.magic_tuple()[1:])
            if path is None or cres.lifted or cres.library.has_dynamic_globals:
                return
            make_private_folder(self._folder)
            if not _is_trusted(self._folder):
                return
            data = dumps(kept_form(cres))
            _write(path, _checksum(data) + data)
            _used[path] = None
            remove_old_folders(self._folder)

    def _path(self, sig: Any, processor: tuple[str, str]) -> Path | None:
        """File for these types on a processor (name, features); None if types have no lasting name."""
        types = sig if isinstance(sig, tuple) else (sig.return_type, *sig.args)
        described = "; ".join(_describe(item) for item in types)
        if " at 0x" in described or " at 0x" in self._function_key:
            return None
        key = f"{described}|{platform_name()}|{processor!r}|{self._function_key}"
        digest = hashlib.blake2b(key.encode(), digest_size=10).hexdigest()
        return self._folder / f"{self._stem}-{digest}{SUFFIX}"


def _describe_code(code: CodeType) -> str:
    """A function's code in words, whatever file it stands in; two on one line may differ by a constant."""
    return f"{code.co_code.hex()} {code.co_names!r} {[_describe_constant(item) for item in code.co_consts]!r}"


def _describe_constant(value: Any) -> str:
    if isinstance(value, CodeType):
        return _describe_code(value)
    return repr(sorted(map(repr, value))) if isinstance(value, frozenset) else repr(value)


def _describe(type_: Any) -> str:
    """A type in words that differ when the types differ, also for two NamedTuples of one name."""
    words = repr(type_)
    owner = getattr(type_, "instance_class", None)
    if owner is not None:
        words += f"<{owner.__module__}.{owner.__qualname__}{getattr(owner, '_fields', '')}>"
    inner = getattr(type_, "types", None)
    if isinstance(inner, tuple):
        words += "(" + ", ".join(_describe(item) for item in inner) + ")"
    return words


def _checksum(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=_CHECKSUM).digest()


@cache
def _is_trusted(folder: Path) -> bool:
    """Once in a process and folder: whether code may be taken from it; OSError if it is not there (yet).

    Once is enough: where only this user can change anything, nobody else can change the answer.
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

    Stale is a folder of the same module with other sources that was not used for `STALE_AFTER_S`; the
    folders used longest ago go first until all take less than `MAX_BYTES`.
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
    with contextlib.suppress(OSError):
        for entry in os.scandir(folder):
            total += entry.stat().st_size
    return total
