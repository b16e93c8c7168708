"""Arrows and measures on the stages of the small scenes: where they point, and that they tell what is so."""

import math

import pytest

from game.physics.oscillators import pendulum_period
from game.scenes import CATALOGUE
from game.stage import Stage
from tests.scenes.examples.test_tasks import stage_of


class Spy:
    """A canvas that keeps what it is asked to draw."""

    def __init__(self):
        self.arrows, self.words = {}, []

    def arrow(self, tail, vector, color, label="", **options):
        self.arrows.setdefault(label or color, []).append((tail, vector))

    def label(self, place, words, *options, **named):
        self.words.append(words)

    def formula(self, place, markup, *options):
        self.words.append(markup)

    def figure(self, place, words):
        return words

    def px(self, length):
        return 0.01 * length

    def __getattr__(self, name):
        return lambda *positional, **named: None


def drawn(stage: Stage) -> Spy:
    spy = Spy()
    stage.scene.draw(spy, 1.0)
    return spy


def played(name, seconds, **parameters):
    stage = Stage(CATALOGUE[name].load(), parameters=parameters)
    stage.run(round(seconds / stage.dt))
    return stage


@pytest.mark.parametrize(
    ("degrees", "times"), [(0.0, 1.0), (60.0, 1.0731820071), (90.0, 1.1803405990), (120.0, 1.3728805006)]
)
def test_the_period_is_that_of_the_tables(degrees, times):
    small = math.tau * math.sqrt(2.0 / 9.81)
    assert pendulum_period(math.radians(degrees), 9.81 / 2.0) == pytest.approx(times * small, rel=1e-9)


def test_a_pendulum_without_gravity_or_beyond_upright_has_no_period():
    assert pendulum_period(1.0, 0.0) == math.inf and pendulum_period(math.radians(180.5), 9.81) == math.inf


@pytest.mark.parametrize("start", [20.0, 100.0])
def test_the_measured_period_is_that_by_the_law(start):
    stage = played("pendulum", 9.0, method="rk4", start=start)
    found = {one.name: one.value for one in stage.readouts()}
    assert found["period"] == pytest.approx(found["by the law"], rel=1e-4)
    assert any(f"{found['period']:.3f} s" in words for words in drawn(stage).words)


def test_arrows_of_a_pendulum_follow_its_motion():
    stage = played("pendulum", 0.3)
    angle, rate = stage.scene.swing.tolist()
    ((tail, velocity),) = drawn(stage).arrows["v"]
    assert tail == pytest.approx((math.sin(angle), -math.cos(angle)))
    assert rate < 0.0 and velocity[0] < 0.0  # let go at the right, it swings to the left
    assert velocity[0] * tail[0] + velocity[1] * tail[1] == pytest.approx(0.0, abs=1e-12)
    ((_, weight),), ((_, rod),) = drawn(stage).arrows["m g"], drawn(stage).arrows["F"]
    total = weight[0] + rod[0], weight[1] + rod[1]
    toward = -(total[0] * tail[0] + total[1] * tail[1])
    assert toward == pytest.approx(0.04 * rate * rate)  # what bends the path: l rate², in the arrows' unit


def test_a_ball_is_told_how_high_it_will_rise():
    stage = played("bouncing-ball", 0.2)
    assert [words for words in drawn(stage).words if "h" in words] == [
        "h",
        *(f"e^{n} h" for n in (2, 4, 6, 8)),
    ]
    ((_, velocity),) = drawn(stage).arrows["v"]
    assert velocity[1] < 0.0 and f"{stage.scene.ball[0]:.2f} m" in drawn(stage).words


def test_beads_are_pulled_back_to_their_line():
    stage = played("spring-chain", 0.0, mode=1)
    assert all(vector[1] < 0.0 < tail[1] for tail, vector in drawn(stage).arrows["amber"])


def test_a_task_is_not_answered_by_the_picture():
    stage = stage_of("pendulum", "task-period")
    stage.run(round(5.0 / stage.dt))
    assert not any("Period" in words for words in drawn(stage).words)
    stage = stage_of("bouncing-ball", "task-restitution")
    assert not any("e^" in words for words in drawn(stage).words)
