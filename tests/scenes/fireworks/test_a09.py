"""Great fireworks, A09, by stage events: shells, bursts, wind, sound, hard cases."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import LevelError, level_files, parse_level
from game.physics.generations.step import BORN, DROPPED, MADE, VX, VY, X, Y
from game.scenes.fireworks import told
from game.scenes.fireworks.eye import AWAY, EYE
from game.scenes.fireworks.level import FireworksContent
from game.scenes.fireworks.measures import NAMED_S, BurstNow
from game.scenes.fireworks.scene import Fireworks
from game.scenes.fireworks.shells import BURSTS, SHELLS, Amounts, all_kinds, heart, spiral_arms
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from tests.scenes.particle_stages import click, drag, open_level, readouts

pytestmark = pytest.mark.compiled
HARD = [path.stem for path in level_files("a09") if path.stem.startswith("hard")]


def empty(**parameters) -> Stage:
    """A lake without a show, in still air unless told otherwise."""
    return Stage(Fireworks, parameters={"wind": 0.0, **parameters})


def until(stage: Stage, name: str, least: float, longest: int = 900) -> None:
    """Step until a readout is at least so much."""
    for _ in range(longest):
        if readouts(stage)[name] >= least:
            return
        stage.run(1)
    raise AssertionError(f"{name} stays at {readouts(stage)[name]}")


def test_ten_or_more_shells_with_different_effects():
    """A09.1"""
    assert len(SHELLS) >= 10
    assert len({(births[0].kind, births[0].pattern) for births in BURSTS.values() if births}) >= 10
    patterns = {birth.pattern for births in BURSTS.values() for birth in births}
    assert {"sphere", "ring", "arms", "shape"} <= patterns


def test_stars_burst_into_stars_and_burn_away():
    """A09.2: a crossette's stars split in four, whose sparks are a further generation."""
    stage = empty(shell="crossette")
    click(stage, (0.0, 90.0))
    until(stage, "bursts", 1)
    system = stage.scene.model.system
    assert system.stars("split").shape[1] == 22
    for _ in range(90):
        stage.run(1)
        if system.stars("cross").shape[1]:
            break
    assert system.stars("cross").shape[1] == 88
    stage.run(20)
    assert system.stars("silver").shape[1] > 500
    assert any(kind.burns > 0.4 for kind in system.kinds)


def test_a_launch_throws_recoil_sparks_and_smoke_and_is_heard():
    """A09.3"""
    stage = empty()
    click(stage, (0.0, 100.0))
    stage.run(2)
    system = stage.scene.model.system
    lift = system.stars("lift")
    assert lift.shape[1] == 54
    assert (lift[VX] < -5.0).any() and (lift[VX] > 5.0).any() and (lift[VY] > 20.0).sum() > 20
    assert system.stars("smoke").shape[1] >= 5
    until(stage, "heard", 1)
    assert stage.scene.hearing().sounds[-1].kind == "mortar"


@pytest.mark.parametrize("wind", [0.0, 12.0, -25.0])
def test_a_shell_bursts_where_it_was_clicked(wind):
    stage = empty(wind=wind, shear=0.0)
    click(stage, (37.0, 96.0))
    until(stage, "bursts", 1)
    assert stage.scene.model.burst[1:3] == pytest.approx((37.0, 96.0), abs=0.05)
    assert readouts(stage)["off the mark"] < 0.05


def test_a_click_from_the_side_bursts_where_it_was_seen():
    stage = empty(bearing=60.0, shear=0.0)
    click(stage, (37.0, 96.0))
    until(stage, "bursts", 1)
    x, _, z = stage.scene.model.burst[1:4]
    assert math.hypot(x, z) == pytest.approx(37.0, abs=0.05) and z > 30.0
    assert stage.scene.story_targets()["burst"] == pytest.approx((37.0, 96.0), abs=0.05)


def test_the_camera_goes_round_and_changes_nothing_of_the_show():
    still, round_it = empty(), empty()
    for stage in (still, round_it):
        stage.scene.model.burst_at("peony", (50.0, 90.0))
        stage.run(30)
    round_it.post(SetParameter("bearing", 90.0))
    for stage in (still, round_it):
        stage.run(200)
    assert round_it.scene.model.bearing == pytest.approx(90.0, abs=0.1)
    assert round_it.digest() == still.digest()
    assert still.scene.story_targets()["burst"] == pytest.approx((50.0, 90.0))
    near = AWAY / (AWAY - 50.0)  # from the right what was to the right is before the middle
    assert round_it.scene.story_targets()["burst"] == pytest.approx((0.0, EYE + near * (90.0 - EYE)), abs=0.2)


def test_a_ball_is_as_deep_as_it_is_large_and_a_heart_is_flat():
    for shell, share in (("peony", 1.0), ("heart", 0.0)):
        stage = empty(shell=shell)
        stage.scene.model.burst_at(shell, (0.0, 100.0))
        stage.run(60)
        found = readouts(stage)
        assert found["burst depth"] == pytest.approx(share * found["burst radius"], rel=0.05, abs=1e-9)


@pytest.mark.parametrize("shear", [0.0, 0.004, 0.01])
def test_smoke_drifts_with_the_wind_of_its_own_height(shear):
    """No puff overtakes the air round it: what is more than the wind at the ground is the shear."""
    stage = open_level(Fireworks, "one-of-each", wind=9.0, shear=shear)
    until(stage, "bursts", 1)
    stage.run(1200)
    found, smoke = readouts(stage), stage.scene.model.system.stars("smoke")
    height = float(smoke[Y].mean())
    assert height > 20.0
    assert found["wind at the smoke"] == pytest.approx(9.0 * (1.0 + shear * height), rel=1e-9)
    old = smoke[:, smoke[BORN] < stage.time_s - 6.0]
    assert old.shape[1] > 100
    assert old[VX] == pytest.approx(9.0 * (1.0 + shear * old[Y]), rel=0.01)


def test_the_programme_is_laid_for_still_air():
    """A09.4: the wind takes its shells off the mark, and carries the smoke."""
    missed = {}
    for wind in (0.0, 20.0):
        stage = open_level(Fireworks, "one-of-each", wind=wind, shear=0.0)
        until(stage, "bursts", 1)
        missed[wind] = readouts(stage)["off the mark"]
        stage.run(120)
        assert readouts(stage)["smoke drift"] == pytest.approx(wind, abs=0.5 + 0.15 * wind)
    assert missed[0.0] < 0.05 and missed[20.0] > 3.0


def test_gusts_change_the_wind_as_the_level_says():
    stage = open_level(Fireworks, "gale")
    for seconds, wind in ((4.0, 9.0), (10.0, 18.0), (23.0, 9.0)):
        stage.run(round((seconds - stage.time_s) / stage.dt))
        assert readouts(stage)["wind"] == pytest.approx(wind, abs=1e-9)
    stage.post(SetEffect("wind", False))
    assert readouts(stage)["wind"] == 0.0


@pytest.mark.parametrize(("method", "most"), [("split-drag", 0.02), ("rk4", 0.002), ("explicit-euler", 1.2)])
def test_the_radius_of_a_burst_in_still_air(method, most):
    """A09.7: beside ln(1 + c v t)/c; the momentum of a burst is that of its shell."""
    stage = open_level(Fireworks, "still-air", method=method)
    stage.run(80)
    found = readouts(stage)
    assert found["ballistics"] == pytest.approx(math.log1p(0.018 * 58.0 * (80 / 60 - 0.5)) / 0.018, rel=1e-12)
    assert found["radius error"] < most
    if method == "explicit-euler":
        assert found["radius error"] > 0.05
    assert found["burst momentum"] < 1e-14


def test_the_radius_of_stars_that_burn_away():
    """Beside 1/v = 1/v0 - c/b ln(1 - b t), with a spread of lives of 6 %."""
    stage = open_level(Fireworks, "still-air")
    stage.post(SetEffect("burning", True))
    stage.run(100)
    found = readouts(stage)
    assert found["radius error"] < 0.006 * found["ballistics"]
    assert found["ballistics"] < math.log1p(0.018 * 58.0 * (100 / 60 - 0.5)) / 0.018 - 1.0


def test_heavier_stars_fly_farther():
    reach = []
    for mass in (0.5, 1.0, 4.0):
        stage = open_level(Fireworks, "still-air", star_mass=mass)
        stage.run(90)
        reach.append(readouts(stage)["burst radius"])
        assert readouts(stage)["radius error"] < 0.1
    assert reach[0] < 0.8 * reach[1] < 0.8 * reach[2]


def test_sound_comes_by_its_distance_in_order_and_none_is_lost():
    """A09.6: each within a step of d / 343.2, wherever the listener goes meanwhile."""
    stage = open_level(Fireworks, "hard-07-far-listener")
    thunder = stage.scene.model.thunder
    place = stage.scene.model.listener_place()
    stage.post(Pointer("down", *place, button=1))
    stage.post(Pointer("move", 700.0, place[1], button=1))
    stage.run(200)
    stage.post(Pointer("move", -400.0, place[1], button=1))
    stage.run(1000)
    assert thunder.ear[0] == pytest.approx(-400.0)
    assert readouts(stage)["heard"] == 10 and readouts(stage)["sounds on their way"] == 0
    rows = thunder.heard[:10]
    assert (np.diff(rows[:, 0]) >= 0.0).all()
    kinds = [sound.kind for sound in stage.scene.hearing().sounds]
    assert kinds.count("mortar") == kinds.count("burst") == 5


def test_a_standing_listener_hears_by_the_distance_alone():
    stage = empty(distance=500.0)
    stage.scene.model.burst_at("peony", (120.0, 90.0))
    until(stage, "heard", 1)
    way = math.hypot(120.0, 90.0 - 1.7, 500.0)
    assert readouts(stage)["sound came after"] == pytest.approx(way / 343.2, abs=1e-9)
    assert stage.scene.hearing().sounds[-1].time == pytest.approx(1e-6 + way / 343.2, abs=1e-7)


def test_clicks_and_drags():
    stage = empty(shell="heart")
    click(stage, (10.0, 4.0))
    assert readouts(stage)["fired"] == 0 and "higher" in stage.scene.messages()[0]
    click(stage, (20.0, 80.0), button=3)
    stage.run(1)
    assert readouts(stage)["bursts"] == 1
    assert stage.scene.model.burst[1:3] == pytest.approx((20.0, 80.0), abs=1e-4)
    drag(stage, stage.scene.model.listener_place(), (60.0, -20.0), steps=30)
    stage.run(30)
    assert stage.scene.model.thunder.ear[0] == pytest.approx(60.0)
    assert readouts(stage)["fired"] == 1  # the drag fired nothing
    stage.post(Action("salvo"))
    stage.run(1)
    assert readouts(stage)["fired"] == 1 + len(SHELLS)
    stage.post(Action("clear"))
    assert readouts(stage)["alive"] == 0
    stage.scene.check()


def test_the_finale_has_sixty_thousand_stars():
    stage = open_level(Fireworks, "default")
    stage.run(round(54.0 / stage.dt))
    assert readouts(stage)["alive"] > 60_000
    stage.scene.check()
    stage.run(round(12.0 / stage.dt))
    assert 0.0 <= readouts(stage)["show"] < 3.0  # it goes round


def test_a_step_back_and_on_again_is_equal():
    stage = open_level(Fireworks, "default")
    stage.run(530)  # a shell is fired, and its sound on its way, within the next steps
    here = stage.digest()
    stage.run(20)
    there = stage.digest()
    for _ in range(20):
        stage.step_back()
    assert stage.digest() == here
    stage.run(20)
    assert stage.digest() == there


def test_the_programme_waits_when_it_is_switched_off():
    stage = open_level(Fireworks, "default")
    stage.post(SetParameter("programme", False))
    stage.run(200)
    assert readouts(stage)["fired"] == 0
    stage.post(SetParameter("programme", True))
    stage.run(200)
    assert readouts(stage)["fired"] == 3  # what was due meanwhile has passed


@pytest.mark.parametrize("name", HARD)
def test_hard_cases_run(name):
    stage = open_level(Fireworks, name)
    stage.run(400)
    assert stage.fault is None
    stage.scene.check()


def test_stiff_drag_goes_to_the_wind_and_never_past_it():
    """H1"""
    stage = open_level(Fireworks, "hard-01-stiff-drag")
    system = stage.scene.model.system
    stage.run(14)
    for _ in range(60):
        stage.run(1)
        for kind in ("ember", "smoke"):
            stars = system.stars(kind)
            old = stars[:, stars[BORN] < stage.time_s - 2.0 * stage.dt]
            assert np.allclose(old[VX], 6.0, rtol=0, atol=1e-9)
            assert np.allclose(old[VY], 0.0, rtol=0, atol=1e-9)
    assert system.stars("ember").shape[1] > 1000


def test_a_full_pool_is_counted_and_told():
    """H3: what is born is alive, has ended, or was dropped; the message comes once."""
    stage = open_level(Fireworks, "hard-02-pool-full")
    stage.run(300)
    system = stage.scene.model.system
    assert system.tally(DROPPED) > 10_000
    assert len(system) <= sum(kind.capacity for kind in all_kinds(Amounts(1.0, 0.02)))
    assert sum("No place" in words for words in stage.scene.messages()) == 1
    system.check()
    assert system.tally(MADE) > system.tally(DROPPED)


def test_a_sudden_wind_takes_smoke_along_and_nothing_past_it():
    """H7"""
    stage = open_level(Fireworks, "hard-03-wind-step")
    stage.run(120)
    assert abs(readouts(stage)["smoke drift"]) < 0.5
    for _ in range(120):
        stage.run(1)
        assert stage.scene.model.system.stars("smoke")[VX].max() <= 40.0
    # k = 1.3/s: 40 (1 - exp(-k t)) after 2 s
    assert readouts(stage)["smoke drift"] == pytest.approx(40.0 * (1.0 - math.exp(-1.3 * 2.0)), rel=0.01)


def test_births_do_not_drift_on_a_late_clock():
    """H10: what an hour later is born is what is born at once, at the same instants."""
    late = open_level(Fireworks, "hard-04-one-hour")
    path = next(path for path in level_files("a09") if path.stem == "hard-04-one-hour")
    words = path.read_text(encoding="utf-8").replace("begins = 3600.0", "begins = 0.0")
    early = Stage(Fireworks, level=parse_level(words, "a09", FireworksContent, path))
    for stage in (late, early):
        stage.run(300)
    one, other = (stage.scene.model.system for stage in (late, early))
    assert one.tally(MADE) == other.tally(MADE) > 2000
    for kind in ("gilt", "glitter"):
        order, same = (np.argsort(system.identities(kind)) for system in (one, other))
        a, b = one.stars(kind)[:, order], other.stars(kind)[:, same]
        assert np.allclose(a[BORN] - 3600.0, b[BORN], rtol=0, atol=2e-12)
        assert np.allclose(a[X], b[X], rtol=0, atol=1e-8) and np.allclose(a[Y], b[Y], rtol=0, atol=1e-8)


def test_burst_and_fall_in_one_step_by_the_order_of_time():
    """H4: the first bursts above the ground; the others meet it before their fuses end."""
    stage = open_level(Fireworks, "hard-05-burst-and-fall")
    stage.run(1)
    assert readouts(stage)["bursts"] == 1
    stage.run(3)
    assert readouts(stage)["bursts"] == 1 and readouts(stage)["duds"] == 2
    for kind in ("red", "lemon"):
        assert (stage.scene.model.system.stars(kind)[Y] >= 0.0).all()


def test_levels_say_what_is_wrong_in_one_line():
    for words, field in (
        ('scene = "a09"\n[content]\ncues = [{ time = 1.0, shell = "salami", at = [0.0, 50.0] }]\n', "shell"),
        ('scene = "a09"\n[content]\ncues = [{ time = -1.0, shell = "peony", at = [0.0, 50.0] }]\n', "time"),
        ('scene = "a09"\n[content]\naloft = [{ shell = "peony", position = [0.0, nan] }]\n', "position"),
    ):
        with pytest.raises(LevelError) as error:
            parse_level(words, "a09", FireworksContent)
        assert field in str(error.value) and "\n" not in str(error.value)


def test_shapes_keep_the_momentum():
    for points in (heart(112), spiral_arms(90)):
        assert math.fsum(x for x, _ in points) == pytest.approx(0.0, abs=1e-12)
        assert math.fsum(y for _, y in points) == pytest.approx(0.0, abs=1e-12)
        assert max(math.hypot(*point) for point in points) == pytest.approx(1.0)


def test_a_burst_is_named_for_so_long_and_no_longer(monkeypatch):
    """And the listener, always."""
    stage = empty()
    names, now = stage.scene.story_names, told.burst_now
    newest = BurstNow(age=0.0, radius=40.0, ballistics=40.0, momentum=0.0, stars=60, fastest=5.0, depth=40.0)
    monkeypatch.setattr(told, "burst_now", lambda model: newest)
    monkeypatch.setattr(told, "burst_middle", lambda model: (0.0, 50.0, 0.0))
    stage.scene.model.burst[4] = 0.0
    for age, count in ((0.0, 2), (math.nextafter(NAMED_S, 0.0), 2), (NAMED_S, 1), (NAMED_S + 1.0, 1)):
        newest = newest._replace(age=age)
        assert len(names()) == count, age
    assert now(stage.scene.model) is None
