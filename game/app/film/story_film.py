"""The film of a story: camera, captions, cards, sound, chapters; subtitles and a poster beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import pygame

from game.app.film.progress import Progress
from game.app.film.soundtrack import Ear, Soundtrack
from game.app.film.video import Chapter, VideoError, VideoWriter
from game.app.stagehand.headless import prepare
from game.app.stagehand.story_picture import draw_words, point_camera
from game.app.stagehand.view import StageView
from game.app.window.pictures import write_png
from game.files import save_text
from game.stage import Frame, Scene, Stage
from game.stage.playing.paced import NEWEST
from game.stage.script.course import Caption
from game.stage.script.lines import Story
from game.stage.story.rehearsal import Rehearsal, stage_of
from game.stage.story.runner import Runner
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

POSTER_AT = 0.5  # of the film's length
LONGEST_GIF_S = 10.0


class FilmResult(NamedTuple):
    """What has been written: pictures, length s, and the files beside the film."""

    pictures: int
    length_s: float
    beside: tuple[Path, ...]


class StoryFilm:
    """Draws the pictures of a story one after the other. ``size``: px; ``player``: whose name it bears."""

    def __init__(
        self, story: Story, scene_type: type[Scene], size: tuple[int, int], theme: str = "dark",
        player: str = "",
    ) -> None:  # fmt: skip
        prepare()
        self.look = Look(theme_named(theme), auto_scale(*size))
        self.surface = pygame.Surface(size, 0, 32)
        self.stage: Stage = stage_of(story, scene_type, record=False, snapshot_bytes=0, charts=False)
        self.runner = Runner(story, self.stage)
        self._player = player
        self._view = StageView(self.stage, self.look)
        self._view.show_marks(False)
        self._view.place(self.surface.get_rect(), self.look)

    @property
    def sounding(self) -> bool:
        """Whether there is anything to be heard."""
        return self.stage.scene.is_heard()

    @property
    def seen(self) -> Frame:
        """The part of the world in the last picture."""
        return self._view.camera.visible()

    def go_to(self, film_s: float) -> bool:
        """Simulate up to a moment of the film, not back; False at the end of the story."""
        runner, stage = self.runner, self.stage
        if not stage.step_number:
            runner.before_step()
        while runner.film_s < film_s - 1e-9 and stage.fault is None:
            stage.run(1)
        return film_s < runner.course.end_s and stage.fault is None

    def picture(self, film_s: float) -> pygame.Surface:
        """The picture of a moment that `go_to` has led to; drawn over by the next one."""
        runner, stage = self.runner, self.stage
        behind = (runner.film_s - film_s) * runner.course.speed / stage.dt
        self.surface.fill(self.look.theme.stage)
        point_camera(self._view, runner, film_s)
        self._view.draw(self.surface, alpha=min(max(1.0 - behind, 0.0), NEWEST))
        draw_words(self.surface, self.look, self._view, runner, film_s, self._player)
        return self.surface


class Excerpt(NamedTuple):
    """The part of a film, s, that is made."""

    begin_s: float = 0.0
    seconds: float = math.inf


WHOLE = Excerpt()


def write_story_film(
    film: StoryFilm, found: Rehearsal, path: Path, fps: int, excerpt: Excerpt = WHOLE
) -> FilmResult:
    """Film a story, or a part of it. VideoError in one line.

    ``found``: its rehearsal, for the chapters. A GIF has neither sound nor files beside it and at most 10 s.
    """
    begin_s, seconds = excerpt
    story, size = film.runner.story, film.surface.get_size()
    gif = path.suffix.lower() == ".gif"
    length = min(found.film_s - begin_s, seconds, LONGEST_GIF_S if gif else math.inf)
    count = max(round(length * fps), 1)
    poster_at = min(int(POSTER_AT * count), count - 1)
    track, progress = Soundtrack(), Progress("Film")
    ear = Ear(track)
    chapters = chapters_of(found, begin_s, length)
    poster = None
    with VideoWriter(path, size, fps, sound=film.sounding, chapters=chapters, title=story.title) as video:
        for i in range(count):
            film.go_to(begin_s + i / fps)
            picture = film.picture(begin_s + i / fps)
            if film.sounding:
                ear.follow(film.stage.scene.hearing(), 1.0 / fps)
            video.add(picture, track.take((i + 1) / fps) if film.sounding else None)
            if i == poster_at:
                poster = picture.copy()
            progress.tell(i + 1, count)
    beside = () if gif else _write_beside(path, film, poster, begin_s, count / fps)
    return FilmResult(count, count / fps, beside)


def chapters_of(found: Rehearsal, begin_s: float, length: float) -> list[Chapter]:
    """Chapters of a part of the film, s from its beginning."""
    starts = [(one.chapter, one.film_s - begin_s) for one in found.chapters]
    rows: list[Chapter] = []
    for i, (title, start) in enumerate(starts):
        end = starts[i + 1][1] if i + 1 < len(starts) else length
        start, end = max(start, 0.0), min(end, length)
        if end - start > 1e-3:
            rows.append(Chapter(title, start, end))
    return rows


def _write_beside(
    path: Path, film: StoryFilm, poster: pygame.Surface | None, begin_s: float, length: float
) -> tuple[Path, ...]:
    """Subtitles and poster, by the film's name. VideoError if one cannot be written."""
    subtitles, picture = path.with_suffix(".srt"), path.with_suffix(".png")
    try:
        save_text(subtitles, srt_of(film.runner.course.captions(), begin_s, length))
        if poster is not None:
            write_png(poster, picture)
    except OSError as error:
        raise VideoError(f"{error} ({path} itself is whole)") from None
    return subtitles, picture


def srt_of(captions: Sequence[Caption], begin_s: float, length: float) -> str:
    """Captions in the format of SubRip, those within a part of the film."""
    rows: list[str] = []
    for caption in captions:
        begins, ends = max(caption.begins - begin_s, 0.0), min(caption.ends - begin_s, length)
        if ends > begins:
            rows.append(f"{len(rows) + 1}\n{_stamp(begins)} --> {_stamp(ends)}\n{caption.text}\n")
    return "\n".join(rows)


def _stamp(seconds: float) -> str:
    milliseconds = round(seconds * 1000.0)
    minutes, rest = divmod(milliseconds, 60_000)
    return f"{minutes // 60:02d}:{minutes % 60:02d}:{rest // 1000:02d},{rest % 1000:03d}"
