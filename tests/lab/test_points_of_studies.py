"""Every study of every scene: its points can be opened in the scene, and the scene finds its own place."""

from __future__ import annotations

import pytest

from game.lab import Setting
from game.scenes import CATALOGUE
from game.stage import SetEffect, SetKnob
from game.stage.door import checked_event

# methods that the scene does not have: its points are not to be clicked
ELSEWHERE = {
    "lecture-table": {"events"},
    "lecture-two-balls": {"events"},
    "three-tables": {"exact"},
    "three-tables-lossless": {"exact"},
    "c08": {"principal"},
}
# what is turned is no parameter of the scene, so that it has no place among the points
NO_PLACE = {"c02-collapse", "c02-joints", "bounds-gap", "c07-swaps", "c07-speed", "c10", "c11-support"}
CASES = [
    pytest.param(entry.name, number, id=f"{entry.name}-{study.name}")
    for entry in CATALOGUE
    for number, study in enumerate(entry.load().study.family)
]


def study_of(name: str, number: int):
    scene_type = CATALOGUE[name].load()
    return scene_type, scene_type.study.family[number]


@pytest.mark.parametrize(("name", "number"), CASES)
def test_the_scene_accepts_the_setting_of_each_point(name: str, number: int):
    scene_type, study = study_of(name, number)
    effects, knobs = scene_type.effects.names, scene_type.knobs()
    without = set()
    for setting in study.settings():
        if not setting.scene:
            without.add(setting.method)
        for key, value in setting.scene.items():
            assert key in knobs or key in effects, f"{study.name}: {name} knows no {key}"
            event = SetKnob(key, value) if key in knobs else SetEffect(key, value)
            assert checked_event(event, scene_type) == event
    assert without == ELSEWHERE.get(study.name, set())


@pytest.mark.parametrize(("name", "number"), CASES)
def test_points_are_told_apart_and_belong_to_methods(name: str, number: int):
    _, study = study_of(name, number)
    settings = study.settings()
    assert len({setting.key for setting in settings}) == len(settings)
    assert {setting.method for setting in settings} == {method.name for method in study.methods}


@pytest.mark.parametrize(("name", "number"), CASES)
def test_the_scene_as_it_opens_has_its_place(name: str, number: int):
    scene_type, study = study_of(name, number)
    if study.present is None:
        assert study.name in NO_PLACE
        return
    values = {key: knob.default for key, knob in scene_type.knobs().items()}
    setting = study.present({**values, **dict.fromkeys(scene_type.effects.names, True)})
    assert isinstance(setting, Setting) and setting.knob > 0.0


def test_studies_of_a_scene_have_short_names_and_no_two_scenes_share_a_name_by_chance():
    known = {}
    for entry in CATALOGUE:
        family = entry.load().study.family
        shorts = [study.short for study in family]
        assert len(set(shorts)) == len(shorts)
        assert len(family) == 1 or all(short and short[0].isupper() for short in shorts), entry.name
        for study in family:
            assert known.setdefault(study.name, study) is study
