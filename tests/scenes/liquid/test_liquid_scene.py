"""A tank of liquid as a person meets it: levels are as they expect, the hand pours, stirs, scoops, builds."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import LevelError, level_files, load_level
from game.scenes.liquid.level import LiquidContent
from game.scenes.liquid.scene import LiquidScene
from game.scenes.liquid.view import ABOUT_DENSITIES
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.ui.canvas.canvas import Canvas
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import drag, measured

LEVELS = level_files("liquid")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str = "still", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(
        LiquidScene, level=load_level(path, "liquid", LiquidContent), parameters={"cells": 48, **parameters}
    )


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = Stage(LiquidScene, level=load_level(path, "liquid", LiquidContent))
    for _ in range(3):
        stage.run(40)
        expected = stage.scene.model.content.expected
        captions = captions_of(expected, stage.readouts())
        assert expected and all(caption.met for caption in captions), captions


def test_the_hand_pours_as_much_as_it_says():
    stage = opened(poured=0.3)
    before = measured(stage, "poured in")
    stage.post(Pointer("down", 1.0, 0.9, 3))
    stage.run(60)
    stage.post(Pointer("up", 1.0, 0.9, 3))
    stage.run(60)
    assert measured(stage, "poured in") - before == pytest.approx(0.3, rel=0.02)
    assert measured(stage, "refused") == 0.0


def test_the_hand_stirs_scoops_and_lets_drops_fall():
    stage = opened()
    stage.post(SetParameter("tool", "stir"))
    drag(stage, (0.5, 0.2), (0.52, 0.2), (0.54, 0.2), (0.56, 0.2))
    assert 0.3 < measured(stage, "fastest") < 20.0
    full = measured(stage, "poured in")
    stage.post(Action("tool-scoop"))
    drag(stage, (1.5, 0.2), (1.5, 0.2), steps=3)
    scooped = measured(stage, "gone")
    assert scooped > 0.5 * math.pi * 0.08**2
    assert measured(stage, "poured in") == pytest.approx(full - scooped)
    stage.post(Action("tool-drop"))
    drag(stage, (1.0, 0.9))
    assert measured(stage, "poured in") == pytest.approx(full - scooped + math.pi * 0.08**2, rel=0.05)


def test_solids_are_put_in_dragged_and_taken_out():
    stage = opened(weight=0.3)
    stage.post(Action("tool-ball"))
    drag(stage, (1.0, 0.8))
    stage.post(Action("tool-box"))
    drag(stage, (0.4, 0.8))
    stage.run(120)
    assert measured(stage, "solids") == 2
    model = stage.scene.model
    ball, crate = model.solids.world.bodies.positions[model.bodies()]
    assert 0.4 < ball[1] < 0.65 and 0.4 < crate[1] < 0.65
    stage.post(Action("tool-grab"))
    drag(stage, tuple(ball), (ball[0] + 0.1, 0.7), (ball[0] + 0.2, 0.8), steps=20)
    assert model.solids.world.bodies.positions[model.bodies()][0, 0] > ball[0] + 0.05
    stage.post(Action("tool-scoop"))
    drag(stage, tuple(model.solids.world.bodies.positions[model.bodies()][1]))
    assert measured(stage, "solids") == 1
    assert measured(stage, "gone") == 0.0


def test_what_stands_still_can_be_put_in_too():
    stage = opened(weight=0.0, size=0.15)
    stage.post(Action("tool-box"))
    drag(stage, (1.0, 0.3))
    stage.run(120)
    model = stage.scene.model
    assert model.solids.world.bodies.positions[model.bodies()][0] == pytest.approx((1.0, 0.3))
    assert measured(stage, "level") == pytest.approx(0.5, rel=0.03)
    assert (model.liquid.solid_distance(model.liquid.places) > -0.02).all()


def test_taps_run_and_drains_drain():
    stage = opened()
    stage.post(Action("tool-tap"))
    drag(stage, (0.3, 1.0), (0.35, 0.95))
    stage.post(Action("tool-drain"))
    drag(stage, (1.7, 0.1))
    stage.run(60)
    assert measured(stage, "put in") > 1.0 and measured(stage, "gone") > 0.01
    given = measured(stage, "put in")
    stage.post(SetParameter("running", False))
    stage.run(30)
    assert measured(stage, "put in") == given


def test_a_floating_ball_is_half_in_the_water():
    stage = opened("floats", cells=80)
    stage.run(240)
    heights = []
    for _ in range(20):
        stage.run(6)
        model = stage.scene.model
        heights.append(model.solids.world.bodies.positions[model.bodies()][:5, 1])
    middle = np.mean(heights, axis=0)
    level = measured(stage, "level") + 0.5 * math.pi * (0.01 * (0.1 + 0.3 + 0.5 + 0.7 + 0.9) + 0.0064)
    assert middle[2] == pytest.approx(level, abs=0.03)
    assert middle[0] > middle[2] > middle[4]


def test_effects_can_be_left_out():
    stage = opened()
    stage.post(SetEffect("gravity", False))
    stage.run(60)
    assert measured(stage, "fastest") < 1e-3
    lost = opened("default")
    lost.post(SetEffect("keep-volume", False))
    kept = opened("default")
    for one in (lost, kept):
        one.run(480)
    assert measured(lost, "volume") < 0.96 * measured(kept, "volume")


@pytest.mark.parametrize("look", ["water", "dots", "cells", "pressure"])
@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_water_is_seen(look, theme):
    stage = opened("default", look=look, arrows=True)
    stage.run(30)
    picture = picture_of_stage(stage, (640, 360), theme)
    colors = [tuple(picture.get_at((x, y)))[:3] for x in range(20, 620, 10) for y in range(0, 360, 4)]
    assert sum(b > r + 20 and b > 40 for r, g, b in colors) > 60


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_a_state_goes_on_as_it_would_have(path):
    stage = Stage(LiquidScene, level=load_level(path, "liquid", LiquidContent), parameters={"cells": 40})
    stage.run(12)
    other = Stage(LiquidScene, level=load_level(path, "liquid", LiquidContent), parameters={"cells": 40})
    other.run(12)
    assert other.digest() == stage.digest()
    for one in (stage, other):
        one.run(12)
    other.readouts()
    assert other.digest() == stage.digest()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("tank = [0.0, 1.0]", "tank"),
        ("water = [{ high = [nan, 1.0] }]", "high"),
        ("open = ['up']", "open"),
        ("solids = [{ at = [1.0, inf] }]", "at"),
    ],
)
def test_nonsense_is_refused_in_a_line(tmp_path, content, words):
    file = tmp_path / "bad.toml"
    file.write_text(f'scene = "liquid"\ntitle = "Bad"\n\n[content]\n{content}\n')
    with pytest.raises(LevelError, match=words) as caught:
        load_level(file, "liquid", LiquidContent)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("carrier", ["apic", "pic-flip"])
@pytest.mark.parametrize("name", ["waterfall", "stairs"])
def test_water_that_runs_over_edges_is_not_lost_in_a_cell(name, carrier):
    """Within 1 % over 20 s; what falls does not gather where cells are cut by solids."""
    path = next(path for path in LEVELS if path.stem == name)
    level = load_level(path, "liquid", LiquidContent)
    stage = Stage(LiquidScene, level=level, parameters={"carrier": carrier})
    for _ in range(10):
        stage.run(round(2.0 / stage.dt))
        assert abs(measured(stage, "volume error")) < 0.01
        assert measured(stage, "fullest cell") < 2.5


def test_densities_are_said_at_the_bodies(monkeypatch):
    said: list[tuple[tuple[float, float], str]] = []
    stage = opened("floats")
    stage.run(30)
    monkeypatch.setattr(Canvas, "label", lambda self, at, text, *more, **other: said.append((at, text)))
    picture_of_stage(stage, (640, 360), "light")
    model = stage.scene.model
    places = model.solids.world.bodies.positions[model.bodies()]
    for place, density in zip(places, (0.1, 0.3, 0.5, 0.7, 0.9, 2.0), strict=True):
        at = next(at for at, text in said if text == f"{density:g}")
        assert at == pytest.approx(tuple(place), abs=0.05)
    assert sum(text == ABOUT_DENSITIES for _, text in said) == 1
    said.clear()
    stage.post(SetParameter("densities", False))
    stage.run(1)
    picture_of_stage(stage, (640, 360), "light")
    assert ABOUT_DENSITIES not in [text for _, text in said]
