"""The painter of very many boxes: whole pixels, shares of pixels, clipping, what is absurd."""

from __future__ import annotations

import numpy as np
import pytest

from game.ui.painters import boxes as painter
from game.ui.painters.boxes import (
    HIDDEN,
    MOST_LAYERS,
    VERY_MANY,
    Between,
    BoxPainter,
    BoxStyles,
    Corners,
    paint_boxes,
    shades,
)

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
    now, then = (
        Corners(np.ascontiguousarray(a[:, :2]), np.ascontiguousarray(a[:, 2:])) for a in (corners, before)
    )
    kinds = np.zeros(len(corners), dtype=np.uint8) if kinds is None else np.array(kinds, dtype=np.uint8)
    clip = np.array(clip or (0, 0, width, height), dtype=np.int64)
    styles = BoxStyles(INKS, weights, 1)
    paint_boxes(pixels, clip, affine, now, then, Between(share, leap), kinds, styles)
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


def test_a_box_is_painted_between_its_places_unless_it_has_leapt():
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


class Sheet:
    """As much of a canvas as the painter asks for; a unit is a pixel."""

    k = 1.0

    def __init__(self):
        self.pixels = np.zeros((60, 80), dtype=np.uint32)
        self.raster_target = self.pixels, np.array((0, 0, 80, 60), dtype=np.int64)

    def ink(self, color):
        return int(color, 16)

    def place(self, point):
        return point


def painted_in_layers(lowers, uppers, kinds):
    sheet = Sheet()
    styles = (("3060c0", 0.34, "ff8000", 1.0), ("40c060", 0.4, "ffffff", 1.0))
    BoxPainter(styles).paint(sheet, lowers, uppers, kinds)
    return (sheet.pixels[..., None] >> np.array([16, 8, 0])).astype(np.int64) & 255


def test_fills_that_lie_under_very_many_others_are_left_out_unseen(monkeypatch):
    random = np.random.default_rng(1)
    lowers = random.random((400, 2)) * (30.0, 20.0)
    uppers = lowers + np.array((50.0, 40.0))
    kinds = random.integers(0, 2, 400).astype(np.uint8)
    kinds[::50] = HIDDEN
    given = kinds.copy()
    limited = painted_in_layers(lowers, uppers, kinds)
    assert (kinds == given).all()
    monkeypatch.setattr(painter, "MOST_LAYERS", 1e9)
    whole = painted_in_layers(lowers, uppers, kinds)
    assert np.abs(limited - whole)[20:40, 30:50].max() <= 1  # where all of them lie
    monkeypatch.setattr(painter, "MOST_LAYERS", 2)
    assert np.abs(painted_in_layers(lowers, uppers, kinds) - whole).max() > 20


def test_what_covers_the_picture_less_often_is_painted_whole(monkeypatch):
    boxes = np.tile([0.0, 0.0, 80.0, 60.0], (MOST_LAYERS, 1))
    boxes[3] = -np.inf, 0.0, np.inf, np.inf
    drawn = []
    monkeypatch.setattr(painter, "paint_boxes", lambda *given: drawn.append(given[6]))
    for count in (MOST_LAYERS, MOST_LAYERS - 1, 1, 0):
        given = boxes[:count]
        painted_in_layers(given[:, :2], given[:, 2:], np.zeros(count, dtype=np.uint8))
    assert [kinds.max(initial=0) for kinds in drawn] == [0, 0, 0, 0]


def test_shades_run_from_ground_to_colour():
    class Ink:
        @staticmethod
        def ink(token):
            return {"stage": 0x102030, "chalk": 0x304050}[token]

    values = np.array([[-1.0, 0.0, 0.5, 1.0, 7.0]])
    assert shades(Ink, values, "chalk").tolist() == [[0x102030, 0x102030, 0x203040, 0x304050, 0x304050]]
