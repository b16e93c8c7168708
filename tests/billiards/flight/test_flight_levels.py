"""The levels with balls in the air: the stroke that is kept with each does what its words say."""

import numpy as np
import pytest

from game.billiards import Physics, Table
from game.billiards.game.frame import Frame
from game.billiards.laws.state import AIRBORNE, BALL_BALL, EVENTS, SEG_BALL, SEG_MOTION, SEG_VZ
from game.levels import level_files, load_level
from game.scenes.billiards.level import BilliardsContent, ball_set, game_of, layout_for

TABLE = Table.pool()
R = 0.028575


def played(name, **changes):
    """What comes of a level's kept stroke, some of its numbers changed."""
    path = next(path for path in level_files("billiards") if path.stem.startswith(name))
    level = load_level(path, "billiards", BilliardsContent)
    game = game_of(level.content)
    given = {k: v for k, v in level.parameters.items() if k in Physics._fields}
    layout = layout_for(level.content, game, TABLE, ball_set(0.0, 0.0, 0), 0)
    frame = Frame(game, layout, TABLE, Physics(**given))
    stroke = level.content.solution.stroke()
    return frame.play(stroke._replace(**{k: v * getattr(stroke, k) for k, v in changes.items()}))


def kinds(played):
    return [EVENTS[int(code)] for code in played.trajectory.rows[:, 1] if int(code) not in range(4, 8)]


def least_distance(trajectory, one, other):
    """Least distance of two balls' centres before they meet, m, on a fine grid."""
    rows = trajectory.rows
    met = rows[(rows[:, 1] == BALL_BALL) & (rows[:, 2] == one) & (rows[:, 3] == other), 0]
    end = float(met[0]) if len(met) else 0.6
    found = np.inf
    for t in np.linspace(0.0, end, 20001):
        xy = trajectory.state_at(t).positions
        z = trajectory.heights_at(t)
        found = min(found, float(np.hypot(np.hypot(*(xy[one] - xy[other])), z[one] - z[other])))
    return found


def test_a_tenth_of_a_millimetre_over_the_ball_and_not():
    clear = played("hard-08")
    assert least_distance(clear.trajectory, 0, 1) - 2.0 * R == pytest.approx(1e-4, rel=0.01)
    assert clear.summary.first == (8,)
    assert played("hard-08", cue_speed=0.999).summary.first == (1,)


def test_onto_the_rail_and_off_the_table_is_a_foul():
    after = played("hard-09")
    assert kinds(after)[-2:] == ["ball-rail-top", "ball-off-table"] or "ball-rail-top" in kinds(after)
    assert after.summary.off_table == (0,) and not after.summary.cue_pocketed
    assert after.verdict.fouls[0].kind == "off the table" and after.frame.game.in_hand == "anywhere"
    assert after.frame.cue_ball is None


def test_down_on_a_ball():
    trajectory = played("hard-10").trajectory
    meets = trajectory.rows[trajectory.rows[:, 1] == BALL_BALL, 0][0]
    assert R < trajectory.heights_at(meets)[0] < 2.0 * R
    assert trajectory.heights_at(trajectory.end_time).max() == 0.0


def test_over_a_pocket_and_into_it():
    assert played("hard-11").summary.off_table == (0,)
    softer = played("hard-11", cue_speed=0.7).summary
    assert softer.cue_pocketed and not softer.off_table


def test_several_in_the_air_at_once():
    trajectory = played("hard-12").trajectory
    most = max(int((trajectory.heights_at(t) > 1e-3).sum()) for t in np.linspace(0.0, 3.0, 150))
    assert most >= 3


def test_bounces_die_out():
    trajectory = played("hard-13").trajectory
    rows = trajectory.segments
    rises = rows[(rows[:, SEG_BALL] == 0) & (rows[:, SEG_MOTION] == AIRBORNE), SEG_VZ]
    assert len(rises) > 20 and rises.min() > 0.02
    assert rises[1:] == pytest.approx(0.9 * rises[:-1], rel=1e-9)


@pytest.mark.parametrize("name", ["trick-17", "trick-18", "trick-20", "drill-07"])
def test_a_jump_is_needed(name):
    """The kept stroke is in the air over the balls in its way; a level cue, or a slate without any
    restitution, solves nothing."""
    jump = played(name)
    assert max(jump.trajectory.heights_at(t)[0] for t in np.linspace(0.0, 1.0, 200)) > R
    assert jump.frame.game.best == 3
    assert played(name, elevation=0.0).frame.game.best == 0
