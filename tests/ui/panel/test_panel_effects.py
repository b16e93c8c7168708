"""Rows of effects: the bar leaves room for every effect's name."""

import math

import pytest

from game.scenes import CATALOGUE
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.panel.effects import BAR, EffectCosts

SWITCH = 44  # design px that the switch takes
GAP = 4


@pytest.mark.parametrize("k", (1.0, 1.25, 1.5))
@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_no_name_of_an_effect_is_cut_off(name, k):
    look = Look(DARK, k)
    for effect in CATALOGUE[name].load().effects:
        assert look.fonts.size(effect.label, 13, "medium")[0] <= look.px(BAR - GAP) - look.px(SWITCH)


def test_a_cost_is_a_dash_until_measured_and_nothing_below_the_noise():
    costs = EffectCosts()
    assert math.isnan(costs.of("gravity"))
    costs.costs = {"gravity": 0.0, "drag": -1e-9, "ground": 2e-6}
    assert [costs.of(name) for name in ("gravity", "drag", "ground")] == [0.0, 0.0, 2e-6]
