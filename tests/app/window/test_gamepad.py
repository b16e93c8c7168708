"""Gamepads: a stick and buttons in the words of keyboard and mouse."""

import pygame
import pytest

from game.app.window.gamepad import POINTER_SPEED, Gamepads


@pytest.fixture
def pads() -> Gamepads:
    pygame.display.init()
    return Gamepads()


def axis(number: int, value: float) -> pygame.Event:
    return pygame.Event(pygame.JOYAXISMOTION, instance_id=0, axis=number, value=value)


def button(number: int, down: bool = True) -> pygame.Event:
    kind = pygame.JOYBUTTONDOWN if down else pygame.JOYBUTTONUP
    return pygame.Event(kind, instance_id=0, button=number)


def test_other_events_pass(pads: Gamepads):
    assert pads.translate(pygame.Event(pygame.KEYDOWN, key=0, scancode=0, mod=0), "keys") is None


def test_stick_is_an_arrow_key_that_repeats(pads: Gamepads):
    assert pads.translate(axis(0, 1.0), "keys") == []
    pressed = [event for _ in range(60) for event in pads.update(1 / 60, "keys", (1280, 720))]
    assert {event.key for event in pressed} == {pygame.K_RIGHT}
    assert len(pressed) == 1 + 5  # at once, after 0.35 s, then every 0.13 s
    pads.translate(axis(0, 0.1), "keys")
    assert pads.update(1 / 60, "keys", (1280, 720)) == []


def test_stick_moves_the_pointer_and_a_presses_it(pads: Gamepads):
    pads.translate(axis(1, -1.0), "pointer")
    (event,) = pads.update(0.1, "pointer", (1000, 500))
    assert event.type == pygame.MOUSEMOTION
    assert event.pos == (500, round(250 - 0.1 * POINTER_SPEED * 500))
    (down,) = pads.translate(button(0), "pointer")
    assert (down.type, down.pos, down.button) == (pygame.MOUSEBUTTONDOWN, event.pos, 1)
    (held,) = pads.update(0.1, "pointer", (1000, 500))
    assert held.buttons == (1, 0, 0)
    (up,) = pads.translate(button(0, down=False), "pointer")
    assert up.type == pygame.MOUSEBUTTONUP


def test_pointer_stays_in_the_window(pads: Gamepads):
    pads.translate(axis(0, 1.0), "pointer")
    for _ in range(600):
        (event,) = pads.update(0.05, "pointer", (320, 240))
    assert event.pos == (319, 120)


def test_buttons_are_keys(pads: Gamepads):
    assert pads.translate(button(0), "keys")[0].key == pygame.K_RETURN
    assert pads.translate(button(1), "pointer")[0].key == pygame.K_ESCAPE
    assert pads.translate(button(99), "keys") == []


def test_cross_is_arrow_keys(pads: Gamepads):
    up = pygame.Event(pygame.JOYHATMOTION, instance_id=0, hat=0, value=(0, 1))
    assert pads.translate(up, "keys")[0].key == pygame.K_UP
    assert pads.translate(pygame.Event(pygame.JOYHATMOTION, instance_id=0, hat=0, value=(0, 0)), "keys") == []


def test_pad_that_is_not_there_any_more(pads: Gamepads):
    assert pads.translate(pygame.Event(pygame.JOYDEVICEADDED, device_index=7), "keys") == []
    assert pads.translate(pygame.Event(pygame.JOYDEVICEREMOVED, instance_id=7), "keys") == []


def test_mouse_takes_over(pads: Gamepads):
    pads.translate(axis(0, 1.0), "pointer")
    pads.update(0.1, "pointer", (1000, 500))
    assert pads.pointer is not None
    pads.translate(pygame.Event(pygame.MOUSEMOTION, pos=(1, 1), rel=(0, 0), buttons=(0, 0, 0)), "pointer")
    assert pads.pointer is None
