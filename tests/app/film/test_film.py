"""Films: the script of a match, the sound track, the file; and one clear line without PyAV."""

import math
import sys
from types import SimpleNamespace

import numpy as np
import pygame
import pytest

from game.app.commands import run_command_line
from game.app.film import video
from game.app.film.captions import draw_caption, draw_tally
from game.app.film.script import (
    ASPECT,
    LEAST_S,
    SLOW,
    SLOW_FROM_S,
    TITLE_S,
    potted_at,
    write_script,
)
from game.app.film.soundtrack import Soundtrack
from game.app.film.video import VideoError, VideoWriter, check_video
from game.billiards.game.arrangement import Stroke, arrange, equal_balls
from game.billiards.game.summary import summarize
from game.billiards.players.match import Match, Round
from game.billiards.shot.shot import Physics
from game.billiards.simulation import simulate
from game.billiards.table.table import Table
from game.stage import Sound
from game.ui.sound import RATE, sample_of


def small_match() -> Match:
    """Two rounds: the last ball but one by way of another, then the last one."""
    table, physics = Table.pool(), Physics()
    diagonal = math.atan2(-1.0, -1.0)
    rounds = []
    for number, places in enumerate(
        ({0: (0.6, 0.6), 3: (0.40, 0.40), 5: (0.2, 0.2)}, {0: (0.5, 0.5), 3: (0.2, 0.2)}), start=1
    ):
        stroke = Stroke(2.2, diagonal)
        shot = arrange(places).shot(table, physics, stroke)
        played = simulate(shot)
        fallen = summarize(played).pocketed[0]
        rounds.append(Round(number, (number - 1) % 2, stroke, fallen, shot, played, 0.1))
    return Match(1, equal_balls(), tuple(rounds))


def test_a_film_lasts_a_minute_and_its_rounds_follow_each_other():
    match = small_match()
    script = write_script(match)
    assert script.length >= LEAST_S
    assert script.acts[0].begins == TITLE_S
    for act, following in zip(script.acts, script.acts[1:], strict=False):
        assert act.ends == following.begins
    for act in script.acts:
        assert act.begins < act.hits < act.hits + potted_at(act.round) <= act.potted < act.ends
        assert script.act_at(act.hits) is act
    assert script.act_at(0.0) is None and script.act_at(script.length) is None


def test_the_camera_sees_the_ball_that_falls():
    script = write_script(small_match())
    for act in script.acts:
        trajectory = act.round.trajectory
        row = trajectory.shot.ids.index(str(act.round.fallen.ball))
        for share in np.linspace(0.0, 1.0, 12):
            since = share * potted_at(act.round)
            x, y, length = script.camera.sample(act.film_time(since)).tolist()
            px, py = trajectory.state_at(since).positions[row].tolist()
            assert abs(py - y) < 0.5 * length and abs(px - x) < 0.5 * length / ASPECT + 0.03


def test_the_deciding_ball_falls_slowly_and_near_and_no_other():
    first, last = write_script(small_match()).acts
    assert first.potted == first.hits + potted_at(first.round)
    down = potted_at(last.round)
    assert last.potted == pytest.approx(last.hits + down + min(SLOW_FROM_S, down) * (SLOW - 1.0))
    for act in (first, last):
        for since in np.linspace(-0.5, down + 1.0, 40).tolist():
            assert act.shot_time(act.film_time(since)) == pytest.approx(since, abs=1e-12)
    before, now = last.shot_time(last.potted - 0.2), last.shot_time(last.potted - 0.1)
    assert now - before == pytest.approx(0.1 / SLOW)
    camera = write_script(small_match()).camera
    assert camera.sample(last.potted - 0.1)[2] < 0.8 * camera.sample(first.potted - 0.1)[2]


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (480, 270), (600, 800)])
def test_what_is_said_while_balls_roll_covers_no_part_of_the_table(size):
    from game.app.film.match_film import MatchFilm

    film = MatchFilm(small_match(), size, "")
    assert not film.stage.colliderect(film.row) and film.stage.union(film.row).size == size
    act = film.script.acts[0]
    with_words = pygame.surfarray.array3d(film.picture(act.potted))
    surface = pygame.Surface(size, 0, 32)
    draw_tally(surface, film.look, film.row, (tuple(range(1, 8)), tuple(range(8, 16))))
    draw_caption(surface, film.look, film.row, act, act.potted)
    drawn = pygame.surfarray.array3d(surface)
    assert not drawn[:, : film.row.top].any() and drawn[:, film.row.top :].any()
    assert with_words[:, film.row.top :].any()


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
    for command in (
        ["match", "--video", str(tmp_path / "m.mp4")],
        ["record", "example", "--out", str(tmp_path / "m.mp4")],
    ):
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


def test_match_and_scene_are_filmed(tmp_path, monkeypatch):
    pytest.importorskip("av")
    from game.app.film.match_film import MatchFilm, write_match_film

    path = tmp_path / "match.mp4"
    assert write_match_film(small_match(), path, "Anna Example", (160, 90), 5, seconds=1.0) == 1.0
    assert path.stat().st_size > 1000
    film = MatchFilm(small_match(), (320, 180), "Anna Example")
    times = (1.5, film.script.acts[0].hits - 0.2, film.script.acts[1].hits + 0.4, film.length - 1.0)
    seen = [pygame.image.tobytes(film.picture(time), "RGB") for time in times]
    assert len(set(seen)) == 4
    assert film.potted_at(film.length) == ((5,), (3,))


def test_a_film_of_a_recording_is_as_long_as_that(tmp_path, capsys):
    pytest.importorskip("av")
    recording, film = tmp_path / "r.json", tmp_path / "a.gif"
    assert run_command_line(["run", "example", "--seconds", "0.5", "--record", str(recording)]) == 0
    words = ["record", "example", "--out", str(film), "--size", "160x120", "--fps", "10"]
    assert run_command_line([*words, "--replay", str(recording)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == f"{film}: 0.5 s, 5 pictures"
