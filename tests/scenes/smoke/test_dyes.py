"""Coloured dyes and the keys of smoke: sums, states with and without dyes, saving, how dyes mix."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import Level, LevelError, format_level, parse_level
from game.scenes.smoke.level import SmokeContent, SourceEntry
from game.scenes.smoke.model import DYED, FIELDS, SMOKE, SOOT
from game.scenes.smoke.parameters import DYES, INKS, VIEWS
from game.scenes.smoke.scene import Smoke
from game.stage import Action, Pointer, SetParameter, Stage
from tests.scenes.by_hand import measured

SMALL = {"cells": 32}
KEYS = {action.name: action.key for action in Smoke.actions}


def opened(level: Level) -> Stage:
    return Stage(Smoke, level=level)


def paint(stage: Stage, dye: str, x: float, y: float = 0.7) -> None:
    stage.post(Action(f"dye-{dye}"))
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("up", x, y, button=1))


def test_keys_choose_the_view_and_the_dye():
    stage = Stage(Smoke, parameters=SMALL)
    for view in VIEWS:
        assert KEYS[f"view-{view}"]
        stage.post(Action(f"view-{view}"))
        assert stage.scene.parameters.view == view
    for ink in INKS:
        assert KEYS[f"dye-{ink}"]
        stage.post(Action("tool-stir"))
        stage.post(Action(f"dye-{ink}"))
        assert (stage.scene.parameters.dye, stage.scene.parameters.tool) == (ink, "dye")
    assert len(set(KEYS.values())) == len(KEYS)


@pytest.mark.parametrize("method", ["maccormack", "time-centred", "stam-2003"])
def test_the_first_dye_alters_nothing_else(method):
    plain, dyed = (Stage(Smoke, parameters={**SMALL, "method": method}) for _ in range(2))
    for stage in (plain, dyed):
        stage.run(20)
        stage.scene.model.scalars[..., SOOT] = 1e-4
    assert dyed.scene.model.fields == FIELDS
    paint(dyed, "blue", 1.5)
    assert dyed.scene.model.fields == DYED and measured(dyed, "blue dye") > 0.005
    assert measured(dyed, "pink dye") == 0.0
    for stage in (plain, dyed):
        stage.run(20)
    few = len(FIELDS)
    assert np.array_equal(plain.scene.model.scalars, dyed.scene.model.scalars[..., :few])
    assert np.array_equal(plain.scene.model.velocity(), dyed.scene.model.velocity())


def test_in_flux_form_the_sum_of_each_dye_is_kept_while_it_is_stirred():
    stage = Stage(Smoke, level=None, parameters={**SMALL, "flux": True, "brush": 0.1})
    for k, dye in enumerate(DYES):
        paint(stage, dye, 1.0 + 0.1 * k, 0.4)
    before = [measured(stage, f"{dye} dye") for dye in DYES]
    stage.post(Action("tool-stir"))
    stage.post(Pointer("down", 1.0, 0.4, button=1))
    moved = stage.scene.model.scalars.copy()
    for k in range(10):
        stage.post(Pointer("move", 1.0 + 0.02 * k, 0.4, button=1))
        stage.run(1)
    assert not np.allclose(stage.scene.model.scalars[..., -3:], moved[..., -3:], atol=0.05)
    assert [measured(stage, f"{dye} dye") for dye in DYES] == pytest.approx(before, rel=1e-9)


@pytest.mark.parametrize("method", ["time-centred", "stam-2003"])
def test_states_with_and_without_dyes_are_taken_over_by_either(method):
    stage = Stage(Smoke, parameters={**SMALL, "method": method})
    stage.run(10)
    bare = stage.scene.model.state()
    bare = bare._replace(fluid=type(bare.fluid)(*map(np.copy, bare.fluid)))
    stage.run(5)
    later = stage.scene.model.scalars.copy()
    paint(stage, "yellow", 1.4)
    stage.run(5)
    wide = stage.scene.model.state()
    wide = wide._replace(fluid=type(wide.fluid)(*map(np.copy, wide.fluid)))
    stage.run(5)
    end = stage.scene.model.scalars.copy()
    model = stage.scene.model
    model.restore(bare)
    assert model.fields == FIELDS
    stage.run(5)
    assert np.array_equal(model.scalars, later)
    model.restore(wide)
    assert model.fields == DYED and model.dye("yellow") > 0.0
    stage.run(5)
    assert np.array_equal(model.scalars, end)


def test_steps_back_go_behind_the_first_dye():
    stage, digests = Stage(Smoke, parameters=SMALL), {}
    for step in range(1, 11):
        stage.run(1)
        digests[step] = stage.digest()
        if step == 6:
            paint(stage, "pink", 1.4)
    for step in (9, 8, 7, 6, 5, 4):
        stage.step_back()
        assert stage.step_number == step
        assert step == 6 or stage.digest() == digests[step]  # at 6 the dye may be painted or not
        assert step == 6 or stage.scene.model.fields == (DYED if step > 6 else FIELDS)
    stage.run(1)
    assert stage.digest() == digests[5]


def test_a_level_keeps_the_dye_of_its_sources_and_of_the_hand():
    """Through a file's text and back: the same words, and the same steps."""
    content = SmokeContent(sources=(SourceEntry(at=(0.6, 0.1), dye="pink"), SourceEntry(at=(1.4, 0.1))))
    first = opened(Level(scene="smoke", parameters={**SMALL, "dye": "blue"}, content=content))
    kept = {name: first.scene.values[name] for name in ("cells", "dye")}
    text = format_level(Level(scene="smoke", parameters=kept, content=first.scene.save_content()))
    again = opened(parse_level(text, "smoke", SmokeContent, Path("dyed.toml")))
    assert again.scene.parameters.dye == "blue" and again.scene.save_content() == content
    for stage in (first, again):
        stage.run(10)
    assert first.digest() == again.digest()
    assert measured(again, "pink dye") > 0.003 and measured(again, "smoke") > 0.003
    assert measured(again, "blue dye") == 0.0


def test_a_dye_that_does_not_exist_is_refused():
    with pytest.raises(LevelError, match="dye"):
        parse_level(
            'scene = "smoke"\n[[content.sources]]\nat = [1.0, 0.5]\ndye = "ochre"\n', "smoke", SmokeContent,
            Path("ochre.toml"),
        )  # fmt: skip


def test_clearing_takes_dyes_away_by_the_brush_and_everywhere():
    stage = Stage(Smoke, parameters={**SMALL, "brush": 0.15})
    paint(stage, "blue", 1.5)
    paint(stage, "yellow", 0.4)
    stage.post(SetParameter("tool", "clear"))
    stage.post(Pointer("down", 1.5, 0.7, button=1))
    stage.post(Pointer("up", 1.5, 0.7, button=1))
    assert measured(stage, "blue dye") < 0.1 * measured(stage, "yellow dye")
    stage.post(Action("clear"))
    assert measured(stage, "yellow dye") == 0.0 and stage.scene.model.total(SMOKE) == 0.0
    stage.run(2)
    assert stage.fault is None


def test_dyes_that_meet_are_drawn_mixed_in_equal_parts():
    prepare()
    seen = {}
    for names in (("blue",), ("yellow",), ("blue", "yellow"), ("yellow", "blue")):
        stage = Stage(Smoke, parameters={**SMALL, "brush": 0.3})
        for name in names:
            paint(stage, name, 1.5, 0.5)
        picture = picture_of_stage(stage, (320, 180), "dark")
        seen[names] = np.array(picture.get_at((240, 90))[:3], dtype=float)
    mixed = seen["blue", "yellow"]
    assert np.array_equal(mixed, seen["yellow", "blue"])
    assert np.allclose(mixed, 0.5 * (seen["blue",] + seen["yellow",]), atol=12.0)
    assert mixed[1] > mixed[0] and mixed[1] > mixed[2] - 12.0
