"""The process behind the menu: it tells which scenes are ready, and can be stopped at any moment."""

import subprocess
import sys
import time

from game.app.compile.preparing import Preparation, prepare_all, prepare_scene
from game.app.compile.readiness import is_ready
from game.scenes import CATALOGUE
from game.stage.catalogue import Catalogue
from tests.app.tests_app import example_entry


def wait_for(condition, longest_s: float = 600.0) -> None:
    ends = time.monotonic() + longest_s
    while not condition():
        assert time.monotonic() < ends
        time.sleep(0.005)


def saying(code: str) -> Preparation:
    """A preparation whose process is a few lines of Python."""
    made = Preparation((sys.executable, "-c", code))
    made.begin()
    return made


def test_names_come_in_and_the_end_is_seen(monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    made = saying("print('c04'); print('c05')")
    wait_for(lambda: made.news() or made.ready)
    wait_for(lambda: made.news() or made.ready == {"c04", "c05"})
    wait_for(lambda: not made.going_on)
    assert not made.news()


def test_it_is_stopped_in_the_midst_and_can_begin_again(monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    made = saying("import time; print('c04', flush=True); time.sleep(600)")
    wait_for(lambda: made.news() or made.ready)
    process = made._process
    made.stop()
    assert process.poll() is not None and not made.going_on
    made.begin()
    assert made.going_on
    made.stop()


def test_one_core_is_left_alone(monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: 1 / 0)
    made = saying("print('c04')")
    assert not made.going_on and not made.news()


def test_scenes_are_prepared_once_and_what_fails_is_left_out(monkeypatch, capsys):
    good, bad = example_entry(), example_entry()._replace(name="broken", module="no.such.module")
    prepared = []
    monkeypatch.setattr("game.app.compile.preparing.is_ready", lambda entry: entry.name in prepared)

    def prepare(entry):
        entry.load()
        prepared.append(entry.name)

    monkeypatch.setattr("game.app.compile.preparing.prepare_scene", prepare)
    prepare_all(Catalogue((bad, good)))
    prepare_all(Catalogue((bad, good)))
    assert prepared == [good.name]
    assert capsys.readouterr().out.split() == [good.name, good.name]


def test_a_scene_that_was_prepared_is_ready():
    entry = CATALOGUE["lecture-balls"]
    prepare_scene(entry)
    assert is_ready(entry)
