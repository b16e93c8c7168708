"""The window and the small things around it."""

import math
import os

import pygame
import pytest

from game.app.window.frames import FrameMeter, SystemClock
from game.app.window.transition import CrossFade
from game.app.window.window import Window, display_missing


def test_size_in_pixels_follows_a_resize():
    window = Window((640, 400))
    assert window.size == window.points == (640, 400)
    window.resize((800, 500))
    assert window.size == (800, 500)
    window.close()


def test_mouse_positions_become_pixels(monkeypatch: pytest.MonkeyPatch):
    window = Window((400, 300))
    monkeypatch.setattr(Window, "size", property(lambda self: (800, 600)))
    event = pygame.Event(pygame.MOUSEMOTION, pos=(10, 20), rel=(1, -1), buttons=(0, 0, 0))
    moved = window.to_pixels(event)
    assert (moved.pos, moved.rel) == ((20, 40), (2, -2))
    key = pygame.Event(pygame.KEYDOWN, key=1, scancode=1, mod=0)
    assert window.to_pixels(key) is key
    window.close()


def test_lost_display_is_opened_again(monkeypatch: pytest.MonkeyPatch):
    window = Window((400, 300))
    lost = window.window
    lost.destroy()
    window.flip()  # pygame says that the window is gone; a new one takes its place
    assert window.window is not lost
    assert window.size == (400, 300)
    window.surface.fill("white")
    window.flip()
    window.close()


@pytest.mark.parametrize(
    ("environment", "word"),
    [
        ({"SDL_VIDEODRIVER": "dummy"}, "dummy"),
        ({"SDL_VIDEODRIVER": "offscreen"}, "offscreen"),
        ({}, "DISPLAY"),
        ({"DISPLAY": ":0"}, ""),
        ({"WAYLAND_DISPLAY": "wayland-0"}, ""),
        ({"SDL_VIDEODRIVER": "x11"}, ""),
    ],
)
def test_what_the_environment_says_of_a_display(
    monkeypatch: pytest.MonkeyPatch, environment: dict, word: str
):
    for name in ("SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.platform", "linux")
    assert word in display_missing()
    assert bool(word) == bool(display_missing())
    assert os.environ.get("SDL_VIDEODRIVER") == environment.get("SDL_VIDEODRIVER")


def test_frame_meter_gives_median_and_worst():
    meter = FrameMeter()
    assert math.isnan(meter.median_s) and meter.worst_s == 0.0
    for seconds in (0.003, 0.001, 0.050):
        meter.add(seconds)
    assert (meter.median_s, meter.worst_s) == (0.003, 0.050)
    meter.clear()
    assert meter.worst_s == 0.0


def test_system_clock_never_goes_back():
    clock = SystemClock()
    times = [clock.now() for _ in range(100)]
    assert times == sorted(times)
    clock.wait(-1.0)


def test_cross_fade_shows_less_and_less_of_the_old_picture():
    old, new = pygame.Surface((4, 4)), pygame.Surface((4, 4))
    old.fill((200, 0, 0))
    fade = CrossFade()
    fade.begin(old, 1.0)
    seen = []
    while fade.running:
        new.fill((0, 0, 0))
        fade.draw(new)
        seen.append(new.get_at((0, 0)).r)
        fade.update(0.25)
    assert seen[0] == 200
    assert seen == sorted(seen, reverse=True)
    assert len(seen) == 4


def test_no_fade_in_no_time_and_none_over_another_size():
    fade = CrossFade()
    fade.begin(pygame.Surface((4, 4)), 0.0)
    assert not fade.running
    fade.begin(pygame.Surface((4, 4)), 1.0)
    fade.draw(pygame.Surface((5, 4)))
    assert not fade.running
