"""The list of papers, and the page of each that is done: it loads, draws and measures."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path

import numpy as np
import pygame
import pytest

from game.levels import level_files
from game.scenes import CATALOGUE
from game.scenes.deformables.paper import mirrored_share
from game.scenes.depth.figure import descent
from game.scenes.papers import PAPERS, papers_of
from game.scenes.solids.paper import slid
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.look import Look
from game.ui.look.theme import DARK, LIGHT
from game.ui.text.formula import render_formula
from game.ui.widgets.paper import Comparison

DONE = [row for row in PAPERS if row.done]


def test_all_48_rows_stand_in_their_order():
    assert [row.number for row in PAPERS] == [f"P{number:02}" for number in range(1, 49)]
    assert all(row.title and row.authors and 1990 <= row.year <= 2015 for row in PAPERS)
    assert all(bool(row.scene) == bool(row.page) for row in PAPERS)


@pytest.mark.parametrize("row", DONE, ids=lambda row: row.number)
def test_a_paper_that_is_done_has_its_scene_its_level_and_its_page(row):
    entry = CATALOGUE[row.scene]
    assert row in papers_of(entry.name)
    assert not row.level or row.level in [path.stem for path in level_files(entry.name)]
    paper = row.load()
    for part in (paper.problem, paper.idea, paper.steps, paper.showed, paper.limits, paper.after):
        assert part
    assert [number for number, step in enumerate(paper.steps, 1) if step.figure is None] == []


@pytest.mark.parametrize("row", DONE, ids=lambda row: row.number)
def test_its_figures_lie_in_their_frame_and_its_formulas_can_be_read(row):
    for look in (Look(DARK, 1.0), Look(LIGHT, 1.5)):
        for step in row.load().steps:
            if step.formula:
                assert render_formula(look.fonts, step.formula, look.theme.text1, 14.0).get_width() > 0
            if step.figure is None:
                continue
            pen = Pen((round(FIGURE[0] * look.k), round(FIGURE[1] * look.k)), look, FIGURE)
            pen.fill("stage")
            step.figure(pen)
            frame = pygame.Rect((0, 0), pen.size)
            assert all(frame.contains(place) for place in pen.word_places()), step.words
            shown = pygame.transform.average_color(pen.finished())
            assert tuple(shown)[:3] != tuple(look.color("stage"))[:3]


@pytest.mark.parametrize("row", DONE, ids=lambda row: row.number)
def test_what_its_page_compares_is_measured(row):
    found = list(row.load().measure())
    assert found and all(isinstance(one, Comparison) and one.what and one.ours for one in found)
    assert not any(word in one.ours for one in found for word in ("nan", "inf", "none"))


@pytest.mark.parametrize("row", DONE, ids=lambda row: row.number)
def test_its_costs_are_those_of_its_own_thread(row):
    """The window draws beside it, and would be counted."""
    folder = Path(import_module(row.page.partition(":")[0]).__file__).parent
    pages = folder.glob("measuring.py")
    for path in (Path(import_module(row.page.partition(":")[0]).__file__), *pages):
        names = {node.id for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Name)}
        assert not names & {"process_time", "perf_counter", "monotonic"}, path.name


def test_a_block_that_slides_is_held_against_the_law():
    """Of first order: velocities are the law's, and places lag by half a step of them."""
    for steps in (60, 240):
        assert slid(steps) == pytest.approx(1.0 / steps, rel=1e-3)


def test_a_third_of_the_cells_share_the_slot_of_their_mirror_image():
    """Those whose two products end in as many zero bits: the sum of 1 / 4^k."""
    assert mirrored_share() == pytest.approx(1.0 / 3.0, abs=0.02)


def test_going_to_the_lower_neighbour_ends_in_the_valley_where_it_began():
    valleys = np.array((3.0, 1.0, 2.0, 4.0, 2.5, 0.5, 0.8))
    assert [descent(valleys, i) for i in range(7)] == [1, 1, 1, 1, 5, 5, 5]
