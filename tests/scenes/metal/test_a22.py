"""Metal balls: what is measured, how balls change worlds, gates, what a hand does, what is heard and kept."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from game.levels import Level, format_level, level_files, load_level, parse_level
from game.physics.solids.tracks import motion as m
from game.physics.solids.tracks.motion import ANGLE, MASS, RADIUS, SPIN, VX, VY, X, Y
from game.scenes.metal.level import BallEntry, Box, FloorEntry, GaugeEntry, MetalContent, PlugEntry
from game.scenes.metal.scene import MetalBalls
from game.stage import Action, ParameterError, Pointer, SetParameter, Stage
from game.worlds.entries.tracks import TrackEntry
from game.worlds.rubbing import SILENT
from tests.scenes.listening import heard_in

pytestmark = pytest.mark.compiled

LEVELS = {path.stem: path for path in level_files("a22")}
HARD = sorted(name for name in LEVELS if name.startswith("hard"))
GROUND = FloorEntry(points=((-20.0, 2.0), (-20.0, 0.0), (20.0, 0.0), (20.0, 2.0)))
YARD = Box(left=-30.0, bottom=-5.0, right=30.0, top=1.0)
INCLINE = TrackEntry(points=tuple((-6.0 + 0.4 * k, 4.5 - 0.3 * k) for k in range(11)))


def open_level(name: str, **parameters: Any) -> Stage:
    return Stage(MetalBalls, level=load_level(LEVELS[name], "a22", MetalContent), parameters=parameters)


def run_of(**content: Any) -> Stage:
    level = Level(scene="a22", title="test", content=MetalContent(**content))
    return Stage(MetalBalls, level=level)


def read(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def ball(stage: Stage, number: int = 0) -> np.ndarray:
    row: np.ndarray = stage.scene.model.tracks.riders.balls.rows[number]
    return row


def drag(stage: Stage, start: tuple[float, float], *ends: tuple[float, float]) -> None:
    stage.post(Pointer("down", *start, 1))
    for end in ends:
        stage.post(Pointer("move", *end, 1))
    stage.post(Pointer("up", *ends[-1], 1))


# -- hard levels ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name: str) -> None:
    stage = open_level(name)
    stage.run(60)
    stage.post(Action("next"))
    stage.run(60 * 16)
    assert stage.fault is None
    found, expected = read(stage), stage.scene.model.content.expected
    assert expected
    for one in expected:
        assert found[one.readout] == pytest.approx(one.value, abs=one.within), one.readout


def test_two_of_a_cradle_leave_together() -> None:
    """As many as came: the last but one is as fast as the last, the others hardly move."""
    stage = open_level("hard-05-two-of-five")
    stage.post(Action("next"))
    fastest = np.zeros(5)
    for _ in range(110):
        stage.run(1)
        speeds = stage.scene.model.tracks.riders.balls.rows[:, VX]
        if speeds[4] > 0.0:
            fastest = np.maximum(fastest, speeds)
    assert fastest[3] == pytest.approx(fastest[4], rel=0.05)
    assert fastest[4] > 2.0 and fastest[:2].max() < 0.35 * fastest[4]


def test_fewer_substeps_are_less_exact() -> None:
    errors = []
    for substeps in (1, 8):
        stage = open_level("hard-02-upright-starts", tier="own", substeps=substeps)
        stage.run(130)
        found = read(stage)
        errors.append(abs(found["cycloid"] / found["cycloid exact"] - 1.0))
    assert errors[1] < 0.2 * errors[0] < 1e-3


# -- from one world to the other --------------------------------------------------------------------


def test_what_a_ball_has_goes_over_unchanged() -> None:
    stage = run_of(
        tracks=(INCLINE,), yards=(YARD,), balls=(BallEntry(at=(-5.0, 3.8625), seated=True),), floors=(GROUND,)
    )
    model = stage.scene.model
    before = ball(stage).copy()
    for _ in range(400):
        stage.run(1)
        if read(stage)["loose"] == 1:
            break
        before = ball(stage).copy()
    assert read(stage)["loose"] == 1 and read(stage)["riding"] == 0
    after = ball(stage)
    body = int(model.balls.table.body[0])
    assert after[SPIN] == pytest.approx(before[SPIN], rel=0.05) and after[SPIN] < -10.0
    assert model.world.bodies.spins[body] == after[SPIN]
    assert model.world.bodies.velocities[body].tolist() == after[[VX, VY]].tolist()
    assert 1.0 / model.world.bodies.inverse_masses[body] == pytest.approx(after[MASS])
    assert after[ANGLE] - before[ANGLE] == pytest.approx(float(before[SPIN]) * stage.dt, rel=0.1)


def test_a_ball_that_comes_out_of_a_yard_rides_on() -> None:
    """It rolls on a track through a yard, and out of it on the same track, as fast as energy says."""
    points = ((-6.0, 3.0), (-4.0, 1.5), (-2.0, 0.5), (0.0, 0.0), (2.0, 0.0), (6.0, 0.0), (9.0, 0.0))
    track = TrackEntry(points=points)
    yard = Box(left=0.5, bottom=-1.0, right=2.5, top=2.0)
    stage = run_of(tracks=(track,), yards=(yard,), balls=(BallEntry(at=(-5.0, 2.3), seated=True),))
    high = float(ball(stage)[Y])
    loose = []
    for _ in range(500):
        stage.run(1)
        loose.append(read(stage)["loose"])
        if ball(stage)[X] > 4.0:
            break
    assert max(loose) == 1 and loose[-1] == 0
    assert read(stage)["riding"] == 1
    wanted = math.sqrt(4.0 / 3.0 * 9.81 * (high - float(ball(stage)[Y])))
    assert ball(stage)[VX] == pytest.approx(wanted, rel=0.02)


def test_in_a_yard_balls_push_each_other_and_elsewhere_they_do_not() -> None:
    """Two that fly at one another: they meet in the yard only."""
    for left, met in ((-9.0, True), (20.0, False)):
        stage = run_of(
            yards=(Box(left=left, bottom=-90.0, right=left + 20.0, top=90.0),),
            balls=tuple(BallEntry(at=(x, 0.0), velocity=(-4.0 * x, 3.0)) for x in (-1.0, 1.0)),
        )
        stage.run(60)
        assert (ball(stage)[VX] < 0.0) == met


# -- gates and gauges -------------------------------------------------------------------------------


def test_gates_open_in_their_order_and_hold_till_then() -> None:
    stage = run_of(
        gates=("a", "b"), yards=(YARD,), floors=(GROUND,),
        balls=(BallEntry(at=(0.0, 4.0), gate="b", delay=0.25), BallEntry(at=(1.0, 0.6))),
        plugs=(PlugEntry(start=(0.5, 0.4), end=(1.5, 0.4), gate="a"),),
    )  # fmt: skip
    stage.run(60)
    assert ball(stage, 1)[Y] == pytest.approx(0.54, abs=0.02) and ball(stage)[Y] == 4.0
    stage.post(Action("next"))
    stage.run(60)
    assert ball(stage, 1)[Y] == pytest.approx(0.1, abs=0.02) and ball(stage)[Y] == 4.0
    stage.post(Action("next"))
    stage.run(29)
    assert ball(stage)[Y] == 4.0
    stage.run(31)
    assert ball(stage)[Y] == pytest.approx(4.0 - 0.5 * 9.81 * 0.25**2, abs=0.05)
    stage.post(Action("next"))
    stage.run(1)
    assert tuple(stage.scene.messages()) == ("All gates are open.",)


def test_a_slope_is_measured_beside_its_formula() -> None:
    gauge = GaugeEntry(name="gain", measure="speeds up", of="one", level=-2.5)
    one = BallEntry(at=(-5.0, 3.85), name="one", seated=True)
    stage = run_of(tracks=(INCLINE,), balls=(one,), gauges=(gauge,))
    assert math.isnan(read(stage)["gain"])
    stage.run(300)
    found = read(stage)
    assert found["gain exact"] == pytest.approx(2.0 / 3.0 * 9.81 * 0.6, rel=1e-6)
    assert found["gain"] == pytest.approx(found["gain exact"], rel=1e-6)
    assert found["worst error"] == pytest.approx(100.0 * abs(found["gain"] / found["gain exact"] - 1.0))


def test_another_gravity_changes_what_is_exact() -> None:
    stage = open_level("hard-02-upright-starts", gravity=4.0 * 9.81 / 2.0)
    stage.run(110)
    found = read(stage)
    assert found["cycloid exact"] == pytest.approx(0.8686524 / math.sqrt(2.0), rel=1e-6)
    assert found["cycloid"] == pytest.approx(found["cycloid exact"], rel=5e-3)


def test_a_level_that_cannot_be_is_refused() -> None:
    with pytest.raises(ValueError, match="gate = 'x'"):
        run_of(balls=(BallEntry(at=(0.0, 0.0), gate="x"),))
    with pytest.raises(ValueError, match="'g' is of 'nobody'"):
        run_of(gauges=(GaugeEntry(name="g", measure="speed", of="nobody"),))
    drop = GaugeEntry(name="g", measure="drop", of="ball 1", track=3)
    with pytest.raises(ValueError, match="no loop"):
        run_of(balls=(BallEntry(at=(0.0, 0.0)),), gauges=(drop,))
    with pytest.raises(ParameterError):
        open_level("default", friction=-1.0)


# -- the hand ---------------------------------------------------------------------------------------


def test_the_hand_lifts_a_ball_that_a_gate_holds() -> None:
    """Its height is changed, and it is still held: the loop is passed from higher up."""
    stage = open_level("default")
    low = stage.scene.story_targets()["low"]
    drag(stage, low, (1.78, 8.74))
    stage.run(20)
    found = read(stage)
    assert found["low drop"] > found["low drop exact"] * 1.02
    for _ in range(3):
        stage.post(Action("next"))
    stage.run(420)
    assert read(stage)["low rode"] == 1


def test_a_bent_track_leads_elsewhere_and_throws_nothing() -> None:
    """H7 of tracks: a point that is dragged at 10 m/s under a ball never makes it faster than twice that."""
    stage = run_of(tracks=(INCLINE,), balls=(BallEntry(at=(-5.0, 3.85), seated=True),))
    stage.post(SetParameter("tool", "bend"))
    stage.run(30)
    x, y = ball(stage)[[X, Y]].tolist()
    stage.post(Pointer("down", x, y - 0.12, 1))
    fastest = 0.0
    for k in range(12):
        stage.post(Pointer("move", x, y - 0.12 + (k + 1) * 10.0 / 120.0, 1))
        stage.run(1)
        fastest = max(fastest, float(np.hypot(*ball(stage)[[VX, VY]])))
    assert stage.scene.model.tracks.riders.curves[0].points[1][1] > 3.2
    assert fastest < 20.0


def test_a_track_of_ones_own_carries_a_ball() -> None:
    stage = run_of(balls=(BallEntry(at=(0.0, 3.0)),), view=Box(left=-4.0, bottom=-1.0, right=6.0, top=4.0))
    stage.post(Action("draw"))
    drag(stage, (-0.5, 2.4), *((-0.5 + 0.1 * k, 2.4 - 0.04 * k) for k in range(1, 40)))
    stage.run(70)
    assert read(stage)["riding"] == 1
    assert ball(stage)[Y] == pytest.approx(
        2.4 - 0.4 * (ball(stage)[X] + 0.5) + 0.1 * math.sqrt(1.16), abs=0.02
    )
    stage.post(Action("delete"))
    drag(stage, (2.0, 1.4), (2.0, 1.4))
    stage.run(40)
    assert read(stage)["riding"] == 0 and len(stage.scene.model.tracks.riders.curves) == 0


@pytest.mark.parametrize("y", [0.1, 5.0])
def test_balls_are_made_sized_and_taken_away(y: float) -> None:
    """Both loose ones (in the yard) and those that fly by themselves."""
    stage = run_of(yards=(YARD,), floors=(GROUND,), view=Box(left=-4.0, bottom=-1.0, right=6.0, top=4.0))
    stage.post(SetParameter("gravity", 0.0))
    stage.post(Action("ball"))
    drag(stage, (0.5, y), (0.5, y))
    stage.run(1)
    assert read(stage)["balls"] == 1 and read(stage)["loose"] == (y < 1.0)
    assert ball(stage)[RADIUS] == pytest.approx(0.12)
    stage.post(Action("size"))
    drag(stage, (0.5, y), (0.8, y))
    stage.run(1)
    assert ball(stage)[RADIUS] == pytest.approx(0.3)
    assert ball(stage)[MASS] == pytest.approx(7.8 * math.pi * 0.09)
    if y < 1.0:
        body = int(stage.scene.model.balls.table.body[0])
        assert 1.0 / stage.scene.model.world.bodies.inverse_masses[body] == pytest.approx(ball(stage)[MASS])
    stage.post(Pointer("down", 0.5, y, 3))
    stage.run(1)
    assert read(stage)["balls"] == read(stage)["loose"] == 0


def test_a_ball_in_the_hand_stays_there() -> None:
    stage = run_of(yards=(YARD,), floors=(GROUND,), balls=(BallEntry(at=(0.0, 0.5)),))
    stage.post(Pointer("down", 0.0, 0.5, 1))
    for place in ((0.2, 0.8), (0.4, 3.0)):
        stage.post(Pointer("move", *place, 1))
        stage.run(30)
        assert ball(stage)[[X, Y]].tolist() == pytest.approx(place)
    stage.post(Pointer("up", 0.4, 3.0, 1))
    stage.run(30)
    assert ball(stage)[Y] < 2.9


def test_a_cradles_ball_keeps_its_size() -> None:
    stage = open_level("hard-05-two-of-five", tool="size")
    drag(stage, stage.scene.story_targets()["cradle last"], (3.0, -1.0))
    assert "keeps its size" in stage.scene.messages()[0]


# -- what is heard and kept -------------------------------------------------------------------------


def test_steel_is_heard_on_steel_wood_and_rails_and_how_it_rolls() -> None:
    stage = open_level("default")
    stage.run(60)
    kinds: set[str] = set()
    steady: set[str] = set()
    for _ in range(5):
        stage.post(Action("next"))
        for _ in range(20):
            kinds |= {kind for kind, _ in heard_in(stage, [2] * 10)}
            steady |= {one.kind for one in stage.scene.hearing().steady}
    assert kinds == {"steel", "wood", "rail"}
    assert {"room", "rolling", "sliding"} <= steady


def test_rolling_on_a_track_is_heard_by_its_weight_and_speed() -> None:
    """Down a slope a disc presses with m g cos, and rolls by its speed."""
    stage = open_level("default")
    stage.run(10)
    assert stage.scene.model.ridden == SILENT
    stage.post(Action("next"))
    stage.run(60)
    model = stage.scene.model
    row = model.balls.rows[0]
    slope = math.atan2(0.3, 0.4)
    # the track presses by m g cos, and by a third of m g sin it keeps the disc from sliding
    push = 9.81 * math.hypot(math.cos(slope), math.sin(slope) / 3.0)
    speed = abs(float(row[m.SPEED]))
    assert speed > 1.0
    assert model.ridden.speed == pytest.approx(speed)
    assert model.ridden.power == pytest.approx(float(row[m.MASS]) * push * speed, rel=0.02)
    assert model.ridden.x == pytest.approx(float(row[m.X]))


def test_what_rests_is_silent() -> None:
    stage = run_of(
        yards=(YARD,), floors=(GROUND,), balls=(BallEntry(at=(0.0, 0.1)), BallEntry(at=(1.0, 0.1)))
    )
    stage.run(30)
    assert heard_in(stage, [2] * 60) == []


@pytest.mark.parametrize("name", sorted(name for name in LEVELS if not name.startswith("story")))
def test_a_step_back_leads_on_the_same(name: str) -> None:
    stage = open_level(name)
    for _ in range(3):
        stage.post(Action("next"))
        stage.run(50)
    digest = stage.digest()
    for _ in range(9):
        assert stage.step_back()
    stage.run(9)
    assert stage.digest() == digest


def test_a_step_back_brings_tracks_and_balls_back() -> None:
    stage = run_of(tracks=(INCLINE,), balls=(BallEntry(at=(-5.0, 3.85), seated=True),), yards=(YARD,))
    stage.post(SetParameter("tool", "draw"))
    stage.run(20)
    drag(stage, (0.0, 3.0), (1.0, 2.0), (2.0, 0.5))
    stage.run(5)
    stage.post(SetParameter("tool", "ball"))
    drag(stage, (0.3, 4.0), (0.3, 4.0))
    stage.run(5)
    assert len(stage.scene.model.tracks.riders.curves) == 2 and read(stage)["balls"] == 2
    for _ in range(9):
        assert stage.step_back()
    assert len(stage.scene.model.tracks.riders.curves) == 2 and read(stage)["balls"] == 1
    while stage.step_number > 19:
        assert stage.step_back()
    assert len(stage.scene.model.tracks.riders.curves) == 1 and read(stage)["balls"] == 1


def test_what_a_hand_has_changed_is_saved() -> None:
    stage = open_level("default")
    drag(stage, stage.scene.story_targets()["big"], (16.2, 8.8))
    stage.post(SetParameter("tool", "draw"))
    drag(stage, (24.0, 3.0), (25.0, 2.6), (26.0, 2.5))
    stage.run(2)
    level = Level(scene="a22", title="mine", content=stage.scene.save_content())
    again = Stage(MetalBalls, level=parse_level(format_level(level), "a22", MetalContent))
    assert read(again)["balls"] == read(stage)["balls"]
    assert len(again.scene.model.tracks.riders.curves) == len(stage.scene.model.tracks.riders.curves)
    assert again.scene.story_targets()["big"] == pytest.approx((16.2, 8.8))
    for _ in range(7):
        again.post(Action("next"))
    again.run(300)
    assert again.fault is None and read(again)["thrown"] > 0.5


def test_an_untouched_level_is_saved_as_it_was() -> None:
    stage = open_level("default")
    assert stage.scene.save_content() == stage.level.content
