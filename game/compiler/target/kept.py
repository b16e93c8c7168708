"""Where a kernel for Carom's target finds and keeps its machine code: in cache.py's files, or prebuilt."""

from __future__ import annotations

import contextlib
import hashlib
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from types import CodeType
from typing import Any

from numba.core.caching import NullCache
from numba.core.serialize import dumps

from game.compiler.cache import SUFFIX, keep_code, take_code
from game.compiler.prebuilt import GENERIC, platform_name, prebuilt
from game.compiler.target.linking import kept_form, rebuilt

BEFORE_LOADING: list[Callable[[str], None]] = []  # what makes a symbol known that machine code refers to


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
        return None if path is None else take_code(path)

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
            keep_code(path, dumps(kept_form(cres)))

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
