"""SIGTERM ends a command as Ctrl+C does: one line, and a status that says so."""

import contextlib
import ctypes
import signal
import subprocess
import sys
import time

import pytest

from game.__main__ import main
from game.app.commands import listing
from game.app.window.deadline import GRACE_S
from game.app.window.ending import ENDED, PATIENCE_S, STOPPED, Ended, ends_tidily, status_of
from tests.paths import ROOT


def test_sigterm_is_raised_where_the_program_is_and_then_is_the_systems_again():
    before = signal.getsignal(signal.SIGTERM)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    try:
        with pytest.raises(Ended), ends_tidily():
            signal.raise_signal(signal.SIGTERM)
        assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    finally:
        signal.signal(signal.SIGTERM, before)


def test_who_listens_already_goes_on_listening():
    heard = []
    before = signal.signal(signal.SIGTERM, lambda number, frame: heard.append(number))
    try:
        with ends_tidily():
            signal.raise_signal(signal.SIGTERM)
        assert heard == [signal.SIGTERM]
    finally:
        signal.signal(signal.SIGTERM, before)


@pytest.mark.parametrize(("why", "status"), [(Ended, 143), (KeyboardInterrupt, 130)])
def test_a_command_that_is_stopped_says_so_in_one_line(why, status, monkeypatch, capsys):
    def stopped(options):
        raise why

    monkeypatch.setattr(listing, "execute", stopped)
    assert main(["list"]) == status
    assert capsys.readouterr().err == "carom: stopped\n"


def test_statuses_are_those_of_a_shell():
    assert (status_of(KeyboardInterrupt()), status_of(Ended())) == (STOPPED, ENDED) == (130, 143)


BOTH = pytest.mark.parametrize(
    ("number", "error"), [(signal.SIGINT, KeyboardInterrupt), (signal.SIGTERM, Ended)]
)
insists = pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="no alarm clock")


@pytest.fixture(autouse=True)
def _usual_signals():
    """Nobody listens to either signal, as in a program of its own."""
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@insists
@BOTH
def test_a_signal_that_a_callback_from_c_swallowed_is_raised_again(number, error, capsys):
    """As happens in the compiler, which asks Python for what it keeps; nothing is reported of it either."""
    called = ctypes.CFUNCTYPE(None)(lambda: signal.raise_signal(number))
    with pytest.raises(error), ends_tidily():
        called()
        wait_long()
    assert capsys.readouterr().err == ""


@insists
def test_it_is_raised_again_as_often_as_it_is_swallowed():
    with pytest.raises(KeyboardInterrupt), ends_tidily():
        with contextlib.suppress(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
        with contextlib.suppress(KeyboardInterrupt):
            wait_long()
        wait_long()


@insists
def test_who_tidies_up_is_not_disturbed():
    done = []
    with pytest.raises(KeyboardInterrupt) as caught, ends_tidily():
        try:
            signal.raise_signal(signal.SIGINT)
        finally:
            with contextlib.suppress(OSError):  # something else may go wrong meanwhile
                try:
                    raise OSError
                finally:
                    time.sleep(1.5 * PATIENCE_S)
            time.sleep(1.5 * PATIENCE_S)
            done.append("tidied up")
    assert done and caught.value.__context__ is None
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


@insists
def test_an_alarm_that_rings_when_all_is_over_sets_no_other_one(monkeypatch):
    """It is heard between the clock being stopped and its listener being taken away."""
    stop = signal.setitimer

    def ring(which, seconds):
        before = stop(which, seconds)
        if seconds == 0.0:
            signal.raise_signal(signal.SIGALRM)
        return before

    with pytest.raises(KeyboardInterrupt), ends_tidily():
        try:
            signal.raise_signal(signal.SIGINT)
        finally:
            monkeypatch.setattr(signal, "setitimer", ring)
    monkeypatch.undo()
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


STUCK = {
    # code that runs without the interpreter, as a compiler's, comes back to no handler
    "in machine code": "hashlib.pbkdf2_hmac('sha256', b'', b'', 2**31 - 1)",
    "where exceptions are dropped": """
while True:
    with contextlib.suppress(BaseException):
        while True:
            time.sleep(0.001)""",
    # it has ended, but the interpreter waits for a thread
    "at the exit": """
concurrent.futures.ThreadPoolExecutor(1).submit(hashlib.pbkdf2_hmac, 'sha256', b'', b'', 2**31 - 1)
time.sleep(100.0)""",
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")
@BOTH
@pytest.mark.parametrize("where", STUCK)
def test_what_cannot_be_interrupted_ends_with_the_process(number, error, where):
    body = "\n".join(f"    {line}" for line in STUCK[where].splitlines())
    code = f"""
import concurrent.futures, contextlib, hashlib, time
from game.app.window.deadline import say_stopped
from game.app.window.ending import ends_tidily, status_of
try:
  with ends_tidily(to_the_end=True):
    print("ready", flush=True)
{body}
except KeyboardInterrupt as why:
  say_stopped()
  raise SystemExit(status_of(why))
"""
    root = ROOT
    command = [sys.executable, "-c", code]
    with subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stderr is not None
        assert process.stdout.readline() == b"ready\n"
        time.sleep(0.1)
        began = time.monotonic()
        process.send_signal(number)
        try:
            assert process.wait(600.0) == 128 + number
            assert time.monotonic() - began >= 0.5 * GRACE_S
            assert process.stderr.read() == b"carom: stopped\n"
        finally:
            process.kill()
    assert GRACE_S <= 1.5


@BOTH
def test_who_leaves_in_time_lives_on(number, error, monkeypatch):
    ends = []
    monkeypatch.setattr("game.app.window.deadline.GRACE_S", 0.1)
    monkeypatch.setattr("game.app.window.deadline._end", ends.append)
    before = signal.set_wakeup_fd(-1)
    signal.set_wakeup_fd(before)
    with pytest.raises(error), ends_tidily():
        signal.raise_signal(number)
    time.sleep(0.3)
    assert ends == []
    after = signal.set_wakeup_fd(before)
    assert after == before


def wait_long():
    """What goes on for as long as nobody stops it, but not for ever."""
    until = time.monotonic() + 60.0
    while time.monotonic() < until:
        time.sleep(0.01)
