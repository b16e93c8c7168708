"""Every study of every scene: its points can be opened in the scene, and the scene finds its own place."""

from __future__ import annotations

import math
from typing import Any

import pytest

from game.lab import Setting, measure, measure_present
from game.lab.studies.animation.skinning import collapse_study
from game.lab.studies.narrowphase.distance import gjk_study, vclip_study
from game.lab.studies.narrowphase.support import support_study
from game.levels import level_files, load_level
from game.scenes import CATALOGUE
from game.stage import SetEffect, SetParameter
from game.stage.checks.validation import checked_event

# methods that the scene does not have: its points are not to be clicked
ELSEWHERE = {
    "lecture-table": {"events"},
    "lecture-two-balls": {"events"},
    "real-table": {"lecture"},
    "three-tables": {"exact"},
    "three-tables-lossless": {"exact"},
    "c08": {"principal"},
    "p22": {"random"},
    "depth-with-rotation": {"translation"},
    "carom-chances": {"stepped", "lecture"},
    "snooker-long-pot": {"geometry"},
    "dam": {"shallow"},
    "valley": {"dfsph", "shallow"},
    "splash-blend": {"plain"},
}
# what is turned is nothing that the scene has, so that it has no place among the points
NO_PLACE = {"c02-joints", "c01", "c01-uneven", "bounds-gap", "solver-race"}
MEASURED = {"c02-collapse", "c07-speed", "c10", "c11", "c11-support", "c08", "c09", "c14", "c14-swing", "c15"}
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
    effects, known = scene_type.effects.names, scene_type.declared_parameters()
    without = set()
    for setting in study.settings():
        if not setting.scene:
            without.add(setting.method)
        for key, value in setting.scene.items():
            assert key in known or key in effects, f"{study.name}: {name} knows no {key}"
            event = SetParameter(key, value) if key in known else SetEffect(key, value)
            assert checked_event(event, scene_type) == event
    assert without == ELSEWHERE.get(study.name, set())


# knobs that count what is divided, or how much is taken into account: more of it is finer
PARTS = {
    *("cells", "substeps", "steps", "turns", "chords", "window", "work", "budget", "iterations", "passes"),
    *("samples", "keys", "joints", "influences", "angles", "rounds", "meshes"),
}


@pytest.mark.parametrize(("name", "number"), CASES)
def test_a_knob_that_counts_parts_says_so(name: str, number: int):
    """Else its order would come out with the wrong sign, and points before a failure be fitted."""
    _, study = study_of(name, number)
    if study.axes.up == "error":
        assert study.knob.parts == (study.knob.name in PARTS)


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
    setting = study.present(scene.chosen())
    assert isinstance(setting, Setting) and setting.knob > 0.0
    study.trial(setting).reset()  # a method or a solver that there is not is refused here
    if study.name in MEASURED:  # a trial that no point of the study is like
        row = measure(study, setting, repeats=1)
        assert not row.failure and math.isfinite(row.error)


@pytest.mark.parametrize(
    ("study", "standing", "knobs"),
    [
        (collapse_study, {"bend": 0.0}, {"blend": "linear"}),
        (vclip_study, {"corners": 0.0, "turn": 0.0, "round": 0.0}, {"coherence": True}),
        (gjk_study, {"corners": 0.0, "turn": 0.0, "round": 0.0}, {"exponent": -3.0, "method": "climb"}),
        (support_study, {"corners": 0.0, "turn": 0.0}, {"coherence": True, "method": "climb"}),
    ],
    ids=lambda value: getattr(value, "name", ""),
)
def test_a_scene_that_has_no_place_is_told_so(study, standing, knobs):
    assert study.present({**standing, **knobs}) is None and study.no_place
    assert measure_present(study, {**standing, **knobs}) is None
    assert study.place({**standing, **knobs}) == (None, study.no_place)


def parameters_of(scene) -> dict[str, Any]:
    """What the accuracy page asks a study with."""
    return scene.chosen()


@pytest.mark.parametrize(("name", "number"), CASES)
def test_a_study_tells_what_it_is_measured_on(name: str, number: int):
    """And a mark is of the scene only where the scene has the very workload."""
    scene_type, study = study_of(name, number)
    assert study.workload.words
    for file in level_files(name)[:3]:
        scene = scene_type(load_level(file, name, scene_type.content_type))
        setting, words = study.place(parameters_of(scene))
        if study.workload.words not in words:
            assert setting is None and words == study.no_place
        elif setting is None:
            assert study.present is None or study.workload.own(parameters_of(scene)) in words
        else:
            assert "own" not in words or study.workload.own is None


@pytest.mark.parametrize(
    ("name", "short", "words"),
    [
        ("c05", "Missed pairs", "400 equal boxes at 4 m/s"),
        ("c05", "Cell size", "3000 equal boxes"),
        ("c06", "Missed pairs", "400 equal boxes at 4 m/s"),
        ("c06", "Size ratio", "3000 boxes, 20 of them large"),
        ("c07", "Missed pairs", "400 equal boxes at 4 m/s"),
        ("c07", "Swaps", "1000 equal boxes"),
        ("c07", "Speed", "1000 equal boxes"),
        ("broad-phase-race", "Number", "equal boxes, density 0.375"),
    ],
)
def test_boxes_have_a_mark_only_where_they_are_those_of_the_study(name: str, short: str, words: str):
    scene_type = CATALOGUE[name].load()
    study = next(one for one in scene_type.study.family if one.short == short)
    default = load_level(level_files(name)[0], name, scene_type.content_type)
    setting, said = study.place(parameters_of(scene_type(default)))
    assert setting is None and said.startswith(f"No mark: measured on {words}")
    point = next(one for one in study.settings() if one.method != "exact")
    scene = scene_type(None, {**scene_type(None).values, **point.scene})
    setting, said = study.place(parameters_of(scene))
    assert setting is not None and said.startswith(f"Measured on {words}")
    assert study.place({**parameters_of(scene), "listed": 1.0})[0] is None
    assert study.place({**parameters_of(scene), "box-motion": False})[0] is None


def test_a_pair_of_polygons_has_a_mark_only_where_it_has_the_corners_of_the_study():
    scene_type = CATALOGUE["c11"].load()
    for file in level_files("c11"):
        scene = scene_type(load_level(file, "c11", scene_type.content_type))
        corners = [len(shape) for shape in (scene.model.shape(0), scene.model.shape(1)) if shape is not None]
        setting, words = gjk_study.place(parameters_of(scene))
        if len(corners) < 2 or max(corners) < 3:  # one is refused, or both are segments
            assert setting is None and words == gjk_study.no_place
        elif max(corners) in (8, 64, 512):
            assert setting.method == f"corners-{max(corners)}"
        else:
            assert setting is None and f"your scene has {max(corners)}" in words


@pytest.mark.parametrize(
    ("name", "short", "changed", "method"),
    [
        ("c14", "Swing", {"scheme": "euler", "iterations": 1}, "euler"),
        ("c14", "Swing", {"scheme": "euler", "substeps": 1, "iterations": 7}, "euler-sweeps"),
        ("c14", "Swing", {"scheme": "euler", "substeps": 3, "iterations": 7}, "present"),
        ("c14", "Swing", {"scheme": "bdf2", "solver": "gauss-seidel", "iterations": 1}, "bdf2"),
        ("c14", "Hanging", {"substeps": 8, "iterations": 1, "relaxation": 1.0}, "substeps"),
        ("c14", "Hanging", {"substeps": 3, "iterations": 7, "relaxation": 1.0}, "present"),
        ("c15", "", {"model": "xpbd", "scheme": "euler", "iterations": 1}, "xpbd"),
        ("c15", "", {"model": "xpbd", "scheme": "euler", "iterations": 5}, "present"),
        ("c15", "", {"model": "pbd-even", "scheme": "euler", "iterations": 4}, "pbd-even"),
        ("lecture-table", "Carom", {"order": "joint", "substeps": 3}, "present"),
        ("lecture-table", "Symmetry", {"order": "joint", "substeps": 1, "passes": 4}, "joint"),
        ("lecture-table", "Symmetry", {"order": "joint", "substeps": 2, "passes": 4}, "present"),
    ],
)
def test_settings_are_named_by_the_method_that_they_are(name, short, changed, method):
    """By none of the study's, where they are of none."""
    scene_type = CATALOGUE[name].load()
    study = next(one for one in scene_type.study.family if one.short == short)
    values = {**parameters_of(scene_type(None)), "solver": "gauss-seidel", **changed}
    setting, words = study.place(values)
    assert setting.method == method and words.endswith("with your settings.")


def test_studies_of_a_scene_have_short_names_and_no_two_scenes_share_a_name_by_chance():
    known = {}
    for entry in CATALOGUE:
        family = entry.load().study.family
        shorts = [study.short for study in family]
        assert len(set(shorts)) == len(shorts)
        assert len(family) == 1 or all(short and short[0].isupper() for short in shorts), entry.name
        for study in family:
            assert known.setdefault(study.name, study) is study
