"""A film on a full disk: said in one line, never said to be done, and nothing of it is left."""

import contextlib
import importlib
import subprocess
import sys

import numpy as np
import pygame
import pytest

from game.app.commands import run_command_line
from game.app.film.part_file import ENDING, PREFIX, PartFile
from game.app.film.story_film import Excerpt, StoryFilm, write_story_film
from game.app.film.video import VideoError, VideoWriter
from game.stage.story.rehearsal import rehearse
from game.ui.sound import RATE
from tests.stage.story.bouncing import StoryBall, story

pytest.importorskip("av")
FULL = OSError(28, "No space left on device")


class LimitedFile:
    """A file in which nothing beyond the byte ``room`` can be written."""

    def __init__(self, file, room):
        self._inner, self._room = file, room

    def write(self, data):
        if self._inner.tell() + len(data) > self._room:
            raise FULL
        return self._inner.write(data)

    def __getattr__(self, name):
        return getattr(self._inner, name)


def disk_with(room, monkeypatch):
    """From now on each film's file has so much room, bytes."""
    begin = PartFile.__init__

    def limited(part, path):
        begin(part, path)
        part._file = LimitedFile(part._file, room)

    monkeypatch.setattr(PartFile, "__init__", limited)


@contextlib.contextmanager
def files_of_at_most(size):
    """No file of this process grows beyond so many bytes."""
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    # Python keeps as much as it could write of a module that is imported meanwhile, and fails on it later.
    kept, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        sys.dont_write_bytecode = kept


def test_a_module_imported_while_the_disk_is_full_is_whole_for_the_next_process(tmp_path, monkeypatch):
    (tmp_path / "much_of_it.py").write_text("TEXT = " + repr("many words " * 500))
    monkeypatch.syspath_prepend(tmp_path)
    with files_of_at_most(3000):
        importlib.import_module("much_of_it")
    del sys.modules["much_of_it"]
    assert len(importlib.import_module("much_of_it").TEXT) == 5500
    del sys.modules["much_of_it"]


def noisy_film(path):
    """A film that cannot be packed well; its size, bytes."""
    with VideoWriter(path, (160, 90), 25, sound=True) as film:
        for number in range(12):
            picture = pygame.Surface((160, 90), 0, 32)
            rng = np.random.default_rng(number)
            pygame.surfarray.blit_array(picture, rng.integers(0, 256, (160, 90, 3), np.uint8))
            film.add(picture, rng.integers(-9000, 9000, (RATE // 25, 2)).astype(np.int16))
    return path.stat().st_size


@pytest.mark.parametrize("name", ["film.mp4", "film.mkv", "film.gif"])
@pytest.mark.parametrize("share", [0.0, 0.3, 0.9, 0.999])
def test_wherever_the_disk_is_full_it_is_said_and_an_older_film_stays(name, share, tmp_path, monkeypatch):
    room = int(share * noisy_film(tmp_path / name))
    (tmp_path / name).write_bytes(b"an older film")
    disk_with(room, monkeypatch)
    with pytest.raises(VideoError, match=f"{name}: No space left on device"):
        noisy_film(tmp_path / name)
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_bytes() == b"an older film"


def test_a_command_says_that_its_film_has_no_room(tmp_path, capsys):
    path = tmp_path / "film.mp4"
    words = ["record", "example", "--size", "160x120", "--seconds", "1", "--out", str(path)]
    with files_of_at_most(3000):
        assert run_command_line(words) == 1
    told = capsys.readouterr()
    assert not told.out and len(told.err.strip().splitlines()) == 1 and str(path) in told.err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("share", [0.05, 0.5, 0.98])
def test_a_film_of_a_story_without_room_ends_and_leaves_nothing(share, tmp_path):
    found, path = rehearse(story(), StoryBall), tmp_path / "film.mp4"

    def make():
        return write_story_film(StoryFilm(story(), StoryBall, (160, 90)), found, path, 10, Excerpt(0.0, 2.0))

    make()
    size = path.stat().st_size
    for left in tmp_path.iterdir():
        left.unlink()
    with files_of_at_most(int(share * size)), pytest.raises(VideoError, match=str(path)):
        make()
    assert not list(tmp_path.iterdir())


def test_a_film_whose_poster_has_no_room_is_whole_and_that_is_said(tmp_path, monkeypatch):
    def no_room(path, text):
        raise OSError(f"{path}: no space left on device")

    monkeypatch.setattr("game.app.film.story_film.save_text", no_room)
    found, path = rehearse(story(), StoryBall), tmp_path / "film.mp4"
    with pytest.raises(VideoError, match=r"film.srt: no space left on device \(.*film.mp4 itself is whole\)"):
        write_story_film(StoryFilm(story(), StoryBall, (160, 90)), found, path, 10, Excerpt(0.0, 1.0))
    assert [one.name for one in tmp_path.iterdir()] == ["film.mp4"]


def test_what_a_killed_film_has_left_goes_with_the_next_one(tmp_path):
    code = f"""
from pathlib import Path
from game.app.film.part_file import PartFile
part = PartFile(Path({str(tmp_path / "a.mp4")!r}))
part.write(bytes(1000))
print("begun", flush=True)
input()
"""
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, "-c", code], stdin=pipe, stdout=pipe, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        (left,) = tmp_path.iterdir()
        assert left.name.startswith(PREFIX) and left.name.endswith(ENDING)
        noisy_film(tmp_path / "b.mp4")
        assert left.exists(), "a film that is still being made"
        process.kill()
        process.wait()
    noisy_film(tmp_path / "c.mp4")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["b.mp4", "c.mp4"]


def test_a_failed_write_that_the_packer_passed_over_counts_at_the_end(tmp_path, monkeypatch):
    disk_with(10, monkeypatch)
    part = PartFile(tmp_path / "film.mp4")
    part.write(bytes(5))
    with contextlib.suppress(OSError):
        part.write(bytes(6))
    with pytest.raises(OSError, match="No space"):
        part.write(b"")
    with pytest.raises(OSError, match="No space"):
        part.keep()
    assert not list(tmp_path.iterdir())


def test_what_does_not_come_to_disk_is_no_film(tmp_path, monkeypatch):
    """As on file systems that find out that they are full when they are made to write."""

    def full(handle):
        raise FULL

    monkeypatch.setattr("game.app.film.part_file.os.fsync", full)
    with pytest.raises(VideoError, match="No space left on device"):
        noisy_film(tmp_path / "film.mp4")
    assert not list(tmp_path.iterdir())


def test_an_error_of_the_packers_own_end_counts(tmp_path):
    class Broken:
        def __init__(self, container):
            self._inner = container

        def close(self):
            self._inner.close()
            raise RuntimeError("the index cannot be written")

        def __getattr__(self, name):
            return getattr(self._inner, name)

    with (
        pytest.raises(VideoError, match="the index cannot be written"),
        VideoWriter(tmp_path / "film.mp4", (160, 90), 25, sound=False) as film,
    ):
        film._container = Broken(film._container)
        film.add(pygame.Surface((160, 90), 0, 32))
    assert not list(tmp_path.iterdir())
