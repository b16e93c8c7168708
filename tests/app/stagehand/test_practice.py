"""The keeper of practice: which tries belong to one set, as a person plays in the window."""

from datetime import datetime, timedelta
from types import SimpleNamespace

import pytest

from game.app.stagehand.practice import PracticeKeeper
from game.stage.records.history import Practised, history_path, read_history


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))


def keeper() -> PracticeKeeper:
    """One whose clock goes on by a minute each time it is looked at."""
    times = (datetime(2026, 11, 22, 10) + timedelta(minutes=k) for k in range(1000))
    return PracticeKeeper(lambda: next(times))


def stage(made: int, tried: int, of: int = 10, key: str = "a"):
    return SimpleNamespace(scene=SimpleNamespace(practised=Practised(key, key.upper(), made, tried, of)))


def kept() -> list[tuple[str, int, int]]:
    return [(one.key, one.made, one.tried) for one in read_history()]


def test_a_set_is_kept_from_its_first_try_and_a_new_one_begins_after_none():
    one = keeper()
    for made, tried in ((0, 0), (1, 1), (1, 1), (1, 2), (2, 3)):
        assert one.update(stage(made, tried)) == ""
        assert kept() == ([("a", made, tried)] if tried else [])
    for made, tried in ((0, 0), (0, 1)):
        one.update(stage(made, tried))
    assert kept() == [("a", 2, 3), ("a", 0, 1)]


def test_a_try_that_is_taken_back_is_no_new_set():
    one = keeper()
    for made, tried in ((0, 0), (1, 1), (2, 2), (1, 1), (1, 2)):
        one.update(stage(made, tried, of=0))
    assert kept() == [("a", 1, 2)]


def test_another_drill_is_another_set_and_no_practice_is_none():
    one = keeper()
    one.update(stage(1, 1))
    one.update(stage(1, 1, key="b"))
    assert one.update(SimpleNamespace(scene=SimpleNamespace(practised=None))) == ""
    one.update(stage(2, 2, key="b"))
    assert kept() == [("a", 1, 1), ("b", 2, 2)]


def test_a_game_that_is_gone_on_with_goes_on_with_its_set():
    keeper().update(stage(2, 4))
    keeper().update(stage(3, 5))
    assert kept() == [("a", 3, 5)]
    keeper().update(stage(3, 10))
    later = PracticeKeeper(lambda: datetime(2026, 11, 23))
    later.update(stage(1, 2))  # the last one is complete
    assert kept() == [("a", 3, 10), ("a", 1, 2)]


def test_a_complete_set_that_is_opened_again_is_not_counted_twice():
    keeper().update(stage(2, 4))
    keeper().update(stage(3, 10))
    PracticeKeeper(lambda: datetime(2026, 11, 23)).update(stage(3, 10))
    assert kept() == [("a", 3, 10)]


def test_a_first_try_is_never_an_older_sets():
    keeper().update(stage(0, 1))
    PracticeKeeper(lambda: datetime(2026, 11, 23)).update(stage(0, 1))
    assert kept() == [("a", 0, 1), ("a", 0, 1)]


def test_what_is_wrong_with_the_file_is_told():
    history_path().write_text('{"format": 9}')
    assert "nothing is written over it" in keeper().update(stage(1, 1))
