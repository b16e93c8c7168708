"""One dam by several methods: fronts beside each other, the experiment and Ritter."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import level_files, load_level
from game.physics.waves.experiments import COLUMN_TWICE_AS_HIGH
from game.scenes.liquid.dam_scene import Dam
from game.scenes.liquid.dam_view import BRUSHES, said_of
from game.scenes.liquid.dam_world import DamContent
from game.scenes.liquid.methods import COLUMNS, DamState
from game.stage import Stage
from game.ui.look.numerals import format_number, format_si
from tests.scenes.by_hand import measured

LEVELS = level_files("dam")
NAMES = ("experiment", "liquid", "shallow", "Ritter")


def opened(name: str = "default", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Dam, level=load_level(path, "dam", DamContent), parameters=parameters)


def test_the_fronts_lie_in_their_order():
    """The gate of the experiment was slow: all that is computed leads. Shallow water leads by far."""
    stage = opened()
    for _ in range(4):
        stage.run(20)
        fronts = [measured(stage, f"front, {name}") for name in NAMES]
        assert math.isnan(fronts[0]) == (measured(stage, "scaled time") < 0.832)
        known = [front for front in fronts if not math.isnan(front)]
        assert known == sorted(known)
        assert measured(stage, "front, particles") == pytest.approx(fronts[1], rel=0.05)
    assert measured(stage, "front, liquid") > 2.5 * 0.5


def test_liquid_and_particles_are_where_another_code_has_them():
    """Within 3 % at the last three of the fronts of PySPH, as the level opens; volume within 1 %."""
    stage = opened()
    unit = math.sqrt(2.0 * 9.81 / 0.5)
    for scaled, front in ((1.219, 1.71), (1.997, 2.6), (2.547, 3.34)):
        stage.run(round(scaled / unit / stage.dt) - round(stage.scene.model.time / stage.dt))
        late = measured(stage, "scaled time") - scaled
        for name in ("liquid", "particles"):
            assert measured(stage, f"front, {name}") / 0.5 == pytest.approx(front + 1.35 * late, rel=0.03)
            assert measured(stage, f"volume error, {name}") == pytest.approx(0.0, abs=0.01)


def test_a_soft_law_falls_behind():
    """By a tenth: water that can be squeezed is pushed later."""
    stage = opened(law="mueller-2003", particles=128)
    stage.run(80)
    front = measured(stage, "front, particles")
    assert 0.8 < front / measured(stage, "front, liquid") < 0.97


def test_the_experiment_is_that_of_its_table_and_of_no_other_column():
    stage = opened()
    stage.run(40)
    late = measured(stage, "scaled time")
    times, fronts = zip(*COLUMN_TWICE_AS_HIGH, strict=True)
    assert measured(stage, "front, experiment") == pytest.approx(0.5 * np.interp(late, times, fronts))
    assert math.isnan(measured(opened("low"), "front, experiment"))


def test_shallow_water_follows_ritter():
    stage = opened(row=2000)
    stage.run(20)
    model = stage.scene.model
    x, depth = model.surface()
    water = model.methods[-1].water
    assert np.interp(model.methods[-1].x, x, depth)[:1000] == pytest.approx(water.depth[0][:1000], abs=0.02)
    assert measured(stage, "front, shallow") < measured(stage, "front, Ritter")


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_levels_are_seen_and_keep_their_volume(path):
    stage = opened(path.stem)
    stage.run(60)
    picture = picture_of_stage(stage, (640, 360), "light")
    colors = [tuple(picture.get_at((x, y)))[:3] for x in range(20, 620, 6) for y in range(0, 360, 4)]
    assert sum(b > r + 20 and b > 40 for r, g, b in colors) > 60
    stage.run(180)
    assert abs(measured(stage, "volume error, shallow")) < 1e-9
    assert abs(measured(stage, "volume error, liquid")) < 0.06
    assert abs(measured(stage, "volume error, particles")) < 0.02


def test_a_column_wider_than_its_floor_is_refused():
    with pytest.raises(ValueError, match="width"):
        Stage(Dam, level=None).scene.make(DamContent(width=5.0, length=3.0))


def test_each_column_is_one_entry_and_they_stand_one_above_the_other():
    stage = opened()
    methods = stage.scene.model.methods
    assert tuple(type(one) for one in methods) == COLUMNS and set(BRUSHES) == set(COLUMNS)
    assert len(DamState._fields) == len(COLUMNS)
    floors = [one.floor for one in methods]
    assert floors == sorted(floors, reverse=True) and floors[-1] == 0.0
    assert all(upper - lower > 1.15 * 1.0 for upper, lower in pairwise(floors))


def test_front_loss_and_price_are_said_beside_each_method():
    stage = opened()
    stage.run(60)
    model = stage.scene.model
    measured_now = model.measured()
    for one in model.methods:
        front, ahead, lost, price = said_of(model, one)
        assert front == f"front at {one.front():.2f} m"
        assert ahead == f"{100.0 * (one.front() / measured_now - 1.0):.0f} % ahead of the experiment"
        assert lost.startswith("volume error")
        pace = stage.dt / one.watch.median("step")  # a second of a column half as wide is longer by sqrt(2)
        cost, times = format_si(one.watch.median("step"), "s", 2), 13.8 * math.sqrt(2.0) * pace
        assert price == f"{cost} a step, {format_number(times, 2)} times as fast as PySPH"
    stage.run(150)
    assert said_of(model, model.methods[0])[0] == "front at the far wall"


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_no_water_is_seen_outside_its_tank(theme):
    """As it climbs the far wall, where it once rose above it."""
    stage = opened(exact=False, experiment=False)
    dry = picture_of_stage(stage, (640, 360), theme)
    stage.run(240)
    wet = picture_of_stage(stage, (640, 360), theme)
    shades = [sum(dry.get_at((200, y))[:3]) for y in range(360)]
    edges = [y for y in range(1, 360) if abs(shades[y] - shades[y - 1]) > 60]
    lid, low = edges[0], next(y for y in edges if y > edges[0] + 30)
    left = next(x for x in range(640) if abs(sum(dry.get_at((x, lid + 5))[:3]) - shades[lid + 5]) > 60)
    wall = left + round((low - lid) * 3.0 / 1.15)  # of the floor beside the tank's height
    assert 10 < lid < 60 and 300 < wall < 560

    def touched(columns: range, lines: range) -> list[bool]:
        return [wet.get_at((x, y)) != dry.get_at((x, y)) for x in columns for y in lines]

    assert not any(touched(range(0, 640, 3), range(lid - 1)))
    assert not any(touched(range(wall + 2, wall + 5), range(lid + 90, lid + 130, 3)))
    assert all(touched(range(wall - 4, wall - 1), range(lid + 6, lid + 60, 4)))
