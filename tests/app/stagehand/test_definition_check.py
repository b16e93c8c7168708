"""What a scene declares is tried out: taken keys, colours and signs that are not there."""

from __future__ import annotations

import dataclasses

import pytest

from game.app.stagehand.definition_check import check_definition, check_studies
from game.definition import DefinitionError
from game.lab import Setting
from game.scenes import CATALOGUE
from game.stage import Equation, SceneAction, Stage
from game.ui.text.markup import FormulaError
from tests.app.scene.test_accuracy_card import make_study
from tests.stage.example_scene import BouncingBall


def test_a_scene_without_a_fault():
    assert check_definition(BouncingBall) is None  # and nothing is raised


def test_a_scene_may_undo_in_its_own_way():
    class Undoing(BouncingBall):
        actions = (SceneAction("undo", "undo", "ctrl+z"),)

    assert check_definition(Undoing) is None  # the command of that name asks the scene


def test_a_key_that_is_taken():
    class Taken(BouncingBall):
        actions = (SceneAction("kick", "Kick", "A"),)

    with pytest.raises(DefinitionError, match=r"Taken.actions: A is taken: what accuracy costs"):
        check_definition(Taken)


def test_a_colour_that_the_theme_does_not_have():
    class Coloured(BouncingBall):
        def draw(self, canvas, alpha):
            canvas.dot((0.0, 0.0), color="ambr")

    with pytest.raises(ValueError, match="amber"):
        check_definition(Coloured)


def test_a_sign_that_no_formula_knows():
    class Signed(BouncingBall):
        equations = (Equation("Motion", r"\aplha = 1"),)

    with pytest.raises(FormulaError, match=r"\\aplha"):
        check_definition(Signed)


def test_a_figure_that_has_the_name_of_a_parameter():
    class Standing(BouncingBall):
        def standing(self):
            return {"gravity": 1.0}

    with pytest.raises(DefinitionError, match=r"Standing.standing: gravity is a parameter or an effect as"):
        check_definition(Standing)


def test_a_study_that_places_the_scene_at_no_method():
    class Studied(BouncingBall):
        study = dataclasses.replace(make_study(), present=lambda values: Setting("third", values["gravity"]))

    with pytest.raises(DefinitionError, match="fake has no method 'third'"):
        check_definition(Studied)


@pytest.mark.parametrize("name", ["cavity", "smoke"])
def test_a_word_that_names_a_parameter_and_an_effect_is_the_parameter_to_a_study(name):
    """advection, the method and the switch; pressure, the solver and the switch."""
    stage = Stage(CATALOGUE[name].load())
    both = set(stage.scene.effects.names) & set(stage.scene.values)
    assert both
    assert all(stage.scene.chosen()[word] == stage.scene.values[word] for word in both)
    check_studies(stage.scene)
