"""Pictures of what is shown, in the user's pictures folder."""

from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path

import pygame

from game.folders import pictures_folder


def save_picture(surface: pygame.Surface, title: str) -> Path:
    """Write a PNG named by the title and the time; its path. OSError if it cannot be written."""
    folder = pictures_folder()
    folder.mkdir(parents=True, exist_ok=True)
    word = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "carom"
    stamp = datetime.now().strftime("%Y-%m-%d-%H%M%S")
    path = folder / f"carom-{word}-{stamp}.png"
    number = 2
    while path.exists():
        path = folder / f"carom-{word}-{stamp}-{number}.png"
        number += 1
    write_png(surface, path)
    return path


def write_png(surface: pygame.Surface, path: Path) -> None:
    """Write a PNG to exactly this path; OSError if it cannot be written."""
    try:
        pygame.image.save(surface, str(path), "png")
    except pygame.error as error:
        raise OSError(f"{path}: {error}") from None
