"""The study page of every scene, drawn after every row of its study, whatever the rows are."""

from __future__ import annotations

import dataclasses
import math

import pygame
import pytest

from game.lab import Row, Setting, Study, StudyTable
from game.scenes import CATALOGUE
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_study import study_data
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

SIZE = (640, 400)  # px; small, as there are thousands of pages
STUDIES = {study.name: study for entry in CATALOGUE for study in entry.load().study.family}
ODD = (0.0, float("nan"), 1e9, 1e-3, 1e-3)  # errors: none, no number, beyond all measure, ties
SOON, SELDOM = (
    40,
    12,
)  # pages of the first rows are all drawn, then one in so many


@pytest.fixture(scope="module")
def look() -> Look:
    pygame.font.init()
    return Look(theme_named("dark"), 1.0, less_motion=True)


def made_up(setting: Setting, i: int) -> Row:
    """A row on a line, so that those to come can be placed, which may tie; now and then an odd one."""
    error, cost = setting.knob, 1e-6 / setting.knob
    if i % 5 == 4:
        error, cost = ODD[i // 5 % len(ODD)], 1e-6
    failure = "made up" if i % 11 == 10 or math.isnan(error) else ""
    others, scene = dict(setting.others), dict(setting.scene)
    return Row(setting.method, setting.knob, error, cost, 1 + i % 97, failure, others, scene)


@pytest.mark.parametrize("name", STUDIES)
def test_the_study_page_of_every_scene_is_drawn_after_every_row_of_its_study(name: str, look: Look):
    """Points that tie in cost and error differ in what they set the scene to alone, which has no order."""
    study = STUDIES[name]
    table = StudyTable(study)
    page = AccuracyPage(look, study_data(table, "Scene"))
    surface = pygame.Surface(SIZE, 0, 32)
    page.place(surface.get_rect(), look)
    settings = list(study.settings())
    drawn = 0
    for i, setting in enumerate(settings):
        table.rows.append(made_up(setting, i))
        if i < SOON or i % SELDOM == 0 or i == len(settings) - 1:
            data = study_data(table, "Scene", table.rows[i // 2])
            for one in data.series:
                coming = [point.x for point in one.points if point.pending]
                assert coming == sorted(coming)
            page.show(data)
            page.update(1.0)
            page.draw(surface)
            drawn += 1
    assert drawn >= min(len(settings), SOON)


def test_estimates_that_tie_are_put_in_a_row():
    """The study of the lecture's table has two numbers of passes at each step."""
    study = STUDIES["lecture-table"]
    first = [s for s in study.settings() if s.method == "lecture"][:6]
    rows = [made_up(setting, 0) for setting in first]
    data = study_data(StudyTable(study, rows), "Scene")
    few = {"name": "few", "settings": lambda: few_of(study)}
    data = study_data(StudyTable(dataclasses.replace(study, **few), rows), "Scene")
    lecture = next(one for one in data.series if one.name == "As in the lecture")
    coming = [(point.x, point.y) for point in lecture.points if point.pending]
    assert len(coming) > len(set(coming)) > 1


def few_of(study: Study) -> list[Setting]:
    """So few of its settings that those to come are shown."""
    return [setting for setting in study.settings() if setting.method == "lecture"][:16]
