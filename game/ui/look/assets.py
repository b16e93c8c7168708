"""Where the files that travel with the program lie: fonts, themes, pictures, sounds."""

from __future__ import annotations

from pathlib import Path

from game.folders import data_folder


def asset(*parts: str) -> Path:
    """Path of one file: ``asset("theme", "dark.json")``; FileNotFoundError if there is none."""
    path = data_folder("assets").joinpath(*parts)
    if not path.exists():
        raise FileNotFoundError(f"assets: there is no {'/'.join(parts)}")
    return path
