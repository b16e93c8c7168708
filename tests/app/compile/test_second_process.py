"""A second process: ended at once, or waited for by a thread where the machine is slow to end it."""

import subprocess
import sys
import threading

import pytest

import game
from game.app.compile import second_process
from game.app.compile.second_process import end, start_quietly


@pytest.mark.parametrize("patience_s", (60.0, 0.0))
def test_nothing_is_left_of_a_process_that_was_ended(monkeypatch: pytest.MonkeyPatch, patience_s: float):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    monkeypatch.setattr(second_process, "PATIENCE_S", patience_s)
    process = start_quietly((sys.executable, "-c", "import time; time.sleep(600)"))
    assert process is not None
    end(process)
    for thread in threading.enumerate():
        if thread.name == "ending":
            thread.join()
    assert process.returncode is not None


def test_what_was_never_started_needs_no_end(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **__: 1 / 0)
    assert start_quietly((sys.executable, "-c", "pass")) is None
    end(None)


@pytest.mark.parametrize("runs_modules", (False, True))
def test_a_frozen_application_is_started_only_if_it_runs_modules(monkeypatch, runs_modules: bool):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "runs_modules", runs_modules, raising=False)
    process = start_quietly((sys.executable, "-c", "pass"))
    assert (process is not None) is runs_modules
    end(process)


def test_it_is_of_the_same_carom_whatever_lies_in_the_folder(monkeypatch, tmp_path):
    """A stranger's package of that name would be run, and another version's kernels be compiled."""
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "game").mkdir()
    (tmp_path / "game" / "__init__.py").write_text("raise SystemExit('a stranger')")
    code = "import game; print(game.__file__)"
    process = start_quietly((sys.executable, "-c", code), stdout=subprocess.PIPE, text=True)
    assert process is not None
    assert process.communicate(timeout=900)[0].strip() == game.__file__
