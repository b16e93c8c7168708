"""The fireplace as a person meets it: hard levels, wood that breaks and shrinks, the hand, books of heat."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import level_files, load_level
from game.physics.heat.nodes import BOILING, FUEL, TEMPERATURE
from game.scenes.fireplace.air import USED
from game.scenes.fireplace.level import FireplaceContent, WoodEntry
from game.scenes.fireplace.scene import Fireplace
from game.scenes.fireplace.tables import BODY, SCALE, WHOLE
from game.scenes.fireplace.wood import SPENT
from game.stage import Action, Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import measured

LEVELS = level_files("a26")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]
SMALL = {"tier": "own", "cells": 32}


def opened(name: str, **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Fireplace, level=load_level(path, "a26", FireplaceContent), parameters=parameters)


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = Stage(Fireplace, level=load_level(path, "a26", FireplaceContent))
    stage.run(round(2.0 / stage.dt))
    assert stage.fault is None and stage.scene.model.content.expected
    assert all(one.met for one in captions_of(stage.scene.model.content.expected, stage.readouts()))


def test_in_a_shut_box_no_more_burns_than_there_is_oxygen_for():
    stage = opened("hard-01-shut-in")
    air = stage.scene.model.air
    before = air.flames.contents(air.gas.scalars)[2]
    stage.run(240)
    books = air.flames.books_now()
    used = books.used + float(air.flows[USED])
    assert 0.0 < used <= before and books.used == pytest.approx(1.3 * books.burnt, rel=1e-12)
    assert air.flows[USED] > 0.0 and used + air.contents()[2] == pytest.approx(before, rel=1e-12)
    assert np.min(air.gas.scalars[..., 1:3]) >= -1e-12


def test_wet_wood_dries_at_its_plateau_before_it_burns():
    stage = opened("hard-02-wet")
    wood = stage.scene.model.wood
    first = float(wood.nodes.water.sum())
    stage.run(300)
    wet = wood.nodes.water[4:8] > 0.0
    assert wood.nodes.water.sum() < first and np.all(wood.nodes.temperature[4:8][wet] <= BOILING + 1e-9)


def test_a_match_lights_the_kindling():
    stage = Stage(Fireplace, parameters=SMALL)
    stage.run(10)
    assert measured(stage, "burning pieces") == 0
    stage.post(Action("match"))
    stage.run(60)
    assert measured(stage, "match") == 1.0
    stage.run(240)
    assert measured(stage, "burning pieces") >= 1
    stage.run(300)
    assert measured(stage, "match") == 0.0 and stage.scene.model.match.hidden(stage.scene.model.time)


def test_the_books_close_and_nothing_is_lost_in_carrying_however_fine_the_gas_is():
    left = {}
    for cells in (32, 80):
        stage = opened("embers", tier="own", cells=cells)
        model = stage.scene.model
        fuel, wood = float(model.wood.nodes.fuel.sum()), model.wood.nodes
        given = 0.0
        take = wood.take_given

        def noted(take=take):
            nonlocal given
            rows = take()
            given += math.fsum(rows[0].tolist())
            return rows

        wood.take_given = noted
        stage.run(120)
        radiated, steam, of_fuel, _ = wood.totals.tolist()
        change = wood.heat() - float(model.whole[0])
        assert abs(change + given + radiated + steam - of_fuel) < 1e-9 * of_fuel
        assert float(wood.fuel.sum()) < fuel and 0.0 < measured(stage, "burnt") < 100.0
        assert abs(measured(stage, "open share")) < 1e-9
        left[cells] = abs(measured(stage, "lost in carrying"))
        assert left[cells] < 1e-9, cells


def test_the_books_stay_closed_whatever_the_hand_does():
    """Match, water on the fire, a log, gusts, wood that cools the gas: each is in a row of its own."""
    stage = opened("embers", **SMALL)
    model = stage.scene.model
    stage.run(20)
    for tool, at in (("water", (0.0, 0.1)), ("blow", (0.1, 0.2))):
        stage.post(SetParameter("tool", tool))
        stage.post(Pointer("down", *at, button=1))
        stage.post(Pointer("move", at[0] + 0.1, at[1], button=1))
        stage.post(Pointer("up", at[0] + 0.1, at[1], button=1))
        stage.run(5)
        assert abs(measured(stage, "open share")) < 1e-9, tool
    stage.post(Action("match"))
    stage.post(Action("log"))
    stage.run(120)
    books = model.books()
    assert abs(books["open"]) < 1e-11 * books["made"] and books["steam"] > 0.0 and model.air.of_match != 0.0
    assert books["carrying"] != 0.0 and books["flue"] > 0.0


@pytest.mark.parametrize("cells", [32, 64, 96, 128])
def test_gas_that_is_carried_in_a_shut_box_keeps_its_heat(cells):
    """To rounding, whatever logs lie in it: what leaves a cell enters its neighbour."""
    stage = opened("hard-01-shut-in", tier="own", cells=cells)
    stage.run(240)
    assert abs(measured(stage, "lost in carrying")) < 1e-9 and measured(stage, "burnt") > 5.0
    assert abs(measured(stage, "open share")) < 1e-9 and abs(measured(stage, "up the flue")) < 1e-9


@pytest.mark.parametrize("cells", [32, 64, 96])
def test_vapour_is_neither_made_nor_lost_on_its_way(cells):
    """What wood has given off, by its own weight, has burnt, left or is there. Once 17 % more burnt."""
    stage = Stage(Fireplace, parameters={"tier": "own", "cells": cells, "haste": 4.0})
    stage.post(Action("match"))
    stage.run(480)
    vapour = stage.scene.model.vapour()
    assert vapour["given"] > 1e-3 and 0.7 * vapour["given"] < vapour["burnt"] < vapour["given"]
    assert abs(vapour["carrying"]) < 1e-12 * vapour["given"]
    assert abs(vapour["open"]) < 1e-11 * vapour["given"]
    assert abs(vapour["covered"]) < 0.02 * vapour["given"]
    oxygen = stage.scene.model.air.lost[2]
    assert abs(oxygen) < 1e-11 * stage.scene.model.air.contents()[2]
    assert np.min(stage.scene.model.air.gas.scalars[..., 1:]) > -1e-12


def test_of_wood_a_share_is_left_as_coal_however_fine_the_gas_is():
    """A piece stops burning when SPENT of its fuel is left: that says how much has burnt."""
    for cells in (32, 64):
        stage = opened("embers", tier="own", cells=cells, haste=4.0)
        wood = stage.scene.model.wood
        wood.nodes.nodes[FUEL] = 1.4 * SPENT * wood.table[:, WHOLE]
        stage.run(round(30.0 / stage.dt))
        left = measured(stage, "left as coal")
        assert measured(stage, "burning pieces") == 0
        assert 100.0 * SPENT - 1.0 < left <= 100.0 * SPENT
        assert measured(stage, "burnt") == pytest.approx(100.0 - left, abs=1e-9)


def test_coal_burns_by_the_oxygen_that_it_takes():
    stage = opened("embers", **SMALL)
    air = stage.scene.model.air
    before = float(air.contents()[2])
    points = stage.scene.model._surfaces()
    none, burnt = np.zeros(len(points)), np.full(len(points), 1e-6)
    air.take(points, none, none, burnt)
    used = 1.3 * 1e-6 * len(points)
    assert before - air.contents()[2] == pytest.approx(used, rel=1e-9)
    assert air.flows[USED] == pytest.approx(used, rel=1e-12)


@pytest.mark.parametrize(("name", "cells"), [("hard-01-shut-in", 96), ("embers", 80), ("embers", 128)])
def test_no_niche_between_logs_is_hotter_than_flames_of_wood_are(name, cells):
    """2,200 K is about what wood reaches in air (Drysdale 2011, table 1.17 for its vapours)."""
    stage, most = opened(name, tier="own", cells=cells), 0.0
    for _ in range(120):
        stage.run(2)
        most = max(most, measured(stage, "hottest gas"))
    assert 1200.0 < most < 2300.0


def test_what_a_damper_covers_is_booked():
    stage = opened("embers", **SMALL)
    model = stage.scene.model
    stage.run(20)
    model.air.gas.scalars[..., 0] += 300.0
    model.air.flows[0] += model.air.heat() - model.books()["gas"]
    before = model.books()["open"], model.books()["covered"]
    given = model.air.heat()
    stage.post(Action("flue"))
    stage.run(1)
    books = model.books()
    assert given > 0.0 and abs(books["covered"] - before[1]) > 1.0
    assert abs(books["open"] - before[0]) < 1e-9 * books["made"]


def test_logs_are_walls_of_the_gas():
    """No gas within a log, none through it; a piece that is taken away leaves its place open."""
    stage = opened("default", tier="own", cells=64)
    air, wood = stage.scene.model.air, stage.scene.model.wood
    logs = wood.places()[wood.is_log()]
    j, i = air.cells_at(logs)
    assert not air.openings.open[j, i].any()
    air.gas.scalars[:6, :, 0] = 1200.0
    stage.run(30)
    assert np.all(air.temperature[j, i] < 300.0)
    faces = air.gas.faces
    assert np.all(air.gas.u[faces.ax == 0.0] == 0.0) and np.all(air.gas.v[faces.ay == 0.0] == 0.0)
    assert np.max(np.abs(air.gas.v)) > 0.3
    air.set_logs(np.zeros((0, 8)))
    assert air.openings.open[j, i].all()


def test_sticks_are_no_walls():
    stage = opened("default", tier="own", cells=64)
    air, wood = stage.scene.model.air, stage.scene.model.wood
    j, i = air.cells_at(wood.places()[~wood.is_log()])
    assert air.openings.open[j, i].all()


def test_what_logs_cover_is_in_a_row_of_its_own():
    """The books close when a log falls into hot gas; without the row they would not."""
    stage = opened("embers", **SMALL)
    model = stage.scene.model
    stage.run(40)
    model.air.gas.scalars[..., 0] += 300.0
    model.air.flows[0] += model.air.heat() - model.books()["gas"]  # as a match would have warmed it
    open_before = model.books()["open"]
    stage.post(Action("log"))
    stage.run(30)
    books = model.books()
    assert abs(books["covered"]) > 100.0
    assert abs(books["open"] - open_before) < 1e-9 * books["made"]


def test_a_step_back_over_a_log_that_moves_comes_to_the_same():
    stage = opened("default", **SMALL)
    stage.post(Action("log"))
    stage.run(30)
    digest = stage.digest()
    stage.run(20)
    for _ in range(20):
        stage.step_back()
    assert stage.digest() == digest
    stage.run(20)
    forth = stage.digest()
    for _ in range(20):
        stage.step_back()
    stage.run(20)
    assert stage.digest() == forth


def test_air_that_comes_in_brings_no_heat():
    stage = opened("embers", **SMALL)
    air = stage.scene.model.air
    air.gas.scalars[..., 0] = 400.0
    air.gas.u[:], air.gas.v[:] = -1.0, 0.0
    held = 1212.0 * 0.5 * (400.0 - 293.15) * (400.0 + 293.15) / 400.0
    before = float(air.out[0])
    air.gas.step = lambda dt: None
    air.flames.step = lambda *given: None
    air.advance(0.01)
    assert air.out[0] - before == pytest.approx(0.01 * held * 1.6, rel=1e-9)  # all through the left side


def test_burnt_wood_is_thinner_breaks_and_falls():
    stage = opened("default", **SMALL)
    wood = stage.scene.model.wood
    stage.run(30)
    height = wood.places()[:6, 1].copy()
    wood.nodes.nodes[FUEL, 2:4] = 0.2 * wood.nodes.nodes[FUEL, 2:4]
    stage.run(2)
    assert np.all(wood.table[2:4, SCALE] < 0.7) and wood.nodes.torn.sum() == 3
    assert len(set(wood.table[:, BODY].tolist())) == wood.count
    stage.run(90)
    fallen = height - wood.places()[:6, 1]
    assert np.max(fallen) > 0.01 and np.all(np.isfinite(wood.places()))


def test_a_log_more_keeps_what_the_others_have():
    stage = opened("embers", **SMALL)
    stage.run(30)
    wood = stage.scene.model.wood
    before, burnt = wood.nodes.temperature.copy(), measured(stage, "burnt")
    share = measured(stage, "open share")
    stage.post(Action("log"))
    assert wood.count == len(before) + 5
    assert np.array_equal(wood.nodes.temperature[: len(before)], before)
    assert measured(stage, "burnt") < burnt and measured(stage, "open share") == pytest.approx(
        share, abs=1e-9
    )
    stage.run(5)
    stage.step_back()
    stage.post(Pointer("down", 0.1, 0.6, button=3))
    assert stage.scene.model.wood.count == len(before) + 10
    for _ in range(20):
        stage.post(Action("log"))
    assert stage.scene.model.wood.count <= 96 and any("fits" in one for one in stage.scene.messages())


def test_step_back_over_a_log_that_was_added():
    stage = opened("embers", **SMALL)
    stage.run(10)
    digest = stage.digest()
    stage.post(Action("log"))
    stage.run(3)
    while stage.step_number > 10:
        stage.step_back()
    assert stage.scene.model.wood.count in (5, 10)
    stage.run(3)
    assert stage.fault is None and isinstance(digest, str)


def test_tools_blow_drag_hold_a_match_and_pour():
    stage = opened("embers", **SMALL)
    stage.run(20)
    model = stage.scene.model
    speed = float(model.air.speeds().max())
    stage.post(Pointer("down", -0.3, 0.3, button=1))
    stage.post(Pointer("move", 0.0, 0.3, button=1))
    assert float(model.air.speeds().max()) > speed + 0.5
    stage.post(Pointer("up", 0.0, 0.3, button=1))
    stage.post(SetParameter("tool", "drag"))
    x, y = model.wood.places()[2].tolist()
    stage.post(Pointer("down", x, y, button=1))
    stage.post(Pointer("move", x, y + 0.4, button=1))
    stage.run(60)
    assert model.wood.places()[2, 1] > y + 0.25
    stage.post(Pointer("up", x, y, button=1))
    stage.post(SetParameter("tool", "match"))
    stage.post(Pointer("down", 0.5, 0.2, button=1))
    assert measured(stage, "match") == 1.0
    stage.post(Pointer("up", 0.5, 0.2, button=1))
    assert measured(stage, "match") == 0.0
    stage.post(SetParameter("tool", "water"))
    hot = float(model.wood.nodes.temperature[0])
    x, y = model.wood.places()[0].tolist()
    stage.post(Pointer("down", x, y, button=1))
    assert measured(stage, "water left") > 0.0
    stage.run(30)
    assert float(model.wood.nodes.temperature[0]) < hot - 100.0


def test_the_damper_shuts_the_flue():
    stage = Stage(Fireplace, parameters=SMALL)
    air = stage.scene.model.air
    row = round(1.26 / air.cell)
    open_ways = float(air.gas.faces.ay[row].sum())
    stage.post(Action("flue"))
    shut = float(air.gas.faces.ay[row].sum())
    assert stage.scene.parameters.damper == 0.0 and shut < open_ways - 1.5
    stage.post(Action("flue"))
    assert float(air.gas.faces.ay[row].sum()) == pytest.approx(open_ways)


def test_an_ember_is_followed_beside_its_law():
    stage = opened("embers", **SMALL)
    wood, model = stage.scene.model.wood, stage.scene.model
    wood.nodes.nodes[FUEL, :] = 0.99 * SPENT * wood.table[:, 6]
    wood.nodes.nodes[TEMPERATURE, :] = 900.0
    stage.run(2)
    assert model.ember[0] >= 0.0 and np.all(wood.nodes.fuel == 0.0)
    stage.run(240)
    assert 300.0 < measured(stage, "ember") < 880.0
    assert measured(stage, "off the law") < 12.0


def test_a_saved_level_has_the_wood_where_it_is():
    stage = opened("default", **SMALL)
    stage.run(5)
    assert stage.scene.save_content() == stage.scene.model.content
    stage.scene.model.changed = True
    kept = stage.scene.save_content()
    assert all(isinstance(one, WoodEntry) and one.pieces == 1 for one in kept.wood)
    places = np.array([one.at for one in kept.wood])
    assert np.allclose(places, stage.scene.model.wood.places()[: len(places)])


def test_the_picture_shows_the_fire_and_what_is_measured_of_it():
    prepare()
    seen = set()
    for view in ("fire", "temperature", "speed", "oxygen"):
        stage = opened("embers", **SMALL, view=view, marks=True)
        stage.run(30)
        for theme in ("dark", "light"):
            seen.add(np.asarray(picture_of_stage(stage, (320, 180), theme).get_buffer()).tobytes())
    assert len(seen) == 8


def test_the_room_is_brighter_by_the_fire():
    prepare()
    means = []
    for hot in (False, True):
        stage = opened("embers", **SMALL)
        if not hot:
            stage.scene.model.wood.nodes.nodes[TEMPERATURE, :] = 293.15
        stage.run(60)
        picture = picture_of_stage(stage, (320, 180), "dark")
        means.append(float(np.mean(np.frombuffer(picture.get_buffer().raw, np.uint8))))
    assert means[1] > means[0] + 2.0 and math.isfinite(means[0])


SABOTAGE = {
    "half of the radiation of the gas is not booked": (3, -0.5),
    "a tenth of the heat of flames is not booked": (2, -0.1),
    "more heat of flames is booked than there was": (2, 0.1),
}


@pytest.mark.parametrize("what", SABOTAGE)
def test_what_is_wrongly_booked_is_left_open(what, monkeypatch):
    """What the cells were warmed by is measured by themselves: no row takes up what is missing in another."""
    row, part = SABOTAGE[what]
    stage = opened("embers", **SMALL)
    flames = stage.scene.model.air.flames
    step = flames.step

    def wrong(cells, dt, source):
        before = float(flames.books[row])
        step(cells, dt, source)
        flames.books[row] += part * (float(flames.books[row]) - before)

    monkeypatch.setattr(flames, "step", wrong)
    stage.run(150)
    books = stage.scene.model.books()
    booked = flames.books_now()[row]
    missing = booked - booked / (1.0 + part)
    assert abs(missing) > 1e-3 * books["made"]
    expected = missing if row == 2 else -missing
    assert books["open"] == pytest.approx(expected, rel=1e-6)


def test_a_match_that_is_not_booked_is_left_open():
    stage = opened("embers", **SMALL)
    model = stage.scene.model
    stage.post(Action("match"))
    stage.run(60)
    given = model.air.of_match
    assert given > 0.0 and abs(model.books()["open"]) < 1e-9 * model.books()["made"]
    model.air.flows[0] = 0.0
    assert model.books()["open"] == pytest.approx(-given, rel=1e-6)
