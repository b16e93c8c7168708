"""The second process that compiles beside the opening of a scene: when it starts, what it runs, its end."""

from __future__ import annotations

import sys

import pytest

import game.scenes
from game.app.compile import precompile
from game.app.compile.precompile import Precompiler, compile_from_the_end
from game.app.compile.second_process import start_quietly
from game.scenes import CATALOGUE
from game.ui import raster
from tests.app.tests_app import example_entry


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list:
    """Commands in place of which a process waits; the process goes behind its command."""
    made: list = []
    waiting = (sys.executable, "-c", "import time; time.sleep(600)")

    def start(command):
        made.extend((command, start_quietly(waiting)))
        return made[-1]

    monkeypatch.setattr(precompile, "start_quietly", start)
    return made


def test_it_runs_beside_a_scene_of_carom_that_is_not_ready_and_ends_with_it(started, monkeypatch):
    monkeypatch.setattr(precompile, "opens_at_once", lambda entry: False)
    second = Precompiler(CATALOGUE["c10"])
    command, process = started
    assert command == (sys.executable, "-m", "game.app.compile.precompile", "c10")
    assert process is None or process.poll() is None
    second.stop()
    assert process is None or process.wait(600.0) != 0
    second.stop()


def test_a_scene_that_is_ready_or_of_others_is_opened_without_it(started, monkeypatch):
    Precompiler(example_entry()).stop()
    monkeypatch.setattr(precompile, "opens_at_once", lambda entry: True)
    Precompiler(CATALOGUE["c10"]).stop()
    assert started == []


def test_it_goes_through_both_lists_from_the_end(monkeypatch):
    monkeypatch.setattr(game.scenes, "CATALOGUE", CATALOGUE)  # the real one
    done: list[str] = []
    scene = CATALOGUE["c10"].load()
    names = [warm_up.name for warm_up in scene.warm_ups()]
    assert len(names) > 1
    calls = [type(scene.warm_ups()[0])(name, lambda name=name: done.append(name)) for name in names]
    monkeypatch.setattr(scene, "warm_ups", lambda: calls)
    canvas = [(name, lambda name=name: done.append(name)) for name, _ in raster.WARM_UPS]
    monkeypatch.setattr(raster, "WARM_UPS", tuple(canvas))
    compile_from_the_end("c10")
    assert done == [*names[::-1], *(name for name, _ in canvas[::-1])]
