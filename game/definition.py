"""A scene that is declared wrongly: one line that says what to write, for who writes it."""

from __future__ import annotations


class DefinitionError(TypeError, ValueError):
    """A mistake in a scene's class or in its row of the catalogue, not in what a person gave."""
