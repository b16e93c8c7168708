"""Effects of the exact table: what is left without them, and what comes of it; shots as data."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from game.billiards import Physics, Table, eight_ball_rack, load_shot, make_shot, simulate
from game.billiards.laws.contacts import CONSTANT_FRICTION, NO_FRICTION
from game.billiards.laws.state import BALL_FRICTION, BALL_LAW
from game.billiards.lecture.state import POCKETS
from game.billiards.shot.shot_writing import shot_data
from game.billiards.shot_effects import (
    AIRBORNE,
    CLOTH,
    EXACT_EFFECTS,
    GAME_EFFECTS,
    RUBBER,
    SPIN_DECAY,
    THROW,
    physics_of,
    table_of,
)

POOL = Table.pool()
BARE = Table.bare(1.0, 2.0)
R = 0.028575


def test_all_effects_leave_all():
    assert physics_of(GAME_EFFECTS) == Physics()
    assert physics_of(EXACT_EFFECTS) == Physics(airborne=False)
    assert table_of(EXACT_EFFECTS, POOL) is POOL


@pytest.mark.parametrize(
    ("effect", "changed"),
    [
        (CLOTH, {"sliding": 0.0, "rolling": 0.0}),
        (SPIN_DECAY, {"spinning": 0.0}),
        (THROW, {"ball_ball": "wallace-1988", "ball_friction": 0.0}),
        (RUBBER, {"cushion": "restitution"}),
        (POCKETS, {}),
        (AIRBORNE, {"airborne": False}),
    ],
)
def test_an_effect_takes_away_its_own(effect, changed):
    full = Physics(sliding=0.3, rolling=0.02, cushion="mathavan-2010")
    assert physics_of(GAME_EFFECTS.without(effect), full) == full._replace(**changed)


def test_without_pockets_the_bed_is_the_same():
    table = table_of(EXACT_EFFECTS.without(POCKETS), POOL)
    assert len(table.pockets) == len(table.jaws) == 0 and len(table.cushions) == 4
    assert (table.width, table.length, table.cushion_height) == (
        POOL.width, POOL.length, POOL.cushion_height
    )  # fmt: skip


def cut(active):
    """A ball that slides into another, 30 degrees off; the direction of the other, rad."""
    line = np.array([math.sin(math.radians(30.0)), math.cos(math.radians(30.0))])
    places = [(0.4, 0.6), (0.4, 0.8) + 2.0 * R * line]
    shot = make_shot(BARE, places, physics=physics_of(active)).struck(0, (0.0, 3.0, 0.0), (0.0, 0.0, 0.0))
    played = simulate(shot)
    hit = next(event for event in played.events if event.type == "ball-ball")
    x, y = played.state_at(hit.time + 1e-6).velocities[1][:2]
    return math.degrees(math.atan2(x, y))


def test_without_throw_a_ball_goes_along_the_line_of_centres():
    assert cut(EXACT_EFFECTS.without(THROW)) == pytest.approx(30.0, abs=1e-4)
    assert cut(EXACT_EFFECTS) < 29.0


def test_without_throw_the_kernels_do_without_the_law_of_friction(monkeypatch):
    """No friction and a friction of 0 are the same to the last bit, and the former computes none of it."""
    rough = make_shot(BARE, [(0.4, 0.6)], physics=physics_of(EXACT_EFFECTS)).constants
    smooth = make_shot(BARE, [(0.4, 0.6)], physics=physics_of(EXACT_EFFECTS.without(THROW))).constants
    assert rough[BALL_LAW] != NO_FRICTION == smooth[BALL_LAW]
    measured = Physics("alciatore-2006", ball_friction=0.0)  # its law knows no such number
    assert make_shot(BARE, [(0.4, 0.6)], physics=measured).constants[BALL_LAW] == rough[BALL_LAW]
    racked = eight_ball_rack(POOL, gap=1e-4, seed=2)
    shot = make_shot(POOL, racked, physics=physics_of(EXACT_EFFECTS.without(THROW)))
    shot = shot.struck(0, (0.2, 6.0, 0.0), (-30.0, 5.0, 40.0))
    played = simulate(shot)
    zeros = shot.constants.copy()
    zeros[BALL_LAW], zeros[BALL_FRICTION] = CONSTANT_FRICTION, 0.0
    monkeypatch.setitem(shot.__dict__, "constants", zeros)
    monkeypatch.delitem(shot.__dict__, "batch")
    assert shot.batch.constants[0, BALL_LAW] == CONSTANT_FRICTION
    again = simulate(shot)
    assert (played.rows == again.rows).all() and (played.end == again.end).all()


def test_without_cloth_a_ball_never_slows_down():
    shot = make_shot(BARE, [(0.5, 0.5)], physics=physics_of(EXACT_EFFECTS.without(CLOTH)))
    played = simulate(shot.struck(0, (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)), until=1.25)
    assert played.state_at(1.25).velocities[0][:2] == pytest.approx([0.0, 1.0])
    assert played.state_at(1.25).positions[0] == pytest.approx([0.5, 1.75])


def test_a_written_shot_is_read_to_the_last_bit(tmp_path):
    shot = make_shot(POOL, eight_ball_rack(POOL), physics=Physics(sliding=0.21, cushion="mathavan-2010"))
    shot = shot.struck(0, (0.1, 4.0, 0.0), (-30.0, 1.0, 7.0))
    path = tmp_path / "a.json"
    path.write_text(json.dumps(shot_data(shot)))
    again = load_shot(path)
    assert again.physics == shot.physics and again.ids == shot.ids
    assert np.array_equal(again.balls, shot.balls)
    for part in ("cushions", "jaws", "pockets"):
        assert np.array_equal(getattr(again.table, part), getattr(shot.table, part))
    assert simulate(again).digest == simulate(shot).digest
