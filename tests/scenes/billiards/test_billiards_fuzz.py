"""Whatever a hand does: no exception, no ball lost, and the same again from the recording."""

import contextlib
import math

import numpy as np
import pytest

from game.levels import level_files
from game.scenes.billiards import layout
from game.scenes.billiards.scene import Billiards
from game.stage import Action, Decision, ParameterError, Pointer, SetEffect, SetParameter, replay_scene
from tests.scenes.billiards.billiards_stages import check_balls, open_level
from tests.scenes.test_saved_at_any_moment import opened_again

LEVELS = ("default", "nine-ball", "combination", "practice", "called-pockets")
KINDS = ("move", "move", "move", "down", "up", "wheel", "cancel")


def places_worth_pressing() -> list[tuple[float, float]]:
    """Where there is something to be pressed or dragged."""
    places = [layout.button_box(row).middle for row in range(5)]
    places += [layout.option_box(row, 3).middle for row in range(3)]
    places += [layout.PLAY.middle, layout.SPEED.middle, layout.SCRUBBER.middle, layout.POWER.middle]
    places += [layout.SPIN, layout.ELEVATION, *(layout.tray_place(number) for number in (0, 3, 15))]
    return places


PRESSED = places_worth_pressing()


def random_event(random: np.random.Generator, scene: Billiards):
    """An event that a hand, a key or a panel may bring."""
    chance = random.random()
    if chance < 0.62:
        where = random.random()
        if where < 0.25:
            x, y = PRESSED[random.integers(len(PRESSED))]
        elif where < 0.5 and scene.model.frame.layout.places:
            _, x, y = scene.model.frame.layout.places[random.integers(len(scene.model.frame.layout.places))]
        else:
            x, y = random.uniform(-0.4, 1.7), random.uniform(-0.5, 3.0)
        kind = KINDS[random.integers(len(KINDS))]
        button = int(random.choice((0, 1, 1, 1, 3))) if kind != "wheel" else 0
        return Pointer(
            kind, float(x), float(y), button, float(random.integers(-3, 4)), bool(random.random() < 0.2),
            bool(random.random() < 0.1),
        )  # fmt: skip
    if chance < 0.85:
        actions = [action.name for action in Billiards.actions]
        weights = np.array([6.0 if name == "strike" else 1.0 for name in actions])
        return Action(str(random.choice(actions, p=weights / weights.sum())))
    if chance < 0.95:
        name, low, high = (
            ("power", 0.1, 10.0), ("tip_left", -0.6, 0.6), ("tip_up", -0.6, 0.6), ("elevation", 0.0, 80.0),
            ("rolling", 0.002, 0.05),
        )[random.integers(5)]  # fmt: skip
        return SetParameter(name, float(random.uniform(low, high)))
    if chance < 0.97:
        return SetEffect(str(random.choice(("cloth", "throw", "pockets"))), bool(random.random() < 0.7))
    values = (
        2.0 + 3.0 * random.random(),
        random.uniform(-math.pi, math.pi),
        0.0,
        0.0,
        0.0,
        -1.0,
        -1.0,
        0.0,
        0.0,
    )
    return Decision("stroke", values)


@pytest.mark.parametrize("seed", range(40))
def test_random_sequences_lose_no_ball(seed):
    random = np.random.default_rng(seed)
    stage = open_level(LEVELS[seed % len(LEVELS)])
    for number in range(60):
        with contextlib.suppress(ParameterError):  # refused: a decision where none is due
            stage.post(random_event(random, stage.scene))
        stage.run(int(random.choice((0, 1, 5, 40, 240), p=(0.4, 0.3, 0.15, 0.1, 0.05))))
        assert stage.fault is None, (number, stage.fault)
        if stage.scene.play.phase in ("aiming", "replay"):
            check_balls(stage)
        if number % 6 == 5:
            opened_again(stage)
        if number % 20 == 19:
            for _ in range(3):
                stage.step_back()
            stage.resume()
    if seed % 8 == 0:
        assert replay_scene(stage.recording, Billiards).digest() == stage.digest()


@pytest.mark.parametrize("path", level_files("billiards"), ids=lambda path: path.stem)
def test_every_level_opens(path):
    stage = open_level(path.stem)
    assert stage.run(3) == 3 and stage.fault is None
    check_balls(stage)


HARD = [path.stem for path in level_files("billiards") if path.stem.startswith("hard-")]


@pytest.mark.parametrize("name", HARD)
def test_hard_cases_end_without_a_ball_lost_whichever_way_one_strikes(name):
    stage = open_level(name, power=10.0, tip_up=0.3, tip_left=0.2)
    scene = stage.scene
    start = scene.model.frame.layout.places
    for aim in np.linspace(0.0, 2.0 * math.pi, 13)[:-1].tolist():
        scene.aiming.cue.point_to(aim)
        stage.post(Action("strike"))
        stage.run(60)
        assert scene.play.phase == "rolling"
        stage.post(Action("strike"))
        assert scene.play.phase == "aiming"
        check_balls(stage)
        if scene.model.frame.layout.places != start:
            stage.post(Action("undo"))
        assert scene.model.frame.layout.places == start


def test_a_tight_rack_struck_straight_on_stays_mirror_symmetric():
    stage = open_level("hard-04-tight-rack", power=8.0)
    scene = stage.scene
    stage.post(Action("strike"))
    stage.run(60)
    first = next(time for time, code, *_ in scene.model.played.trajectory.rows.tolist() if code == 0)
    velocities = scene.model.played.trajectory.state_at(first + 1e-6).velocities
    across = np.sort(velocities[:, 0])
    assert across == pytest.approx(-across[::-1], abs=1e-6)
    assert across[-1] > 0.3
