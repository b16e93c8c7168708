"""The table's geometry: rails, jaws and pockets fit together."""

import math

import numpy as np
import pytest

from game.billiards.table.rack import BALL_RADIUS
from game.billiards.table.table import (
    BED_LENGTH,
    BED_WIDTH,
    CUSHION_DEPTH,
    POCKET_NAMES,
    Table,
    checked_table,
)


def test_pool_table_has_six_noses_twelve_facings_twelve_jaws_six_pockets():
    table = Table.pool()
    assert table.cushions.shape == (18, 6)
    assert table.jaws.shape == (12, 3)
    assert table.pockets.shape == (6, 3) and len(POCKET_NAMES) == 6
    assert (table.width, table.length) == (1.27, 2.54)


def test_every_jaw_is_tangent_to_its_nose_and_its_facing():
    table = Table.pool()
    for x, y, radius in table.jaws:
        touching = 0
        for x0, y0, x1, y1, nx, ny in table.cushions:
            for px, py in ((x0, y0), (x1, y1)):
                # tangent: the end lies on the disc, and the radius to it is the cushion's normal
                if abs(px - x - radius * nx) < 1e-14 and abs(py - y - radius * ny) < 1e-14:
                    touching += 1
        assert touching == 2


@pytest.mark.parametrize("axis", [0, 1])
def test_pool_table_is_exactly_mirror_symmetric(axis):
    table = Table.pool()
    extent = (table.width, table.length)[axis]
    for rows in (table.jaws, table.pockets):
        image = rows.copy()
        image[:, axis] = extent - image[:, axis]
        assert np.allclose(_sorted(image), _sorted(rows), rtol=0.0, atol=4.5e-16)


def _sorted(rows):
    return rows[np.lexsort(np.round(rows, 9).T[::-1])]


def test_facings_end_inside_a_capture_circle_so_that_no_ball_can_slip_behind_them():
    table = Table.pool()
    for row in table.cushions[6:]:
        start, end, normal = row[:2], row[2:4], row[4:]
        for s in np.linspace(0.6, 1.0, 9):
            centre = start + s * (end - start) + BALL_RADIUS * normal
            assert (np.hypot(*(table.pockets[:, :2] - centre).T) < table.pockets[:, 2]).any()
        outside = max(-end[0], end[0] - BED_WIDTH, -end[1], end[1] - BED_LENGTH)
        assert math.isclose(outside, CUSHION_DEPTH, rel_tol=1e-12)


def test_a_ball_passes_each_mouth_and_one_frozen_to_a_rail_is_not_taken_by_the_side_pocket():
    table = Table.pool()
    for x, y, radius in table.pockets[[2, 3]]:
        frozen = BALL_RADIUS if x < 0.0 else table.width - BALL_RADIUS
        assert abs(frozen - x) > radius
        nearest = np.sort(np.hypot(table.jaws[:, 0] - x, table.jaws[:, 1] - y) - table.jaws[:, 2])[:2]
        assert nearest.sum() > 4.0 * BALL_RADIUS


def test_bare_table_has_four_full_rails():
    table = Table.bare(1.0, 2.0)
    assert table.cushions.shape == (4, 6) and table.jaws.size == 0 and table.pockets.size == 0
    assert np.array_equal(
        np.sort(np.hypot(*(table.cushions[:, 2:4] - table.cushions[:, :2]).T)), [1, 1, 2, 2]
    )
    middle = 0.5 * (table.cushions[:, :2] + table.cushions[:, 2:4])
    assert (((np.array([0.5, 1.0]) - middle) * table.cushions[:, 4:]).sum(axis=1) > 0.0).all()


def test_arrays_are_frozen():
    with pytest.raises(ValueError, match="read-only"):
        Table.pool().pockets[0, 0] = 1.0


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_absurd_measures_are_refused(value):
    with pytest.raises(ValueError, match="table width"):
        Table.bare(value, 1.0)
    with pytest.raises(ValueError, match="table length"):
        Table.bare(1.0, value)


@pytest.mark.parametrize(
    ("rail", "reason"),
    [
        ([0, 0, 0, 0, 1, 0], "same point"),
        ([0, 0, 0, 1, 2, 0], "length 1"),
        ([0, 0, 0, 1, 0, 1], "right angles"),
        ([0, 0, 0, math.nan, 1, 0], "finite"),
    ],
)
def test_broken_cushions_are_named(rail, reason):
    with pytest.raises(ValueError, match=reason):
        checked_table(1.0, 1.0, 0.0, np.array([rail], float), np.empty((0, 3)), np.empty((0, 3)))


def test_broken_discs_are_named():
    with pytest.raises(ValueError, match=r"pockets\[0\]: radius"):
        checked_table(1.0, 1.0, 0.0, np.empty((0, 6)), np.empty((0, 3)), np.array([[0.0, 0.0, 0.0]]))
    with pytest.raises(ValueError, match="3 numbers a row"):
        checked_table(1.0, 1.0, 0.0, np.empty((0, 6)), np.ones((1, 4)), np.empty((0, 3)))


def test_facings_stand_at_the_angles_of_the_rules():
    """WPA 9: 142 degrees between nose and facing at a corner pocket, 104 at a side pocket."""
    noses, facings = Table.pool().cushions[:6], Table.pool().cushions[6:]
    angles = []
    for facing in facings:
        ends = facing[:4].reshape(2, 2)
        bed = np.array([0.5 * BED_WIDTH, 0.5 * BED_LENGTH])
        inner = ends[np.argmin(np.abs((ends - bed) / bed).max(axis=1))]
        outwards = ends.sum(axis=0) - 2.0 * inner
        gaps = [np.linalg.norm(nose[:4].reshape(2, 2) - inner, axis=1) for nose in noses]
        nose = noses[int(np.argmin([gap.min() for gap in gaps]))]
        near, far = (nose[:4].reshape(2, 2)[k] for k in np.argsort(min(gaps, key=lambda gap: gap.min())))
        along = far - near
        cosine = outwards @ along / np.linalg.norm(outwards) / np.linalg.norm(along)
        angles.append(round(math.degrees(math.acos(cosine)), 6))
    assert sorted(angles) == [104.0] * 4 + [142.0] * 8
