"""Films: the sound track, the file; and one clear line without PyAV."""

import sys
from types import SimpleNamespace

import numpy as np
import pygame
import pytest

from game.app.commands import run_command_line
from game.app.film import video
from game.app.film.soundtrack import Soundtrack
from game.app.film.video import VideoError, VideoWriter, check_video
from game.stage import Sound
from game.ui.sound import RATE, sample_of


def test_sounds_come_at_their_moments_however_they_are_taken():
    sounds = [Sound(0.10, "ball", 3.0), Sound(0.25, "cushion", 2.0)]
    whole, parts = Soundtrack(), Soundtrack()
    for track in (whole, parts):
        track.schedule(sounds, 0.05)
    one = whole.take(1.0)
    many = np.concatenate([parts.take((k + 1) / 30.0) for k in range(30)])
    assert one.shape == many.shape == (RATE, 2)
    assert np.abs(one.astype(int) - many.astype(int)).max() <= 3
    start = int(0.15 * RATE)
    assert not one[: start - 10].any()
    assert np.abs(one[start : start + len(sample_of("ball", 1))]).max() > 500


def test_without_pyav_there_is_one_clear_line(monkeypatch, tmp_path, capsys):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(VideoError) as missing:
        check_video(tmp_path / "a.mp4")
    assert "pip install" in str(missing.value) and "\n" not in str(missing.value)
    for command in (["record", "example", "--out", str(tmp_path / "m.mp4")],):
        assert run_command_line(command) == 2
        told = capsys.readouterr().err
        assert "PyAV" in told and len(told.strip().splitlines()) == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "words",
    [["--size", "641x360"], ["--size", "10x10"], ["--fps", "0"], ["--fps", "x"], ["--out", "film.avi"],
     ["--theme", "pink"], ["--seconds", "nan"]],
)  # fmt: skip
def test_absurd_films_are_refused(words, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(video, "load_av", lambda: SimpleNamespace())
    assert run_command_line(["record", "example", *words]) == 2
    assert len(capsys.readouterr().err.strip().splitlines()) == 1


@pytest.mark.parametrize("name", ["film.mp4", "film.gif"])
def test_a_film_holds_the_pictures_that_were_added(name, tmp_path):
    av = pytest.importorskip("av")
    path = tmp_path / name
    with VideoWriter(path, (96, 64), 25, sound=True) as film:
        for k in range(20):
            picture = pygame.Surface((96, 64), 0, 32)
            picture.fill((10 * k, 120, 60))
            film.add(picture, np.zeros((RATE // 25, 2), np.int16))
    assert [item.name for item in tmp_path.iterdir()] == [name]
    with av.open(str(path)) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert len(frames) == 20 and frames[0].shape == (64, 96, 3)
    middle = frames[12][32, 48].astype(int)
    assert abs(middle[0] - 120) < 40 and abs(middle[1] - 120) < 40


def test_a_film_that_fails_leaves_no_file(tmp_path):
    pytest.importorskip("av")
    with (
        pytest.raises(RuntimeError, match="slip"),
        VideoWriter(tmp_path / "a.mp4", (96, 64), 25, sound=False),
    ):
        raise RuntimeError("slip")
    assert not list(tmp_path.iterdir())


def test_a_film_of_a_recording_is_as_long_as_that(tmp_path, capsys):
    pytest.importorskip("av")
    recording, film = tmp_path / "r.json", tmp_path / "a.gif"
    assert run_command_line(["run", "example", "--seconds", "0.5", "--record", str(recording)]) == 0
    words = ["record", "example", "--out", str(film), "--size", "160x120", "--fps", "10"]
    assert run_command_line([*words, "--replay", str(recording)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == f"{film}: 0.5 s, 5 pictures"
