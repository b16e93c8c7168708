"""Which sources a module's machine code depends on, and a hash of them.

A kernel compiled from one file holds the code of helpers and the values of constants from others. So its
cache is named by a hash of its own file and of all files of this package that it imports, directly or not:
an edit anywhere in that closure names another folder, and an edit elsewhere costs nothing.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

PACKAGE_ROOT = Path(__file__).resolve().parents[1]
COMPILER_FILES = tuple(
    PACKAGE_ROOT / "compiler" / name for name in ("decorator.py", "cache.py", "sources.py")
)

# Found anywhere in the text, even in a comment: a module too many costs a compilation, one too few is wrong.
_FROM = re.compile(r"\bfrom\s+(\.*[\w.]*)\s+import\s*(\((?:[^()#]|#[^\n]*)*\)|[^\n;]+)")
_IMPORT = re.compile(r"\bimport\s+([\w.][\w., \t]*)")
_QUOTED = re.compile(r"[\"'](\.*[A-Za-z_]\w*(?:\.\w+)*)[\"']")  # for import_module and lazy packages
_CONTINUED = re.compile(r"\\\r?\n")
_COMMENT = re.compile(r"#[^\n]*")


def imports_of(text: str, module: str, is_package: bool) -> set[str]:
    """Names that a source text may import, in full: modules, and things in them that may be modules.

    ``module``: dotted name of the module itself, by which relative imports are resolved.
    """
    text = _CONTINUED.sub(" ", text)
    parts = module.split(".")
    inside = parts if is_package else parts[:-1]
    found = {_absolute(name, inside) for name in _QUOTED.findall(text) if "." in name}
    for names in _IMPORT.findall(text):
        found.update(_first_words(names))
    for origin, names in _FROM.findall(text):
        base = _absolute(origin, inside)
        found.add(base)
        found.update(f"{base}.{name}" for name in _first_words(_COMMENT.sub("", names).strip("()")))
    found.discard("")
    return found


def _absolute(name: str, inside: list[str]) -> str:
    """A name in full; one that begins with dots counts from the package ``inside``."""
    dots = len(name) - len(name.lstrip("."))
    above = inside[: len(inside) - dots + 1] if dots else []
    return ".".join([*above, *filter(None, [name[dots:]])])


def _first_words(names: str) -> Iterator[str]:
    """``a as b, c`` gives a and c."""
    return (words[0] for item in names.split(",") if (words := item.split()))


@cache
def module_name(file: Path) -> str | None:
    """Dotted name of a source file of this package; None for a file elsewhere."""
    try:
        parts = list(file.relative_to(PACKAGE_ROOT.parent).with_suffix("").parts)
    except ValueError:
        return None
    if parts[0] != PACKAGE_ROOT.name:
        return None
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def _file_of(name: str) -> Path | None:
    """Source file of the module or package ``game.a.b``, or of the module ``game.a`` that b is a thing in.

    Packages on the way are not named: a kernel holds nothing of what they merely run.
    """
    folder = PACKAGE_ROOT
    for part in name.split(".")[1:]:
        if (folder / part).is_dir():
            folder = folder / part
        else:
            file = folder / f"{part}.py"
            return file if file.is_file() else None
    file = folder / "__init__.py"
    return file if file.is_file() else None


def closure_of(file: Path) -> list[Path]:
    """All source files of this package that a module of it depends on, itself included, sorted.

    ValueError for a file outside the package; OSError if one cannot be read.
    """
    name = module_name(file)
    if name is None:
        raise ValueError(f"{file} is not in the package {PACKAGE_ROOT.name}")
    seen = {file}
    waiting = [file]
    while waiting:
        for path in _imports_of_file(waiting.pop()):
            if path not in seen:
                seen.add(path)
                waiting.append(path)
    return sorted(seen)


@cache
def _source(file: Path) -> bytes:
    return file.read_bytes()


@cache
def _imports_of_file(file: Path) -> tuple[Path, ...]:
    """The source files of this package that a file of it imports."""
    package = PACKAGE_ROOT.name
    text = _source(file).decode("utf-8", errors="replace")
    names = imports_of(text, module_name(file) or package, file.name == "__init__.py")
    inside = (_file_of(name) for name in names if name == package or name.startswith(package + "."))
    return tuple({path for path in inside if path is not None})


@cache
def source_digest(file: Path) -> str:
    """Hash of all sources that the kernels of a module depend on, the compiler's options here included.

    ValueError if one of them was edited since this process began: what was loaded is then unknown, and must
    not be kept under the new text's name. ValueError and OSError as for `closure_of`.
    """
    hasher = hashlib.blake2b(digest_size=10)
    for path in sorted({*closure_of(file), *COMPILER_FILES}):
        hasher.update(f"{module_name(path)}|".encode())
        hasher.update(_text_digest(path))
    return hasher.hexdigest()


@cache
def _text_digest(file: Path) -> bytes:
    """Hash of one file's text; ValueError if it was edited since this process began."""
    text = _source(file)
    stamp = _stamp(file)
    if _STAMPS.get(file, stamp) != stamp:
        raise ValueError(f"{file} was edited since this process began")
    return hashlib.blake2b(text).digest()


def _stamp(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_mtime_ns, found.st_size


def _stamps(paths: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """When each file was last written, and how long it is."""
    stamps = {}
    for path in paths:
        try:
            stamps[path] = _stamp(path)
        except OSError:  # gone since it was listed
            continue
    return stamps


_STAMPS = _stamps(PACKAGE_ROOT.rglob("*.py"))
