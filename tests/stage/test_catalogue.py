"""The catalogue's categories and topics."""

from game.scenes import CATALOGUE
from game.stage.catalogue import CATEGORIES, Catalogue, Entry


def row(name: str, category: str, topic: str = "") -> Entry:
    return Entry(name, "X", name, "fact", category, "module", "Class", topic=topic)


def test_known_categories_come_in_their_order_and_new_ones_after_them():
    rows = (row("a", "New"), row("b", "Stories"), row("c", "Course"), row("d", "Other"), row("e", "Play"))
    assert Catalogue(rows).categories() == ("Play", "Course", "Stories", "New", "Other")


def test_topics_of_a_category_in_order_of_first_appearance():
    rows = (row("a", "Course", "Two"), row("b", "Play"), row("c", "Course"), row("d", "Course", "Two"))
    topics = Catalogue(rows).topics("Course")
    assert {topic: [e.name for e in entries] for topic, entries in topics.items()} == {
        "Two": ["a", "d"],
        "": ["c"],
    }
    assert list(topics) == ["Two", ""] and Catalogue(rows).topics("Lecture") == {}


def test_every_scene_has_a_category_of_the_bar():
    assert {entry.category for entry in CATALOGUE} <= set(CATEGORIES)
    by_task = {entry.task[0]: entry.category for entry in CATALOGUE if len(entry.task) > 1}
    assert by_task["C"] == "Course" and all(entry.topic for entry in CATALOGUE if entry.category == "Course")
