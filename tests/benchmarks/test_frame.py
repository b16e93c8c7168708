"""How long frames take. Figures for a person to read; nothing here fails because a machine is slow."""

from __future__ import annotations

from pathlib import Path
from time import thread_time

import pygame
import pytest

from game.scenes import CATALOGUE
from game.stage.catalogue import Catalogue
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


def test_large_menu_scrolls(tmp_path: Path, benchmark):
    """Frames of a menu of eighty cards while it goes through all of them; the longest, ms of the thread."""
    rows = list(CATALOGUE)
    more = [rows[i % len(rows)]._replace(name=f"s{i}", category="Stories", topic="") for i in range(57)]
    driver = Driver(tmp_path, catalogue=Catalogue((*rows, *more)))
    driver.frames(60)
    longest: list[float] = []

    def scroll() -> None:
        for i in range(240):
            if i % 4 == 0:
                driver.waiting.append(pygame.Event(pygame.MOUSEWHEEL, x=0, y=-1, pos=(400, 300)))
            begin = thread_time()
            driver.frames()
            longest.append(1e3 * (thread_time() - begin))

    benchmark.pedantic(scroll, rounds=1)
    benchmark.extra_info["longest_ms"] = round(max(longest), 1)
    print(f"longest frame {max(longest):.1f} ms")
    assert driver.top.scroll.offset > 4 * driver.top.view.h
    driver.close()


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_scene_frame(driver: Driver, benchmark, name: str):
    """A whole frame at 1280 x 720 with panel and charts, two steps in it, also of a story in slow motion."""
    driver.open(name)
    frames = 120 if benchmark.enabled else 30
    driver.frames(2)
    driver.stage.speed = 1.0
    driver.frames(frames)
    benchmark.pedantic(driver.frames, rounds=120, warmup_rounds=10)
    assert driver.stage.step_number > 0.4 * frames
    assert driver.stage.fault is None
