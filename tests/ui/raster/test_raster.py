"""Every kernel covers what counting samples says it should, inside the clip only, whatever it is given."""

import itertools
import math

import numpy as np
import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.ui import raster
from game.ui.raster import (
    BUTT,
    ROUND,
    WARM_UPS,
    clip_of,
    fill_arrow,
    fill_box,
    fill_disc,
    fill_discs,
    fill_particle_streaks,
    fill_particles,
    fill_polygon,
    fill_shadow,
    fill_under,
    packed,
    pixels_of,
    scratch_for,
    straighten,
    stroke_arc,
    stroke_box,
    stroke_dashes,
    stroke_polyline,
    stroke_ring,
    stroke_segment,
    stroke_segments,
)
from game.ui.raster.discs import disc_stamps
from game.ui.raster.pixels import blend, fill_row
from game.ui.raster.vectors import blend_four_plainly
from tests.ui.raster.paper import Paper, in_polygon, sampled, segment_distance

INK = 0xFFFFFF
near = st.floats(-5.0, 45.0)


def worst(drawn, truth):
    return float(np.abs(drawn - truth).max())


@given(near, near, st.floats(0.6, 25.0))
@settings(max_examples=40, deadline=None)
def test_disc(x, y, radius):
    paper = Paper()
    fill_disc(paper.pixels, paper.clip, x, y, radius, INK, 1.0)
    truth = sampled(lambda u, v: np.hypot(u - x, v - y) <= radius)
    assert worst(paper.coverage, truth) < 0.13
    assert abs(paper.coverage.sum() - truth.sum()) < 0.02 * truth.sum() + 0.6


@given(near, near, st.one_of(st.floats(0.05, 25.0), st.sampled_from((0.5, 1.0, 7.5))), st.floats(0.05, 1.0))
@settings(max_examples=60, deadline=None)
def test_a_disc_row_by_row_is_that_pixel_by_pixel(x, y, radius, alpha):
    paper, plain = Paper(clip=(3, 2, 37, 28)), Paper(clip=(3, 2, 37, 28))
    fill_disc(paper.pixels, paper.clip, x, y, radius, 0x4080C0, alpha)
    share = alpha * min(1.0, 4.0 * radius * radius)
    reach = max(radius, 0.5) + 0.5
    for row in range(2, 28):
        for column in range(3, 37):
            dx, dy = column + 0.5 - x, row + 0.5 - y
            squared = dx * dx + dy * dy
            if squared < reach * reach:
                covered = 1.0 if squared <= (reach - 1.0) ** 2 else reach - math.sqrt(squared)
                weight = int(min(max(covered * share, 0.0), 1.0) * 256.0 + 0.5)
                blend(plain.pixels, row, column, 0x4080C0, weight)
    assert (paper.pixels == plain.pixels).all()


@given(near, near, st.floats(3.0, 25.0), st.floats(0.8, 4.0))
@settings(max_examples=40, deadline=None)
def test_ring(x, y, radius, width):
    paper = Paper()
    stroke_ring(paper.pixels, paper.clip, x, y, radius, width, INK, 1.0)
    truth = sampled(lambda u, v: np.abs(np.hypot(u - x, v - y) - radius) <= 0.5 * width)
    assert worst(paper.coverage, truth) < 0.22
    assert abs(paper.coverage.sum() - truth.sum()) < 0.03 * truth.sum() + 0.6


@given(st.floats(-7.0, 7.0), st.one_of(st.floats(-6.3, 6.3), st.floats(5.8, 6.29)))  # ends meet above 5.98
@settings(max_examples=80, deadline=None)
def test_arc_with_round_ends(start, sweep):
    paper = Paper()
    x, y, radius, width = 20.3, 14.8, 10.0, 3.0
    stroke_arc(paper.pixels, paper.clip, x, y, radius, width, start, sweep, INK, 1.0)

    def inside(u, v):
        turned = np.mod(math.copysign(1.0, sweep) * (np.arctan2(v - y, u - x) - start), 2.0 * math.pi)
        away = np.where(turned <= abs(sweep), np.abs(np.hypot(u - x, v - y) - radius), np.inf)
        for t in (start, start + sweep):
            end = np.hypot(u - x - radius * math.cos(t), v - y - radius * math.sin(t))
            away = np.minimum(away, end)
        return away <= 0.5 * width

    assert worst(paper.coverage, sampled(inside)) < 0.25


@given(near, near, near, near, st.floats(0.8, 9.0))
@settings(max_examples=60, deadline=None)
def test_round_segment(x0, y0, x1, y1, width):
    paper = Paper()
    stroke_segment(paper.pixels, paper.clip, x0, y0, x1, y1, width, ROUND, INK, 1.0)
    truth = sampled(lambda u, v: segment_distance(u, v, x0, y0, x1, y1) <= 0.5 * width)
    assert worst(paper.coverage, truth) < 0.22


def test_straight_lines_are_exact():
    for y, expected in ((10.5, {10: 1.0}), (10.0, {9: 0.5, 10: 0.5}), (10.25, {9: 0.25, 10: 0.75})):
        paper = Paper()
        stroke_segment(paper.pixels, paper.clip, 3.0, y, 30.0, y, 1.0, BUTT, INK, 1.0)
        middle = paper.coverage[:, 15]
        assert {i: c for i, c in enumerate(middle) if c > 0} == pytest.approx(expected, abs=0.005)
        row = paper.coverage[10] / paper.coverage[10].max()
        assert row[2] == row[30] == 0.0
        assert row[3] == row[29] == 1.0


def test_a_thin_line_fades_and_does_not_break():
    paper = Paper()
    stroke_segment(paper.pixels, paper.clip, 2.0, 10.5, 30.0, 10.5, 0.25, BUTT, INK, 1.0)
    assert paper.coverage[10, 5:25] == pytest.approx(0.25, abs=0.005)


@given(st.lists(st.tuples(near, near), min_size=2, max_size=7), st.booleans(), st.floats(0.1, 1.0))
@settings(max_examples=50, deadline=None)
def test_a_chain_is_blended_once(points, closed, alpha):
    paper = Paper()
    chain = np.array(points)
    stroke_polyline(paper.pixels, paper.clip, paper.scratch.cover, chain, 4.0, closed, INK, alpha)
    ends = (
        itertools.pairwise(points + points[:1]) if closed and len(points) > 2 else itertools.pairwise(points)
    )
    truth = np.zeros((30, 40))
    for (x0, y0), (x1, y1) in ends:
        one = Paper()
        stroke_segment(one.pixels, one.clip, x0, y0, x1, y1, 4.0, ROUND, INK, 1.0)
        truth = np.maximum(truth, one.coverage)
    assert worst(paper.coverage, truth * alpha) < 0.012
    assert paper.is_clean()


def test_broken_points_break_the_chain():
    paper = Paper()
    chain = np.array(((2.0, 5.5), (10.0, 5.5), (math.nan, 5.5), (20.0, 5.5), (30.0, 5.5)))
    stroke_polyline(paper.pixels, paper.clip, paper.scratch.cover, chain, 1.0, False, INK, 1.0)
    row = paper.coverage[5]
    assert row[5] == row[25] == 1.0
    assert row[12:18].max() == 0.0


@given(st.floats(-30.0, 30.0), st.floats(2.0, 8.0), st.floats(1.0, 8.0))
@settings(max_examples=40, deadline=None)
def test_dashes_follow_the_pattern_round_a_corner(offset, dash, gap):
    paper = Paper()
    chain = np.array(((2.0, 5.0), (30.0, 5.0), (30.0, 25.0)))
    stroke_dashes(
        paper.pixels, paper.clip, paper.scratch.cover, chain, 2.0, False, dash, gap, offset, INK, 1.0
    )
    fine = np.arange(0, 28, 1 / 64)
    on = ((fine + 1 / 128 + offset) % (dash + gap)) < dash
    truth = on.reshape(28, 64).mean(axis=1)
    assert np.abs(paper.coverage[4, 2:29] - truth[:27]).max() < 0.06
    fine = np.arange(28, 48, 1 / 64)
    on = ((fine + 1 / 128 + offset) % (dash + gap)) < dash
    truth = on.reshape(20, 64).mean(axis=1)
    assert np.abs(paper.coverage[6:25, 30] - truth[1:20]).max() < 0.06
    assert paper.is_clean()


def test_dashes_without_gap_are_a_line_and_finest_dashes_a_paler_one():
    line, solid, fine = Paper(), Paper(), Paper()
    chain = np.array(((2.0, 5.5), (30.0, 20.0)))
    stroke_polyline(line.pixels, line.clip, line.scratch.cover, chain, 2.0, False, INK, 1.0)
    for paper, dash, gap in ((solid, 4.0, 0.0), (fine, 0.1, 0.1)):
        stroke_dashes(
            paper.pixels, paper.clip, paper.scratch.cover, chain, 2.0, False, dash, gap, 0.0, INK, 1.0
        )
    assert (line.pixels == solid.pixels).all()
    assert worst(fine.coverage, 0.5 * line.coverage) < 0.01


@given(st.lists(st.tuples(near, near), min_size=3, max_size=3))
@settings(max_examples=60, deadline=None)
def test_triangle_is_exact(points):
    paper = Paper()
    corners = np.array(points)
    fill_polygon(paper.pixels, paper.clip, paper.scratch.area, paper.scratch.extent, corners, INK, 1.0)
    assert worst(paper.coverage, sampled(in_polygon(corners))) < 0.1  # of which the samples' error is most
    assert paper.is_clean()


def test_polygon_area_is_exact_inside_and_cut_by_the_clip():
    rng = np.random.default_rng(5)
    angle = np.linspace(0, 2 * math.pi, 23)[:-1]
    for _ in range(10):
        radius = rng.uniform(4, 13, 22)
        star = np.stack([20 + radius * np.cos(angle), 15 + radius * np.sin(angle)], axis=1)
        x, y = star.T
        area = 0.5 * abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))
        paper = Paper()
        fill_polygon(paper.pixels, paper.clip, paper.scratch.area, paper.scratch.extent, star, INK, 1.0)
        assert paper.coverage.sum() == pytest.approx(area, abs=0.5)
        cut = Paper(clip=(17, 9, 26, 20))
        fill_polygon(cut.pixels, cut.clip, cut.scratch.area, cut.scratch.extent, star, INK, 1.0)
        assert (cut.pixels[9:20, 17:26] == paper.pixels[9:20, 17:26]).all()
        assert cut.untouched_outside()
        assert cut.is_clean()


def test_concave_polygon_and_both_orientations():
    corners = np.array(((3.0, 3.0), (35.0, 4.0), (30.0, 25.0), (20.0, 10.0), (6.0, 26.0)))
    there, back = Paper(), Paper()
    fill_polygon(there.pixels, there.clip, there.scratch.area, there.scratch.extent, corners, INK, 1.0)
    fill_polygon(
        back.pixels, back.clip, back.scratch.area, back.scratch.extent, corners[::-1].copy(), INK, 1.0
    )
    assert worst(there.coverage, sampled(in_polygon(corners))) < 0.06
    assert worst(there.coverage, back.coverage) < 0.005


def test_arrow_points_where_it_should():
    paper = Paper()
    fill_arrow(
        paper.pixels,
        paper.clip,
        paper.scratch.area,
        paper.scratch.extent,
        5.0,
        15.0,
        30.0,
        15.0,
        3.0,
        INK,
        1.0,
    )
    head, half = 30.0 - 3.2 * 3.0, 1.6 * 3.0
    shape = [(5, 13.5), (head, 13.5), (head, 15 - half), (30, 15), (head, 15 + half), (head, 16.5), (5, 16.5)]
    assert worst(paper.coverage, sampled(in_polygon(np.array(shape)))) < 0.06
    assert paper.is_clean()


@given(near, near, st.floats(0.3, 40.0), st.floats(0.3, 40.0), st.floats(0.0, 12.0))
@settings(max_examples=60, deadline=None)
def test_box(x, y, width, height, radius):
    paper = Paper()
    fill_box(paper.pixels, paper.clip, x, y, x + width, y + height, radius, INK, 1.0)
    r = min(radius, 0.5 * width, 0.5 * height)

    def inside(u, v):
        qx = np.maximum(np.abs(u - x - 0.5 * width) - 0.5 * width + r, 0)
        qy = np.maximum(np.abs(v - y - 0.5 * height) - 0.5 * height + r, 0)
        in_corner = (qx > 0) & (qy > 0)
        within = (u >= x) & (u < x + width) & (v >= y) & (v < y + height)
        return within & (~in_corner | (np.hypot(qx, qy) <= r))

    truth = sampled(inside)
    assert worst(paper.coverage, truth) < (0.2 if r < 2.0 else 0.15)
    # sampling is off by up to half a sample along each side
    assert abs(paper.coverage.sum() - truth.sum()) < 0.02 * truth.sum() + 0.6 + (width + height) / 12


def test_outline_lies_inside_the_box():
    paper = Paper()
    stroke_box(paper.pixels, paper.clip, 4.0, 3.0, 36.0, 27.0, 0.0, 2.0, INK, 1.0)
    truth = np.zeros((30, 40))
    truth[3:27, 4:36] = 1.0
    truth[5:25, 6:34] = 0.0
    assert (paper.coverage == truth).all()
    curved, outer, inner = Paper(), Paper(), Paper()
    stroke_box(curved.pixels, curved.clip, 4.0, 3.0, 36.0, 27.0, 8.0, 2.0, INK, 1.0)
    fill_box(outer.pixels, outer.clip, 4.0, 3.0, 36.0, 27.0, 8.0, INK, 1.0)
    fill_box(inner.pixels, inner.clip, 6.0, 5.0, 34.0, 25.0, 6.0, INK, 1.0)
    assert worst(curved.coverage, outer.coverage - inner.coverage) < 0.01


def test_shadow_is_half_on_the_edge_and_falls_monotonically():
    paper = Paper(60, 60)
    fill_shadow(paper.pixels, paper.clip, 20.0, 20.0, 40.0, 60.0, 0.0, 8.0, INK, 1.0)
    row = paper.coverage[45, :31]
    assert (np.diff(row) >= 0).all()
    assert 0.4 < row[19] < row[20] < 0.6
    assert row[11] == 0.0


def test_ground_under_a_curve_fades_to_the_base():
    paper = Paper()
    curve = np.array(((5.0, 8.0), (20.0, 8.0), (35.0, 18.0)))
    fill_under(paper.pixels, paper.clip, curve, 28.0, 8.0, INK, 1.0)
    column = paper.coverage[:, 10]
    assert column[:8].max() == 0.0
    assert (np.diff(column[8:28]) < 0).all()
    assert column[28:].max() == 0.0
    assert paper.coverage[12, 34] == 0.0
    assert paper.coverage[:, 4].max() == 0.0


@given(st.floats(0.2, 3.5), st.floats(8.0, 30.0), st.floats(8.0, 20.0), st.floats(0.1, 1.0))
@settings(max_examples=40, deadline=None)
def test_particles_are_the_same_discs_to_an_eighth_of_a_pixel(radius, x, y, alpha):
    many, one = Paper(), Paper()
    fill_particles(many.pixels, many.clip, np.array(((x, y),)), np.array([INK], np.uint32), radius, alpha)
    step = 1.0 / 8.0
    x, y = ((math.floor((v + 0.5) / step) + 0.5) * step - 0.5 for v in (x, y))
    fill_disc(one.pixels, one.clip, x, y, round(radius, 2), INK, alpha)
    assert worst(many.coverage, one.coverage) < 0.012


@pytest.mark.parametrize("radius", [1.15, 2.0, 3.2])
def test_particles_are_cut_by_the_clip_pixel_by_pixel(radius):
    rng = np.random.default_rng(2)
    points = rng.uniform((-6, -6), (46, 36), (300, 2))
    points[:3] = ((math.nan, 5), (1e300, 5), (-math.inf, math.inf))
    colors = rng.integers(0, 1 << 24, 300).astype(np.uint32)
    whole, cut = Paper(), Paper(clip=(7, 4, 23, 19))
    for paper in (whole, cut):
        fill_particles(paper.pixels, paper.clip, points, colors, radius, 0.8)
    assert cut.untouched_outside()
    assert (cut.pixels[4:19, 7:23] == whole.pixels[4:19, 7:23]).all()


def test_a_streak_fades_backwards():
    paper = Paper()
    point, trail, color = np.array(((30.0, 15.5),)), np.array(((1000.0, 0.0),)), np.array([INK], np.uint32)
    fill_particle_streaks(paper.pixels, paper.clip, point, trail, color, 1.15, 0.020, 1.0)
    dots = [paper.coverage[15, column] for column in (30, 25, 20, 15, 10)]
    assert all(a > b > 0 for a, b in itertools.pairwise(dots))
    assert paper.coverage[15, :8].max() == 0.0
    assert paper.coverage[15, 33:].max() == 0.0


def test_four_pixels_at_once_are_as_four_pixels_alone():
    rng = np.random.default_rng(3)
    weights, rows, side = disc_stamps(1.15, (0.7,))
    assert (rows, side) == (4, 4)
    points = rng.uniform(5, 25, (200, 2))
    colors = rng.integers(0, 1 << 24, 200).astype(np.uint32)
    paper, twin = Paper(), Paper()
    fill_particles(paper.pixels, paper.clip, points, colors, 1.15, 0.7)
    flat = twin.pixels.reshape(-1)
    for (x, y), color in zip(points, colors, strict=True):
        i, j = math.floor(x - 1.5), math.floor(y - 1.5)
        first = (int((y - 1.5 - j) * 8) * 8 + int((x - 1.5 - i) * 8)) * 64
        for row in range(4):
            blend_four_plainly(flat, (j + row) * 40 + i, weights, first + 16 * row, int(color) | 0xFF000000)
    assert (paper.pixels == twin.pixels).all()


@pytest.mark.parametrize("shape", [(1, 3), (2, 7), (30, 45)])
@pytest.mark.parametrize("alpha", [1.0, 0.4])
def test_a_disc_is_what_each_pixel_alone_would_get(shape, alpha):
    """Each pixel of the clip by how far its middle lies from the edge, to the bit; the picture's last too."""
    rng = np.random.default_rng(8)
    pixels = rng.integers(0, 1 << 32, shape).astype(np.uint32)
    twin, low, high = pixels.copy(), 1 if shape[1] > 3 else 0, shape[1]
    clip = np.array([low, 0, high, shape[0]])
    for radius in (0.5, 1.0, 2.6, 7.0, 8.4, 19.0):
        for _ in range(8):
            x, y = rng.uniform(-4.0, shape[1] + 4.0), rng.uniform(-4.0, shape[0] + 4.0)
            color = int(rng.integers(0, 1 << 24))
            fill_disc(pixels, clip, x, y, radius, color, alpha)
            for row in range(shape[0]):
                for column in range(low, high):
                    dx, dy = column + 0.5 - x, row + 0.5 - y
                    covered = min(max(radius + 0.5 - math.sqrt(dx * dx + dy * dy), 0.0), 1.0)
                    blend(twin, row, column, color, int(covered * alpha * 256.0 + 0.5))
            assert (pixels == twin).all(), (radius, x, y)


@given(st.integers(0, 0xFFFFFF), st.integers(0, 0xFFFFFFFF), st.integers(0, 256))
@settings(max_examples=200, deadline=None)
def test_blending_rounds_each_channel(color, below, weight):
    pixels = np.array([[below]], np.uint32)
    blend(pixels, 0, 0, color, weight)
    over = color | 0xFF000000
    for shift in (0, 8, 16, 24):
        a, b = (over >> shift) & 255, (below >> shift) & 255
        assert (int(pixels[0, 0]) >> shift) & 255 == (a * weight + b * (256 - weight) + 128) >> 8


@given(
    st.integers(0, 0xFFFFFF), st.integers(0, 256), st.integers(0, 20), st.integers(0, 20), st.integers(0, 99)
)
@settings(max_examples=100, deadline=None)
def test_a_piece_of_a_row_is_its_pixels_one_by_one(color, weight, start, length, seed):
    row = np.random.default_rng(seed).integers(0, 1 << 32, (3, 41)).astype(np.uint32)
    twin = row.copy()
    fill_row(row, 1, start, start + length, color, weight)
    for column in range(start, start + length):
        blend(twin, 1, column, color, weight)
    assert (row == twin).all()


@given(points=st.lists(st.tuples(st.floats(-30, 70), st.floats(-10, 50)), min_size=3, max_size=9))
@settings(max_examples=100, deadline=None)
def test_a_polygon_keeps_its_share_between_its_edges(points):
    """Against the same polygon in strips one column wide, in which there is nothing between edges."""
    paper, twin = Paper(), Paper()
    corners = np.array(points)
    _cover, area, extent = scratch_for(paper.pixels)
    fill_polygon(paper.pixels, paper.clip, area, extent, corners, 0xFFFFFF, 0.7)
    for column in range(paper.clip[0], paper.clip[2]):
        strip = np.array((column, paper.clip[1], column + 1, paper.clip[3]), np.int64)
        fill_polygon(twin.pixels, strip, area, extent, corners, 0xFFFFFF, 0.7)
    unlike = paper.pixels.view(np.uint8).astype(int) - twin.pixels.view(np.uint8).astype(int)
    assert np.abs(unlike).max() <= 1  # float32 sums
    assert not area.any()


def test_many_discs_and_lines_are_single_ones_in_turn():
    rng = np.random.default_rng(4)
    points, radii = rng.uniform(0, 35, (20, 2)), rng.uniform(0.2, 6, 20)
    colors = rng.integers(0, 1 << 24, 20).astype(np.uint32)
    segments = rng.uniform(0, 35, (20, 4))
    many, single = Paper(), Paper()
    fill_discs(many.pixels, many.clip, points, radii, colors, 0.6)
    stroke_segments(many.pixels, many.clip, segments, 1.5, BUTT, colors, 0.6)
    for (x, y), radius, color in zip(points, radii, colors, strict=True):
        fill_disc(single.pixels, single.clip, x, y, radius, int(color), 0.6)
    for (x0, y0, x1, y1), color in zip(segments, colors, strict=True):
        stroke_segment(single.pixels, single.clip, x0, y0, x1, y1, 1.5, BUTT, int(color), 0.6)
    assert (many.pixels == single.pixels).all()


def draw_everything(paper, v):
    """Each kernel once with the numbers v (8 floats)."""
    pixels, clip, (cover, area, extent) = paper.pixels, paper.clip, paper.scratch
    a, b, c, d, e, f, g, h = v
    points = np.array(((a, b), (c, d), (e, f), (g, h)))
    colors, radii = np.full(4, INK, np.uint32), np.array((a, b, c, d))
    fill_disc(pixels, clip, a, b, c, INK, d)
    stroke_ring(pixels, clip, a, b, c, d, INK, e)
    stroke_arc(pixels, clip, a, b, c, d, e, f, INK, g)
    fill_discs(pixels, clip, points, radii, colors, e)
    fill_particles(pixels, clip, points, colors, 1.15, 0.5)
    fill_particle_streaks(pixels, clip, points, points[::-1].copy(), colors, 1.15, e, 0.5)
    stroke_segment(pixels, clip, a, b, c, d, e, ROUND, INK, f)
    stroke_segment(pixels, clip, a, b, c, d, e, BUTT, INK, f)
    stroke_segments(pixels, clip, points.reshape(2, 4), e, ROUND, colors, f)
    stroke_polyline(pixels, clip, cover, points, e, True, INK, f)
    stroke_dashes(pixels, clip, cover, points, 1.0, True, e, f, g, INK, h)
    stroke_dashes(pixels, clip, cover, points, e, False, 5.0, 4.0, g, INK, h)
    fill_polygon(pixels, clip, area, extent, points, INK, 0.5)
    fill_arrow(pixels, clip, area, extent, a, b, c, d, e, INK, f)
    fill_under(pixels, clip, points, e, f, INK, g)
    fill_box(pixels, clip, a, b, c, d, e, INK, f)
    stroke_box(pixels, clip, a, b, c, d, e, f, INK, g)
    fill_shadow(pixels, clip, a, b, c, d, e, f, INK, g)


odd = st.one_of(
    st.floats(allow_nan=True, allow_infinity=True),
    st.floats(-50.0, 90.0),
    st.sampled_from([0.0, -0.0, 1.0, 20.0, 1e9, -1e9, 1.1e9, 5e-324, 1e-200, math.nan, math.inf, -math.inf]),
)


@given(st.lists(odd, min_size=8, max_size=8), st.sampled_from([(1, 1), (40, 30)]), st.booleans())
@settings(max_examples=150, deadline=None)
def test_nothing_breaks_a_kernel(values, size, clipped):
    clip = (-3, 5, 12, 900) if clipped else None
    first, second = Paper(*size, clip=clip), Paper(*size, clip=clip)
    for paper in (first, second):
        with np.errstate(all="ignore"):  # uncompiled, numpy's scalars warn of inf * 0; compiled code does not
            draw_everything(paper, values)
        assert paper.untouched_outside()
        assert paper.is_clean()
    assert (first.pixels == second.pixels).all()


def test_empty_arrays_and_empty_clips_draw_nothing():
    nothing, none = np.zeros((0, 2)), np.zeros(0, np.uint32)
    paper = Paper(clip=(10, 10, 10, 10))
    draw_everything(paper, (5.0, 6.0, 20.0, 25.0, 3.0, 1.0, 12.0, 1.0))
    assert (paper.pixels == 0xFF000000).all()
    paper = Paper()
    cover, area, extent = paper.scratch
    fill_discs(paper.pixels, paper.clip, nothing, np.zeros(0), none, 1.0)
    fill_particles(paper.pixels, paper.clip, nothing, none, 1.0, 1.0)
    stroke_polyline(paper.pixels, paper.clip, cover, nothing, 1.0, True, INK, 1.0)
    stroke_dashes(paper.pixels, paper.clip, cover, nothing, 1.0, True, 2.0, 2.0, 0.0, INK, 1.0)
    fill_polygon(paper.pixels, paper.clip, area, extent, nothing, INK, 1.0)
    fill_under(paper.pixels, paper.clip, nothing, 20.0, 5.0, INK, 1.0)
    assert (paper.pixels == 0xFF000000).all()


def test_far_lines_cross_the_picture_where_they_should():
    far, short = Paper(), Paper()
    stroke_segment(far.pixels, far.clip, -9e8, 15.5, 9e8, 15.5, 2.0, BUTT, INK, 1.0)
    stroke_segment(short.pixels, short.clip, -50.0, 15.5, 90.0, 15.5, 2.0, BUTT, INK, 1.0)
    assert (far.pixels == short.pixels).all()


def test_pixels_are_the_surfaces_own_and_do_not_lock_it():
    surface = pygame.Surface((31, 17), 0, 32)
    pixels = pixels_of(surface)
    assert pixels.shape == (17, 31)
    pixels[3, 5] = 0xFF102030
    assert surface.get_at((5, 3))[:3] == (0x10, 0x20, 0x30)
    assert not surface.get_locked()
    surface.blit(surface, (1, 0))
    assert pixels[3, 6] & 0xFFFFFF == 0x102030


def test_a_subsurface_is_a_clip_of_its_parent():
    surface = pygame.Surface((40, 30), 0, 32)
    part = surface.subsurface((10, 5, 20, 15)).subsurface((2, 3, 10, 4))
    assert clip_of(part).tolist() == [12, 8, 22, 12]
    fill_box(pixels_of(part), clip_of(part), 0.0, 0.0, 40.0, 30.0, 0.0, INK, 1.0)
    white = pygame.surfarray.array3d(surface)[:, :, 0] == 255
    assert white[12:22, 8:12].all()
    assert white.sum() == 40
    surface.set_clip((35, 25, 100, 100))
    assert clip_of(surface).tolist() == [35, 25, 40, 30]


def test_other_formats_are_refused():
    for surface in (pygame.Surface((4, 4), 0, 24), pygame.Surface((4, 4), 0, 8)):
        with pytest.raises(ValueError, match="not 32 bit RGB"):
            pixels_of(surface)


def test_transparent_pictures_are_straightened():
    surface = pygame.Surface((40, 30), pygame.SRCALPHA, 32)
    color = pygame.Color("#5FBAF9")
    fill_disc(pixels_of(surface), clip_of(surface), 20.0, 15.0, 9.3, packed(color), 0.8)
    straighten(surface)
    ground = pygame.Surface((40, 30), 0, 32)
    ground.fill("#202020")
    direct = ground.copy()
    ground.blit(surface, (0, 0))
    fill_disc(pixels_of(direct), clip_of(direct), 20.0, 15.0, 9.3, packed(color), 0.8)
    apart = pygame.surfarray.array3d(ground).astype(int) - pygame.surfarray.array3d(direct)
    assert np.abs(apart).max() <= 3


def test_scratch_grows_and_is_shared(monkeypatch):
    small = scratch_for(np.zeros((4, 5), np.uint32))
    large = scratch_for(np.zeros((2000, 7), np.uint32))
    assert large.cover.shape[0] >= 2000
    assert large.cover.shape[1] >= small.cover.shape[1]
    assert scratch_for(np.zeros((3, 3), np.uint32)) is large


def test_warm_ups_name_every_public_kernel():
    named = {name for name, _ in WARM_UPS}
    kernels = {name for name in raster.__all__ if name.startswith(("fill_", "stroke_", "color_"))}
    kernels |= {"lights", "mirror_rows", "paint_veil"}  # of the verbs for light and smoke
    assert named == kernels
    for _, call in WARM_UPS:
        call()
