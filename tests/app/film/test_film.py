"""Films: the script of a match, the sound track, the file; and one clear line without PyAV."""

import itertools
import math
import sys
from types import SimpleNamespace

import msgspec
import numpy as np
import pygame
import pytest

from game.app.commands import run_command_line
from game.app.film import video
from game.app.film.match_acts import (
    CUE_SHOWN,
    LEAST_S,
    LOOK_AHEAD_S,
    LOOK_BACK_S,
    MARGIN,
    TITLE_S,
    Act,
    acts_of,
    potted_at,
    what_matters,
)
from game.app.film.match_film import scene_of, story_of, write_match_film
from game.app.film.soundtrack import Soundtrack
from game.app.film.story_film import StoryFilm
from game.app.film.video import VideoError, VideoWriter, check_video
from game.billiards.game.arrangement import Stroke, arrange, equal_balls
from game.billiards.game.summary import summarize
from game.billiards.laws.state import BALL_POCKET
from game.billiards.players.match import Match, Round
from game.billiards.shot.physics import Physics
from game.billiards.simulation import simulate
from game.billiards.table.table import Table
from game.stage import Sound
from game.stage.script.lines import Say
from game.stage.story.rehearsal import rehearse, stage_of
from game.stage.story.runner import Runner, last_words
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
    acts = acts_of(match)
    assert acts[0].begins == TITLE_S and acts[-1].ends >= LEAST_S
    for act, following in itertools.pairwise(acts):
        assert act.ends == following.begins
    for act in acts:
        assert act.begins < act.hits < act.hits + potted_at(act.round) < act.ends


def test_what_matters_is_the_balls_of_the_chain_the_cue_before_the_hit_and_then_the_pocket():
    for act in acts_of(small_match()):
        shot, fallen = act.round.trajectory.shot, act.round.fallen
        cue = shot.positions[shot.ids.index("0")]
        pocket = shot.table.pockets[fallen.pocket, :2]
        falls = act.hits + potted_at(act.round)
        behind = cue - CUE_SHOWN * np.array((math.cos(-0.75 * math.pi), math.sin(-0.75 * math.pi)))

        def holds(time, place, act=act) -> bool:
            low, high = what_matters(act, time)
            return bool((low <= place - MARGIN + 1e-9).all() and (place + MARGIN - 1e-9 <= high).all())

        assert holds(act.hits - 0.1, behind) and not holds(act.hits + 0.3, behind)
        assert holds(act.hits - 0.1, cue)
        for early in (0.9 * LOOK_AHEAD_S, 0.1 * LOOK_AHEAD_S, -0.1):
            assert holds(falls - early, pocket)
        row = shot.ids.index(str(fallen.ball))
        for time in np.arange(act.hits, falls, 0.1).tolist():
            for ahead in (0.0, LOOK_AHEAD_S):
                assert holds(time, act.round.trajectory.state_at(time + ahead - act.hits).positions[row])


def test_the_picture_reaches_from_a_little_before_to_a_little_ahead():
    """A ball that rolls evenly for 9 s: the box ends where it was and where it will be."""

    def places(time):
        return np.array([(0.5, 0.95), (0.3 + 0.02 * time, 0.4 + 0.2 * time)])

    shot = SimpleNamespace(ids=("0", "5"), table=Table.pool(), positions=places(0.0))
    trajectory = SimpleNamespace(
        shot=shot, rows=np.array([(9.0, BALL_POCKET, 1, 2)]), end_time=9.0,
        state_at=lambda time: SimpleNamespace(positions=places(time)),
    )  # fmt: skip
    fallen = SimpleNamespace(chain=(5,), ball=5, pocket=2)
    act = Act(SimpleNamespace(trajectory=trajectory, fallen=fallen), 0.0, 1.0, 12.0, None)
    now = 3.0
    low, high = what_matters(act, act.hits + now)
    assert high[1] == pytest.approx(places(now + LOOK_AHEAD_S)[1, 1] + MARGIN)
    assert low == pytest.approx(places(now - LOOK_BACK_S).min(axis=0) - MARGIN)
    assert high[0] == pytest.approx(0.5 + MARGIN)


def test_the_story_of_a_match_says_what_fell_and_holds():
    match = small_match()
    found = rehearse(story_of(match, "Anna Example"), scene_of(match))
    assert found.failures == [] and found.film_s >= LEAST_S
    assert [one.chapter for one in found.moments] == ["Round 1", "Ball 5", "Round 2", "Ball 3", "The end"]
    for act, down in zip(acts_of(match), found.moments[1::2], strict=False):
        assert down.time_s == pytest.approx(act.hits + potted_at(act.round), abs=0.05)


def test_the_camera_sees_the_ball_that_falls():
    match = small_match()
    story = story_of(match)
    stage = stage_of(story, scene_of(match))
    runner = Runner(story, stage)
    for act in acts_of(match):
        row = act.round.trajectory.shot.ids.index(str(act.round.fallen.ball))
        while stage.time_s < act.hits + potted_at(act.round):
            stage.run(6)
            if stage.time_s < act.hits:
                continue
            seen = runner.view(runner.film_s).frame(turned=True)
            x, y = act.round.trajectory.state_at(stage.time_s - act.hits).positions[row].tolist()
            assert seen.left - 0.03 < x < seen.right + 0.03 and seen.bottom < y < seen.top


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
    path = tmp_path / "match.mp4"
    assert write_match_film(small_match(), path, "Anna Example", (160, 90), 5, seconds=1.0) == 1.0
    assert path.stat().st_size > 1000
    match = small_match()
    film = StoryFilm(story_of(match), scene_of(match), (320, 180), player="Anna Example")
    acts, seen = acts_of(match), []
    for time in (1.5, acts[0].hits - 0.2, acts[1].hits + 0.4, acts[1].ends + 2.0):
        film.go_to(time)
        seen.append(pygame.image.tobytes(film.picture(time), "RGB"))
    assert len(set(seen)) == 4


def test_a_film_of_a_recording_is_as_long_as_that(tmp_path, capsys):
    pytest.importorskip("av")
    recording, film = tmp_path / "r.json", tmp_path / "a.gif"
    assert run_command_line(["run", "example", "--seconds", "0.5", "--record", str(recording)]) == 0
    words = ["record", "example", "--out", str(film), "--size", "160x120", "--fps", "10"]
    assert run_command_line([*words, "--replay", str(recording)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == f"{film}: 0.5 s, 5 pictures"


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (480, 270), (600, 800)])
def test_what_is_said_while_balls_roll_covers_no_part_of_the_table(size):
    match = small_match()
    scene_type, story = scene_of(match), story_of(match, "")
    silent = msgspec.structs.replace(story, lines=tuple(x for x in story.lines if not isinstance(x, Say)))
    found = rehearse(story, scene_type)
    time = next(one.film_s for one in found.moments if one.chapter == "Ball 5") - 0.6
    drawn = []
    for told in (story, silent):
        film = StoryFilm(told, scene_type, size)
        film.go_to(time)
        drawn.append(pygame.surfarray.array3d(film.picture(time)))
    row = size[1] - min(film.look.px(scene_type.story_row), size[1] // 3)
    assert (drawn[0][:, :row] == drawn[1][:, :row]).all()
    assert (drawn[0][:, row:] != drawn[1][:, row:]).any()


def test_a_match_without_a_winner_is_a_draw():
    match = small_match()
    assert last_words(story_of(match)) == "A draw, 1 : 1"
