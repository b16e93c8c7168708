"""Controls that change nothing: grey, taking no hand and no key, with the reason in the tool tip."""

from __future__ import annotations

import pygame
import pytest

from game.stage import SetParameter, Stage
from game.ui.look.look import Look
from game.ui.look.theme import DARK, LIGHT
from game.ui.panel.panel import Panel
from game.ui.panel.slider import SliderRow
from game.ui.panel.switch import SwitchRow
from tests.ui.pointing import click, event, move
from tests.ui.sample_scene import Sample

RECT = pygame.Rect(960, 48, 320, 672)
WHY = "Nothing emits."


class Still(Sample):
    """While the ball keeps all its speed, four parameters of every kind do nothing."""

    name = "still"

    def why_idle(self, name):
        return WHY if self.restitution == 1.0 and name in ("rate", "shadow", "method", "order") else ""


class Desk:
    def __init__(self, theme=DARK):
        self.look = Look(theme)
        self.stage = Stage(Still)
        self.panel = Panel(self.look, Still)
        self.panel.place(RECT, self.look)
        self.surface = pygame.Surface((RECT.right, RECT.bottom), 0, 32)
        self.frame()

    def frame(self, dt=0.3):
        for _ in range(2):
            self.panel.update(dt, self.stage)
            self.panel.draw(self.surface)

    def set(self, **values):
        for name, value in values.items():
            self.stage.post(SetParameter(name, value))
        self.frame()

    def thing(self, name):
        sheet = self.panel._sheet
        return sheet.menus.get(name) or next(
            row for row in sheet.rows if row.follows == name and row.height >= 32
        )

    def place(self, name, x, y):
        thing = self.thing(name)
        self.panel._reveal((thing.rect.top, thing.rect.bottom))
        return RECT.x + thing.rect.x + x, RECT.y + thing.rect.y + y - self.panel.scroll

    def picture(self, name):
        thing = self.thing(name)
        return pygame.image.tobytes(self.panel._sheet.picture.subsurface(thing.rect), "RGB")


@pytest.fixture(params=(DARK, LIGHT), ids=("dark", "light"))
def desk(request):
    made = Desk(request.param)
    yield made
    made.panel.close()


PLACES = {"rate": (150, 30), "shadow": (30, 16), "method": (40, 16), "order": (100, 16)}


@pytest.mark.parametrize("name", PLACES)
def test_an_idle_control_is_grey_takes_no_hand_and_says_why(desk, name):
    lively = desk.picture(name)
    desk.set(restitution=1.0)
    assert desk.picture(name) != lively
    place = desk.place(name, *PLACES[name])
    assert click(desk.panel, place) == []
    assert not desk.panel.has_open_list and not desk.panel.typing
    desk.panel.handle(move(*place))
    assert desk.panel.tip()[0].startswith(WHY)
    desk.panel.handle(event(pygame.WINDOWLEAVE))
    desk.set(restitution=0.5)
    assert desk.picture(name) == lively
    desk.panel.handle(move(*place))
    assert not (desk.panel.tip() or ("",))[0].startswith(WHY)
    wishes = click(desk.panel, place)
    assert desk.panel.has_open_list if name == "order" else isinstance(wishes[0], SetParameter)


def test_the_keyboard_passes_over_idle_controls_and_leaves_one_that_falls_idle(desk):
    def reached():
        names = []
        while desk.panel.focus_next():
            names += [row.follows for row in desk.panel._sheet.rows if row.has_keys]
        return names

    assert {"rate", "shadow"} <= set(reached())
    slider = desk.thing("rate")
    assert isinstance(slider, SliderRow) and isinstance(desk.thing("shadow"), SwitchRow)
    slider.has_keys = True
    desk.set(restitution=1.0)
    assert desk.panel.handle(event(pygame.KEYDOWN, key=pygame.K_RIGHT, mod=0, unicode="")) == []
    assert not {"rate", "shadow", "method"} & set(reached())


def test_a_scene_that_says_nothing_has_no_idle_control():
    assert all(not Stage(Sample).scene.why_idle(name) for name in Sample.declared_parameters())
