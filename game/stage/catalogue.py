"""The list of scenes, as a type: a row names a scene's module, so that only the one opened is imported."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from importlib import import_module
from typing import NamedTuple

from game.stage.scene import Scene


class Entry(NamedTuple):
    """A scene as the menu shows it before its module is imported."""

    name: str
    task: str
    title: str
    fact: str  # the few words beside the id on its card
    category: str
    module: str
    class_name: str
    keywords: str = ""
    roomy: bool = False  # a game: all of the window is its stage until the panel is asked for

    def load(self) -> type[Scene]:
        """Import the scene's class; ValueError unless it says the same of itself as this row."""
        scene_type: type[Scene] = getattr(import_module(self.module), self.class_name)
        if (scene_type.name, scene_type.task, scene_type.title) != (self.name, self.task, self.title):
            raise ValueError(f"catalogue row {self.name} differs from {self.module}.{self.class_name}")
        return scene_type


class Catalogue:
    """Scenes in the order of the menu, by category. ValueError for two of one name."""

    def __init__(self, entries: tuple[Entry, ...]):
        names = [entry.name for entry in entries]
        if len(set(names)) != len(names):
            raise ValueError("catalogue: two scenes have one name")
        self.entries = entries

    def __iter__(self) -> Iterator[Entry]:
        return iter(self.entries)

    def __len__(self) -> int:
        return len(self.entries)

    def __getitem__(self, name: str) -> Entry:
        """The row of that name; KeyError with the known names if there is none."""
        for entry in self.entries:
            if entry.name == name:
                return entry
        near = self.near(name)
        meant = f" (did you mean {' or '.join(near)}?)" if near else ""
        raise KeyError(
            f"no scene is called {name}{meant}; there are {', '.join(entry.name for entry in self.entries)}"
        )

    def near(self, name: str) -> list[str]:
        """Names of at most three scenes that may have been meant: alike, or with that word in their title."""
        word = name.strip().lower()
        alike = get_close_matches(word, [entry.name for entry in self.entries], 3, 0.6)
        titled = [e.name for e in self.entries if len(word) > 2 and word in f"{e.name} {e.title.lower()}"]
        return list(dict.fromkeys([*titled, *alike]))[:3]

    def categories(self) -> tuple[str, ...]:
        """Category names in order of first appearance."""
        return tuple(dict.fromkeys(entry.category for entry in self.entries))

    def neighbour(self, name: str, offset: int) -> Entry:
        """The scene so many places on, round the end."""
        index = self.entries.index(self[name])
        return self.entries[(index + offset) % len(self.entries)]
