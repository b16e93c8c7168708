"""CPU time of a call: of its own thread, and not of the first call."""

from __future__ import annotations

import threading
import time

import pytest

from game.lab.timing import least_time


def burn(seconds: float) -> None:
    """Spend so much CPU time of the calling thread."""
    end = time.thread_time() + seconds
    while time.thread_time() < end:
        pass


def test_the_first_call_is_not_timed():
    costs = iter((0.2, 0.002, 0.004))
    assert 0.002 <= least_time(lambda: burn(next(costs)), 2) < 0.1
    assert next(costs, None) is None


def test_what_another_thread_computes_is_not_counted():
    stop = threading.Event()
    other = threading.Thread(target=lambda: [burn(0.001) for _ in iter(stop.is_set, True)])
    other.start()
    try:
        assert least_time(lambda: time.sleep(0.1), 1) < 0.05
    finally:
        stop.set()
        other.join()


def test_nothing_to_time_is_refused():
    with pytest.raises(ValueError, match="repeats"):
        least_time(lambda: None, 0)
