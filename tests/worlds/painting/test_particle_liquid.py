"""A body of liquid in pixels: as large as its particles, even inside, lit at its edge, mixed between."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.particle_fluids import lattice
from game.worlds.painting.particle_liquid import DEEP, ParticleLiquidPainter

SPACING = 10.0


def painted(places, inks, clip=(0, 0, 300, 200)) -> np.ndarray:
    """(200, 300, 3) of a picture that was black."""
    pixels = np.zeros((200, 300), np.uint32)
    ParticleLiquidPainter().paint(
        (pixels, np.array(clip, np.int64)), places, SPACING, np.asarray(inks), np.ones(len(places))
    )
    return np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(int)


def of_one(ink, places) -> np.ndarray:
    return painted(places, np.tile(ink, (len(places), 1)))


def test_a_block_is_as_large_as_its_particles_and_even_inside():
    picture = of_one((0.2, 0.4, 0.8), lattice((60.0, 50.0), (220.0, 150.0), SPACING))
    covered = np.count_nonzero(picture.sum(axis=2) > 60)
    assert covered == pytest.approx(160.0 * 100.0, rel=0.04)
    inside = picture[70:130, 80:200].reshape(-1, 3)
    assert inside == pytest.approx(
        np.tile(255.0 * (1.0 - DEEP) * np.array((0.2, 0.4, 0.8)), (7200, 1)), abs=2.5
    )


def test_light_comes_from_the_upper_left():
    picture = of_one((0.4, 0.4, 0.4), lattice((60.0, 50.0), (220.0, 150.0), SPACING)).max(axis=2)
    top, bottom = picture[:, 140][45:60].max(), picture[:, 140][140:156].max()
    left, right = picture[100, 55:70].max(), picture[100, 210:226].max()
    assert top > bottom + 30 and left > right + 20


def test_colours_mix_where_two_liquids_meet_and_nowhere_else():
    places = lattice((60.0, 50.0), (220.0, 150.0), SPACING)
    inks = np.where(places[:, :1] < 140.0, (0.8, 0.1, 0.1), (0.1, 0.1, 0.8))
    row = painted(places, inks)[100]
    assert (row[90:120, 0] > row[90:120, 2] + 120).all() and (row[160:190, 2] > row[160:190, 0] + 120).all()
    assert abs(int(row[139, 0]) - int(row[139, 2])) < 40
    assert (np.diff(row[90:190, 0]) <= 3).all(), "from red to blue without a step back"
    assert (np.diff(row[90:190, 0]) > -25).all(), "and without one of a whole cell"


def test_nothing_is_painted_beyond_the_clip_or_without_particles():
    places = lattice((0.0, 0.0), (300.0, 200.0), SPACING)
    picture = painted(places, np.full((len(places), 3), 0.5), clip=(50, 40, 170, 111))
    assert picture[40:111, 50:170].min() > 0
    picture[40:111, 50:170] = 0
    assert picture.max() == 0
    assert painted(np.zeros((0, 2)), np.zeros((0, 3))).max() == 0
