"""A video file that is fed with pictures and sound; encoded by a thread while the next picture is drawn.

MP4 holds H.264 and AAC, GIF pictures alone, which wait in a file without loss until all colours are known.
The file appears under its name only when it is whole. PyAV is an extra (``video``); without it VideoError
says so in one line.
"""

from __future__ import annotations

import contextlib
import os
import queue
import tempfile
import threading
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.app.film.gif import write_gif
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
            handle, name = tempfile.mkstemp(prefix=".", suffix=path.suffix, dir=path.parent)
            os.close(handle)
            self._part = Path(name)
            form = "matroska" if self._gif else FORMATS[path.suffix.lower()]
            self._container = load_av().open(name, "w", format=form)
        except OSError as error:
            raise VideoError(f"{path}: {error.strerror or error}") from None
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
        with contextlib.suppress(Exception):
            self._container.close()
        if self._gif and kind is None and not self._failure:
            self._reduce_colors()
        failed = kind is not None or bool(self._failure)
        if failed:
            self._part.unlink(missing_ok=True)
            if kind is None:
                raise VideoError(f"{self.path}: {self._failure}")
            return
        self._part.chmod(0o666 & ~_umask())
        self._part.replace(self.path)

    def _reduce_colors(self) -> None:
        """The GIF from what was kept without loss."""
        reduced = self._part.with_suffix(".reduced.gif")
        try:
            write_gif(self._part, reduced, self._rate, load_av())
            reduced.replace(self._part)
        except Exception as error:  # whatever the filters find, as of the encoder
            reduced.unlink(missing_ok=True)
            self._failure = " ".join(str(error).split()) or type(error).__name__

    def add(self, picture: pygame.Surface, sound: NDArray[np.int16] | None = None) -> None:
        """The next picture, and the samples (n, 2) that are heard with it. VideoError if encoding failed."""
        if self._failure:
            raise VideoError(f"{self.path}: {self._failure}")
        width, height = self.size
        rows = np.frombuffer(picture.get_buffer().raw, np.uint8).reshape(height, -1, 4)
        self._jobs.put((rows[:, :width].copy(), sound))

    def _work(self) -> None:
        """Encode what comes, until there is nothing more."""
        try:
            while (job := self._jobs.get()) is not None:
                self._encode(*job)
            self._flush()
        except Exception as error:  # whatever the encoder finds: raised where pictures are added
            words = getattr(error, "strerror", None) or str(error)
            self._failure = " ".join(words.split()) or type(error).__name__
            while self._jobs.get() is not None:
                pass

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


def _umask() -> int:
    """The mask for new files; there is no way to read it but to set it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
