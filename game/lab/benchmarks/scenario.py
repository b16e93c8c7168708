"""A workload with its peers, and how it is timed: in turns, so that a busy moment slows all of them alike."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from statistics import median
from time import thread_time
from typing import NamedTuple

Call = Callable[[], object]
LEAST_S = 2e-3  # a turn lasts at least so long: calls shorter than this are repeated within it


@dataclass(frozen=True)
class Peer:
    """Something else that does the same work. prepare: makes the call; ImportError if it is not installed."""

    name: str
    prepare: Callable[[], Call]


@dataclass(frozen=True)
class Scenario:
    """One workload.

    name: for the command line. title: for people. unit: what is timed. count: how many of these units one
    call does. prepare: makes the call. peers: other methods that do it.
    """

    name: str
    title: str
    unit: str
    prepare: Callable[[], Call]
    count: int = 1
    peers: tuple[Peer, ...] = ()


class Measured(NamedTuple):
    """Least, median and worst CPU time of one unit, s; and the peers' least by name, of those installed.

    Least times are compared: what else runs on a machine only ever adds to them.
    """

    scenario: Scenario
    least_s: float
    median_s: float
    worst_s: float
    peers: dict[str, float]

    def ratio(self, peer: str) -> float:
        """How many times longer a peer takes."""
        return self.peers[peer] / self.least_s


def measure_scenario(scenario: Scenario, turns: int = 15) -> Measured:
    """Time a scenario and its peers by turns. ValueError for less than one turn."""
    if turns < 1:
        raise ValueError(f"turns: must be at least 1, got {turns!r}")
    calls = {"": scenario.prepare()}
    for peer in scenario.peers:
        try:
            calls[peer.name] = peer.prepare()
        except ImportError:
            continue
    repeats = {name: _repeats(call) for name, call in calls.items()}
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(turns):
        for name, call in calls.items():
            times[name].append(_turn(call, repeats[name]) / scenario.count)
    peers = {name: min(found) for name, found in times.items() if name}
    return Measured(scenario, min(times[""]), median(times[""]), max(times[""]), peers)


def _repeats(call: Call) -> int:
    """How often a call fits into a turn; the first two calls compile and fill caches."""
    call()
    call()
    return max(1, round(LEAST_S / max(_turn(call, 1), 1e-9)))


def _turn(call: Call, repeats: int) -> float:
    """CPU seconds of one call, the mean of so many: none of the peers works in further threads."""
    begin = thread_time()
    for _ in range(repeats):
        call()
    return (thread_time() - begin) / repeats
