"""The reference shots: same events, times and places as an independent solver of the same equations."""

import json
from collections import defaultdict

import pytest

from game.billiards import load_shot, run_shot_file, simulate
from tests.paths import TESTS

SHOTS = sorted((TESTS / "reference" / "shots").glob("*.json"))


def _times(events, before):
    """Times of the events by type and ids; the ids of two balls have no order."""
    found = defaultdict(list)
    for kind, time, ids in events:
        if time < before:
            found[kind, frozenset(ids) if kind == "ball-ball" else tuple(ids)].append(time)
    return found


def test_there_are_reference_shots():
    assert len(SHOTS) >= 38


@pytest.mark.parametrize("path", SHOTS, ids=lambda path: path.stem)
def test_reference_shot(path):
    expect = json.loads(path.read_text())["expect"]
    tolerance = expect["tolerance"]
    before = tolerance.get("events_before", float("inf"))
    trajectory = simulate(load_shot(path))
    found = _times(trajectory.events, before)
    wanted = _times(((e["type"], e["time"], e["ids"]) for e in expect["events"]), before)
    assert found.keys() == wanted.keys()
    for key, times in wanted.items():
        assert found[key] == pytest.approx(times, rel=0.0, abs=tolerance["time"])
    assert trajectory.final.keys() == expect["final"].keys()
    for name, place in expect["final"].items():
        if place == "pocketed":
            assert trajectory.final[name] == "pocketed"
        else:
            assert trajectory.final[name] == pytest.approx(place, rel=0.0, abs=tolerance["position"])
    if before == float("inf"):
        assert trajectory.end_time == pytest.approx(expect["end_time"], rel=0.0, abs=tolerance["time"])


def test_run_shot_file_holds_what_the_command_line_writes():
    result = run_shot_file(SHOTS[0])
    assert set(result) >= {"events", "final", "end_time", "digest", "model"}
    assert set(result["events"][0]) == {"type", "time", "ids"}
    assert json.loads(json.dumps(result)) == result
