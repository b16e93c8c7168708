"""The clipboard, as text."""

from __future__ import annotations

from pathlib import Path

import pygame

from game.folders import user_folder


def put(text: str) -> str:
    """Put a text into it. Why that could not be, in a few words; empty if it could."""
    try:
        pygame.scrap.put_text(text)
    except (pygame.error, AttributeError) as error:
        return f"There is no clipboard: {error}"
    return ""


def get() -> str:
    """The text in it; without a clipboard that of its file; empty if there is none."""
    try:
        return pygame.scrap.get_text()
    except (pygame.error, AttributeError):
        return _kept()


def file_for_text() -> Path:
    """The file that stands for the clipboard where there is none."""
    return user_folder() / "clipboard.txt"


def put_or_keep(text: str) -> str:
    """Put a text into the clipboard, or into its file if there is none. Which file, in words; else empty."""
    if not put(text):
        return ""
    path = file_for_text()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        return f"There is no clipboard, and no file: {error.strerror}."
    return f"There is no clipboard: the text is in {path}."


def _kept() -> str:
    """The text in the clipboard's file; empty if there is none."""
    try:
        return file_for_text().read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""
