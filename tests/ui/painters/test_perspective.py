"""A table in perspective: pixels are where a pinhole camera puts them, and balls show how they are turned."""

from __future__ import annotations

import math

import numpy as np
import pygame
import pytest

from game.billiards.table.table import Table
from game.ui.look.theme import DARK
from game.ui.painters.perspective.eye import NEAREST, Eye, room_heading, room_points
from game.ui.painters.perspective.ground import paint_ground
from game.ui.painters.perspective.relief import SCALE, relief_of, sheet_size
from game.ui.painters.perspective.spheres import RoomBalls, paint_balls_seen
from game.ui.painters.perspective.stick import paint_stick
from game.ui.painters.table import TableView, table_picture
from game.ui.raster import clip_of, pixels_of

W, H = 320, 180
EYE = Eye(-0.5, -0.2, 0.6, 0.35, 0.5, 300.0, 0.5 * W, 0.5 * H)


def seen_by_hand(eye: Eye, point):
    """The pinhole formula with a look-at basis of cross products, independent of `Eye.seen`."""
    forward = np.array((
        math.cos(eye.tilt) * math.cos(eye.heading), math.cos(eye.tilt) * math.sin(eye.heading),
        -math.sin(eye.tilt),
    ))  # fmt: skip
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    away = np.asarray(point) - eye[:3]
    depth = away @ forward
    return (
        eye.middle_x + eye.focal * (away @ right) / depth, eye.middle_y - eye.focal * (away @ up) / depth,
        depth,
    )  # fmt: skip


@pytest.fixture
def target():
    surface = pygame.Surface((W, H), 0, 32)
    return surface, pixels_of(surface), clip_of(surface)


def flat_table(marks):
    """A relief of one grey table with coloured squares of 6 cm about points (x, y) m of the room."""
    table = Table.pool()
    columns, rows = sheet_size(table)
    picture = pygame.Surface((columns, rows), 0, 32)
    picture.fill((90, 90, 90))
    for (x, y), color in marks:
        side = round(0.06 * SCALE)
        at = pygame.Rect(0, 0, side, side)
        at.center = (round(0.5 * columns + x * SCALE), round(0.5 * rows - y * SCALE))
        picture.fill(color, at)
    return table, relief_of(picture, table, table.cushion_height)


@pytest.mark.parametrize("point", [(0.4, 0.1, 0.0), (-0.1, -0.4, 0.05), (1.2, 0.5, 0.3)])
def test_a_point_is_where_a_pinhole_camera_puts_it(point):
    assert EYE.seen(np.array((point,)))[0] == pytest.approx(seen_by_hand(EYE, point), abs=1e-9)


def test_a_chain_is_cut_where_it_goes_behind_the_eye():
    points = np.array(((0.5, 0.2, 0.0), (-1.5, -0.5, 0.0), (-1.6, -0.5, 0.0), (0.6, 0.1, 0.0)))
    assert [len(piece) for piece in EYE.chain(points)] == [2, 2]
    assert EYE.seen(points)[1, 2] < NEAREST


def test_the_rooms_frame_is_the_picture_from_above():
    table = Table.pool()
    place = room_points(np.array(((0.2, 2.0),)), 0.1, table.width, table.length)[0]
    assert place == pytest.approx((2.0 - 0.5 * table.length, 0.5 * table.width - 0.2, 0.1))
    ahead = room_points(np.array(((0.5, 0.5), (0.5, 0.6))), 0.0, table.width, table.length)
    assert room_heading(0.5 * math.pi) == pytest.approx(math.atan2(*(ahead[1] - ahead[0])[[1, 0]]))


def test_cloth_lies_where_its_points_are_seen(target):
    surface, pixels, clip = target
    marks = [((0.35, 0.25), (255, 0, 0)), ((0.3, -0.15), (0, 255, 0)), ((0.9, 0.05), (0, 0, 255))]
    _, relief = flat_table(marks)
    paint_ground(pixels, clip, EYE.numbers(), relief)
    for (x, y), color in marks:
        px, py = EYE.at(x, y, 0.0)
        assert surface.get_at((int(px), int(py)))[:3] == pytest.approx(color, abs=40)
    reds = np.argwhere((pixels & 0xFF0000) > 0xC00000)
    assert reds.mean(axis=0)[::-1] == pytest.approx(EYE.at(0.35, 0.25, 0.0), abs=1.5)


def test_rails_are_higher_than_the_cloth(target):
    """A mark on the far cushion's top is seen at that height, not at the cloth's."""
    _, pixels, clip = target
    table = Table.pool()
    x = 0.5 * table.length + 0.03
    _, relief = flat_table([((x, 0.25), (255, 0, 0))])
    eye = Eye(0.3, 0.25, 0.5, 0.0, 0.4, 300.0, 0.5 * W, 0.5 * H)
    paint_ground(pixels, clip, eye.numbers(), relief)
    reds = np.argwhere((pixels >> 16 & 255) > (pixels & 255) + 90)
    seen, low = eye.at(x + 0.03, 0.25, table.cushion_height), eye.at(x + 0.03, 0.25, 0.0)
    assert reds[:, 0].min() == pytest.approx(seen[1], abs=1.5)
    assert low[1] - seen[1] > 5.0


def test_a_cushion_hides_what_is_behind_its_face_and_a_pocket_is_open(target):
    surface, pixels, clip = target
    table = Table.pool()
    view = TableView(
        *(0.5 * (np.array(sheet_size(table)) - np.array((table.length, table.width)) * SCALE)), SCALE
    )
    relief = relief_of(table_picture(sheet_size(table), table, view, DARK), table, table.cushion_height)
    eye = Eye(0.0, 0.0, 0.5, 0.5 * math.pi, 0.55, 300.0, 0.5 * W, 0.5 * H)  # at a side pocket
    paint_ground(pixels, clip, eye.numbers(), relief)
    nose = 0.5 * table.width
    pocket = eye.at(0.0, nose + 0.03, 0.0)
    face = eye.at(0.3, nose, 0.4 * table.cushion_height)
    top = eye.at(0.3, nose + 0.03, table.cushion_height)
    bright = [sum(surface.get_at((int(x), int(y)))[:3]) for x, y in (pocket, face, top)]
    assert bright[0] < 60 < bright[1] < 0.8 * bright[2]


def balls_at(middle, number, turn):
    """One ball of a pool set."""
    return RoomBalls(
        np.array((middle,)), np.full(1, 0.0286), np.array((number,)), np.array((turn,)), np.ones(1)
    )


def test_a_ball_covers_the_ellipse_of_its_silhouette(target):
    """Against the cone that touches the sphere: its cut with the picture has the area of Eberly's ellipse."""
    _, pixels, clip = target
    middle = np.array((0.05, 0.12, 0.0286))
    paint_balls_seen(pixels, clip, EYE, balls_at(middle, 3, np.eye(3)), np.zeros(3))
    x, y, depth = seen_by_hand(EYE, middle)
    covered = np.argwhere((pixels & 0xFFFFFF) > 0)
    away = np.linalg.norm(middle - np.array(EYE[:3]))
    off = math.acos(depth / away)
    half = math.asin(0.0286 / away)
    spread = math.cos(off) ** 2 - math.sin(half) ** 2
    area = math.pi * EYE.focal**2 * math.sin(half) ** 2 * math.cos(half) / spread**1.5
    assert len(covered) == pytest.approx(area, rel=0.12)  # the rim's pixels count as whole ones
    assert covered.mean(axis=0)[::-1] + 0.5 == pytest.approx((x, y), abs=1.0)


def test_a_stripe_and_a_number_turn_with_the_ball(target):
    surface, pixels, clip = target
    eye = Eye(-0.4, 0.0, 0.0286, 0.0, 0.0, 900.0, 0.5 * W, 0.5 * H)  # level with the ball, looking along x
    towards = np.array(((0.0, 0.0, -1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)))  # its z axis points at the eye
    said = {}
    for name, turn in (("number", towards), ("top", np.eye(3))):
        surface.fill(0)
        paint_balls_seen(pixels, clip, eye, balls_at((0.0, 0.0, 0.0286), 2, turn), np.zeros(3))
        said[name] = surface.get_at((W // 2 - 30, H // 2))[:3]
    assert min(said["number"]) > 100  # the white disc about the 2
    assert said["top"][2] > 2.0 * said["top"][0]  # blue resin


def test_the_nearer_ball_covers_the_farther(target):
    surface, pixels, clip = target
    ahead = np.array((math.cos(EYE.heading), math.sin(EYE.heading), 0.0))
    base = np.array((EYE.x, EYE.y, 0.0286)) + ahead
    pair = RoomBalls(
        np.stack([base, base + 0.06 * ahead]),
        np.full(2, 0.0286),
        np.array((1, 3)),
        np.stack([np.eye(3)] * 2),
        np.ones(2),
    )
    for order in ([0, 1], [1, 0]):
        balls = RoomBalls(*(np.ascontiguousarray(part[order]) for part in pair))
        paint_balls_seen(pixels, clip, EYE, balls, np.zeros(3))
        x, y = EYE.at(base[0], base[1], base[2] + 0.01)
        red, green, _ = surface.get_at((int(x), int(y)))[:3]
        assert green > 0.6 * red  # yellow over red


def test_the_cue_ends_at_its_tip_and_before_the_eye(target):
    _, pixels, clip = target
    tip, rise = np.array((0.2, 0.05, 0.03)), 0.07
    heading = np.array((math.cos(EYE.heading), math.sin(EYE.heading)))
    along = np.array((*(-heading * math.cos(rise)), math.sin(rise)))
    paint_stick(pixels, clip, EYE, tip, along)
    rows = np.argwhere((pixels & 0xFFFFFF) > 0)[:, 0]
    assert abs(rows.min() - EYE.at(*tip)[1]) < 4.0
    assert rows.max() == H - 1  # it comes towards the eye, out of the picture


def test_equal_input_gives_equal_pixels(target):
    _, pixels, clip = target
    _, relief = flat_table([])
    pictures = []
    for _ in range(2):
        paint_ground(pixels, clip, EYE.numbers(), relief)
        pictures.append(pixels.copy())
    assert np.array_equal(*pictures)
