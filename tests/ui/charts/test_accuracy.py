"""The accuracy overlay's words: nothing of what a study or its methods are called is cut off."""

import pygame
import pytest

from game.lab import StudyTable
from game.scenes import CATALOGUE
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_data import Progress
from game.ui.charts.accuracy_study import study_data
from game.ui.look.fonts import FontBook
from game.ui.look.look import Look
from game.ui.look.theme import DARK

LEVEL = "Hard: a level of thirty letters"


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_no_word_of_a_study_is_cut_off(name, monkeypatch):
    pygame.font.init()
    cut = []
    fit = FontBook.fit

    def note(fonts, text, size, weight, width):
        shown = fit(fonts, text, size, weight, width)
        if shown != text:
            cut.append(text)
        return shown

    monkeypatch.setattr(FontBook, "fit", note)
    look = Look(DARK)
    study = CATALOGUE[name].load().study
    for one in study.family if study is not None else ():
        data = study_data(StudyTable(one), f"{one.title}, {LEVEL}")
        page = AccuracyPage(look, data._replace(rows=tuple(row._replace(order=1.23) for row in data.rows)))
        page.place(pygame.Rect(0, 0, 1280, 720), look)
        page.picture()
    assert cut == []


def test_runs_can_be_stopped_and_what_is_done_saved():
    pygame.font.init()
    look = Look(DARK)
    study = CATALOGUE["c04"].load().study
    page = AccuracyPage(look, study_data(StudyTable(study), LEVEL))
    page.place(pygame.Rect(0, 0, 1280, 720), look)

    def enabled(*progress) -> set[str]:
        page.report(Progress(*progress))
        return {spot.name for spot in page.spots.spots if spot.enabled} & {"stop", "save-csv", "save-picture"}

    assert enabled() == set()
    assert enabled(0, 9, "", 1.0, True) == {"stop"}
    assert enabled(4, 9, "", 1.0, True) == {"stop", "save-csv", "save-picture"}
    assert enabled(9, 9) == {"save-csv", "save-picture"}
