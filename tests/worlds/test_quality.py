"""One choice of how finely a scene is computed."""

import pytest

from game.scenes.burning_cloth.parameters import BurningClothParameters
from game.scenes.candle.parameters import CandleParameters
from game.scenes.fireplace.parameters import FireplaceParameters
from game.worlds.quality import Quality

QUALITY = Quality(10, 20, 40, "cells across")


def test_each_quality_has_its_parts_and_ones_own_those_that_are_said():
    assert [QUALITY.parts(tier, 7.0) for tier in ("play", "teach", "film", "own")] == [10, 20, 40, 7]
    with pytest.raises(AttributeError):
        QUALITY.parts("finest", 7.0)


def test_the_choice_says_how_many_parts_each_has():
    choice = QUALITY.choose("teach", "Gas", "; more of them cost more", rebuild=False)
    assert choice.options == ("play", "teach", "film", "own") and choice.default == "teach"
    assert choice.help == "cells across: 10, 20, 40, or as many as you say; more of them cost more"
    assert not choice.rebuild and QUALITY.choose("play", "Gas").rebuild


@pytest.mark.parametrize(
    ("parameters", "read"),
    [
        (FireplaceParameters(), FireplaceParameters.cells_now),
        (CandleParameters(), CandleParameters.cells_now),
        (BurningClothParameters(), BurningClothParameters.meshes_now),
    ],
)
def test_the_three_fires_take_what_is_chosen(parameters, read):
    own = "meshes" if hasattr(parameters, "meshes") else "cells"
    found = {}
    for tier in ("play", "teach", "film"):
        parameters.tier = tier
        found[tier] = read(parameters)
    assert found["play"] < found["teach"] < found["film"]
    parameters.tier = "own"
    assert read(parameters) == getattr(parameters, own)
