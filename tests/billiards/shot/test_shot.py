"""Shots and shot files: what is missing or wrong is named, in one line."""

import copy
import json
import math

import numpy as np
import pytest

from game.billiards import Physics, ShotError, Table, load_shot, make_shot, run_shot_file
from game.billiards.laws.layout import is_clear, layout_of
from game.billiards.shot.shot_file import parse_shot
from game.billiards.table.rack import BALL_RADIUS
from tests.paths import TESTS

GOOD = json.loads((TESTS / "reference" / "shots" / "p07-corner-cut.json").read_text())
R = BALL_RADIUS


def _broken(path, value):
    """The good shot with one thing changed; the value None takes it away."""
    data = copy.deepcopy(GOOD)
    *way, last = path
    place = data
    for step in way:
        place = place[step]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return data


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (["gravity"], None, "gravity: is missing"),
        (["gravity"], "9.81", "gravity: must be a number"),
        (["gravity"], 0, "gravity: must be positive"),
        (["gravity"], float("nan"), "gravity: must be finite"),
        (["gravity"], 10**400, "gravity: must be finite"),
        (["models"], None, "models: is missing"),
        (["models"], [], "models: must be an object"),
        (["models", "ball_ball"], "magic", "models.ball_ball: must be one of elastic"),
        (["models", "cushion"], 3, "models.cushion: must be one of mirror"),
        (["friction", "sliding"], None, "friction.sliding: is missing"),
        (["friction", "rolling"], -0.1, "friction.rolling: must be 0, or between"),
        (["friction", "cushion"], True, "friction.cushion: must be a number"),
        (["restitution", "ball_ball"], 1.2, "restitution.ball: must be between 0 and 1"),
        (["table"], None, "table: is missing"),
        (["table", "cushion_height"], -1, "cushion_height: must be finite and not negative"),
        (["table", "cushions"], {}, "table.cushions: must be a list"),
        (["table", "cushions", 3, "normal"], None, r"table.cushions\[3\].normal: is missing"),
        (["table", "cushions", 2, "from"], [1, 2, 3], r"table.cushions\[2\].from: must be 2 numbers, got 3"),
        (["table", "cushions", 2, "normal"], [0, 0], r"cushions\[2\]: normal must have length 1"),
        (["table", "cushions", 1, "id"], "3", "table.cushions: two have the same id"),
        (["table", "jaws", 0, "radius"], 0, r"jaws\[0\]: radius must be positive"),
        (["table", "pockets", 5, "center"], [0, "a"], r"table.pockets\[5\].center\[1\]: must be a number"),
        (["balls"], [], "balls: there must be at least one"),
        (["balls", 1], 7, r"balls\[1\]: must be an object"),
        (["balls", 1, "id"], None, r"balls\[1\].id: is missing"),
        (["balls", 1, "id"], 1.5, r"balls\[1\].id: must be a text"),
        (["balls", 0, "radius"], 0, r"balls\[0\].radius: must be at least"),
        (["balls", 0, "mass"], -1, r"balls\[0\].mass: must be at least"),
        (["balls", 0, "position"], [0.1], r"balls\[0\].position: must be 2 numbers"),
        (["balls", 0, "position"], [1e300, 0], r"balls\[0\].position: must be finite and at most"),
        (["balls", 0, "velocity"], [1e9, 0], r"balls\[0\].velocity: must be finite and at most"),
        (["balls", 0, "spin"], [0, 0], r"balls\[0\].spin: must be 3 numbers"),
        (["balls", 0, "motion"], "flying", r"balls\[0\].motion: must be one of stationary"),
        (["balls", 0, "motion"], "stationary", r"balls\[0\].motion: stationary, but"),
        (["format"], "scene", "format: must be"),
        (["version"], 2, "version: only 1"),
    ],
)
def test_what_is_wrong_is_named(path, value, message):
    with pytest.raises(ValueError, match=message) as caught:
        parse_shot(_broken(path, value))
    assert "\n" not in str(caught.value)


def test_the_good_one_is_good():
    shot = parse_shot(GOOD)
    assert shot.ids == tuple(ball["id"] for ball in GOOD["balls"])
    assert shot.positions == pytest.approx(np.array([b["position"] for b in GOOD["balls"]]), rel=0, abs=1e-16)


def test_a_ball_twice_and_balls_in_each_other():
    data = copy.deepcopy(GOOD)
    data["balls"].append(copy.deepcopy(data["balls"][0]))
    with pytest.raises(ShotError, match=r"balls\[2\].id: .* is there twice"):
        parse_shot(data)
    data["balls"][2]["id"] = "another"
    with pytest.raises(ShotError, match=r"balls\[0\] and balls\[2\] overlap by 0.0571"):
        parse_shot(data)


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(ShotError, match=r"nowhere\.json: No such file"):
        load_shot(tmp_path / "nowhere.json")
    with pytest.raises(ShotError, match="Is a directory"):
        load_shot(tmp_path)
    broken = tmp_path / "broken.json"
    for content, message in (
        (b"{", "not JSON"),
        (b"\xff\xfe\x00", "not a text file"),
        (b"[]", "the file: must be an object"),
        (b"[" * 100_000, "nested too deeply"),
    ):
        broken.write_bytes(content)
        with pytest.raises(ShotError, match=message):
            load_shot(broken)


def test_running_a_file_with_an_unknown_model(tmp_path):
    file = tmp_path / "shot.json"
    file.write_text(json.dumps(GOOD))
    with pytest.raises(ValueError, match="model: must be one of exact"):
        run_shot_file(file, "magic")


def test_a_rolling_ball_must_roll():
    with pytest.raises(ShotError, match="slips at 1 m/s"):
        make_shot(Table.open(), [[0, 0]], [(1.0, 0.0)], motions=["rolling"])


def test_a_tall_cushion_is_refused_only_by_models_that_look_at_it():
    table = Table.bare(1.0, 1.0, cushion_height=0.1)
    make_shot(table, [[0.5, 0.5]], physics=Physics("elastic", "restitution"))
    with pytest.raises(ShotError, match=r"table\.cushion_height: han-2005 needs"):
        make_shot(table, [[0.5, 0.5]], physics=Physics("elastic", "han-2005"))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"positions": [[0.1, math.nan]]}, "position: must be finite"),
        ({"velocities": [[1.0, 2.0, 3.0]]}, r"velocities: shape \(1, 3\) does not fit"),
        ({"radii": [R, R]}, "radii: shape"),
        ({"motions": ["sliding", "sliding"]}, "motions: need 1"),
        ({"ids": ("a", "b")}, "1 balls need 1 different ids"),
        ({"physics": Physics(ball_restitution=math.nan)}, "restitution.ball"),
        ({"physics": Physics("soft")}, "models.ball_ball"),
        ({"physics": Physics(sliding=1e-300)}, "friction.sliding"),
    ],
)
def test_absurd_shots_are_refused(arguments, message):
    with pytest.raises(ShotError, match=message):
        make_shot(Table.pool(), **{"positions": [[0.5, 0.5]], **arguments})


def test_a_strike_must_be_finite():
    with pytest.raises(ShotError, match="struck"):
        make_shot(Table.pool(), [[0.5, 0.5]]).struck(0, (math.inf, 0.0))


@pytest.mark.parametrize(
    ("ball", "velocity", "spin"),
    [
        (1, (1.0, 0.0), (0.0, 0.0, 0.0)),
        (-1, (1.0, 0.0), (0.0, 0.0, 0.0)),
        (0, (1.0,), (0.0,) * 4),
        (0, (1.0,), (0.0,) * 3),
        (0, (1.0, 0.0), (0.0,) * 4),
        (0, (1.0, 0.0), (0.0,) * 2),
    ],
)
def test_a_strike_of_no_ball_or_with_too_few_numbers_is_refused(ball, velocity, spin):
    with pytest.raises(ShotError, match="struck"):
        make_shot(Table.pool(), [[0.5, 0.5]]).struck(ball, velocity, spin)


def test_integers_lists_and_views_are_as_good_as_float_arrays():
    numbers = np.array([[0.5, 0.5, 9.0], [0.8, 0.75, 9.0]], dtype=np.float32)
    shots = [
        make_shot(Table.pool(), places, [(1, 0), (0, 0)])
        for places in (numbers[:, :2], numbers[:, :2].tolist())
    ]
    assert np.array_equal(shots[0].balls, shots[1].balls)


def test_layout_is_about_the_middle_and_knows_its_free_rectangle():
    table = Table.pool()
    layout = layout_of(table)
    assert layout is layout_of(Table.pool())
    assert layout.middle == (0.635, 1.27) and layout.free == (-0.635, 0.635, -1.27, 1.27)
    assert is_clear(table, R)
    assert not is_clear(table, 0.01)  # so small a ball could fall into a side pocket beside the rail
    assert layout_of(Table.open()).middle == (0.0, 0.0)
