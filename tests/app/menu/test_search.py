"""Search: what a few letters find, and in which order."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.app.menu.search import Field, rank, score_word

TITLES = [
    "Particle fountain",
    "Sweep and prune",
    "Uniform grid",
    "Hierarchical grids",
    "V-Clip",
    "GJK",
    "Two balls",
]


def find(query: str) -> list[str]:
    return rank(query, [(title, (Field(title, 1.0),)) for title in TITLES])


@pytest.mark.parametrize(
    ("query", "first"),
    [
        ("fountain", "Particle fountain"),
        ("FOUNT", "Particle fountain"),
        ("fntn", "Particle fountain"),
        ("fuontain", "Particle fountain"),
        ("grid", "Uniform grid"),
        ("grids", "Hierarchical grids"),
        ("sp", "Sweep and prune"),
        ("swe pru", "Sweep and prune"),
        ("prune sweep", "Sweep and prune"),
        ("vclip", "V-Clip"),
        ("v-clip", "V-Clip"),
        ("gjk", "GJK"),
        ("bälls", "Two balls"),
    ],
)
def test_few_letters_find_a_scene(query: str, first: str):
    assert find(query)[:1] == [first]


def test_nothing_finds_all_and_nonsense_finds_nothing():
    assert find("") == TITLES
    assert find("  -- ") == TITLES
    assert find("zzzz") == []
    assert find("grid zzzz") == []


def test_weight_decides_between_equal_hits():
    candidates = [("about", (Field("break", 0.5),)), ("title", (Field("break", 1.0),))]
    assert rank("break", candidates) == ["title", "about"]


def test_better_kinds_of_hits_score_higher():
    scores = [
        score_word("grid", "grid"),
        score_word("grid", "uniform grid"),
        score_word("gri", "grid world"),
        score_word("gri", "uniform grid"),
        score_word("rid", "grid"),
        score_word("ug", "uniform grid"),
        score_word("unfrm", "uniform grid"),
    ]
    assert scores == sorted(scores, reverse=True)
    assert len(set(scores)) == len(scores)
    assert scores[-1] > 0.0


@given(query=st.text(max_size=200), texts=st.lists(st.text(max_size=60), max_size=8))
def test_any_text_may_be_searched(query: str, texts: list[str]):
    found = rank(query, [(text, (Field(text, 1.0),)) for text in texts])
    assert set(found) <= set(texts)
    assert 0.0 <= max((score_word("abc", text) for text in texts), default=0.0) <= 1.0
