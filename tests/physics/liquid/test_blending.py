"""Runs between recorded ones: ends to the last bit, discs by law, links, and what cannot be aligned."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.liquid.blending import Blend, align
from game.physics.liquid.distances import Run, area_of, lasting, run_of

CELL, NODES, R = 0.05, 61, 0.5


def disc(x: float, radius: float = R, y: float = 0.0, frames: int = 3) -> Run:
    places = (np.arange(NODES) - NODES // 2) * CELL
    distance = np.hypot(places[None, :] - x, places[:, None] - y) - radius
    fill = np.clip(0.5 - 0.5 * distance / CELL, 0.0, 1.0)
    return run_of(np.repeat(fill[None], frames, axis=0), (CELL, CELL, CELL))


def kept(blend: Blend, aligned: bool) -> float:
    one, other = (area_of(blend.at(1.0, ends), CELL) for ends in ((1.0, 0.0), (0.0, 1.0)))
    return 2.0 * area_of(blend.at(1.0, (0.5, 0.5), aligned), CELL) / (one + other)


def middle(distance: np.ndarray) -> np.ndarray:
    """Centre (y, x) of what is liquid, m."""
    return (np.argwhere(distance < 0.0).mean(axis=0) - NODES // 2) * CELL


def test_distances_are_those_of_a_ball_in_place_and_time():
    """Signed, within an eighth of a cell; a stack that is a ball knows distances through time."""
    axis = (np.arange(41) - 20) * CELL
    true = np.sqrt(axis[:, None, None] ** 2 + axis[None, :, None] ** 2 + axis[None, None, :] ** 2) - 0.6
    run = run_of(np.clip(0.5 - 0.5 * true / CELL, 0.0, 1.0), (CELL, CELL, CELL))
    assert np.abs(run.distance - true).max() < 0.125 * CELL
    outwards = (run.points - 20 * CELL) / 0.6
    assert np.sum(run.normals * outwards, axis=1).min() > 0.99
    assert area_of(run.distance[20], CELL) == pytest.approx(math.pi * 0.36, rel=0.01)


def test_weights_of_0_and_1_give_the_inputs_to_the_last_bit():
    runs = disc(-0.6, 0.4), disc(0.7, 0.5, 0.2), disc(0.0, 0.3, -0.5)
    blend = Blend(runs)
    for k, run in enumerate(runs):
        for frame in range(3):
            assert np.array_equal(blend.at(frame, np.eye(3)[k]), run.distance[frame])
    assert np.abs(blend.shifts[1:]).max() > 0.5, "something is moved in between"


@pytest.mark.parametrize(("apart", "law"), [(0.5, 0.9682458), (1.5, 0.6614378), (2.5, 0.0)])
def test_plain_mixing_loses_two_discs_by_law_and_the_aligned_one_keeps_them(apart, law):
    """Two distances of sum 0: an ellipse with both centres as foci, √(1 - (d / 2r)²) of the area."""
    blend = Blend((disc(-0.5 * apart * R), disc(0.5 * apart * R)))
    assert kept(blend, aligned=False) == pytest.approx(law, abs=0.01)
    assert kept(blend, aligned=True) == pytest.approx(1.0, abs=0.01)


def test_what_lies_between_is_between_in_place_and_size():
    """A quarter of the way; radii mix, not areas: 0.8448276 of the mean area at 1 : 2.5."""
    blend = Blend((disc(-0.8, 0.3, -0.4), disc(0.8, 0.5, 0.4)))
    found = blend.at(1.0, (0.75, 0.25))
    assert middle(found) == pytest.approx([-0.2, -0.4], abs=CELL)
    assert area_of(found, CELL) == pytest.approx(math.pi * 0.35**2, rel=0.05)
    assert kept(Blend((disc(0.0, 0.3), disc(0.0, 0.75))), aligned=True) == pytest.approx(0.8448276, abs=0.01)


def test_features_are_carried_through_time():
    """A disc that is there late and one that is there early: between them, it is there in the middle."""

    def seen(frame: int) -> Run:
        fill = np.zeros((21, NODES, NODES))
        fill[frame - 3 : frame + 4] = np.where(disc(0.0).distance[0] < 0.0, 1.0, 0.0)
        return run_of(fill, (CELL, CELL, CELL))

    blend = Blend((seen(5), seen(15)))
    areas = [area_of(blend.at(frame, (0.5, 0.5)), CELL) for frame in range(21)]
    assert max(areas) < 1.01 * areas[10] > 0.8 * math.pi * R * R and areas[4] == areas[16] == 0.0
    assert max(area_of(blend.at(frame, (0.5, 0.5), False), CELL) for frame in range(21)) == 0.0


def test_a_link_of_the_hand_decides_between_two_alike():
    """One disc left in the first run, two in the other: it goes to the one that it is linked with."""
    both = np.minimum(disc(-0.8, 0.3).distance, disc(0.8, 0.3).distance)
    other = run_of(np.clip(0.5 - 0.5 * both / CELL, 0.0, 1.0), (CELL, CELL, CELL))
    first, origin = disc(-0.1, 0.3), CELL * (NODES // 2)
    for goal in (-0.8, 0.8):
        link = [[CELL, origin, origin - 0.1, CELL, origin, origin + goal]]
        shift = align(first, other, np.array(link)).shift
        assert np.mean(shift[1, 7:9, 7, 2]) == pytest.approx(goal + 0.1, abs=0.2)


def test_runs_of_unlike_length_and_empty_ones_are_stated():
    short, long, none = (
        disc(0.0, frames=2),
        disc(0.2, frames=4),
        run_of(np.zeros((3, NODES, NODES)), (CELL,) * 3),
    )
    blend = Blend((short, long))
    assert "not equally long" in blend.warning and blend.frames == 4
    assert np.array_equal(blend.at(3.0, (1.0, 0.0)), short.distance[-1])
    assert lasting(long, 2) is long
    blend = Blend((disc(0.0), none))
    assert "no surface" in blend.warning and none.empty and np.isfinite(blend.at(1.0, (0.5, 0.5))).all()
    assert area_of(blend.at(1.0, (0.5, 0.5)), CELL) == 0.0 and not Blend((disc(0.0), disc(0.1))).warning


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: run_of(np.full((2, 2, 2), math.nan), (1.0, 1.0, 1.0)), "finite"),
        (lambda: run_of(np.zeros((2, 2)), (1.0, 1.0, 1.0)), "frames, rows"),
        (lambda: run_of(np.zeros((2, 2, 2)), (1.0, 0.0, 1.0)), "above 0"),
        (lambda: Blend((disc(0.0),)), "at least two"),
        (lambda: Blend((disc(0.0), disc(0.1))).at(0.0, (0.7, 0.7)), "sum 1"),
        (lambda: align(disc(0.0), run_of(np.zeros((2, 4, 4)), (1.0, 1.0, 1.0))), "same nodes"),
    ],
)
def test_nonsense_is_refused(call, words):
    with pytest.raises(ValueError, match=words):
        call()
