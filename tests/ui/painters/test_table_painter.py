"""The table's picture: cushions from the rails, holes where pockets are, the same each time, at any size."""

import math

import numpy as np
import pygame
import pytest

from game.billiards.table.table import CUSHION_DEPTH, Table
from game.ui.look.theme import DARK, FELT_BLUE, LIGHT
from game.ui.painters.table import SURROUND, TablePainter, TableView, carom_dress, fit_table, table_picture
from game.ui.painters.table_shapes import cushion_shapes

POOL = Table.pool()


def area_of(outline):
    x, y = outline.T
    return 0.5 * abs(float(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))))


def picture(size=(640, 360), table=POOL, theme=DARK):
    view = fit_table(pygame.Rect(40, 28, size[0] - 80, size[1] - 56), table)
    return table_picture(size, table, view, theme), view


def test_the_view_is_seen_from_above():
    view = TableView(100.0, 50.0, 200.0)
    assert view.to_screen(0.0, 0.0) == (100.0, 50.0)
    right, down = view.to_screen(0.0, 1.0), view.to_screen(1.0, 0.0)
    assert right[0] > 100.0
    assert down[1] > 50.0
    # x down, y right: with z up towards the viewer that is a turn, not a mirror image
    x_axis, y_axis = np.array((0.0, -1.0)), np.array((1.0, 0.0))
    assert x_axis[0] * y_axis[1] - x_axis[1] * y_axis[0] > 0.0
    assert view.points(np.array(((0.3, 1.7),)))[0] == pytest.approx(view.to_screen(0.3, 1.7))


def test_the_bed_of_the_design_size():
    view = fit_table(pygame.Rect(80, 56, 1120, 608), POOL)
    assert (view.left, view.top) == (128.0, 104.0)
    assert view.scale * POOL.length == pytest.approx(1024.0)
    assert 0.028575 * view.scale == pytest.approx(11.5, abs=0.05)


@pytest.mark.parametrize("size", [(1, 1), (50, 400), (333, 222), (1920, 1080)])
def test_the_view_fits_where_it_can(size):
    area = pygame.Rect(7, 9, *size)
    view = fit_table(area, POOL)
    assert view.scale * POOL.length >= 15.999
    if min(size) > 60:
        reach = SURROUND * view.scale
        assert view.left - reach >= area.left - 1.0
        assert view.left + POOL.length * view.scale + reach <= area.right + 1.0


def test_cushions_of_a_pool_table():
    shapes = cushion_shapes(POOL, CUSHION_DEPTH)
    assert len(shapes) == 6
    areas = [area_of(shape.outline) for shape in shapes]
    assert areas[:4] == pytest.approx([areas[0]] * 4)
    assert areas[4] == pytest.approx(areas[5])
    noses = POOL.cushions[:6]
    for shape, row in zip(shapes, noses, strict=True):
        nose = math.dist(row[0:2], row[2:4])
        assert nose * CUSHION_DEPTH < area_of(shape.outline) < (nose + 0.15) * CUSHION_DEPTH
        assert area_of(shape.top) < area_of(shape.outline)
        behind = (row[0:2] - shape.outline) @ row[4:6]
        assert behind.min() == pytest.approx(0.0, abs=1e-12)
        assert behind.max() == pytest.approx(CUSHION_DEPTH)
        ends = np.sort((shape.back - row[0:2]) @ (row[2:4] - row[0:2]) / nose)
        assert ends[0] < 0.0
        assert ends[1] > nose


def test_outlines_follow_jaws_and_facings():
    outline = cushion_shapes(POOL, CUSHION_DEPTH)[0].outline
    jaw = next(
        j for j in POOL.jaws if math.dist(j[:2] + j[2] * np.array((1.0, 0.0)), POOL.cushions[0, :2]) < 1e-9
    )
    on_jaw = np.abs(np.hypot(*(outline - jaw[:2]).T) - jaw[2]) < 1e-9
    assert on_jaw.sum() >= 5
    facing = POOL.cushions[7]
    assert min(math.dist(p, facing[2:4]) for p in outline) < 1e-9


def test_cushions_of_a_bare_table_meet_in_mitres():
    table = Table.bare(1.0, 2.0)
    shapes = cushion_shapes(table, CUSHION_DEPTH)
    whole = (1.0 + 2 * CUSHION_DEPTH) * (2.0 + 2 * CUSHION_DEPTH) - 2.0
    assert sum(area_of(shape.outline) for shape in shapes) == pytest.approx(whole)
    assert cushion_shapes(Table.open(), CUSHION_DEPTH) == []


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=lambda t: t.name)
def test_holes_are_black_cloth_is_green_wood_is_brown(theme):
    surface, view = picture(theme=theme)
    for x, y, _ in POOL.pockets:
        assert max(surface.get_at([round(v) for v in view.to_screen(x, y)])[:3]) < 12
    red, green, blue, _ = surface.get_at([round(v) for v in view.to_screen(0.5, 1.0)])
    assert green > blue > 3 * red
    red, green, blue, _ = surface.get_at([round(v) for v in view.to_screen(-0.085, 0.45)])
    assert red > 1.3 * green > 1.3 * blue
    corner = tuple(surface.get_at((0, 0)))[:3]
    if theme is LIGHT:
        assert corner == tuple(theme.bg)[:3]
    else:
        assert corner[0] > corner[1] > corner[2]
        assert max(corner) < 64  # words stand on it


def test_the_floor_of_the_room_is_boards_in_the_light_of_the_lamp():
    """By the table it is bright, far off as dark as the window; along a board it changes less than across."""
    view = TableView(300.0, 60.0, 160.0)
    near, far = (
        pygame.surfarray.array3d(table_picture((1600, 320), POOL, view, DARK))[a:b].mean(axis=(0, 1))
        for a, b in ((750, 800), (1500, 1600))
    )
    assert near[0] > 2.0 * far[0]
    assert far == pytest.approx(tuple(DARK.bg)[:3], abs=12)
    floor = pygame.surfarray.array3d(table_picture((900, 900), POOL, TableView(880.0, 100.0, 320.0), DARK))
    floor = floor[100:500].astype(float).sum(axis=2)
    assert np.abs(np.diff(floor, axis=1)).mean() > 1.1 * np.abs(np.diff(floor, axis=0)).mean()


def test_a_table_among_others_stands_on_plain_ground():
    view = TableView(300.0, 60.0, 160.0)
    plain = pygame.surfarray.array3d(table_picture((1600, 320), POOL, view, DARK, room=False))
    assert plain[1500:, :, :].max(axis=2).std() < 2.0
    assert np.abs(plain.astype(int) - tuple(DARK.bg)[:3])[1500:].max() < 8


def test_light_lies_on_the_middle_of_the_cloth():
    surface, view = picture()
    middle, corner = (
        np.mean([surface.get_at([round(v) + d for v in view.to_screen(x, y)])[1] for d in range(6)])
        for x, y in ((0.5, 1.27), (1.17, 2.4))
    )
    assert middle > 1.1 * corner


def test_the_picture_is_the_same_each_time_and_symmetric_in_shape():
    first, second = (pygame.surfarray.array3d(picture()[0]) for _ in range(2))
    assert (first == second).all()
    surface, view = picture()
    dark = pygame.surfarray.array3d(surface).max(axis=2) < 12
    left, right = round(view.left), round(view.left + POOL.length * view.scale)
    top, bottom = round(view.top), round(view.top + POOL.width * view.scale)
    holes = dark[left:right, top:bottom]
    assert np.abs(holes.astype(int) - holes[::-1]).mean() < 0.002


@pytest.mark.parametrize("size", [(1, 1), (3, 200), (64, 40), (200, 120)])
@pytest.mark.parametrize("table", [POOL, Table.bare(1.0, 2.0), Table.open()], ids=["pool", "bare", "open"])
def test_any_size_of_any_table(size, table):
    view = fit_table(pygame.Rect(0, 0, *size), table)
    assert table_picture(size, table, view, DARK).get_size() == size


def test_the_painter_keeps_its_picture(monkeypatch):
    made = []
    monkeypatch.setattr(
        "game.ui.painters.table.table_picture",
        lambda size, *_: made.append(size) or pygame.Surface(size, 0, 32),
    )
    painter, surface, view = TablePainter(), pygame.Surface((90, 60), 0, 32), TableView(5.0, 5.0, 20.0)
    for theme in (DARK, DARK, LIGHT, LIGHT):
        painter.draw(surface, POOL, view, theme)
    painter.draw(surface, POOL, view._replace(left=6.0), LIGHT)
    assert len(made) == 3


def test_a_carom_table_is_blue_with_its_spots_and_no_line():
    table = Table.carom()
    spots = ((0.5, 0.25), (0.5, 0.5), (0.5, 0.75))
    size = (640, 360)
    view = fit_table(pygame.Rect(40, 28, 560, 304), table)
    dressed = table_picture(size, table, view, DARK, carom_dress(FELT_BLUE, spots))
    bare = table_picture(size, table, view, DARK, carom_dress(FELT_BLUE, ()))
    plain = table_picture(size, table, view, DARK)
    at = tuple(round(v) for v in view.to_screen(0.3, 1.0))
    assert dressed.get_at(at).b > dressed.get_at(at).g > dressed.get_at(at).r
    assert plain.get_at(at).g > plain.get_at(at).b
    for across, along in spots:
        x, y = view.to_screen(across * table.width, along * table.length)
        assert dressed.get_at((int(x), int(y))).b < bare.get_at((int(x), int(y))).b
    painter = TablePainter()
    surface = pygame.Surface(size, 0, 32)
    painter.draw(surface, table, view, DARK)
    painter.draw(surface, table, view, DARK, carom_dress(FELT_BLUE, spots))
    assert surface.get_at(at)[:3] == dressed.get_at(at)[:3]
