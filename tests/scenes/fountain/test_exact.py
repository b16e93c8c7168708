"""Where the exact curve of the fountain is known."""

from __future__ import annotations

import pytest

from game.physics.fields import DRAG, GRAVITY, WHIRL
from game.scenes.fountain.exact import exact_envelope, has_exact
from game.scenes.fountain.scene import Fountain
from game.stage import SetEffect, SetParameter
from tests.scenes.particle_stages import open_level


@pytest.mark.parametrize(
    ("whirl", "off", "known"),
    [(0.0, None, True), (4.0, None, False), (4.0, WHIRL, True), (4.0, DRAG, True)],
)
def test_a_vortex_that_is_felt_leaves_no_closed_form(whirl, off, known):
    stage = open_level(Fountain, "default", rate=1000.0, step_length=1.0 / 60.0)
    for effect in stage.scene.effects:
        stage.post(SetEffect(effect.name, effect in (GRAVITY, DRAG, WHIRL) and effect != off))
    stage.post(SetParameter("whirl", whirl))
    assert has_exact(stage.scene.model) is known
    assert (len(exact_envelope(stage.scene.model)) > 0) is known
