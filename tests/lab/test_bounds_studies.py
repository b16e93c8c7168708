"""The studies of bounding volumes: what their curves must show."""

from __future__ import annotations

from dataclasses import replace

import pytest

from game.lab import Setting, fit_order, run_study
from game.lab.studies.bounds.fits import STEPS_DEGREES, box_study, capsule_study
from game.lab.studies.bounds.gap import gap_study
from game.scenes.bounds.capsules import Capsules
from game.scenes.bounds.oriented_boxes import OrientedBoxes


def at(study, knobs, methods=None):
    """The study with only these values of the knob, and these methods."""
    return replace(
        study,
        settings=lambda: [
            s for s in study.settings() if s.knob in knobs and (methods is None or s.method in methods)
        ],
    )


def test_the_search_for_a_box_is_of_first_order():
    table = run_study(at(box_study, STEPS_DEGREES[4:12]), repeats=1)
    assert fit_order(table.of("search")) == pytest.approx(1.0, abs=0.15)
    assert max(row.error for row in table.of("refined")) < 1e-8
    assert table.of("exact")[0].error == 0.0
    assert table.of("thinnest")[0].error > 1e-3
    assert table.of("principal")[0].error > 0.01
    assert not [row for row in table if row.failed]


def test_twice_the_tests_prove_half_the_gap_or_a_quarter():
    """Expected order 1 for axis-aligned boxes, 2 for boxes on the curve; by degrees that is lost."""
    table = run_study(gap_study, repeats=1)
    assert fit_order(table.of("aabb"), over="counter") == pytest.approx(1.0, abs=0.15)
    exact = fit_order(table.of("obb-exact"), over="counter")
    assert 1.85 <= exact <= 2.25
    assert 1.4 < fit_order(table.of("obb"), over="counter") < exact
    assert table.of("aabb", failed=True)
    least = {name: table.of(name)[-1].counter for name in ("obb-exact", "obb", "capsule")}
    assert (
        least["obb-exact"] < least["obb"] < least["capsule"] < 0.2 * table.of("aabb", failed=True)[-1].counter
    )


def test_a_finer_step_does_not_make_a_centred_capsule_the_least():
    table = run_study(at(capsule_study, (10.0, 1.0)), repeats=1)
    coarse, fine = (row.error for row in table.of("search"))
    assert fine < 0.5 * coarse
    rest = [row.error for row in table.of("refined")]
    assert min(rest) > 0.005 and max(rest) < 1.2 * min(rest)
    assert table.of("thinnest")[0].error > min(rest)
    assert table.of("exact")[0].error <= 1e-3


@pytest.mark.parametrize("scene_type", [OrientedBoxes, Capsules])
def test_the_present_point_is_that_of_the_scene(scene_type):
    scene = scene_type(parameters={"angle_step": 2.5})
    assert scene_type.study.present(scene.values) == Setting("search", 2.5)
    exact = scene_type.study.present({"fit": "exact", "angle_step": 2.5})
    assert exact.method == "exact"
    assert exact.method in {method.name for method in scene_type.study.methods}
    for study in (scene_type.study, *scene_type.study.related):
        for setting in study.settings():
            scene_type(parameters=dict(setting.scene))
