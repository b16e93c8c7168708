"""Names of methods in words."""

from __future__ import annotations

import pytest

from game.naming import titled, words_of


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("semi-implicit-euler", "semi-implicit Euler"),
        ("explicit-euler", "explicit Euler"),
        ("gauss-seidel", "Gauss-Seidel"),
        ("xpbd", "XPBD"),
        ("compliant-lagrangian", "compliant Lagrangian"),
        ("augmented-vertex-block-descent", "augmented vertex block descent"),
        ("stam-1999", "Stam 1999"),
        ("time-centred", "time-centred"),
        ("v-cycles", "v-cycles"),
        ("", ""),
    ],
)
def test_proper_names_keep_their_capitals_and_joined_words_their_hyphen(name: str, words: str):
    assert words_of(name) == words
    assert titled(name) == words[:1].upper() + words[1:]
