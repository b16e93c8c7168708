"""The first minute of who never played: from the card of billiards to a ball potted against the computer.

All by posted events, as a hand would: it aims with the pointer and the wheel by what the guide shows, sets
spin and power at their instruments, and presses Strike. Where the table lies is asked of the program.
"""

import math
import time

import pygame
import pytest

from game.billiards.game.frame import Struck
from game.billiards.game.rules import CUE_BALL
from game.scenes import CATALOGUE
from game.scenes.billiards import layout
from game.scenes.billiards.opponents.thinking import decision_of, simple_stroke
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.prediction import foresee
from game.scenes.shared.thinker import Thinker, Thought
from game.stage import Decision
from tests.app.tests_app import Driver

POWER = 2.2  # m/s that the person gives to a pot
TURN = math.radians(0.05)  # of a notch of the wheel
MINUTE_S = 60.0


def simply(question):
    """An opponent that needs no search: the straightest stroke there is."""
    if question.frame.game.options:
        return Thought((Decision("option", (0.0,)),))
    return Thought((decision_of(simple_stroke(question.frame, question.seed % 1000)),))


class Person:
    """Hands at mouse and keyboard."""

    def __init__(self, driver: Driver) -> None:
        self.driver = driver
        self.scene = driver.stage.scene

    def pixel(self, x: float, y: float) -> tuple[int, int]:
        px, py = self.driver.top.play.view.camera.to_screen(x, y)
        return round(px), round(py)

    def press(self, name: str) -> None:
        """A button of the scene."""
        row = [button for button, _, _ in self.scene.buttons.rows()].index(name)
        self.driver.click(*self.pixel(*layout.button_box(row).middle))

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Press there, move, let go."""
        self.driver.move(*self.pixel(*start))
        self.driver.button(True, *self.pixel(*start))
        self.driver.move(*self.pixel(*end))
        self.driver.button(False, *self.pixel(*end))

    def aim(self, azimuth: float) -> None:
        """The pointer where the ball is to go, then the wheel."""
        x, y = self.scene.model.frame.cue_ball
        place = self.pixel(x + 0.1 * math.cos(azimuth), y + 0.1 * math.sin(azimuth))
        self.driver.move(*place)
        off = math.remainder(self.scene.aiming.cue.aim - azimuth, 2.0 * math.pi)
        notches = round(off / TURN)
        for _ in range(abs(notches)):
            turn = 1 if notches > 0 else -1
            self.driver.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=turn, precise_y=float(turn), pos=place))
        self.driver.click(*place)
        assert self.scene.aiming.locked
        assert abs(math.remainder(self.scene.aiming.cue.aim - azimuth, 2.0 * math.pi)) <= 0.51 * TURN

    def set_spin(self, up: float) -> None:
        x, y = layout.SPIN
        self.drag((x, y), (x - up * layout.SPIN_RADIUS, y))

    def set_power(self, power: float) -> None:
        zero, full = layout.POWER.bottom - layout.POWER_FOOT, layout.POWER.top + layout.POWER_TOP
        x, y = zero + (full - zero) * power / MAX_SPEED, layout.POWER.middle[1]
        self.drag((x, y), (x, y))

    def watch(self) -> None:
        """Until all balls have come to rest."""
        for _ in range(400):
            self.driver.frames(1, 0.05)
            if self.scene.play.phase == "aiming":
                return
        raise AssertionError("the stroke does not end")


@pytest.fixture
def person(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    driver.app.open_scene("billiards")
    driver.frames(20)
    driver.key(pygame.K_RETURN)
    while driver.top.loader is not None:
        driver.top.loader.wait(300.0)
        driver.frames(2)
    driver.stage.scene.opponents.thinker = Thinker(simply)
    yield Person(driver)
    driver.close()


def pot_of(scene) -> float | None:
    """An aim with which a ball that counts goes down and the cue ball does not, as tried along the guide."""
    frame, stroke = scene.model.frame, scene.aiming.stroke
    places = {number: (x, y) for number, x, y in frame.layout.places}
    x, y = frame.cue_ball
    for number in frame.game.legal_first():
        towards = math.atan2(places[number][1] - y, places[number][0] - x)
        for step in range(-60, 61):
            azimuth = towards + step * 2.0 * TURN
            sights = [
                foresee(Struck(frame, stroke._replace(azimuth=azimuth + off)), 200)
                for off in (-0.6 * TURN, 0.0, 0.6 * TURN)
            ]
            if all(sight.target == number and number in _down(sight) and _stays(sight) for sight in sights):
                return azimuth
    return None


def _down(sight) -> set[int]:
    return {path.number for path in sight.others if path.potted}


def _stays(sight) -> bool:
    return sight.last is not None and 8 not in _down(sight)


def their_turn(person: Person) -> None:
    """The opponent plays, or chooses, until the person is at turn."""
    scene = person.scene
    for _ in range(2000):
        if scene.play.person_plays and scene.play.phase == "aiming":
            return
        person.driver.frames(1, 0.05)
        while scene.opponents.thinker.thinking:
            time.sleep(0.001)
        if scene.play.phase == "rolling":
            person.driver.key(pygame.K_RETURN)
    raise AssertionError("the opponent does not play")


def test_from_the_card_to_a_potted_ball_within_a_minute(person: Person):
    scene, driver = person.scene, person.driver
    began = driver.clock.time_s
    assert scene.play.grade_of(0) == "person" and scene.play.grade_of(1) == "novice"
    x, y = scene.model.frame.cue_ball
    person.aim(math.atan2(1.9 - y, 0.635 - x))
    person.set_power(7.0)
    person.press("strike")
    person.watch()
    potted = None
    while potted is None and driver.clock.time_s - began < 4.0 * MINUTE_S:
        their_turn(person)
        if scene.model.frame.game.options:
            driver.key(pygame.K_1)
            continue
        if scene.model.frame.game.in_hand:
            driver.move(*person.pixel(*scene.model.frame.cue_ball))
        aimed = play_a_stroke(person)
        count = set(scene.model.frame.game.on_table)
        assert scene.play.phase == "striking"
        person.watch()
        gone = count - set(scene.model.frame.game.on_table)
        if aimed and gone and not scene.model.frame.foul:
            potted = gone
    assert potted and CUE_BALL not in potted
    assert scene.model.frame.game.turn == 0  # who pots plays on
    assert driver.clock.time_s - began < MINUTE_S
    assert driver.top.play.trouble == ""


def play_a_stroke(person: Person) -> bool:
    """Power, aim, spin, power again, each left alone by the others; then Strike. Whether a pot was seen."""
    scene = person.scene
    person.set_power(POWER)
    person.driver.key(pygame.K_c)
    azimuth = pot_of(scene)
    found = azimuth is not None
    if azimuth is None:
        azimuth = simple_stroke(scene.model.frame, 0).azimuth
    if scene.aiming.locked:  # a click frees the aim
        x, y = scene.model.frame.cue_ball
        person.driver.click(*person.pixel(x + 0.15, y + 0.15 if y < 1.2 else y - 0.15))
    person.aim(azimuth)
    aim = scene.aiming.cue.aim
    person.set_spin(0.2)
    assert scene.aiming.cue.aim == aim and scene.parameters.tip_up == pytest.approx(0.2, abs=0.05)
    person.driver.key(pygame.K_c)
    assert scene.aiming.cue.aim == aim and scene.parameters.tip_up == 0.0
    tip = (scene.parameters.tip_left, scene.parameters.tip_up)
    person.set_power(POWER)
    assert scene.aiming.cue.aim == aim and (scene.parameters.tip_left, scene.parameters.tip_up) == tip
    power = scene.parameters.power
    assert power == pytest.approx(POWER, abs=0.05)
    person.press("strike")
    assert scene.play.pending.azimuth == aim and scene.parameters.power == power
    return found
