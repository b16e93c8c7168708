"""The one ``@kernel`` decorator: numba's nopython compiler with a disk cache that cannot go stale.

numba's own cache looks only at the file a function stands in. A kernel that calls a helper from another
file would keep the helper's old code after an edit. Here the machine code of a module's kernels lies in a
folder named by a hash of that module *and of every module of this package that it imports*, directly or
not; an edit anywhere in that closure names another folder, and an edit elsewhere costs nothing.

    <user cache>/carom/kernels/game.billiards.lecture-4f1c.../step_lecture-88.py311.1.nbc

The folder is the user's cache folder, or ``CAROM_CACHE_DIR``. If it cannot be written, kernels compile
anew in each process: that costs time and nothing else.

Only module-level kernels, and closures over plain integers, are kept on disk (a closure over another
kernel is a new function in every process). So variants by effect are specialised by integer masks.

``NUMBA_DISABLE_JIT=1`` leaves every kernel the Python function that it is.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import shutil
import time
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

import numba
from numba import config
from numba.core.caching import CompileResultCacheImpl, FunctionCache
from platformdirs import user_cache_dir

PACKAGE_ROOT = Path(__file__).resolve().parents[1]
STALE_AFTER_S = 7 * 86_400.0  # s; another checkout of another version may still use a younger folder
_IMPORT = re.compile(r"^[ \t]*(?:from[ \t]+(\.*[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n#]+)|import[ \t]+([\w., \t]+))", re.M)


def cache_root() -> Path:
    """The folder that holds one folder for each module with kernels."""
    base = os.environ.get("CAROM_CACHE_DIR") or user_cache_dir("carom", appauthor=False)
    return Path(base) / "kernels"


def _module_files(name: str) -> Iterator[Path]:
    """Source files that importing the module ``game.a.b`` runs: its packages and itself."""
    parts = name.split(".")[1:]
    folder = PACKAGE_ROOT
    yield folder / "__init__.py"
    for part in parts:
        if (folder / part).is_dir():
            folder = folder / part
            yield folder / "__init__.py"
        else:
            yield folder / f"{part}.py"
            return


def _module_name(file: Path) -> str:
    """Dotted name of a source file of this package."""
    parts = list(file.relative_to(PACKAGE_ROOT.parent).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@lru_cache(maxsize=None)
def _source_and_imports(file: Path) -> tuple[bytes, tuple[str, ...]]:
    """A file's text and the modules of this package that it imports, anywhere in it."""
    source = file.read_bytes()
    package = PACKAGE_ROOT.name
    here = _module_name(file).split(".")
    inside = here if file.name == "__init__.py" else here[:-1]
    found: list[str] = []
    for origin, names, plain in _IMPORT.findall(source.decode("utf-8", errors="replace")):
        if plain:
            found += [word.split()[0] for word in plain.split(",") if word.strip()]
            continue
        dots = len(origin) - len(origin.lstrip("."))
        base = ".".join([*inside[: len(inside) - dots + 1], origin[dots:]]).rstrip(".") if dots else origin
        found.append(base)
        # "from game.physics import jit" may name a module as well as a thing in one
        found += [f"{base}.{word.split()[0]}" for word in names.strip("() \n").split(",") if word.strip()]
    return source, tuple(name for name in found if name == package or name.startswith(package + "."))


@lru_cache(maxsize=None)
def source_digest(file: Path) -> str:
    """Hash of a module's source and of all modules of this package that it imports, directly or not."""
    seen: dict[Path, bytes] = {}
    waiting = [Path(__file__).resolve(), *_module_files(_module_name(file))]
    while waiting:
        path = waiting.pop()
        if path in seen or not path.is_file():
            continue
        source, imports = _source_and_imports(path)
        seen[path] = source
        for name in imports:
            waiting.extend(_module_files(name))
    digest = hashlib.blake2b(numba.__version__.encode(), digest_size=10)
    for path in sorted(seen):
        digest.update(str(path.relative_to(PACKAGE_ROOT)).encode())
        digest.update(seen[path])
    return digest.hexdigest()


def cache_folder(file: Path) -> Path:
    """Folder of the machine code of the kernels that stand in ``file``."""
    return cache_root() / f"{_module_name(file)}-{source_digest(file)}"


class _Locator:
    """Tells numba where the code of one function is kept; the folder's name is its freshness."""

    def __init__(self, line: int, folder: Path) -> None:
        self._line = line
        self._folder = folder
        self._py_file = str(folder)

    def ensure_cache_path(self) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        probe = self._folder / f".probe-{os.getpid()}"
        probe.touch()
        probe.unlink()

    def get_cache_path(self) -> str:
        return str(self._folder)

    def get_source_stamp(self) -> str:
        return self._folder.name

    def get_disambiguator(self) -> str:
        return str(self._line)

    @classmethod
    def from_function(cls, function: Any, source: str) -> _Locator | None:
        folder = cache_folder(Path(source).resolve())
        locator = cls(function.__code__.co_firstlineno, folder)
        try:
            locator.ensure_cache_path()
        except OSError:
            return None
        _remove_old_folders(folder)
        return locator


@lru_cache(maxsize=None)
def _remove_old_folders(current: Path) -> None:
    """Remove folders of the same module made from other sources and unused for a while."""
    stem = current.name.rsplit("-", 1)[0] + "-"
    with contextlib.suppress(OSError):
        os.utime(current)
        limit = time.time() - STALE_AFTER_S
        for other in current.parent.glob(stem + "*"):
            if other != current and other.stat().st_mtime < limit:
                shutil.rmtree(other, ignore_errors=True)


@contextlib.contextmanager
def _folder_lock(folder: Path) -> Iterator[None]:
    """Let one process at a time add to a folder: two would give two kernels one file number."""
    with (folder / ".lock").open("a+b") as handle:
        if os.name == "nt":  # pragma: no cover
            import msvcrt

            msvcrt.locking(handle.fileno(), msvcrt.LK_LOCK, 1)  # type: ignore[attr-defined,unused-ignore]
            try:
                yield
            finally:
                handle.seek(0)
                msvcrt.locking(handle.fileno(), msvcrt.LK_UNLCK, 1)  # type: ignore[attr-defined,unused-ignore]
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX)
            yield


class _Impl(CompileResultCacheImpl):
    _locator_classes = [_Locator]


class _KernelCache(FunctionCache):
    """numba's function cache with our folder, a lock on writing, and no way to fail but slowly."""

    _impl_class = _Impl

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        try:
            return super().load_overload(sig, target_context)
        except Exception:  # a damaged cache file may raise anything; compiling mends it
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        with contextlib.suppress(OSError), _folder_lock(Path(self.cache_path)):
            super().save_overload(sig, data)


def kernel(function: Callable[..., Any] | None = None, **options: Any) -> Any:
    """Compile a function to machine code (nopython, no GIL, no fastmath), kept on disk.

    Use bare (``@kernel``) or with numba options (``@kernel(inline="always")``). Division by zero gives
    inf or nan as in numpy. fastmath is refused: it removes NaN tests and fuses sums, so equal input
    would no longer give equal bits.
    """
    if options.get("fastmath") or options.get("parallel"):
        raise ValueError("kernel: fastmath and parallel change results; they are not to be had here")

    def compile_lazily(py_function: Callable[..., Any]) -> Any:
        dispatcher = numba.njit(nogil=True, error_model="numpy", **options)(py_function)
        if config.DISABLE_JIT:
            return dispatcher
        with contextlib.suppress(RuntimeError, OSError, ValueError):  # no writable folder: compile each time
            dispatcher._cache = _KernelCache(py_function)
        return dispatcher

    return compile_lazily if function is None else compile_lazily(function)
