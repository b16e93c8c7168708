"""Words on the cloth."""

import math

import pytest

from game.scenes.shared.tables.view import cut_words


@pytest.mark.parametrize(
    ("degrees", "words"), ((0.0, "cut 0°"), (29.6, "cut 30°"), (89.4, "cut 89°"), (89.9, "cut 89.9°"))
)
def test_a_cut_that_just_finds_the_ball_is_not_called_a_miss(degrees, words):
    assert cut_words(math.radians(degrees)) == words
