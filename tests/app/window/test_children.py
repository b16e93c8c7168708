"""After a signal no process that was started goes on alone, wherever the signal comes."""

import contextlib
import os
import signal
import subprocess
import sys
import time

import pytest

from game.app.commands import precompile
from game.app.window import children
from game.app.window.children import end_children, start
from game.app.window.ending import Ended, ends_tidily
from tests.paths import ROOT

SLEEP = [sys.executable, "-c", "import time; time.sleep(60)"]
GRANDCHILD = """
import subprocess, sys, time
print(subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"]).pid, flush=True)
time.sleep(60)
"""
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")


@pytest.fixture(autouse=True)
def _usual_signals():
    """Nobody listens to either signal, as in a program of its own."""
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


def lives(pid):
    """Whether a process goes on; one that nobody has fetched yet does not."""
    try:
        with open(f"/proc/{pid}/stat") as file:  # noqa: PTH123
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def ends_soon(pid):
    until = time.monotonic() + 600.0
    while lives(pid) and time.monotonic() < until:
        time.sleep(0.02)
    return not lives(pid)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_what_was_started(number):
    with pytest.raises(KeyboardInterrupt), ends_tidily():
        process = start(SLEEP)
        signal.raise_signal(number)
    assert process.wait(600.0) == -signal.SIGTERM


def test_a_command_that_deals_with_its_signal_itself_leaves_nothing_either():
    with ends_tidily():
        process = start(SLEEP)
        with contextlib.suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert process.wait(600.0) == -signal.SIGTERM


def test_without_a_signal_it_goes_on():
    with ends_tidily():
        process = start(SLEEP)
    try:
        assert process.poll() is None
    finally:
        end_children()
    assert process.wait(600.0) == -signal.SIGTERM


def test_a_group_ends_with_what_it_has_started():
    process = start([sys.executable, "-c", GRANDCHILD], group=True, stdout=subprocess.PIPE, text=True)
    with process:
        below = int(process.stdout.readline())
        assert lives(below)
        end_children()
        process.wait(600.0)
    assert ends_soon(below)


def test_a_signal_between_the_start_and_the_note_of_it_forgets_nothing(monkeypatch):
    made = []
    begin = subprocess.Popen

    def interrupted(*arguments, **options):
        made.append(begin(*arguments, **options))
        signal.raise_signal(signal.SIGTERM)
        return made[0]

    monkeypatch.setattr(children.subprocess, "Popen", interrupted)
    with pytest.raises(Ended), ends_tidily():
        start(SLEEP)
    assert made[0].wait(600.0) == -signal.SIGTERM


@pytest.mark.skipif(not os.path.isdir("/proc"), reason="no list of processes")  # noqa: PTH112
def test_a_program_that_is_ended_where_it_stands_ends_its_children():
    """It hears nothing: it computes in machine code, and its deadline ends it."""
    code = """
import hashlib, sys
from game.app.window.children import start
from game.app.window.ending import ends_tidily
with ends_tidily(to_the_end=True):
    print(start([sys.executable, "-c", "import time; time.sleep(60)"]).pid, flush=True)
    hashlib.pbkdf2_hmac('sha256', b'', b'', 2**31 - 1)
"""
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, "-c", code], cwd=ROOT, stdout=pipe, stderr=pipe, text=True) as one:
        child = int(one.stdout.readline())
        one.send_signal(signal.SIGTERM)
        one.wait(600.0)
    assert ends_soon(child)


def test_making_a_wheel_that_is_stopped_stops_pip(monkeypatch, tmp_path):
    """What builds for pip is a process that pip has started."""
    told = tmp_path / "pid"
    pip = tmp_path / "python"
    pip.write_text(f"#!/bin/sh\nsleep 60 &\necho $! > {told}\nwait\n")
    pip.chmod(0o755)
    monkeypatch.setattr(precompile.sys, "executable", str(pip))
    wait = subprocess.Popen.wait

    made = []

    def stopped(process, timeout=None):
        made.append(process)
        while not (told.exists() and told.read_text().strip()):
            time.sleep(0.01)
        monkeypatch.setattr(subprocess.Popen, "wait", wait)
        signal.raise_signal(signal.SIGTERM)

    monkeypatch.setattr(subprocess.Popen, "wait", stopped)
    with pytest.raises(Ended), ends_tidily():
        precompile.make_wheel(tmp_path, tmp_path / "code", tmp_path)
    assert made[0].wait(600.0) == -signal.SIGTERM
    assert ends_soon(int(told.read_text()))
