"""The catalogue's categories and topics."""

from game.scenes import CATALOGUE
from game.stage.catalogue import CATEGORIES, STORIES, Catalogue, Entry, StoryCard


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


def test_a_story_of_another_scene_stands_among_the_stories_by_its_own_words():
    told = row("game", "Play")._replace(story=StoryCard("A1", "A match", "long"))
    catalogue = Catalogue((told, row("a", STORIES), row("b", STORIES), row("c", "Course")))
    assert [(one.name, one.title) for one in catalogue.stories()] == [
        ("a", "a"), ("b", "b"), ("game", "A match"),
    ]  # fmt: skip
    following = {name: catalogue.after_in_category(name, STORIES) for name in ("a", "b", "game")}
    assert [one and one.title for one in following.values()] == ["b", "A match", "a"]
    assert catalogue["game"].title == "game" and catalogue.after_in_category("c", "Course") is None


def test_the_match_is_a_story():
    from game.stage.story.reading import stories_of

    match = next(entry for entry in CATALOGUE.stories() if entry.name == "billiards")
    assert match.task == "A02" and match.title == stories_of(CATALOGUE["billiards"].load())[0].title
