"""Fixtures of the program's tests; the driver itself stands in tests_app.py."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import game.scenes
from tests.app.tests_app import CATALOGUE, Driver, load_example


@pytest.fixture(autouse=True)
def examples(monkeypatch: pytest.MonkeyPatch) -> None:
    """The catalogue of the tests in place of the real one."""
    load_example()
    monkeypatch.setattr(game.scenes, "CATALOGUE", CATALOGUE)


@pytest.fixture
def start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Driver]]:
    """A function that starts a program; all are closed at the end."""
    monkeypatch.setenv("CAROM_HOME", str(tmp_path / "home"))
    drivers: list[Driver] = []

    def begin(**options: Any) -> Driver:
        drivers.append(Driver(tmp_path / "home", **options))
        return drivers[-1]

    yield begin
    for driver in drivers:
        driver.close()


@pytest.fixture
def driver(start: Callable[..., Driver]) -> Driver:
    """A program that shows the menu."""
    return start()
