"""What a scene declares is tried out: taken keys, colours and signs that are not there."""

from __future__ import annotations

import pytest

from game.app.stagehand.definition_check import check_definition
from game.definition import DefinitionError
from game.stage import Equation, SceneAction
from game.ui.text.markup import FormulaError
from tests.stage.example_scene import BouncingBall


def test_a_scene_without_a_fault():
    assert check_definition(BouncingBall) is None  # and nothing is raised


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
