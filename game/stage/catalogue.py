"""The list of scenes, as a type: a row names a scene's module, so that only the one opened is imported."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from difflib import get_close_matches
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

from game.definition import DefinitionError
from game.stage.declarations import StartLine
from game.stage.scene import Scene

# Of the menu's bar, in its order; one that is not among them comes after these.
CATEGORIES = ("Play", "Course", "Lecture", "Examples", "Stories", "Papers", "Playgrounds", "Carom")
STORIES = "Stories"  # category of scenes that open with their story, and of the stories that others have


class CloseUp(NamedTuple):
    """How a scene is framed in the live picture of its card, where all of it would be too small to see.

    shown_s: simulated time, s, at which the picture begins. zoom: so many times closer than the whole frame;
    across, down: the point of the frame that is in the middle of the card, in shares of the frame from its
    upper left corner. level: the name of one of the scene's levels that shows more than its default.
    """

    shown_s: float = 1.6
    zoom: float = 1.0
    across: float = 0.5
    down: float = 0.5
    level: str = ""


class StoryCard(NamedTuple):
    """What the card of a scene's own story says, in place of the scene's own words."""

    task: str
    title: str
    fact: str


class Entry(NamedTuple):
    """A scene as the menu shows it before its module is imported."""

    name: str
    task: str
    title: str
    fact: str  # the few words beside the id on its card
    category: str  # one of CATEGORIES, or a new one: where it stands in the menu
    module: str
    class_name: str
    keywords: str = ""
    roomy: bool = False  # a game: all of the window is its stage until the panel is asked for
    card: str = ""  # function in card.py beside the module that draws its card with a ui.canvas.pen.Pen
    topic: str = ""  # what a large category is divided into; of it a heading in the menu
    level_card: str = ""  # function in card.py that draws a level, as its file is read, with a Pen
    start: str = ""  # StartLines in start.py beside the module: the card that a game is begun with
    story: StoryCard | None = None  # of its own story, by which it stands among the stories as well

    @property
    def names(self) -> tuple[str, str, str]:
        """What the scene is called: ``name, task, title = ENTRY.names`` in its class says it once."""
        return self.name, self.task, self.title

    def load(self) -> type[Scene]:
        """Import the scene's class; DefinitionError, naming what differs, unless it is called so."""
        scene_type: type[Scene] = getattr(import_module(self.module), self.class_name)
        for field in ("name", "task", "title"):
            said, row = getattr(scene_type, field), getattr(self, field)
            if said != row:
                raise DefinitionError(
                    f"{self.module}.{self.class_name}.{field} is {said!r}, in the catalogue {row!r}; "
                    "write `name, task, title = ENTRY.names` in the class"
                )
        return scene_type

    def card_painter(self) -> Callable[[Any], None] | None:
        """The function that draws its card; None for a scene without one of its own.

        DefinitionError if card.py has no such function.
        """
        painter: Callable[[Any], None] | None = self._beside("card", self.card)
        return painter

    def close_up(self) -> CloseUp:
        """How its live picture is framed: as CLOSE_UPS, by scenes' names, in card.py says, or all of it."""
        if not self.card:
            return CloseUp()
        close_up: CloseUp = getattr(self._module_beside("card"), "CLOSE_UPS", {}).get(self.name, CloseUp())
        return close_up

    def level_painter(self) -> Callable[[Any, dict[str, Any]], None] | None:
        """The function that draws a level (a Pen, the level's file as it is read); None without one.

        DefinitionError if card.py has no such function.
        """
        painter: Callable[[Any, dict[str, Any]], None] | None = self._beside("card", self.level_card)
        return painter

    def start_lines(self) -> tuple[StartLine, ...]:
        """What can be chosen before a game begins; empty if it begins at once.

        DefinitionError if start.py has no such lines.
        """
        lines: tuple[StartLine, ...] = self._beside("start", self.start) or ()
        return lines

    def _beside(self, module: str, wanted: str) -> Any:
        """What a module beside the scene's defines; None if nothing is wanted of it."""
        if not wanted:
            return None
        home = self._module_beside(module)
        found = getattr(home, wanted, None)
        if found is None:
            raise DefinitionError(f"{home.__name__} has no {wanted!r}, which the row of {self.name} names")
        return found

    def _module_beside(self, module: str) -> ModuleType:
        return import_module(f"{self.module.rpartition('.')[0]}.{module}")


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
        """Category names: those of CATEGORIES in their order, then others in order of first appearance."""
        named = dict.fromkeys(entry.category for entry in self.entries)
        known = [category for category in CATEGORIES if category in named]
        return tuple(dict.fromkeys([*known, *named]))

    def topics(self, category: str) -> dict[str, tuple[Entry, ...]]:
        """Scenes of a category by topic, both in order of first appearance; "" is the topic of none."""
        found: dict[str, tuple[Entry, ...]] = {}
        for entry in self.entries:
            if entry.category == category:
                found[entry.topic] = (*found.get(entry.topic, ()), entry)
        return found

    def stories(self) -> tuple[Entry, ...]:
        """Scenes that are stories, then others as the stories that they have: with its card's words."""
        own = tuple(entry for entry in self.entries if entry.category == STORIES)
        told = (entry for entry in self.entries if entry.story is not None and entry.category != STORIES)
        return (*own, *(entry._replace(**entry.story._asdict()) for entry in told if entry.story is not None))

    def after_in_category(self, name: str, category: str) -> Entry | None:
        """The scene of a category that comes after one, or the first; None if there is no other."""
        own = tuple(entry for entry in self.entries if entry.category == category)
        entries = self.stories() if category == STORIES else own
        names = [entry.name for entry in entries]
        found = entries[(names.index(name) + 1 if name in names else 0) % len(entries)] if entries else None
        return None if found is None or found.name == name else found

    def neighbour(self, name: str, offset: int) -> Entry:
        """The scene so many places on, round the end."""
        index = self.entries.index(self[name])
        return self.entries[(index + offset) % len(self.entries)]
