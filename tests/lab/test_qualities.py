"""The qualities that scenes offer are marked in what accuracy costs them."""

from __future__ import annotations

import pytest

from game.lab.runner import StudyTable
from game.lab.studies.dominoes import domino_study
from game.lab.studies.loops import loop_study
from game.lab.studies.marbles import marble_study
from game.lab.studies.stacks import race_study, stack_study
from game.lab.study import Row
from game.physics.solids import TIERS
from game.ui.charts.accuracy_study import study_data

STUDIES = (stack_study, race_study, domino_study, marble_study, loop_study)


def rows_of(study):
    for place, setting in enumerate(study.settings()):
        cost, others = 1e-3 * (1 + place), dict(setting.others)
        yield Row(setting.method, setting.knob, 1e-2 / (1 + place), cost, 1, "", others, dict(setting.scene))


@pytest.mark.parametrize("study", STUDIES, ids=lambda study: study.name)
def test_each_quality_is_marked_once_at_its_substeps(study):
    marked = {study.mark(row): row for row in rows_of(study) if study.mark(row)}
    assert {name.lower(): row.scene["substeps"] for name, row in marked.items()} == TIERS
    assert all(row.scene.get("tier") == "own" for row in marked.values())


def test_the_page_shows_the_marks_beside_their_points():
    table = StudyTable(stack_study, list(rows_of(stack_study)))
    marks = [point.mark for one in study_data(table, "Solids").series for point in one.points if point.mark]
    assert marks == ["Play", "Teach", "Film"]
