"""A video file that is fed with pictures and sound; encoded by a thread while the next picture is drawn.

MP4 holds H.264 and AAC, GIF pictures alone, which wait in a file without loss until all colours are known.
The file appears under its name only when it is whole. PyAV is an extra (``video``); without it VideoError
says so in one line.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.app.film.gif import write_gif
from game.app.film.part_file import PartFile
from game.ui.sound import RATE

WAITING = 8  # pictures that may wait for the encoder
FORMATS = {".mp4": "mp4", ".mkv": "matroska", ".gif": "gif"}
QUALITY = {"crf": "20", "preset": "veryfast"}
MOST_GIF_HZ = 50  # delays in GIF files are whole hundredths of a second
SAMPLES = 1024  # of sound that are encoded at a time


class Chapter(NamedTuple):
    """A part of a film with a title, from and to, s."""

    title: str
    begins: float
    ends: float


class VideoError(RuntimeError):
    """A film that cannot be made; one line."""


def check_video(path: Path) -> None:
    """VideoError if no such film could be written: another ending, or PyAV is missing."""
    if path.suffix.lower() not in FORMATS:
        raise VideoError(f"{path}: expected a name that ends in {' or '.join(FORMATS)}")
    load_av()


def load_av() -> Any:
    """PyAV; VideoError if it is not installed."""
    try:
        import av
    except ImportError:
        raise VideoError("films need PyAV, which is not installed: pip install 'carom[video]'") from None
    return av


class VideoWriter:
    """Writes one film. Use as a context; what fails inside leaves no file."""

    def __init__(
        self, path: Path, size: tuple[int, int], fps: int, sound: bool, chapters: Sequence[Chapter] = (),
        title: str = "",
    ) -> None:  # fmt: skip
        """size: px, even numbers. Raises VideoError if the file cannot be begun."""
        check_video(path)
        self.path = path
        self.size = size
        self.fps = fps
        self._gif = path.suffix.lower() == ".gif"
        self._with_sound = sound and not self._gif
        self._chapters = () if self._gif else tuple(chapters)
        self._title = title
        self._failure = ""
        self._jobs: queue.Queue[Any] = queue.Queue(WAITING)
        try:
            self._part = PartFile(path)
        except OSError as error:
            raise VideoError(f"{path}: {_reason(error)}") from None
        form = "matroska" if self._gif else FORMATS[path.suffix.lower()]
        self._container = load_av().open(self._part, "w", format=form)
        self._add_streams()
        self._thread = threading.Thread(target=self._work, name="encoder", daemon=True)
        self._thread.start()

    def _add_streams(self) -> None:
        self._video = self._container.add_stream("ffv1" if self._gif else "libx264", rate=self._rate)
        self._video.width, self._video.height = self.size
        self._video.pix_fmt = "bgr0" if self._gif else "yuv420p"
        if not self._gif:
            self._video.options = dict(QUALITY)
        if self._title:
            self._container.metadata["title"] = self._title
        if self._chapters:
            base = Fraction(1, 1000)
            self._container.set_chapters([
                {"id": i, "start": round(one.begins * 1000), "end": round(one.ends * 1000),
                 "time_base": base, "metadata": {"title": one.title}}
                for i, one in enumerate(self._chapters)
            ])  # fmt: skip
        self._sound = None
        if self._with_sound:
            self._sound = self._container.add_stream("aac", rate=RATE)
            self._sound.layout = "stereo"
        self._heard = 0

    @property
    def _rate(self) -> int:
        """Pictures a second."""
        return min(self.fps, MOST_GIF_HZ) if self._gif else self.fps

    def __enter__(self) -> VideoWriter:
        return self

    @property
    def full(self) -> bool:
        """Whether the next picture would have to wait for the encoder."""
        return self._jobs.full()

    def __exit__(self, kind: Any, *_: object) -> None:
        self._jobs.put(None)
        self._thread.join()
        try:
            self._container.close()  # writes what only the end knows
        except Exception as error:  # whatever the packer finds
            self._failure = self._failure or _reason(error)
        if self._part.problem is not None:
            self._failure = _reason(self._part.problem)
        if self._gif and kind is None and not self._failure:
            self._reduce_colors()
        if kind is not None or self._failure:
            self._part.drop()
            if kind is None:
                raise VideoError(f"{self.path}: {self._failure}")
            return
        try:
            self._part.keep()
        except OSError as error:
            raise VideoError(f"{self.path}: {_reason(error)}") from None

    def _reduce_colors(self) -> None:
        """The GIF from what was kept without loss, which is then no longer needed."""
        lossless = self._part
        try:
            self._part = PartFile(self.path)
        except OSError as error:
            self._failure = _reason(error)
            return
        try:
            write_gif(lossless, self._part, self._rate, load_av())
        except Exception as error:  # whatever the filters find, as of the encoder
            self._failure = _reason(self._part.problem or error)
        finally:
            lossless.drop()

    def add(self, picture: pygame.Surface, sound: NDArray[np.int16] | None = None) -> None:
        """The next picture, and the samples (n, 2) that are heard with it. VideoError if encoding failed."""
        if self._failure:
            raise VideoError(f"{self.path}: {self._failure}")
        width, height = self.size
        rows = np.frombuffer(picture.get_buffer().raw, np.uint8).reshape(height, -1, 4)
        self._jobs.put((rows[:, :width].copy(), sound))

    def _work(self) -> None:
        """Encode what comes, until there is nothing more; what comes after a failure is passed over."""
        while (job := self._jobs.get()) is not None:
            if not self._failure:
                self._try(self._encode, *job)
        if not self._failure:
            self._try(self._flush)

    def _try(self, work: Callable[..., None], *given: Any) -> None:
        """Do a piece of work; why it failed is raised where pictures are added."""
        try:
            work(*given)
        except Exception as error:  # whatever the encoder finds
            self._failure = _reason(error)

    def _encode(self, pixels: NDArray[np.uint8], sound: NDArray[np.int16] | None) -> None:
        av = load_av()
        frame = av.VideoFrame.from_ndarray(pixels, format="bgra")
        if self._gif:
            frame = frame.reformat(format="bgr0")
        for packet in self._video.encode(frame):
            self._container.mux(packet)
        if self._sound is None or sound is None:
            return
        for start in range(0, len(sound), SAMPLES):
            part = np.ascontiguousarray(sound[start : start + SAMPLES]).reshape(1, -1)
            heard = av.AudioFrame.from_ndarray(part, format="s16", layout="stereo")
            heard.sample_rate, heard.pts, heard.time_base = RATE, self._heard, Fraction(1, RATE)
            self._heard += part.shape[1] // 2
            for packet in self._sound.encode(heard):
                self._container.mux(packet)

    def _flush(self) -> None:
        for stream in (self._video, self._sound):
            if stream is not None:
                for packet in stream.encode():
                    self._container.mux(packet)


def _reason(error: Exception) -> str:
    """Why something failed, in one line."""
    words = getattr(error, "strerror", None) or str(error)
    return " ".join(words.split()) or type(error).__name__
