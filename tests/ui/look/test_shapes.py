"""Rounded boxes: large ones are made of what small ones are; what is kept has a limit."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.ui.look import shapes
from game.ui.look.shapes import SurfaceStore

DARK, PALE = pygame.Color(20, 30, 40, 200), pygame.Color(240, 240, 230)


def _pixels(surface: pygame.Surface) -> np.ndarray:
    alpha = pygame.surfarray.array_alpha(surface)[:, :, None]
    return np.concatenate([pygame.surfarray.array3d(surface), alpha], axis=2)


@pytest.mark.parametrize("size", [(1, 1), (7, 3), (24, 90), (211, 24), (180, 131)])
@pytest.mark.parametrize("radius", [0.0, 3.0, 7.5, 12.0])
@pytest.mark.parametrize(
    ("fill", "outline", "border"), [(DARK, None, 1.0), (DARK, PALE, 2.3), (None, PALE, 1.0)]
)
def test_a_box_is_as_if_every_pixel_were_computed(size, radius, fill, outline, border):
    radius = min(radius, 0.5 * size[0], 0.5 * size[1])
    made = shapes._make_box(*size, radius, fill, outline, border)
    whole = shapes._make_small_box(*size, radius, fill, outline, border)
    assert np.array_equal(_pixels(made), _pixels(whole))


def test_only_the_corners_of_a_large_box_are_computed(monkeypatch: pytest.MonkeyPatch):
    sizes: list[tuple[int, ...]] = []
    painted = shapes._painted

    def watched(distance, *more):
        sizes.append(distance.shape)
        return painted(distance, *more)

    monkeypatch.setattr(shapes, "_painted", watched)
    assert shapes._make_box(1600, 1000, 8.0, DARK, PALE, 1.0).get_size() == (1600, 1000)
    assert sizes and max(sizes[0]) < 40


def test_what_is_kept_has_a_limit():
    store = SurfaceStore(most_pixels=10_000)
    for i in range(50):
        store.get(("box", i), lambda: pygame.Surface((30, 30)))
    assert store._pixels <= 10_000 and len(store._kept) == 11
    assert store._pixels == sum(s.get_width() * s.get_height() for s in store._kept.values())
