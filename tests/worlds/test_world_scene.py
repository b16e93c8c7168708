"""What a scene that is built tells its model and its hand of parameters, and which go by the quality."""

from __future__ import annotations

import pytest

from game.scenes import CATALOGUE
from game.stage import SetParameter, Stage


@pytest.mark.parametrize("name", ["a01", "a08", "a10", "a18", "a22", "a26", "falling-plates"])
def test_a_model_is_told_of_all_but_tools_and_picture(name, monkeypatch):
    stage = Stage(CATALOGUE[name].load())
    scene, told = stage.scene, []
    monkeypatch.setattr(scene.model, "change_parameter", told.append)
    declared = scene.declared_parameters()
    assert set(scene.not_of_model) <= set(declared)
    for one in declared:
        scene.parameter_changed(one)
    assert told == [one for one in declared if one != "tool" and one not in scene.not_of_model]
    assert len(told) > 2


@pytest.mark.parametrize("name", ["a01", "a10", "a22", "a26"])
def test_another_tool_lets_go_of_what_is_held(name, monkeypatch):
    stage = Stage(CATALOGUE[name].load())
    let_go = []
    monkeypatch.setattr(stage.scene.hand, "let_go", lambda: let_go.append(1))
    tools = stage.scene.declared_parameters()["tool"].options
    stage.post(SetParameter("tool", tools[1]))
    assert let_go == [1]


@pytest.mark.parametrize(("name", "number"), [("a10", "meshes"), ("a26", "cells"), ("a01", "substeps")])
def test_what_the_quality_says_is_idle(name, number):
    scene_type = CATALOGUE[name].load()
    tiers = [one for one in scene_type.declared_parameters()["tier"].options if one != "own"]
    assert "Own" in Stage(scene_type, parameters={"tier": tiers[0]}).scene.why_idle(number)
    assert Stage(scene_type, parameters={"tier": "own"}).scene.why_idle(number) == ""
