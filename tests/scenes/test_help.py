"""What the help pages of the scenes with equations must say."""

from __future__ import annotations

import inspect

import pytest

from game.scenes import CATALOGUE
from game.stage import Choice

NAMES = ("c01", "c02", "c03", "c04", "c12", "c13", "c14", "c15")


def test_stories_have_all_of_the_window():
    stories = [entry for entry in CATALOGUE if entry.category == "Stories"]
    assert len(stories) > 6 and all(entry.roomy for entry in stories)


@pytest.mark.parametrize("entry", list(CATALOGUE), ids=lambda entry: entry.name)
def test_what_can_be_chosen_begins_with_a_capital(entry):
    """All lists look alike; single letters stand for symbols."""
    for parameter in entry.load().declared_parameters().values():
        if isinstance(parameter, Choice):
            assert [one for one in parameter.labels if len(one) > 2 and one[0].islower()] == []


@pytest.mark.parametrize("name", NAMES)
def test_symbols_are_explained(name):
    words = " ".join(inspect.cleandoc(CATALOGUE[name].load().__doc__ or "").split())
    assert "In the equations:" in words
    explained = words.partition("In the equations:")[2]
    assert explained.count(",") > 4
