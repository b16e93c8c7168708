"""Fuzzing: what a scene raises is found, and hostile files are refused."""

from __future__ import annotations

import math
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pygame
import pytest

from game.app.fuzz.hostile import spoil
from game.app.fuzz.session import FuzzSession
from game.app.fuzz.values import any_value
from game.app.window.settings import load_settings
from game.levels import LevelError, load_level, parse_level
from game.stage import ParameterError, SetEffect, SetParameter
from game.stage.records.recording import Recording, RecordingError
from tests.app.tests_app import CATALOGUE, example_entry
from tests.paths import ROOT

LEVEL = """scene = "example"
title = "A level"
seed = 3
[parameters]
restitution = 0.5
"""


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    return tmp_path


def test_a_scene_bears_a_random_hand(home: Path):
    report = FuzzSession(CATALOGUE, "example", 5, home).run(400)
    assert report.trouble == "" and report.events >= 400
    assert report.refused > 0


def test_what_a_scene_raises_is_told_with_the_event(home: Path, monkeypatch: pytest.MonkeyPatch):
    entry = example_entry()

    def slip(scene, event):
        raise ZeroDivisionError("a slip")

    monkeypatch.setattr(entry.load(), "pointer", slip)
    report = FuzzSession(CATALOGUE, "example", 1, home).run(400)
    assert report.trouble.startswith("event ") and "a slip" in report.trouble


def test_a_random_hand_turns_every_parameter_and_every_effect(home: Path, monkeypatch: pytest.MonkeyPatch):
    session, posted = FuzzSession(CATALOGUE, "example", 5, home), []
    try:
        session._open()
        play = session.driver.top.play
        monkeypatch.setattr(play, "post", lambda event: posted.append(event) or True)
        for _ in range(300):
            session._set_something(play)
    finally:
        session.driver.close()
    scene = play.stage.scene
    effects = [event for event in posted if isinstance(event, SetEffect)]
    assert {event.name for event in effects} == set(scene.effects.names)
    assert {event.on for event in effects} == {False, True}
    others = {event.name for event in posted if isinstance(event, SetParameter)}
    assert others == set(scene.declared_parameters())
    assert 0.1 * len(posted) < len(effects) < 0.35 * len(posted)


def test_values_at_and_beyond_the_limits(home: Path):
    scene_type = example_entry().load()
    hand = random.Random(1)
    for parameter in scene_type.declared_parameters().values():
        taken = refused = 0
        for _ in range(300):
            try:
                value = parameter.check(any_value(hand, parameter))
                taken += 1
                assert not isinstance(value, float) or math.isfinite(value)
            except ParameterError as error:
                refused += 1
                assert "\n" not in str(error)
        assert taken > 50 and refused > 10


def test_spoilt_files_are_refused_in_one_line_or_taken(tmp_path: Path):
    hand = random.Random(2)
    scene_type = example_entry().load()
    recording = '{"scene": "example", "steps": 3, "events": [], "digest": "x"}'
    refused = 0
    for i in range(400):
        try:
            parse_level(spoil(LEVEL, hand), "example", scene_type.content_type)
        except LevelError as error:
            refused += 1
            assert "\n" not in str(error)
        path = tmp_path / f"{i}.json"
        path.write_text(spoil(recording, hand), encoding="utf-8")
        try:
            Recording.load(path)
        except RecordingError as error:
            assert "\n" not in str(error) and path.name in str(error)
        (tmp_path / "settings.toml").write_text(
            spoil('theme = "dark"\nwidth = 1280\n', hand), encoding="utf-8"
        )
        loaded = load_settings(tmp_path)
        assert loaded.settings.theme in ("dark", "light") and "\n" not in loaded.complaint
    assert refused > 100


WRITER = """
import sys
from pathlib import Path
import pygame
from game.app.window.pictures import write_png
from game.app.window.settings import Settings, save_settings
from game.files import write_text
from game.levels import Level, save_level
from game.stage.records.recording import Recording
folder = Path(sys.argv[1])
n = 0
while True:
    n += 1
    write_text(folder / "kept.txt", f"{n} " * 20000 + "end")
    save_settings(Settings(width=640 + n % 1000, keys={"pause": "x"}), folder)
    save_level(Level(scene="example", title=f"{n} " * 50, parameters={"restitution": 0.5}), folder / "a.toml")
    recording = Recording(scene="example", seed=n, dt=0.01, parameters={"a" * i: 0.5 for i in range(99)},
                          effects_off=[], events=[], steps=0, digest="x")
    recording.save(folder / "a.json")
    surface = pygame.Surface((200, 200 + n % 50))
    surface.fill((n % 255, 9, 9))
    write_png(surface, folder / "a.png")
    if n == 1:
        print("ready", flush=True)
"""


def _check_kept(folder: Path) -> None:
    """Everything that was ever written is there, whole."""
    words = (folder / "kept.txt").read_text(encoding="utf-8").split()
    assert words[-1] == "end" and len(words) == 20_001 and len(set(words[:-1])) == 1
    loaded = load_settings(folder)
    assert loaded.complaint == "" and loaded.settings.keys == {"pause": "x"}
    assert len(set(load_level(folder / "a.toml", "example", None).title.split())) == 1
    assert len(Recording.load(folder / "a.json").parameters) == 99
    picture = pygame.image.load(str(folder / "a.png"))
    assert picture.get_at((0, 0)) == picture.get_at((199, picture.get_height() - 1))


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs a process that can be killed")
def test_a_process_killed_while_it_writes_loses_nothing(tmp_path: Path):
    hand = random.Random(3)
    for _ in range(5):
        process = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT),
                 "PYGAME_HIDE_SUPPORT_PROMPT": "1"},
        )  # fmt: skip
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        time.sleep(hand.uniform(0.0, 0.06))
        process.send_signal(signal.SIGKILL)
        process.communicate()
        _check_kept(tmp_path)
