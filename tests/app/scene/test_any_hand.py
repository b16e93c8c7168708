"""Whatever a hand does to keys, mouse and window, nothing raises, and the same hand gives the same state."""

from __future__ import annotations

import random
import tracemalloc

import pygame
import pytest

from game.app.fuzz.hand import SIZES, any_event
from game.app.scene.screen import SceneScreen
from game.stage.catalogue import Catalogue
from tests.app.tests_app import Driver, example_entry


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_thousand_events_raise_nothing(start, seed: int, tmp_path):
    hand = random.Random(seed)
    driver = start(catalogue=Catalogue(tuple(example_entry(name) for name in ("example", "second"))))
    for i in range(1000):
        if i % 50 == 49:
            driver.resize(*hand.choice(SIZES))
        driver.waiting += any_event(hand, driver.window.size)
        driver.frames(1, seconds=hand.choice([0.0, 0.004, 0.016, 0.1, 3.0]))
        top = driver.top
        if isinstance(top, SceneScreen) and top.loader is not None:
            top.loader.wait(600.0)
        if i % 100 == 0 and not isinstance(top, SceneScreen):
            driver.app.open_scene("example")
        driver.app.running = True  # the hand may have chosen to leave
    assert driver.window.surface.get_size() == driver.window.size


def drag_script(driver: Driver, frame_s: float) -> tuple[int, str]:
    """The same hand at the same steps, whatever the length of a frame; step and digest at the end."""
    driver.open()
    stage = driver.stage
    hand = {
        30: (True, 0.5, 1.0),
        60: (False, 0.7, 1.4),
        61: None,
        90: (True, -1.0, 0.5),
        91: (False, -1.0, 0.5),
    }
    for step, what in hand.items():
        while stage.step_number < step:
            driver.frames(1, seconds=min(frame_s, (step - stage.step_number) * stage.dt))
        play = driver.top.play
        if what is None:
            play.act("kick")
        else:
            down, x, y = what
            px, py = play.view.camera.to_screen(x, y)
            driver.waiting.append(
                pygame.Event(
                    pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP,
                    pos=(round(px), round(py)),
                    button=1,
                )
            )
            driver.frames(1, seconds=0.0)
    stage.run(240 - stage.step_number)
    return stage.step_number, stage.digest()


def test_frame_rate_does_not_change_the_state(start):
    ends = [drag_script(start(), frame_s) for frame_s in (1 / 240, 1 / 60, 1 / 17)]
    assert ends[0][0] == 240
    assert len(set(ends)) == 1


def test_recorded_session_replays_at_any_frame_rate(start, tmp_path):
    driver = start()
    drag_script(driver, 1 / 60)
    recording, path = driver.stage.recording, tmp_path / "session.json"
    recording.save(path)
    for frame_s in (1 / 144, 0.07):
        play = driver.top.play
        play.open_file(path)
        while driver.stage.step_number < recording.steps:
            driver.frames(
                1, seconds=min(frame_s, (recording.steps - driver.stage.step_number) * driver.stage.dt)
            )
        if play.record.script is not None:  # it is gone with its last event
            play.record.script.post_due()
        assert driver.stage.step_number == recording.steps
        assert driver.stage.digest() == recording.digest


def test_memory_stays_flat(start):
    driver = start()
    driver.open()
    driver.key(pygame.K_SPACE)  # stands still: the charts and snapshots of a running scene fill their bounds

    def used() -> int:
        driver.move(300, 300)
        driver.frames(300)
        return tracemalloc.get_traced_memory()[0]

    tracemalloc.start()
    try:
        for _ in range(8):  # until the bounded rings of figures and words have filled
            before = used()
        for _ in range(3):
            after = used()
        assert after - before < 20_000
    finally:
        tracemalloc.stop()
