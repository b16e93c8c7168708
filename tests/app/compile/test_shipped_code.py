"""Scenes whose machine code came with Carom: open at once, and are compiled for this processor meanwhile."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path

import pytest

from game.app.compile import preparing, readiness
from game.app.compile.preparing import OURS, main, native_code_of
from game.app.compile.readiness import any_code, is_ready, opens_at_once
from game.compiler import prebuilt
from game.compiler.prebuilt import Found, pack, unpack
from game.scenes import CATALOGUE
from tests.app.tests_app import Driver


@pytest.fixture
def shipped(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> prebuilt.Prebuilt:
    """Code of the two scenes, in the place of what came with this Carom; the cache is empty."""
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
    code = unpack(pack({"a/b": b"code"}, ["lecture-balls", "example"]))
    monkeypatch.setattr(prebuilt, "_found", cache(lambda: Found(code, "")))
    prebuilt.found()
    return code


def test_a_scene_of_which_code_came_opens_at_once_though_it_is_not_compiled_for_this_processor(shipped):
    assert opens_at_once(CATALOGUE["lecture-balls"]) and not is_ready(CATALOGUE["lecture-balls"])
    assert not opens_at_once(CATALOGUE["c04"])


def test_with_code_that_came_pictures_are_made_in_the_menus_first_session(monkeypatch, tmp_path):
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setenv("CAROM_PREBUILT", "0")
    assert not any_code()
    file = tmp_path / "some.kernels"
    file.touch()
    monkeypatch.setenv("CAROM_PREBUILT", str(file))
    assert any_code()


@pytest.mark.parametrize("taken", [False, True])
def test_a_scene_opened_with_code_that_came_is_still_to_be_compiled(monkeypatch, shipped, start, taken):
    """Only what was compiled here is noted as ready; after the other a process compiles, while one plays."""
    driver: Driver = start()
    driver.app.background = True
    if taken:
        shipped.take("a/b")
    asked, noted = tmp_command(monkeypatch), []
    monkeypatch.setattr("game.app.scene.loader.mark_ready", noted.append)
    screen = driver.open()
    assert noted == ([] if taken else [screen.entry])
    assert asked == ([("example",)] if taken else [])
    assert screen.play.native.going_on is taken
    driver.app.open_menu()
    assert not screen.play.native.going_on


def tmp_command(monkeypatch) -> list[tuple[str, ...]]:
    """Processes that only sleep, in the place of those that compile; the names that they were given."""
    asked: list[tuple[str, ...]] = []
    begin = preparing.Preparation.begin

    def sleep(self) -> None:
        asked.append(self._command[len(OURS) :])
        self._command = (sys.executable, "-c", "import time; time.sleep(600)")
        begin(self)

    monkeypatch.setattr("os.cpu_count", lambda: 2)
    monkeypatch.setattr(preparing.Preparation, "begin", sleep)
    return asked


def test_the_process_is_told_the_scene():
    assert native_code_of(CATALOGUE["c04"])._command == (*OURS, "c04")


class TestTheProcess:
    @pytest.fixture
    def prepared(self, monkeypatch: pytest.MonkeyPatch) -> list[str]:
        """Names of the scenes that the process would prepare."""
        names: list[str] = []
        monkeypatch.setattr(preparing, "prepare_all", lambda entries: names.extend(e.name for e in entries))
        monkeypatch.setattr("os.nice", lambda more: 0, raising=False)
        monkeypatch.setenv("CAROM_PREBUILT", __file__)
        monkeypatch.setattr("game.scenes.CATALOGUE", CATALOGUE)
        return names

    def test_it_takes_nothing_that_came_and_compiles_the_scenes_named(self, prepared, tmp_path, monkeypatch):
        monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
        main(["c04"])
        assert prepared == ["c04"] and prebuilt.shipped_file() is None
        prepared.clear()
        main([])
        assert prepared == [entry.name for entry in CATALOGUE]

    def test_it_compiles_nothing_that_could_not_be_kept(self, prepared, tmp_path, monkeypatch):
        file = tmp_path / "no folder"
        file.touch()
        monkeypatch.setenv("CAROM_CACHE_DIR", str(file))
        main(["c04"])
        assert prepared == []


def test_a_scene_is_ready_once_it_is_marked_and_notes_of_older_sources_go(monkeypatch, tmp_path):
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path))
    entry, other = CATALOGUE["lecture-balls"], CATALOGUE["c04"]
    notes = tmp_path / "ready"
    notes.mkdir()
    for name in (f"{entry.name}-older-sources", f"{other.name}-older-sources"):
        (notes / name).touch()
    assert not is_ready(entry) and not is_ready(other)
    readiness.mark_ready(entry)
    assert is_ready(entry) and not is_ready(other)
    kept = sorted(note.name for note in notes.iterdir())
    assert len(kept) == 2 and kept[0] == f"{other.name}-older-sources"


def test_notes_name_the_sources_alone(shipped):
    """So that code for this processor, compiled in the background, makes a scene ready as ever."""
    entry = CATALOGUE["lecture-balls"]
    readiness.mark_ready(entry)
    assert is_ready(entry)
