"""Nothing is left behind: by scenes that were closed, by resizes, by a long time in one scene."""

from __future__ import annotations

import gc
import weakref

import numpy as np
import pygame
import pygame_gui
import pytest

from game.app.fuzz.memory import peak_bytes, resident_bytes
from tests.app.tests_app import Driver

ROUNDS = 6
SLACK = 200  # objects; a round that kept a panel, a stage or a screen would leave thousands


def _objects() -> int:
    gc.collect()
    return len(gc.get_objects())


def test_scenes_that_were_opened_and_closed_are_gone(driver: Driver):
    kept = []
    counts = []
    for _ in range(2 + ROUNDS):
        screen = driver.open()
        driver.frames(3)
        kept += [weakref.ref(screen), weakref.ref(screen.play.stage), weakref.ref(screen.shell.panel)]
        del screen
        driver.app.open_menu()
        driver.frames(40)  # until the change of screens has faded
        counts.append(_objects())
    assert [ref for ref in kept if ref() is not None] == []
    assert counts[-1] - counts[1] < SLACK


@pytest.fixture
def scene(driver: Driver) -> Driver:
    driver.open()
    driver.frames(3)
    return driver


def test_resizes_leave_nothing_behind(scene: Driver):
    sizes = ((1000, 700), (1280, 720), (640, 480))
    counts = []
    for _ in range(2 + ROUNDS):
        for size in sizes:
            scene.resize(*size)
        counts.append(_objects())
    assert counts[-1] - counts[1] < SLACK


def test_a_long_time_in_a_scene_takes_what_snapshots_may_take_and_no_more(scene: Driver):
    stage = scene.stage
    stage.run(40_000)
    scene.frames(2)
    begun, kept = _objects(), stage.snapshot_bytes
    stage.run(20_000)
    scene.frames(2)
    snapshots = (stage.snapshot_bytes - kept) / 300  # bytes: of the least that a snapshot takes
    digests = 20_000 / 120
    assert stage.snapshot_bytes <= 64 << 20
    assert _objects() - begun < SLACK + digests + 20 * snapshots


def test_what_an_element_of_the_panel_posted_is_let_go(scene: Driver):
    class Element:
        pass

    element = Element()
    posted = weakref.ref(element)
    pygame.event.post(pygame.Event(pygame_gui.UI_BUTTON_PRESSED, ui_element=element))
    del element
    scene.resize(1000, 700)
    scene.frames(1)
    assert posted() is None


def test_the_most_is_remembered_when_it_is_given_back():
    much, slack = 64 << 20, 4 << 20  # bytes; the system counts its pages in batches
    before = max(peak_bytes(), resident_bytes())
    taken = np.ones(before - resident_bytes() + much, dtype=np.uint8)
    held = peak_bytes()
    assert held >= before + much - slack
    del taken
    assert peak_bytes() >= held - slack
    assert resident_bytes() < held - much + slack
