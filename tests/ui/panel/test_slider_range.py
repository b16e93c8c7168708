"""A slider that spans a part of its range: drags and arrows stay in it, the typed field takes all."""

from __future__ import annotations

import pygame
import pytest

from game.stage import SetParameter, Stage, Toggle
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.panel.panel import Panel
from game.ui.panel.slider import SliderRow, share_of, value_at
from tests.ui.pointing import click, event, press
from tests.ui.sample_scene import Sample

RECT = pygame.Rect(960, 48, 320, 672)
ENDS = {"restitution": (0.25, 0.75), "stiffness": (100.0, 1e4)}
START, END = 24, 296  # px: the ends of the track


class Near(Sample):
    """Two sliders span a part of what may be typed; one switch has its control elsewhere."""

    name = "near"
    playing = Toggle(True, label="Play", group="Shown", in_panel=False)

    def slider_range(self, name):
        return ENDS.get(name)


class Desk:
    def __init__(self):
        self.stage = Stage(Near)
        self.panel = Panel(Look(DARK), Near)
        self.panel.place(RECT, self.panel.look)
        self.surface = pygame.Surface((RECT.right, RECT.bottom), 0, 32)
        self.frame()

    def frame(self):
        self.panel.update(0.4, self.stage)
        self.panel.draw(self.surface)

    def row(self, name):
        rows = [row for row in self.panel._sheet.rows if isinstance(row, SliderRow) and row.follows == name]
        self.panel._reveal((rows[0].rect.top, rows[0].rect.bottom))
        return rows[0]

    def place(self, name, x, y=30):
        row = self.row(name)
        return RECT.x + x, RECT.y + row.rect.y + y - self.panel.scroll

    def set(self, **values):
        for name, value in values.items():
            self.stage.post(SetParameter(name, value))
        self.frame()


@pytest.fixture
def desk():
    made = Desk()
    yield made
    made.panel.close()


@pytest.mark.parametrize("name", sorted(ENDS))
def test_the_ends_of_the_track_are_those_of_the_part(desk, name):
    low, high = ENDS[name]
    desk.set(restitution=0.3)
    assert click(desk.panel, desk.place(name, START)) == [SetParameter(name, low)]
    assert click(desk.panel, desk.place(name, END)) == [SetParameter(name, high)]
    middle = 0.5 if name == "restitution" else 1e3
    wishes = click(desk.panel, desk.place(name, (START + END) // 2))
    assert wishes[0].value == pytest.approx(middle, rel=0.02)


def test_any_value_of_the_range_is_typed_and_the_grip_stands_at_the_end(desk):
    click(desk.panel, desk.place("restitution", 262, 10))
    for letter in "0.9":
        desk.panel.handle(event(pygame.TEXTINPUT, text=letter))
    desk.frame()
    wishes = desk.panel.handle(press(pygame.K_RETURN))
    assert wishes == [SetParameter("restitution", 0.9)]
    desk.set(restitution=0.9)
    assert desk.row("restitution").value == 0.9
    assert share_of(Near.restitution, 0.9, ENDS["restitution"]) == 1.0


def test_arrows_stay_in_the_part_but_do_not_fetch_a_value_from_outside(desk):
    row = desk.row("restitution")
    desk.set(restitution=0.75)
    sent = []
    row.context = row.context._replace(send=sent.append)
    row.key(pygame.K_RIGHT)
    assert sent == []
    row.key(pygame.K_LEFT)
    assert 0.7 <= sent.pop().value < 0.75
    desk.set(restitution=0.9)
    row.key(pygame.K_LEFT)
    assert 0.85 <= sent.pop().value < 0.9


def test_a_part_beyond_the_range_is_cut_to_it_and_an_empty_one_is_none():
    assert value_at(Near.restitution, 1.0, (0.5, 7.0)) == 1.0
    assert value_at(Near.restitution, 0.0, (3.0, 7.0)) == 0.0
    assert share_of(Near.restitution, 0.5, (2.0, 2.0)) == 0.5


def test_a_parameter_whose_control_is_elsewhere_has_no_row(desk):
    followed = {row.follows for row in desk.panel._sheet.rows}
    assert "playing" in Near.declared_parameters() and "playing" not in followed
    assert "shadow" in followed
