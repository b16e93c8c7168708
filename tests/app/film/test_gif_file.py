"""GIF files of our own: read back by the system's decoder, picture for picture."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pygame
import pytest

from game.app.film.gif_file import GifFile, chosen_colors
from game.files import FileProblem

RNG = np.random.default_rng(5)


def pictures_in(path: Path) -> list[np.ndarray]:
    """All pictures of a GIF as (h, w, 3) red, green, blue."""
    shown = pygame.image.load_animation(str(path))
    return [pygame.surfarray.array3d(surface).transpose(1, 0, 2) for surface, _ in shown]


def written(path: Path, pictures: list[np.ndarray]) -> list[np.ndarray]:
    height, width = pictures[0].shape[:2]
    film = GifFile(path, (width, height), 20)
    for picture in pictures:
        film.add(np.ascontiguousarray(picture))
    film.write()
    return pictures_in(path)


def plain(color: tuple[int, int, int], size=(40, 30)) -> np.ndarray:
    """A picture (h, w, 4) of blue, green, red."""
    picture = np.zeros((size[1], size[0], 4), np.uint8)
    picture[:, :, :3] = color[::-1]
    return picture


def test_few_colours_come_back_as_they_were(tmp_path):
    first, second = plain((255, 0, 0)), plain((255, 0, 0))
    second[5:9, 7:20, :3] = (255, 255, 255)
    found = written(tmp_path / "a.gif", [first, second])
    assert len(found) == 2
    for picture, back in zip([first, second], found, strict=True):
        assert np.array_equal(picture[:, :, 2::-1], back)


def test_noise_of_many_colours_fills_the_table_of_codes_and_comes_back_near(tmp_path):
    noise = RNG.integers(0, 256, (120, 160, 4)).astype(np.uint8)
    (back,) = written(tmp_path / "n.gif", [noise])
    error = np.abs(back.astype(int) - noise[:, :, 2::-1])
    assert error.mean() < 16 and np.percentile(error, 99) < 60


@pytest.mark.parametrize("count", [1, 2, 3, 255, 256, 257, 4095, 40_000])
def test_rows_of_any_length_are_whole(tmp_path, count):
    levels = (RNG.integers(0, 4, count) * 85).astype(np.uint8)
    row = np.stack([levels] * 4, axis=1).reshape(1, count, 4)
    (back,) = written(tmp_path / "r.gif", [row])

    assert np.abs(back[0, :, 0].astype(int) - levels).max() <= 4


def test_a_picture_that_stays_is_shown_longer(tmp_path):
    film = GifFile(tmp_path / "s.gif", (40, 30), 20)
    for _ in range(10):
        film.add(plain((0, 0, 255)))
    film.add(plain((0, 255, 0)), times=3)
    film.write()
    shown = pygame.image.load_animation(str(tmp_path / "s.gif"))
    assert [time for _, time in shown] == [500, 150] and film.count == 13


def test_no_picture_and_no_folder_are_told(tmp_path):
    with pytest.raises(FileProblem, match="no picture"):
        GifFile(tmp_path / "x.gif", (2, 2), 20).write()
    (tmp_path / "none").write_text("in the way")
    film = GifFile(tmp_path / "none" / "x.gif", (40, 30), 20)
    film.add(plain((1, 2, 3)))
    with pytest.raises(FileProblem):
        film.write()


def test_the_colours_chosen_are_255_at_most_and_the_many_are_met_best():
    counts = np.zeros(64**3, np.int64)
    counts[RNG.choice(64**3, 5000, replace=False)] = RNG.integers(1, 1000, 5000)
    colors, index = chosen_colors(counts)
    assert colors.shape == (256, 3) and index.max() == 254
