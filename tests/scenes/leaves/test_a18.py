"""Leaves in a wind, A18, by stage events: from the lawn into the basket; hand, shapes, hard cases."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import LevelError, level_files, load_level, parse_level
from game.physics.plates import Plate, Plates
from game.physics.plates.law import BEND, HALF, MASS_Y, X, Y
from game.physics.plates.watch import FLUTTER, GLIDE, NOTHING, TUMBLE
from game.scenes.leaves import foliage
from game.scenes.leaves.basket import Basket
from game.scenes.leaves.foliage import Foliage, cut_outlines, nearer, shifts_of
from game.scenes.leaves.level import LeavesContent
from game.scenes.leaves.model import KIND, NAMES
from game.scenes.leaves.scene import Leaves
from game.scenes.leaves.species import SPECIES, half_of, outline_of
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.listening import heard_in

pytestmark = pytest.mark.compiled
LEVELS = {path.stem: path for path in level_files("a18") if not path.stem.startswith("story")}
HARD = [name for name in LEVELS if name.startswith("hard-")]


def opened(name: str, **parameters) -> Stage:
    return Stage(Leaves, level=load_level(LEVELS[name], "a18", LeavesContent), parameters=parameters)


def measured(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.readouts()}


def drag(stage: Stage, start: tuple[float, float], end: tuple[float, float]) -> None:
    stage.post(Pointer("down", *start, button=1))
    stage.post(Pointer("move", *end, button=1))
    stage.post(Pointer("up", *end, button=1))


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name):
    stage = opened(name)
    worst = 0.0
    for _ in range(12):
        stage.run(math.ceil(1.0 / stage.dt))
        worst = max(worst, measured(stage)["fastest"])
    scene = stage.scene
    captions = captions_of(scene.model.content.expected, stage.readouts())
    assert captions and all(caption.met for caption in captions), captions
    for entry in scene.model.content.expected:
        if entry.readout == "fastest":
            assert worst < max(entry.value, 25.0)
    scene.check()


def test_leaves_lie_still_until_a_wind_comes():
    """A18.1, A18.2"""
    stage = opened("default")
    stage.run(230)
    assert measured(stage)["in the air"] == 0 and measured(stage)["fastest"] < 0.05
    most = 0.0
    for _ in range(12):
        stage.run(40)
        most = max(most, measured(stage)["in the air"])
    assert most >= 8 and measured(stage)["highest"] > 0.8


@pytest.mark.parametrize(
    ("kind", "way"),
    [("maple", FLUTTER), ("linden", FLUTTER), ("oak", TUMBLE), ("birch", TUMBLE), ("ash", GLIDE)],
)
def test_each_kind_comes_down_as_its_shape_asks(kind, way):
    """A18.3: let go in still air at any angle, all but a few of a kind are seen to do what it does."""
    words = (
        'scene = "a18"\ntitle = "some"\n[parameters]\nwind = 0.0\n[content]\nbeds = [{ '
        f'kinds = ["{kind}"], count = 20, left = -19.0, right = 19.0, height = 6.0 }}]\n'
    )
    stage = Stage(Leaves, level=parse_level(words, "a18", LeavesContent))
    counts = np.zeros(5)
    model = stage.scene.model
    for _ in range(20):
        stage.run(30)
        counts += np.bincount(model.seen()[model.flying()], minlength=5)
    own, other = counts[way], counts.sum() - counts[way] - counts[NOTHING]
    assert own > 5.0 * other and own > 0.4 * counts.sum(), counts


def test_a_drag_draws_a_gust_that_takes_leaves_along():
    stage = opened("default")
    stage.post(Action("calm"))
    stage.run(120)
    before = stage.scene.model.plates.positions
    drag(stage, (-2.2, 0.3), (-0.6, 0.7))
    assert stage.scene.model.wind.count == 1
    stage.run(240)
    assert measured(stage)["took off"] > 5
    moved = stage.scene.model.plates.positions - before
    assert np.max(moved[:, 0]) > 0.8
    drag(stage, (0.0, 0.5), (0.01, 0.5))  # too short to be one
    assert stage.scene.model.wind.count == 1
    stage.run(240)
    assert stage.scene.model.wind.count == 0  # it is over and forgotten


def test_leaves_are_dropped_and_shaped():
    stage = opened("default")
    stage.post(SetParameter("leaf", "birch"))
    stage.post(Pointer("down", 0.5, 1.5, button=3))
    model = stage.scene.model
    assert len(model.plates) == 61 and model.plates.positions[-1] == pytest.approx((0.5, 1.5))
    before = model.plates.laws[MASS_Y] - 1.0
    stage.post(SetParameter("weight", 2.0))
    assert np.allclose(model.plates.laws[MASS_Y] - 1.0, 2.0 * before)
    stage.post(SetParameter("curl", 0.6))
    stage.run(240)
    assert np.mean(model.plates.rows[BEND]) > 0.4


def test_what_lies_in_the_basket_is_sheltered():
    """A18.4"""
    stage = opened("hard-02-heap")
    stage.run(900)
    inside = measured(stage)["in the basket"]
    drag(stage, (0.2, 0.6), (2.2, 1.0))
    stage.run(500)
    assert measured(stage)["in the basket"] >= inside - 2 >= 28


def test_without_gust_inertia_leaves_lag():
    moved = []
    for on in (True, False):
        stage = opened("hard-01-storm")
        stage.post(SetEffect("gust-inertia", on))
        stage.run(math.ceil(1.015 / stage.dt))
        moved.append(float(np.mean(stage.scene.model.plates.velocities[:, 0])))
    assert moved[0] > moved[1] > 0.0


def test_a_step_back_and_on_again_is_equal():
    stage = opened("default")
    stage.run(480)
    here = stage.digest()
    stage.run(25)
    there = stage.digest()
    for _ in range(25):
        stage.step_back()
    assert stage.digest() == here
    stage.run(25)
    assert stage.digest() == there


def test_landings_are_heard():
    stage = opened("hard-05-still-air")
    kinds = {kind for kind, _ in heard_in(stage, [60] * 12)}
    assert kinds == {"rustle"}  # the air is still
    windy = opened("hard-01-storm")
    windy.run(150)
    assert {kind for kind, _ in heard_in(windy, [30] * 6)} == {"rustle", "wind"}


def leaf_in_basket(half_chord: float, x: float, y: float, theta: float):
    basket = Basket(1.5, 0.4, 0.6)
    plates = Plates([Plate(half_chord, 0.6, 0.03)], [(x, y, theta)])
    own = np.array([[float(NAMES.index("maple")), 0.3, 0.5, -0.4, 0.0, 1.0]])
    return basket, plates, own


def test_one_outline_stops_counts_and_draws_leaves():
    """What is beside the foot, under the rim that overhangs it, is not in the basket; what is in it is not
    drawn through its walls.
    """
    basket = Basket(1.5, 0.4, 0.6)
    for side in (-1.0, 1.0):
        x = 1.5 + side * 0.37
        assert basket.holds(np.array([x]), np.array([0.59])).all()
        assert not basket.holds(np.array([x, 1.5]), np.array([0.01, 0.61])).any()
    (left, _, left_rim, top, *_), (right, *_) = basket.walls()
    assert (left, left_rim, right) == pytest.approx((1.5 - 0.34, 1.5 - 0.4, 1.5 + 0.34)) and top == 0.6
    assert basket.half_at(0.0) == pytest.approx(0.34) and basket.half_at(2.0) == pytest.approx(0.4)
    _, plates, own = leaf_in_basket(0.05, 1.5 - 0.31, 0.05, 0.1)
    leaves, halves = Foliage(), plates.laws[HALF]
    leaves._fit(own)
    before = leaves._corners(plates.rows, own, halves)
    assert np.max(np.abs(before[:, 0] - 1.5) - basket.half_at(before[:, 1])) > 0.005
    rows = plates.rows.copy()
    rows[X] += leaves._pushed_in(before, basket)
    after = leaves._corners(rows, own, halves)
    assert np.max(np.abs(after[:, 0] - 1.5) - basket.half_at(after[:, 1])) < 1e-9


def test_no_leaf_comes_into_the_basket_but_over_its_rim():
    """A wind presses leaves at the wall from outside; the shelter does not reach beyond it."""
    words = (
        'scene = "a18"\n[parameters]\nwind = 3.0\n[content]\nbasket = { x = 1.5 }\n'
        'beds = [{ kinds = ["maple", "oak", "ash"], count = 30, left = 0.3, right = 1.1 }]\n'
    )
    stage = Stage(Leaves, level=parse_level(words, "a18", LeavesContent))
    model = stage.scene.model
    was = model.inside()
    for _ in range(480):
        heights = model.plates.rows[Y].copy()
        stage.run(1)
        now = model.inside()
        assert (heights[now & ~was] > model.basket.height - 0.03).all()
        was = now
    x, y = 1.5 - 0.37, 0.1
    assert model.wind.sample([(x, y)])[0, 0] == pytest.approx(model.wind.sample([(x - 1.0, y)])[0, 0])
    assert model.wind.sample([(1.5, y)])[0, 0] < 0.1 * model.wind.sample([(x, y)])[0, 0]


def test_outlines_are_cut_in_halves_of_the_same_area():
    for name in SPECIES:
        shape = outline_of(name)
        area = abs(_area(shape))
        left, right = half_of(shape, -1.0), half_of(shape, 1.0)
        assert abs(_area(left)) + abs(_area(right)) == pytest.approx(area, rel=1e-9)
        assert np.max(left[:, 0]) <= 1e-12 and np.min(right[:, 0]) >= -1e-12
    cut = cut_outlines(np.array([[0.0, 0.3, 0.5, 0.0, 1.0, 1.0], [2.0, -0.2, 0.5, 0.0, 0.0, 1.0]]))
    assert len(cut.starts) == 5 and cut.starts[-1] == len(cut.points) == len(cut.leaves)


def _area(points: np.ndarray) -> float:
    x, y = points.T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def test_outlines_are_cut_anew_only_when_a_shape_changes(monkeypatch):
    cuts = []
    monkeypatch.setattr(foliage, "cut_outlines", lambda own: cuts.append(1) or cut_outlines(own))
    stage = Stage(Leaves)
    for _ in range(3):
        stage.run(1)
        assert picture_of_stage(stage, (640, 360), "dark").get_width() == 640
    assert len(cuts) <= 2  # of no leaves at first, and of those there are


def test_levels_say_what_is_wrong_in_one_line():
    for words, field in (
        ('[content]\nbeds = [{ kinds = ["palm"], left = 0.0, right = 1.0 }]\n', "kinds"),
        ("[content]\nbasket = { half = -1.0 }\n", "half"),
        ("[content]\ngusts = [{ place = [0.0, nan] }]\n", "place"),
    ):
        with pytest.raises(LevelError) as error:
            parse_level(f'scene = "a18"\n{words}', "a18", LeavesContent)
        assert field in str(error.value) and "\n" not in str(error.value)


def test_the_picture_is_drawn_in_both_themes_with_leaves_in_it():
    prepare()
    stage = opened("default")
    stage.run(500)
    full = [
        np.asarray(picture_of_stage(stage, (480, 270), theme).get_buffer()).tobytes()
        for theme in ("light", "dark")
    ]
    empty = Stage(Leaves, level=parse_level('scene = "a18"\n[content]\nbeds = []\n', "a18", LeavesContent))
    bare = np.asarray(picture_of_stage(empty, (480, 270), "light").get_buffer()).tobytes()
    assert len({*full, bare}) == 3
    laws = stage.scene.model.plates.laws
    assert np.all(laws[HALF] > 0.015) and np.all(np.isfinite(stage.scene.model.plates.rows[[X, Y]]))


def test_one_leaf_of_each_way_is_named_where_it_flies():
    stage = opened("default")
    assert stage.scene.story_names() == []
    stage.post(Action("whirl"))
    model = stage.scene.model
    while len(np.unique(model.seen())) < 4:
        stage.run(1)
        assert model.plates.time < 30.0
    found = stage.scene.story_names()
    assert {words.split(":")[0].split()[1] for _, words in found} == {"flutters", "tumbles", "glides"}
    rows = model.plates.rows
    seen = rows[[X, Y]].T + shifts_of(nearer(model.basket, rows, model.own))
    for place, words in found:
        away = np.hypot(*(seen - place).T)
        i = int(np.argmin(away))
        assert away[i] == 0.0, "at the depth at which it is drawn"
        kind, inertia = NAMES[int(model.own[i, KIND])], float(model.plates.laws[MASS_Y, i]) - 1.0
        assert model.flying()[i] and words.startswith(kind) and words.endswith(f"{inertia:.2f}")
