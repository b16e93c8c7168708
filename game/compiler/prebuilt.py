"""Machine code that came with Carom: one file inside the package, for a generic processor of its platform.

    game/data/kernels/cpython-311-linux-x86_64.kernels

A newcomer's first picture need not wait for the compiler. The file is made by ``python -m game precompile``
and put into a wheel by hatch_build.py. It is used where Python, numba, llvmlite and numpy are those that it
was made with. Each kernel in it has a name that says all that it depends on, the sources included, as in the
cache folder (see cache.py). Otherwise kernels are compiled as if it were not there.

It is read whole, once, and checked whole: bytes that are not those that were packed count as no file, and so
does a file that another user could have written (see game/trust.py). Both are said, once.

``CAROM_PREBUILT`` names another file, or is 0: no such code then, whatever came with Carom.
"""

from __future__ import annotations

import hashlib
import json
import logging
import os
import platform
import sys
import threading
import zlib
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from game.folders import PACKAGE
from game.trust import is_private_file, reason_to_distrust

GENERIC = ("generic", "")  # name and features of a processor that has only what all of its kind have
VARIABLE = "CAROM_PREBUILT"
MOST_BYTES = 1 << 30
_MAGIC = b"carom machine code 1\n"
_CHECKSUM, _LENGTH = 32, 8  # bytes of the head after the magic words


class UnfitError(Exception):
    """There is a file, and it is sound, but it was made for something else."""


class DamagedError(Exception):
    """What is there is not what was packed, or cannot be trusted."""


class Prebuilt:
    """The kernels of one file, by name; ``scenes``: those that compile nothing when they are opened."""

    def __init__(self, places: Mapping[str, tuple[int, int]], body: bytes, scenes: frozenset[str]):
        """``places``: begin and length of each kernel's compressed code in the body."""
        self.scenes = scenes
        self._places = places
        self._body = body
        self.taken: set[str] = set()

    def __len__(self) -> int:
        return len(self._places)

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def take(self, name: str) -> bytes | None:
        """The code of that name, if it is there."""
        place = self._places.get(name)
        if place is None:
            return None
        data = zlib.decompress(self._body[place[0] : place[0] + place[1]])
        self.taken.add(name)
        return data


class Found(NamedTuple):
    """What came with this Carom: its code, or why there is none to take, in a few words."""

    code: Prebuilt | None
    reason: str


def platform_name() -> str:
    """System and kind of processor, such as linux-x86_64: what machine code of a generic one is for."""
    return f"{sys.platform}-{platform.machine().lower()}"


def file_name() -> str:
    """Name of the file for this Python on this platform."""
    return f"{sys.implementation.cache_tag}-{platform_name()}.kernels"


def what_must_fit() -> dict[str, str]:
    """What machine code depends on besides sources: versions, as they are here. Imports the compiler."""
    import llvmlite
    import numba
    import numpy

    return {
        "Python": str(sys.implementation.cache_tag),
        "numba": numba.__version__,
        "llvmlite": llvmlite.__version__,
        "numpy": numpy.__version__.split(".")[0],  # the layout of arrays lasts as long as this
        "platform": platform_name(),
    }


def pack(codes: Mapping[str, bytes], scenes: Iterable[str]) -> bytes:
    """A file's content: kernels by name, packed one by one, and the scenes that need no others to open."""
    places, parts, begin = {}, [], 0
    for name, code in sorted(codes.items()):
        parts.append(zlib.compress(code, 9))
        places[name] = begin, len(parts[-1])
        begin += len(parts[-1])
    index = json.dumps({"fits": what_must_fit(), "scenes": sorted(scenes), "codes": places}).encode()
    rest = len(index).to_bytes(_LENGTH, "little") + index + b"".join(parts)
    return _MAGIC + _checksum(rest) + rest


def unpack(data: bytes) -> Prebuilt:
    """The kernels of a file's content. DamagedError or UnfitError says why there are none."""
    head = len(_MAGIC) + _CHECKSUM
    if data[: len(_MAGIC)] != _MAGIC or _checksum(data[head:]) != data[len(_MAGIC) : head]:
        raise DamagedError("it is not what was packed")
    begin = head + _LENGTH
    end = begin + int.from_bytes(data[head:begin], "little")
    index = json.loads(data[begin:end])
    for name, here in what_must_fit().items():
        made_for = index["fits"].get(name)
        if made_for != here:
            raise UnfitError(f"made for {name} {made_for}, and here is {here}")
    places = {name: (place[0], place[1]) for name, place in index["codes"].items()}
    return Prebuilt(places, data[end:], frozenset(index["scenes"]))


def shipped_file() -> Path | None:
    """The file to take machine code from, one that is named even if it is not there; None if there is none.

    Nothing is read, and no compiler is imported.
    """
    chosen = os.environ.get(VARIABLE, "")
    if chosen == "0":
        return None
    if chosen:
        return Path(chosen).absolute()
    file = PACKAGE / "data" / "kernels" / file_name()
    return file if os.path.lexists(file) else None


_lock = threading.Lock()


def found() -> Found:
    """What came with Carom, looked for once in a process; what is wrong with it is said then."""
    with _lock:
        return _found()


@cache
def _found() -> Found:
    file = shipped_file()
    if file is None:
        return Found(None, "none came with this Carom")
    try:
        return Found(unpack(_read(file)), "")
    except UnfitError as error:
        return Found(None, str(error))
    except Exception as error:  # no sound file: whatever is in it
        words = "it is not what was packed"
        if isinstance(error, OSError):
            words = error.strerror or str(error)
        elif isinstance(error, DamagedError):
            words = str(error)
        logging.getLogger("carom").warning(
            "carom: machine code that came with Carom is not taken and is compiled anew, %s: %s", file, words
        )
        return Found(None, words)


def prebuilt() -> Prebuilt | None:
    """The machine code that came with Carom; None if there is none that can be taken here."""
    return found().code


def anything_taken() -> bool:
    """Whether any kernel of this process is one that came with Carom."""
    if not _found.cache_info().currsize:
        return False
    code = found().code
    return code is not None and bool(code.taken)


def no_file(path: Path) -> str:
    """What lies in the place of a file, if it is none: a folder, or a pipe or such; empty for a file."""
    if path.is_dir():
        return "it is a folder, not a file"
    return "" if path.is_file() else "it is not a regular file"


def _read(file: Path) -> bytes:
    """A file's content; DamagedError for one that another user may have written."""
    wrong = "no such file" if not file.exists() else reason_to_distrust(file.parent) or no_file(file)
    if wrong:
        raise DamagedError(wrong)
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    with os.fdopen(os.open(file, flags | getattr(os, "O_BINARY", 0)), "rb") as opened:
        if not is_private_file(os.fstat(opened.fileno())):
            raise DamagedError("another user may have written it")
        return opened.read(MOST_BYTES)


def _checksum(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=_CHECKSUM).digest()
