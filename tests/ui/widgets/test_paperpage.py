"""The page of a paper: it shows what has been measured so far, and its links ask for what they name."""

from __future__ import annotations

import pygame
import pytest

from game.ui.widgets.paper import Comparison, Paper, PaperRow, Step
from game.ui.widgets.paperpage import PaperPage, cuts_of
from game.ui.widgets.wishes import Wish
from tests.ui.pointing import click

ROW = PaperRow("P99", "On a method", "Somebody", 2001, "c01", "", "nowhere:PAGE")
PAPER = Paper(
    ("A problem.",), ("An idea.",),
    (Step("A step.", lambda pen: pen.disc(60.0, 60.0, 20.0, "amber"), "x = 1"),),
    ("They showed it.",), lambda: iter(()), ("A limit.",), ("Later.",),
)  # fmt: skip


def page_of(look, size=(1280, 720)) -> PaperPage:
    page = PaperPage(look, ROW, PAPER, [("open", "Open C01")])
    page.place(pygame.Rect(0, 0, *size), look)
    page.update(1.0)
    return page


def picture(page: PaperPage, size=(1280, 720)) -> bytes:
    surface = pygame.Surface(size, 0, 32)
    page.draw(surface)
    return pygame.image.tobytes(surface, "RGB")


def test_the_page_shows_what_has_been_measured_so_far(look):
    page = page_of(look)
    pictures = []
    for count in (0, 1, 2):
        page.show([Comparison("a", "1", "2")] * count, "" if count == 2 else "measuring ...")
        pictures.append(picture(page))
    assert len(set(pictures)) == 3
    page.show([Comparison("a", "1", "2")] * 2, "")
    assert picture(page) == pictures[2]


def test_a_link_asks_for_what_it_names_and_leaves_where_there_is_no_space(look):
    page = page_of(look)
    assert click(page, page.spots.find("open").rect.center) == Wish("open")
    narrow = page_of(look, (200, 300))
    assert narrow.spots.find("open") is None and picture(narrow, (200, 300))


def test_the_page_in_any_window(any_look):
    for size in ((1, 1), (90, 60), (700, 500), (1920, 1080)):
        page = PaperPage(any_look, ROW, PAPER)
        page.place(pygame.Rect(0, 0, *size), any_look)
        page.update(1.0)
        assert picture(page, size)


@pytest.mark.parametrize(
    ("heights", "columns", "cuts"),
    [
        ([3, 3, 3], 3, (1, 2)),
        ([5, 1, 1, 1, 5, 2], 3, (3, 5)),
        ([9, 1, 1], 2, (1,)),
        ([4], 3, (1, 1)),
        ([], 2, (0,)),
        ([2, 2, 2, 2], 1, ()),
        ([1, 8, 1, 1], 3, (1, 2)),
    ],
)
def test_the_highest_column_is_as_low_as_can_be(heights, columns, cuts):
    assert cuts_of(heights, columns) == cuts


def bottoms(page: PaperPage, monkeypatch) -> list[int]:
    """Where the columns of a page end, px."""
    made = []
    even = page.even_columns
    monkeypatch.setattr(page, "even_columns", lambda sheet: made.append(even(sheet)) or made[-1])
    page.write(None)
    return [column.y for column in made[-1]]


def test_its_columns_are_filled_alike(look, monkeypatch):
    page = page_of(look)
    page.paper = PAPER._replace(steps=PAPER.steps * 5, limits=("Some words. " * 20,) * 3)
    page.show([Comparison("what is compared here", "1", "2")] * 6, "")
    ends = bottoms(page, monkeypatch)
    assert len(ends) == 3
    assert max(ends) - min(ends) < 330  # a step with its figure, which is not cut


def test_nothing_jumps_while_it_is_measured(look, monkeypatch):
    page = page_of(look)
    page.show((), "measuring ...")
    before = bottoms(page, monkeypatch)
    page.show([Comparison("a", "1", "2")] * 20, "measuring ...")
    after = bottoms(page, monkeypatch)
    assert after[:2] == before[:2] and after[2] > before[2]
    page.show([Comparison("a", "1", "2")] * 20, "")
    assert max(bottoms(page, monkeypatch)) < after[2]
