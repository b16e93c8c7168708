"""The list of papers and a paper's page in the window, as a person goes through them."""

from __future__ import annotations

import pygame
import pytest

from game.app.fuzz.driver import LONGEST_LOAD_S
from game.app.scene.help_card import HelpCard
from game.app.scene.screen import SceneScreen
from game.app.screens.paper_card import PaperCard
from game.app.screens.papers_card import PapersCard
from game.scenes import CATALOGUE
from game.scenes.papers import PAPERS
from game.ui.widgets.paper import Comparison, PaperRow
from tests.app.tests_app import Driver
from tests.app.window.test_guard import message_of

P48 = next(row for row in PAPERS if row.number == "P48")


@pytest.fixture
def program(tmp_path) -> Driver:
    return Driver(tmp_path, (1280, 720), CATALOGUE)


@pytest.fixture
def quick(monkeypatch):
    """Nothing of a page is measured but what the test gives."""
    load = PaperRow.load

    def measured():
        yield Comparison("size", "1", "2")

    monkeypatch.setattr(PaperRow, "load", lambda row: load(row)._replace(measure=measured))


def test_the_list_opens_by_key_and_button_and_names_what_is_to_come(program: Driver, quick):
    program.frames(5)
    program.key(pygame.K_F4)
    program.frames(30)
    card = program.top
    assert isinstance(card, PapersCard) and len(card.rows) == 48
    program.key(pygame.K_F4)
    assert program.top is card  # not over itself
    program.key(pygame.K_END)
    program.key(pygame.K_RETURN)
    program.frames(30)
    assert not isinstance(program.top, PaperCard)
    assert message_of(program).startswith("P47 is not done yet")
    header = program.top.header.spots.find("papers")
    program.click(*header.rect.center)
    program.frames(30)
    assert isinstance(program.top, PapersCard)
    program.key(pygame.K_HOME)
    program.key(pygame.K_RETURN)
    program.frames(30)
    assert isinstance(program.top, PaperCard)
    program.key(pygame.K_ESCAPE)
    program.frames(30)
    assert not isinstance(program.top, PaperCard)


def test_a_page_leads_to_its_scene_and_the_scene_s_help_to_the_page(program: Driver, quick):
    program.frames(5)
    program.app.cards.open_paper(P48)
    program.frames(30)
    page = program.top
    assert isinstance(page, PaperCard)
    page.measuring.wait()
    program.frames(2)
    program.click(*page.page.spots.find("open").rect.center)
    program.frames(30)
    assert isinstance(program.top, SceneScreen) and program.top.entry.name == "c01"
    if program.top.loader is not None:
        program.top.loader.wait(LONGEST_LOAD_S)
    program.frames(5)
    program.key(pygame.K_F1)
    program.frames(30)
    assert isinstance(program.top, HelpCard)
    program.click(*program.top.page.spots.find("P48").rect.center)
    program.frames(30)
    assert isinstance(program.top, PaperCard) and program.top.row == P48


def test_a_measurement_that_fails_is_told_on_the_page(program: Driver, monkeypatch):
    load = PaperRow.load

    def fails():
        yield Comparison("size", "1", "2")
        raise ValueError("no room")

    monkeypatch.setattr(PaperRow, "load", lambda row: load(row)._replace(measure=fails))
    program.frames(5)
    program.app.cards.open_paper(P48)
    program.top.measuring.wait()
    program.frames(3)
    assert program.top.page.note == "Not measured: no room" and len(program.top.page.compared) == 1
