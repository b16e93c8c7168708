"""A table's furnishing: cloth and pockets act on the strokes, the colour on the picture alone."""

from __future__ import annotations

import itertools

import pygame
import pytest

from game.billiards.table.table import Table
from game.scenes.shared.tables.furnishing.choices import CAROM_FELT_NAMES, FELT_NAMES, HOUSE
from game.scenes.shared.tables.furnishing.felts import FELTS
from game.stage import SetParameter
from game.ui.look.theme import BALL_COLORS, CAROM_COLORS, FELT_COOL, FELT_LINE, FELT_WARM, SNOOKER_COLORS
from tests.scenes.billiards import billiards_stages as pool
from tests.scenes.snooker import snooker_stages as snooker
from tests.ui.look.colorimetry import difference, lab
from tests.ui.look.test_theme import luminance

TABLES = {
    "billiards": (pool.open_level, "nine-ball", Table.pool),
    "snooker": (lambda _: snooker.open_level(), "", Table.snooker),
}


@pytest.mark.parametrize("name", TABLES)
def test_a_table_is_faster_or_tighter_from_the_next_stroke_on(name):
    opened, level, kind = TABLES[name]
    stage = opened(level)
    usual = stage.scene.model.frame
    stage.post(SetParameter("table", "fast"))
    stage.run(1)
    fast = stage.scene.model.frame
    assert fast.physics.rolling < 0.7 * usual.physics.rolling
    assert (fast.table.jaws == usual.table.jaws).all()
    stage.post(SetParameter("table", "tight"))
    stage.run(1)
    tight = stage.scene.model.frame
    assert tight.physics == usual.physics
    assert tight.conditions != usual.conditions != fast.conditions
    assert (tight.table.jaws == kind(tight=True).jaws).all()
    assert not (tight.table.jaws == usual.table.jaws).all()


@pytest.mark.parametrize("name", TABLES)
def test_the_colour_of_the_cloth_changes_no_ball(name):
    opened, level, _ = TABLES[name]
    stage = opened(level)
    digest = stage.digest()
    stage.scene.parameters.felt = "olive"
    assert stage.digest() == digest


def contrast(a, b):
    """Of WCAG 2."""
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("felt", FELTS)
def test_lines_and_balls_are_seen_on_each_cloth(felt):
    color = FELTS[felt]
    assert min(contrast(color, ink) for ink in (FELT_LINE, FELT_WARM, FELT_COOL)) >= 3.0
    for balls in (BALL_COLORS[:9], CAROM_COLORS, SNOOKER_COLORS):
        assert min(difference(lab(color, "normal"), lab(ball, "normal")) for ball in balls) >= 10.0


def test_every_name_has_its_own_colour():
    assert {*FELT_NAMES} == {HOUSE, *FELTS}
    assert {*CAROM_FELT_NAMES} == {"green", *FELTS}
    assert all(pygame.Color(a) != pygame.Color(b) for a, b in itertools.combinations(FELTS.values(), 2))
