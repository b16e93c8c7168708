"""Snapshots are taken at their intervals, however one walks."""

from __future__ import annotations

from game.stage import Stage
from game.stage.session import Session
from game.stage.states.snapshots import INTERVAL, SnapshotRing
from tests.stage.example_scene import BouncingBall


def steps_kept(monkeypatch) -> list[int]:
    """The steps of snapshots, as they are taken."""
    kept = []
    add = SnapshotRing.add
    monkeypatch.setattr(SnapshotRing, "add", lambda ring, one: (kept.append(one.step), add(ring, one)))
    return kept


def session_of_ball() -> Session:
    return Stage(BouncingBall)._session


def test_a_snapshot_is_taken_once_an_interval(monkeypatch):
    kept, session = steps_kept(monkeypatch), session_of_ball()
    for _ in range(5 * INTERVAL):
        session.advance()
    assert kept == [INTERVAL * k for k in range(6)]


def test_steps_back_do_not_put_off_the_next_snapshot(monkeypatch):
    kept, session = steps_kept(monkeypatch), session_of_ball()
    while session.step < 3 * INTERVAL:
        for _ in range(10):
            session.advance()
        if session.step < 3 * INTERVAL:
            session.go_back()
    assert kept == [INTERVAL * k for k in range(4)]
