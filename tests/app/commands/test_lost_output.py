"""Disks that are full and pipes that are closed: one line, the right status, nothing half written."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pygame
import pytest

from game import files
from game.__main__ import main
from game.app.commands import run_command_line
from game.app.window.pictures import PictureSaver, write_png
from tests.paths import ROOT

FULL = Path("/dev/full")  # Linux has a disk that is always full


@pytest.mark.skipif(not FULL.exists(), reason="no device that is always full")
def test_a_full_disk_under_the_standard_output_is_told_in_one_line():
    with FULL.open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "game", "list"], stdout=full, stderr=subprocess.PIPE, text=True, cwd=ROOT
        )
    assert done.returncode == 1
    assert done.stderr == "carom: no space left on device\n"


@pytest.mark.skipif(os.name == "nt", reason="pipes end otherwise there")
def test_a_reader_that_has_enough_is_no_mistake():
    with subprocess.Popen(
        [sys.executable, "-m", "game", "list"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait(600.0) == 0


def test_an_error_of_the_system_is_one_line(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture):
    def gone(options):
        raise OSError(5, "Input/output error", "/a/file")

    monkeypatch.setattr("game.app.commands.listing.execute", gone)
    assert run_command_line(["list"]) == 1
    assert capsys.readouterr().err == "carom: /a/file: input/output error\n"


def _disk_is_full(path: Path, data: bytes) -> None:
    raise OSError(28, "No space left on device")


def test_a_picture_is_written_whole_or_not_at_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "a.png"
    write_png(pygame.Surface((30, 20)), path)
    before = path.read_bytes()
    assert pygame.image.load(str(path)).get_size() == (30, 20)
    monkeypatch.setattr(files, "_replace", _disk_is_full)
    with pytest.raises(OSError, match="no space left on device"):
        write_png(pygame.Surface((40, 40)), path)
    assert path.read_bytes() == before and list(tmp_path.iterdir()) == [path]


def test_a_picture_for_which_there_is_no_room_is_told_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    monkeypatch.setattr(files, "_replace", _disk_is_full)
    saver = PictureSaver()
    saver.save(pygame.Surface((30, 20)), "Scene")
    saver.wait()
    (done,) = saver.take()
    assert "no space left on device" in done.problem
    assert list((tmp_path / "pictures").iterdir()) == []


@pytest.mark.parametrize("module", ["game.app.window.ending", "game.app.commands"])
def test_an_impatient_hand_is_told_in_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture, module: str
):
    class Interrupted:
        def __getattr__(self, name: str):
            raise KeyboardInterrupt

    monkeypatch.setitem(sys.modules, module, Interrupted())
    assert main(["list"]) == 130
    assert capsys.readouterr().err == "carom: stopped\n"
