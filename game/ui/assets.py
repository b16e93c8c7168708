"""Where the files that travel with the program lie: fonts, themes, pictures, sounds."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]


@lru_cache(maxsize=1)
def assets_folder() -> Path:
    """The folder ``assets`` of a checkout, or the copy inside an installed package."""
    for folder in (_PACKAGE.parent / "assets", _PACKAGE / "data" / "assets"):
        if (folder / "fonts").is_dir():
            return folder
    raise FileNotFoundError("assets: no folder with fonts, neither beside nor inside the package")


def asset(*parts: str) -> Path:
    """Path of one file: ``asset("theme", "dark.json")``; FileNotFoundError if there is none."""
    path = assets_folder().joinpath(*parts)
    if not path.exists():
        raise FileNotFoundError(f"assets: there is no {'/'.join(parts)}")
    return path
