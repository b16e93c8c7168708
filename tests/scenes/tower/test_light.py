"""Light on the tower by night, in dust and in a heap; what is heard when nothing falls."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.fields import GRAVITY
from game.scenes.tower.air import AIR, DIMS, LAMP_RISES, LAMPS_AT, TowerAir
from game.scenes.tower.building import RUBBLE, SLAB, column_place, floor_height
from game.scenes.tower.level import TowerContent
from game.scenes.tower.scene import Tower
from game.scenes.tower.site import DAY, NIGHT, lamplight, lit
from game.scenes.tower.view import DARKEST, FLASH_S, _in_the_heap, flashes_of, packs_of
from game.stage import Stage

SMALL = TowerContent(storeys=6, bays=2, first=3)


def test_lamps_light_what_is_low_more_and_nothing_by_day():
    inks, heights = np.full(3, 0x404040), np.array([0.0, LAMP_RISES, 40.0])
    red = lit(NIGHT, inks, heights) >> 16
    assert red[0] > red[1] > red[2] > 0x40
    assert (lit(DAY, inks, heights) == inks).all()
    assert lamplight(NIGHT, LAMP_RISES) == pytest.approx(2.0**-0.75)


def test_dust_is_lit_at_its_rim_and_dark_where_the_light_has_gone_through_more_of_it():
    """Even dust between the lamps: at the middle exp(-density times way over DIMS) is left (Lambert)."""
    air = TowerAir(SMALL, GRAVITY | AIR)
    h, nx = air.grid.cell, air.grid.shape[1]
    clear = air._lit_by_lamps()
    assert clear == pytest.approx(clear[:, ::-1]) and clear[0].max() == pytest.approx(1.0)
    assert (np.diff(clear[:, nx // 2]) < 0.0).all()
    air.density[0] = 0.1
    row = air._lit_by_lamps()[0]
    lamp = round((LAMPS_AT - 0.5 * h) / h)
    assert row[nx // 2] == pytest.approx(np.exp(-0.1 * LAMPS_AT / DIMS), rel=0.1)
    assert row[nx // 2] < row[nx // 2 + lamp // 2] < row[nx // 2 + lamp - 1]
    assert row == pytest.approx(row[::-1], rel=0.1)


def test_a_heap_is_darker_below_and_floors_that_stand_are_not():
    places = np.array([[0.5, 0.3], [0.5, 3.0], [0.5, 6.0], [7.5, 0.3], [0.5, 0.2]])
    found = _in_the_heap(places, np.array([RUBBLE, RUBBLE, RUBBLE, RUBBLE, SLAB]))
    assert DARKEST > found[0] > found[1] > found[2] == 0.0 == found[3] == found[4]


def test_it_is_never_wholly_silent():
    steady = Stage(Tower).scene.hearing().steady
    assert [one.kind for one in steady] == ["room", "wind"] and steady[0].level > 0.0 == steady[1].level


def test_a_charge_lies_on_each_column_that_is_cut_first_until_it_goes_off_and_its_light_dies_away():
    stage = Stage(Tower)
    model = stage.scene.model
    content, delay = model.content, model.parameters.delay
    x = [column_place(content, k) for k in range(content.bays + 1)]
    assert sorted(packs_of(model)[:, 0]) == pytest.approx(x)
    assert (packs_of(model)[:, 1] < floor_height(content, model.first_storey())).all()
    assert not len(flashes_of(model)[0])
    model.fire()
    stage.run(1)
    places, left = flashes_of(model)
    assert places[:, 0] == pytest.approx(x[:1]) and left[0] > math.exp(-2.0 * stage.dt / FLASH_S)
    assert sorted(packs_of(model)[:, 0]) == pytest.approx(x[1:])
    stage.run(round(delay * content.bays / stage.dt) + 1)
    places, left = flashes_of(model)
    assert not len(packs_of(model)) and places[-1, 0] == pytest.approx(x[-1])
    assert (np.diff(left) > 0.0).all() and left[-1] / left[-2] == pytest.approx(math.exp(delay / FLASH_S))
    stage.run(round(4.0 * FLASH_S / stage.dt))
    assert not len(flashes_of(model)[0])
