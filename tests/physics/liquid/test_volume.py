"""No volume is lost: beside walls on the grid's faces and across its cells, poured in, splashed about."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.grid.layout import Grid
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids import SolidSettings, SolidWorld, box
from game.physics.surfaces import SolidSurface

N = 32  # cells along a metre
CARRIERS = pytest.mark.parametrize("carrier", [1, 0], ids=["apic", "flip"])
SOLIDS = {  # size, place, turn
    "slant": (((3.0, 0.2), (0.5, 0.2), 0.35),),
    "vee": (((3.0, 0.2), (0.0, 0.2), -0.5), ((3.0, 0.2), (1.0, 0.2), 0.5)),
    "block off the faces": (((0.513, 0.437), (0.25, 0.2), 0.0),),
    "block on the faces": (((0.5, 0.5), (0.25, 0.25), 0.0),),
}


def tank(carrier: int, *solids, open_sides=()) -> Liquid:
    """1 m wide, 2 m high."""
    liquid = Liquid(
        Grid(N, 2 * N, 1.0 / N), LiquidSettings(carrier=carrier), most=64 * N * N, open_sides=open_sides
    )
    world = SolidWorld(SolidSettings())
    for size, place, turn in solids:
        world.add_body(box(*size), place, turn, kind="fixed")
    if solids:
        liquid.set_solids(SolidSurface(world))
    return liquid


def most_in_a_cell(liquid: Liquid) -> int:
    """Particles, of 4 in a cell that is just full."""
    cells = (liquid.places / liquid.grid.cell).astype(np.int64)
    return int(np.bincount(cells[:, 1] * N + cells[:, 0]).max())


def lost(liquid: Liquid) -> float:
    """Share of the volume that crowding hides; below 0, where it is too thin."""
    liquid.refresh()
    return liquid.wet_area() / (liquid.count * liquid.area) - 1.0


def run(liquid: Liquid, seconds: int) -> list[float]:
    """`lost` after each second."""
    found = []
    for _ in range(seconds):
        for _ in range(60):
            liquid.advance(1.0 / 60.0)
        found.append(lost(liquid))
    return found


@CARRIERS
@pytest.mark.parametrize("kind", SOLIDS)
def test_a_column_falls_on_solids_and_nothing_is_lost(kind, carrier):
    """20 s, within 1 % at each second; no cell holds more than three times what is full."""
    liquid = tank(carrier, *SOLIDS[kind])
    liquid.add(liquid.lattice((0.0, 0.9), (0.5, 1.7)))
    assert np.abs(run(liquid, 20)).max() < 0.01
    assert most_in_a_cell(liquid) <= 12


@CARRIERS
def test_water_runs_over_an_edge_that_lies_on_a_face(carrier):
    """It falls down the side of a block and out of an open side, where particles once came to rest for good:
    cells that touch a solid counted as full, however many were in them.
    """
    liquid = tank(carrier, ((0.5, 0.5), (0.25, 0.25), 0.0), open_sides=("right",))
    errors = []
    for frame in range(600):
        if frame % 4 == 0:
            liquid.add(liquid.lattice((0.0, 0.5), (2.0 / N, 0.6)), (1.0, 0.0))
        liquid.advance(1.0 / 60.0)
        if frame % 60 == 59:
            errors.append(lost(liquid))
    assert np.abs(errors[2:]).max() < 0.02 and most_in_a_cell(liquid) <= 16
    assert liquid.account[1] > 0.5 * liquid.account[0]


@CARRIERS
def test_a_minute_of_pouring_and_of_splashes_keeps_the_volume(carrier):
    """Water comes in for 20 s, then ten drops fall; within 1 % in the mean of each ten seconds."""
    liquid, errors = tank(carrier), []
    for frame in range(3600):
        if frame < 1200 and frame % 6 == 0:
            liquid.add(liquid.lattice((0.45, 1.8), (0.55, 1.8 + 1.0 / N)), (0.0, -1.0))
        elif 1200 <= frame < 3000 and frame % 180 == 0:
            drop = liquid.lattice((0.2, 1.5), (0.4, 1.7))
            liquid.add(drop[np.hypot(drop[:, 0] - 0.3, drop[:, 1] - 1.6) < 0.1], (1.0, -4.0))
        liquid.advance(1.0 / 60.0)
        if frame % 20 == 19:
            errors.append(lost(liquid))
    means = np.reshape(errors, (6, -1)).mean(axis=1)
    assert np.abs(means).max() < 0.01 and abs(errors[-1]) < 0.01
    assert liquid.account[1] == liquid.account[2] == 0.0 and liquid.count == liquid.account[0]


@pytest.mark.parametrize("thick", [1, 2, 3, 5])
@pytest.mark.parametrize("off", [0.0, 0.3])
def test_a_sheet_counts_in_full_however_thin_it_is(thick, off):
    liquid = tank(1)
    liquid.add(np.add(liquid.lattice((0.0, 0.5), (1.0, 0.5 + thick / N)), (0.0, off / N)))
    assert abs(lost(liquid)) < 1e-9


def test_what_crowds_is_missing_and_what_solids_take_is_not_counted():
    liquid = tank(1, ((0.5, 0.5), (0.25, 0.25), 0.0))
    liquid.add(liquid.lattice((0.0, 0.0), (1.0, 1.0)))
    assert liquid.wet_area() == 0.0
    liquid.refresh()
    assert liquid.wet_area() == pytest.approx(0.75, rel=1e-9)
    liquid.add(liquid.lattice((0.7, 0.2), (0.9, 0.4)))
    assert lost(liquid) == pytest.approx(-liquid.area * 0.04 * 4 * N * N / (0.79), rel=0.1)


def test_the_room_of_cells_is_what_solids_leave():
    """Also where solids cut cells at any slope; cells with their centres inside have none."""
    for kind, solids in SOLIDS.items():
        liquid = tank(1, *solids)
        room, centres = liquid.cells.room, liquid.walls.distance[1::2, 1::2]
        assert (room[centres < 0.0] == 0.0).all() and (room[centres >= 0.0] > 0.2).all(), kind
        space = float(liquid.obstacles.faces.volume.sum())
        assert float(room.sum()) == pytest.approx(space, rel=0.01), kind
        assert math.isclose(float(room[-8:].mean()), 1.0)


def test_a_cell_that_stands_alone_is_never_more_than_full():
    liquid = tank(1)
    liquid.add(np.random.default_rng(1).uniform(0.5, 0.5 + 1.0 / N, (64, 2)))
    liquid.refresh()
    assert liquid.wet_area() <= 9.0 / (N * N) < liquid.count * liquid.area
