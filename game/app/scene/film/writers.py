"""Where the pictures of a film go while the scene is in play: never to be waited for.

MP4 is made by PyAV where that is installed; GIF needs nothing. A thread packs, and finishes the file.
"""

from __future__ import annotations

import queue
import threading
from pathlib import Path
from typing import Protocol

import numpy as np
import pygame
from numpy.typing import NDArray

from game.app.film.gif_file import GifFile, pixels_of_picture
from game.app.film.video import VideoError, VideoWriter, load_av
from game.arrays import Samples
from game.files import FileProblem

MP4_SIZE, GIF_SIZE = (1280, 720), (640, 400)  # px, the largest
MP4_HZ, GIF_HZ = 30, 20
LONGEST_S = {"mp4": 1800.0, "gif": 60.0}
WAITING = 6  # pictures
MISSING = "MP4 needs PyAV, which is not installed: pip install 'carom[video]'"


class Writer(Protocol):
    """Takes pictures of one size at a steady rate."""

    path: Path
    size: tuple[int, int]
    rate: int
    share: float  # of the finishing that is done, 0 to 1

    @property
    def full(self) -> bool:
        """Whether a picture would have to wait."""
        ...

    def add(self, picture: pygame.Surface, sounds: list[Samples] | None) -> None:
        """A picture of `size`, shown once for each piece of sound. VideoError if something has failed."""
        ...

    def finish(self) -> None:
        """Make the file whole; any thread may do it. VideoError if it cannot be."""
        ...

    def drop(self) -> None:
        """Leave no file."""
        ...


def has_mp4() -> bool:
    """Whether PyAV is installed."""
    try:
        load_av()
    except VideoError:
        return False
    return True


def fitted(size: tuple[int, int], most: tuple[int, int]) -> tuple[int, int]:
    """Size (px, even numbers) of the same shape, no larger than ``most``."""
    share = min(1.0, most[0] / max(size[0], 1), most[1] / max(size[1], 1))
    width, height = (max(2, 2 * round(0.5 * share * side)) for side in size)
    return width, height


def make_writer(kind: str, path: Path, stage: tuple[int, int], sound: bool) -> Writer:
    """The writer of a film of a stage of that size (px). VideoError if there is no place for it."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise VideoError(f"{path.parent}: {error.strerror or error}") from None
    if kind == "mp4":
        return Mp4(path, fitted(stage, MP4_SIZE), sound)
    return Gif(path, fitted(stage, GIF_SIZE))


class Mp4:
    """A film with sound, by PyAV, which has a thread of its own."""

    rate = MP4_HZ

    def __init__(self, path: Path, size: tuple[int, int], sound: bool) -> None:
        self.path, self.size, self.share = path, size, 0.0
        self._video = VideoWriter(path, size, self.rate, sound)

    @property
    def full(self) -> bool:
        return self._video.full

    def add(self, picture: pygame.Surface, sounds: list[Samples] | None) -> None:
        for sound in sounds or [None]:  # type: ignore[list-item]
            self._video.add(picture, sound)

    def finish(self) -> None:
        self._video.__exit__(None)
        self.share = 1.0

    def drop(self) -> None:
        self._video.__exit__(VideoError)


class Gif:
    """A film without sound."""

    rate = GIF_HZ

    def __init__(self, path: Path, size: tuple[int, int]) -> None:
        self.path, self.size, self.share = path, size, 0.0
        self._file = GifFile(path, size, self.rate)
        self._jobs: queue.Queue[tuple[NDArray[np.uint8], int] | None] = queue.Queue()
        self._thread = threading.Thread(target=self._work, name="film", daemon=True)
        self._thread.start()

    @property
    def full(self) -> bool:
        return self._jobs.qsize() >= WAITING

    def add(self, picture: pygame.Surface, sounds: list[Samples] | None) -> None:
        self._jobs.put((pixels_of_picture(picture), len(sounds) if sounds else 1))

    def _work(self) -> None:
        while (job := self._jobs.get()) is not None:
            self._file.add(*job)

    def finish(self) -> None:
        self.drop()
        try:
            self._file.write(self._tell)
        except FileProblem as problem:
            raise VideoError(f"{self.path}: {problem}") from None

    def drop(self) -> None:
        self._jobs.put(None)
        self._thread.join()

    def _tell(self, share: float) -> None:
        self.share = share
