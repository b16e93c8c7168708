"""The painter of very many boxes: whole pixels, shares of pixels, clipping, what is absurd."""

from __future__ import annotations

import numpy as np
import pytest

from game.ui.painters.boxes import HIDDEN, VERY_MANY, paint_boxes, shades

IDENTITY = np.array([1.0, 0.0, 0.0, 1.0, 0.0, 0.0])
FILL, LINE = 0x102030, 0xFF8000
INKS = np.array([[FILL, LINE]], dtype=np.int64)
SOLID = np.array([[256, 256]], dtype=np.int64)


def paint(
    boxes, size=(40, 30), clip=None, kinds=None, old=None, share=1.0, leap=1.0, weights=SOLID, affine=IDENTITY
):
    width, height = size
    pixels = np.zeros((height, width), dtype=np.uint32)
    corners = np.array(boxes, dtype=np.float64).reshape(-1, 4)
    before = corners if old is None else np.array(old, dtype=np.float64).reshape(-1, 4)
    columns = [
        np.ascontiguousarray(a[:, part]) for a in (corners, before) for part in (slice(0, 2), slice(2, 4))
    ]
    kinds = np.zeros(len(corners), dtype=np.uint8) if kinds is None else np.array(kinds, dtype=np.uint8)
    clip = np.array(clip or (0, 0, width, height), dtype=np.int64)
    paint_boxes(pixels, clip, affine, *columns, share, leap, kinds, INKS, weights, 1)
    return pixels & 0xFFFFFF


def test_a_box_has_its_fill_and_a_crisp_outline_inside_its_rounded_corners():
    picture = paint([(5.2, 6.4, 14.6, 12.4)])
    rows, columns = np.nonzero(picture)
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (6, 11, 5, 14)
    inside = picture[7:11, 6:14]
    assert (inside == FILL).all()
    rim = picture[6:12, 5:15].copy()
    rim[1:-1, 1:-1] = LINE
    assert (rim == LINE).all()


def test_a_small_box_covers_pixels_by_their_share():
    picture = paint([(10.25, 10.0, 12.25, 12.0)])
    strength = (picture >> 16) / 255.0
    assert strength[10:12, 10:13] == pytest.approx(np.array([[0.75, 1.0, 0.25]] * 2), abs=0.01)
    assert np.count_nonzero(picture) == 6


def test_what_has_no_size_is_still_a_pixel():
    picture = paint([(10.5, 10.5, 10.5, 10.5)])
    assert picture[10, 10] == LINE and np.count_nonzero(picture) == 1


def test_nothing_is_painted_outside_the_clip_nor_of_a_hidden_box():
    whole, part = paint([(-50, -50, 90, 90)]), paint([(-50, -50, 90, 90)], clip=(8, 4, 20, 9))
    assert (whole == FILL).all()
    assert np.count_nonzero(part) == 12 * 5 and part[4:9, 8:20].all()
    assert not paint([(5, 5, 9, 9)], kinds=[HIDDEN]).any()


@pytest.mark.parametrize(
    "box",
    [
        (np.nan, 0, 1, 1),
        (0, np.nan, 10, 10),
        (-np.inf, 5, np.inf, 15),
        (-np.inf, -np.inf, np.inf, np.inf),
        (1e300, 1e300, 1e301, 1e301),
        (-1e300, 3, 1e300, 4),
        (500, 500, 600, 600),
    ],
)
def test_absurd_boxes_paint_their_part_or_nothing(box):
    picture = paint([box, (30, 20, 36, 26)])
    assert np.array_equal(paint([box, (30, 20, 36, 26)], share=0.5), picture)
    assert picture[22, 33] != 0
    if box[0] == -np.inf:
        assert picture[10, 20] == FILL


def test_a_box_is_painted_on_its_way_unless_it_has_leapt():
    middle = paint([(20, 10, 26, 16)], old=[(10, 10, 16, 16)], share=0.5, leap=20.0)
    assert np.nonzero(middle)[1].min() == 15
    leapt = paint([(20, 10, 26, 16)], old=[(10, 10, 16, 16)], share=0.5, leap=5.0)
    assert np.nonzero(leapt)[1].min() == 20


def test_the_view_may_turn_and_mirror():
    upside_down = paint([(5, 5, 15, 12)], affine=np.array([1.0, 0.0, 0.0, -1.0, 0.0, 30.0]))
    rows, columns = np.nonzero(upside_down)
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (18, 24, 5, 14)
    turned = paint([(5, 5, 15, 12)], affine=np.array([0.0, 1.0, 1.0, 0.0, 0.0, 0.0]))
    rows, columns = np.nonzero(turned)
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (5, 14, 5, 11)


def test_very_many_small_boxes_are_whole_pixels():
    count = VERY_MANY + 1
    boxes = np.tile([3.3, 3.3, 4.1, 4.1], (count, 1))
    boxes[0] = 20.2, 20.2, 20.9, 20.9
    picture = paint(boxes)
    assert np.argwhere(picture).tolist() == [[3, 3], [20, 20]]
    assert picture[20, 20] == LINE


def test_shades_run_from_ground_to_colour():
    class Ink:
        @staticmethod
        def ink(token):
            return {"stage": 0x102030, "chalk": 0x304050}[token]

    values = np.array([[-1.0, 0.0, 0.5, 1.0, 7.0]])
    assert shades(Ink, values, "chalk").tolist() == [[0x102030, 0x102030, 0x203040, 0x304050, 0x304050]]
