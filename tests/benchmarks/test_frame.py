"""How long frames take. Figures for a person to read; nothing here fails because a machine is slow."""

from __future__ import annotations

from pathlib import Path

import pytest

from game.scenes import CATALOGUE
from tests.app.tests_app import Driver


@pytest.fixture
def driver(tmp_path: Path):
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    yield driver
    driver.close()


def test_menu_frame(driver: Driver, benchmark):
    driver.frames(30)
    benchmark.pedantic(driver.frames, rounds=60, warmup_rounds=10)
    assert len(driver.top.items) >= len(CATALOGUE)


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_scene_frame(driver: Driver, benchmark, name: str):
    """A whole frame at 1280 x 720 with panel and charts, two steps in it."""
    driver.open(name)
    driver.frames(120)
    benchmark.pedantic(driver.frames, rounds=120, warmup_rounds=10)
    assert driver.stage.step_number > 50
    assert driver.stage.fault is None
