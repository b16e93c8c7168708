"""A catalogue of eighty cards in many categories, for the tests of a large menu."""

from __future__ import annotations

from game.stage.catalogue import Catalogue, Entry
from tests.app.tests_app import example_entry

NUMBERS = {"Carom": 8, "Stories": 22, "Play": 1, "Course": 15, "Lecture": 3, "Papers": 18, "Inventions": 13}
TOPICS = ("Animation", "Broad phase", "Rigid bodies")


def eighty() -> Catalogue:
    """Eighty rows of the example scene; a course of three topics, and a category that nobody knew."""
    return Catalogue(tuple(_row(category, i) for category, number in NUMBERS.items() for i in range(number)))


def _row(category: str, i: int) -> Entry:
    name = f"{category.lower()}-{i}"
    topic = TOPICS[i // 5] if category == "Course" else ""
    return example_entry(name)._replace(category=category, topic=topic)
