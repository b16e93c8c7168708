"""The clipboard, as text."""

from __future__ import annotations

import pygame


def put(text: str) -> str:
    """Put a text into it. Why that could not be, in a few words; empty if it could."""
    try:
        pygame.scrap.put_text(text)
    except (pygame.error, AttributeError) as error:
        return f"There is no clipboard: {error}"
    return ""


def get() -> str:
    """The text in it; empty if there is none."""
    try:
        return pygame.scrap.get_text()
    except (pygame.error, AttributeError):
        return ""
