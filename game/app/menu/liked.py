"""Favourites and what was opened last, as the settings keep them: names of scenes."""

from __future__ import annotations

from game.app.window.settings import Settings

MOST_RECENT = 12
MOST_FAVOURITES = 500


def toggle_favourite(settings: Settings, name: str) -> bool:
    """Give a scene a star, or take it away; True if it has one now."""
    starred = name not in settings.favourites
    others = [one for one in settings.favourites if one != name]
    settings.favourites = [*others, name][-MOST_FAVOURITES:] if starred else others
    return starred


def note_opened(settings: Settings, name: str) -> None:
    """A scene has been opened: it is the first of the recent ones."""
    others = [one for one in settings.recent if one != name]
    settings.recent = [name, *others][:MOST_RECENT]
