"""What the menu offers and what a search finds in it: scenes and levels."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, islice
from typing import NamedTuple

from game.app.menu.flow import Group
from game.app.menu.search import Field, rank, words_of
from game.app.stagehand.level_index import LevelHead, level_heads
from game.stage.catalogue import STORIES, Catalogue, Entry

FAVOURITES, RECENT = "Favourites", "Recent"  # categories of what stands in another one as well
LEVELS = "Levels"
WIDE = ("billiards", "lecture-table")  # the first of these that there is takes two places


class Found(NamedTuple):
    """Scenes and levels to be shown, the best first."""

    scenes: tuple[Entry, ...]
    levels: tuple[LevelHead, ...]


class Offer:
    """All scenes and levels of the catalogue, searchable."""

    def __init__(self, catalogue: Catalogue):
        self.catalogue = catalogue
        self.levels = tuple(head for entry in catalogue for head in level_heads(entry.name))
        names = [entry.name for entry in catalogue]
        self.wide = next((name for name in WIDE if name in names), "")
        self._scene_fields = [(entry, _fields_of_entry(entry)) for entry in catalogue]
        self._level_fields = [(head, self._fields_of_level(head)) for head in self.levels]
        fields = chain.from_iterable(some for _, some in chain(self._scene_fields, self._level_fields))
        self._unprepared = (field.text for field in fields)

    def prepare(self, most: int) -> None:
        """Get some of the texts ready to be searched; the first letter typed is to find all ready."""
        for text in islice(self._unprepared, most):
            words_of(text)

    def groups(self, favourites: Sequence[str] = (), recent: Sequence[str] = ()) -> list[Group]:
        """Favourites and what was opened last, then all scenes by category and topic, the wide card first."""
        starred = self._known(favourites)
        opened = tuple(name for name in self._known(recent) if name not in starred)
        first = [
            Group(FAVOURITES, starred, FAVOURITES, again=True),
            Group(RECENT, opened, RECENT, again=True, one_row=True),
        ]
        return [group for group in first if group.names] + [
            group for category in self.catalogue.categories() for group in self._groups_of(category)
        ]

    def _groups_of(self, category: str) -> list[Group]:
        """A category by its topics; the stories with those that other scenes have."""
        if category == STORIES:
            names = tuple(entry.name for entry in self.catalogue.stories())
            return [Group(category, names, category, again=True)]
        topics = self.catalogue.topics(category)
        return [Group(topic or category, self._names(entries), category) for topic, entries in topics.items()]

    def entry_in(self, category: str, name: str) -> Entry:
        """A scene as its card in a category shows it."""
        told = self.catalogue.stories() if category == STORIES else ()
        return next((entry for entry in told if entry.name == name), self.catalogue[name])

    def _known(self, names: Sequence[str]) -> tuple[str, ...]:
        """Those that there are, each once."""
        there = {entry.name for entry in self.catalogue}
        return tuple(name for name in dict.fromkeys(names) if name in there)

    def _names(self, entries: Sequence[Entry]) -> tuple[str, ...]:
        return tuple(sorted((entry.name for entry in entries), key=lambda name: name != self.wide))

    def find(self, query: str) -> Found:
        """What a query finds; a level is found by its own words and, less so, by its scene's."""
        return Found(tuple(rank(query, self._scene_fields)), tuple(rank(query, self._level_fields)))

    def _fields_of_level(self, head: LevelHead) -> Sequence[Field]:
        entry = self.catalogue[head.scene]
        own = (
            Field(head.title, 1.0),
            Field(head.path.stem, 0.8),
            Field(head.hard_case, 0.9),
            Field(head.about, 0.5),
        )
        return (*own, Field(entry.title, 0.4), Field(entry.name, 0.4))


def _fields_of_entry(entry: Entry) -> Sequence[Field]:
    return (
        Field(entry.title, 1.0),
        Field(entry.name, 1.0),
        Field(entry.task, 0.95),
        Field(entry.keywords, 0.7),
        Field(entry.fact, 0.6),
        Field(entry.category, 0.5),
        Field(entry.topic, 0.5),
    )
