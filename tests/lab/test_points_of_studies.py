"""Every study of every scene: its points can be opened in the scene, and the scene finds its own place."""

from __future__ import annotations

import math

import pytest

from game.lab import Setting, measure, measure_present
from game.lab.studies.bounds_gap import gap_study
from game.lab.studies.narrowphase import vclip_study
from game.lab.studies.narrowphase_support import support_study
from game.lab.studies.skinning import collapse_study
from game.levels import level_files, load_level
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
# what is turned is nothing that the scene has, so that it has no place among the points
NO_PLACE = {"c02-joints"}
MEASURED = {"c02-collapse", "bounds-gap", "c07-speed", "c10", "c11-support", "c08", "c09"}
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
        assert study.name in NO_PLACE and study.no_place
        return
    level = load_level(level_files(name)[0], name, scene_type.content_type)
    scene = scene_type(level)
    scene.advance(scene.dt)
    setting = study.present({**scene.standing(), **scene.values, **dict.fromkeys(scene.effects.names, True)})
    assert isinstance(setting, Setting) and setting.knob > 0.0
    if study.name in MEASURED:  # a trial that no point of the study is like
        row = measure(study, setting, repeats=1)
        assert not row.failure and math.isfinite(row.error)


@pytest.mark.parametrize(
    ("study", "standing", "knobs"),
    [
        (collapse_study, {"bend": 0.0}, {"blend": "linear"}),
        (gap_study, {"gap": 0.0}, {"volume": "obb", "fit": "search"}),
        (vclip_study, {"corners": 0.0, "turn": 0.0}, {"coherence": True}),
        (support_study, {"corners": 0.0, "turn": 0.0}, {"coherence": True, "method": "climb"}),
    ],
    ids=lambda value: getattr(value, "name", ""),
)
def test_a_scene_that_has_no_place_is_told_so(study, standing, knobs):
    assert study.present({**standing, **knobs}) is None and study.no_place
    assert measure_present(study, {**standing, **knobs}) is None


def test_studies_of_a_scene_have_short_names_and_no_two_scenes_share_a_name_by_chance():
    known = {}
    for entry in CATALOGUE:
        family = entry.load().study.family
        shorts = [study.short for study in family]
        assert len(set(shorts)) == len(shorts)
        assert len(family) == 1 or all(short and short[0].isupper() for short in shorts), entry.name
        for study in family:
            assert known.setdefault(study.name, study) is study
