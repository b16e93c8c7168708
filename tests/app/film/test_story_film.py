"""The film of a story: sound, chapters, subtitles, poster; the same pictures from the same command."""

from __future__ import annotations

import re

import numpy as np
import pygame
import pytest

from game.app.film.story_film import Excerpt, StoryFilm, chapters_of, srt_of, write_story_film
from game.stage.script.course import Caption
from game.stage.story.rehearsal import rehearse
from tests.stage.story.bouncing import StoryBall, story

av = pytest.importorskip("av")


@pytest.fixture(scope="module")
def found():
    return rehearse(story(), StoryBall)


def pictures(path):
    with av.open(str(path)) as container:
        return [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]


def test_a_film_has_picture_sound_chapters_subtitles_and_a_poster(found, tmp_path):
    path = tmp_path / "a.mp4"
    made = write_story_film(StoryFilm(story(), StoryBall, (320, 180)), found, path, 10)
    assert sorted(item.name for item in tmp_path.iterdir()) == ["a.mp4", "a.png", "a.srt"]
    assert made.length_s == pytest.approx(found.film_s, abs=0.1)
    with av.open(str(path)) as film:
        video, audio = film.streams.video[0], film.streams.audio[0]
        assert (video.codec_context.name, video.codec_context.pix_fmt) == ("h264", "yuv420p")
        assert (video.codec_context.width, video.codec_context.height) == (320, 180)
        assert audio.codec_context.name == "aac"
        assert film.duration / 1e6 == pytest.approx(found.film_s, abs=0.3)
        titles = [chapter["metadata"]["title"] for chapter in film.chapters()]
        starts = [chapter["start"] * float(chapter["time_base"]) for chapter in film.chapters()]
        assert titles == ["Beginning", "Three bounces", "Five"]
        assert starts == pytest.approx([one.film_s for one in found.chapters], abs=0.01)
        samples = np.concatenate([f.to_ndarray() for f in film.decode(audio=0)], axis=1)
    assert np.abs(samples).max() > 0.01
    poster = pygame.image.load(tmp_path / "a.png")
    assert poster.get_size() == (320, 180)
    words = (tmp_path / "a.srt").read_text(encoding="utf-8")
    assert len(re.findall(r"\d\d:\d\d:\d\d,\d\d\d --> ", words)) == 2 and "It has bounced 1 times" in words


def test_the_same_story_gives_the_same_pictures_bit_for_bit(found):
    seen = []
    for _ in range(2):
        film = StoryFilm(story(), StoryBall, (320, 180), player="Ada")
        seen.append([])
        for i in range(80):
            film.go_to(i / 5)
            seen[-1].append(pygame.image.tobytes(film.picture(i / 5), "RGB"))
    assert seen[0] == seen[1] and len(set(seen[0])) > 60


def test_a_part_of_a_story(found, tmp_path):
    path = tmp_path / "part.mp4"
    begin = found.chapters[1].film_s
    made = write_story_film(StoryFilm(story(), StoryBall, (160, 90)), found, path, 10, Excerpt(begin, 2.0))
    assert made.pictures == 20 and len(pictures(path)) == 20
    with av.open(str(path)) as film:
        assert [c["metadata"]["title"] for c in film.chapters()] == ["Three bounces"]


def test_a_gif_has_its_own_colours_and_at_most_ten_seconds(found, tmp_path):
    path = tmp_path / "a.gif"
    made = write_story_film(StoryFilm(story(), StoryBall, (160, 90)), found, path, 10)
    assert made.length_s == 10.0 and [item.name for item in tmp_path.iterdir()] == ["a.gif"]
    film = StoryFilm(story(), StoryBall, (160, 90))
    film.go_to(9.0)
    drawn = pygame.surfarray.array3d(film.picture(9.0)).swapaxes(0, 1).astype(int)
    shown = pictures(path)
    assert len(shown) == 100
    assert np.abs(shown[90].astype(int) - drawn).mean() < 4.0


def test_upright_films_show_what_lying_ones_show(found):
    lying = StoryFilm(story(), StoryBall, (320, 180))
    upright = StoryFilm(story(), StoryBall, (180, 320))
    for film in (lying, upright):
        film.go_to(4.0)
        film.picture(4.0)
    assert lying.seen.right - lying.seen.left == pytest.approx(upright.seen.right - upright.seen.left)
    assert upright.seen.top - upright.seen.bottom > lying.seen.top - lying.seen.bottom


def test_subtitles_are_cut_to_the_part():
    captions = [Caption("a", 0.0, 2.0, 1), Caption("b", 3.5, 7.25, 2), Caption("c", 9.0, 11.0, 3)]
    assert srt_of(captions, 1.0, 5.0) == (
        "1\n00:00:00,000 --> 00:00:01,000\na\n\n2\n00:00:02,500 --> 00:00:05,000\nb\n"
    )


def test_chapters_are_cut_to_the_part(found):
    rows = chapters_of(found, found.chapters[2].film_s - 1.0, 3.0)
    assert [(row.title, round(row.begins, 6), round(row.ends, 6)) for row in rows] == [
        ("Three bounces", 0.0, 1.0),
        ("Five", 1.0, 3.0),
    ]
