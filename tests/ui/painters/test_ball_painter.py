"""Balls: the kernel agrees with its numpy twin, markings sit where the turn puts them, nothing breaks it."""

import math

import numpy as np
import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.ui.look.theme import FELT
from game.ui.painters import ball_look
from game.ui.painters.ball import BallPainter, ScreenBalls, texture_stack
from game.ui.painters.ball_picture import ball_chip, ball_picture, plain_ball_picture, turned

FELT_PIXEL = 0xFF1E6E66


def canvas(width=60, height=50):
    return np.full((height, width), FELT_PIXEL, np.uint32), np.array((0, 0, width, height), np.int64)


def draw_one(pixels, clip, number, at, radius, turn, shadows=False, opacity=1.0, middle=(30.0, 25.0)):
    place, size, which = np.array((at,)), np.array((radius,)), np.array((number,), np.int64)
    ball = ScreenBalls(place, size, which, turn[None].copy(), np.array((opacity,)))
    BallPainter(FELT).draw(pixels, clip, ball, middle, 100.0, shadows)


def channels(pixels):
    return np.stack([(pixels >> shift) & 255 for shift in (16, 8, 0)], axis=-1).astype(int)


@pytest.mark.parametrize("number", [0, 3, 8, 9, 12, 16, 17, 18])
@pytest.mark.parametrize("radius", [4.0, 11.5, 22.0])
def test_the_kernel_agrees_with_its_twin(number, radius):
    turn = turned(0.5, -0.4, 0.9)
    pixels, clip = canvas()
    draw_one(pixels, clip, number, (30.0, 25.0), radius, turn)
    ground = pygame.Surface((60, 50), 0, 32)
    ground.fill(FELT)
    picture = ball_picture(number, radius, turn, FELT)
    ground.blit(picture, picture.get_rect(center=(30, 25)))
    twin = pygame.surfarray.array3d(ground).transpose(1, 0, 2).astype(int)
    assert np.abs(channels(pixels) - twin).max() <= 3


def test_nothing_changes_outside_the_ball():
    pixels, clip = canvas()
    draw_one(pixels, clip, 5, (30.3, 24.6), 9.7, np.eye(3))
    y, x = np.mgrid[0:50, 0:60] + 0.5
    outside = np.hypot(x - 30.3, y - 24.6) > 9.7 + 0.51
    assert (pixels[outside] == FELT_PIXEL).all()
    assert (pixels[~outside] != FELT_PIXEL).mean() > 0.95


def test_the_number_faces_the_viewer_and_turns_away():
    def white_share(turn):
        pixels, clip = canvas()
        draw_one(pixels, clip, 4, (30.0, 25.0), 20.0, turn)
        return float((channels(pixels).min(axis=-1) > 150).mean())

    front, back, side = (white_share(turned(0.0, a, 0.0)) for a in (0.0, math.pi, 0.5 * math.pi))
    assert front == pytest.approx(back, rel=0.1)
    assert front > 3.0 * side


def test_the_back_number_reads_as_the_front_one():
    front, back = canvas()[0], canvas()[0]
    clip = canvas()[1]
    draw_one(front, clip, 7, (30.0, 25.0), 20.0, np.eye(3))
    draw_one(back, clip, 7, (30.0, 25.0), 20.0, turned(0.0, math.pi, 0.0))
    assert np.abs(channels(front) - channels(back)).max() <= 2


@pytest.mark.parametrize(("axis", "shift"), [((0.0, 1.0, 0.0), (1, 0)), ((1.0, 0.0, 0.0), (0, 1))])
def test_markings_move_with_the_rolling(axis, shift):
    """Turned about the screen's y axis the number goes right; about its x axis it goes down."""
    pixels, clip = canvas()
    draw_one(pixels, clip, 1, (30.0, 25.0), 20.0, turned(*(0.5 * a for a in axis)))
    white = channels(pixels)[..., 2] > 180  # the disc; yellow resin has little blue
    y, x = np.argwhere(white).mean(axis=0)
    moved = np.array((x - 29.5, y - 24.5))
    assert float(moved @ shift) > 6.0
    assert abs(float(moved @ shift[::-1])) < 2.0


def test_a_stripe_leaves_two_white_caps():
    pixels, clip = canvas()
    draw_one(pixels, clip, 10, (30.0, 25.0), 20.0, turned(0.0, 0.5 * math.pi, 0.0))
    red = channels(pixels)[:, 30, 0]
    assert red[8] > 150
    assert red[40] > 100
    assert red[25] < 80


def test_the_cue_ball_has_six_spots():
    spots = 0
    for turn in (
        np.eye(3),
        turned(math.pi, 0, 0),
        *(turned(0, a, 0) for a in (0.5 * math.pi, -0.5 * math.pi)),
    ):
        pixels, clip = canvas()
        draw_one(pixels, clip, 0, (30.0, 25.0), 20.0, turn)
        spots += channels(pixels)[25, 30, 1] < 100
    for angle in (0.5 * math.pi, -0.5 * math.pi):
        pixels, clip = canvas()
        draw_one(pixels, clip, 0, (30.0, 25.0), 20.0, turned(angle, 0, 0))
        spots += channels(pixels)[25, 30, 1] < 100
    assert spots == 6


def test_the_lamp_lights_the_side_towards_it():
    pixels, clip = canvas()
    draw_one(pixels, clip, 8, (30.0, 25.0), 20.0, turned(0, 0.5 * math.pi, 0), middle=(30.0, -40.0))
    upper, lower = (channels(pixels)[rows].sum() for rows in (slice(8, 22), slice(28, 42)))
    assert upper > lower


def test_shadows_lie_under_all_balls_and_away_from_the_lamp():
    pixels, clip = canvas()
    places, turns = np.array(((20.0, 20.0), (20.0, 32.0))), np.stack([np.eye(3)] * 2)
    painter = BallPainter(FELT)
    balls = ScreenBalls(places, np.full(2, 6.0), np.array((3, 3)), turns)
    painter.draw(pixels, clip, balls, (30.0, 25.0), 100.0)
    alone, _ = canvas()
    draw_one(alone, clip, 3, (20.0, 20.0), 6.0, np.eye(3))
    ball = np.hypot(*(np.mgrid[0:50, 0:60] + 0.5 - np.array((20.0, 20.0))[:, None, None])) < 5.0
    assert (pixels[ball] == alone[ball]).all()
    pixels, _ = canvas()
    draw_one(pixels, clip, 3, (30.0, 25.0), 6.0, np.eye(3), shadows=True)
    dark = 0x6E - channels(pixels)[..., 1]
    assert dark[34, 30] > dark[15, 30] >= 0
    assert dark[34, 30] > 10


def test_digits_are_drawn_once_and_underlined_where_they_must_be():
    assert texture_stack(25) is texture_stack(25)
    assert texture_stack(25).shape == (16, 25, 25)
    assert not texture_stack(25)[0].any()
    for number in (6, 9):
        low = ball_look.digit_texture(number, 60)[45:]
        plain = ball_look.digit_texture(8, 60)[45:]
        assert low.astype(int).sum() > plain.astype(int).sum()
    six, nine = (ball_look.digit_texture(n, 60).astype(int) for n in (6, 9))
    assert np.abs(six - nine[::-1, ::-1]).mean() > 10


def test_no_ball_number_is_mistaken_at_the_size_of_the_table():
    side = ball_look.texture_side(11.5)
    digits = [ball_look.digit_texture(n, side).astype(float) for n in range(1, 16)]
    apart = [np.abs(a - b).mean() for i, a in enumerate(digits) for b in digits[i + 1 :]]
    assert min(apart) > 5.0


@given(st.floats(-20.0, 80.0), st.floats(-20.0, 70.0), st.floats(0.5, 30.0), st.integers(0, 15))
@settings(max_examples=40, deadline=None)
def test_clip_is_kept_and_pixels_are_the_same_inside(x, y, radius, number):
    whole, _ = canvas()
    cut, _ = canvas()
    clip = np.array((12, 9, 37, 31), np.int64)
    draw_one(whole, canvas()[1], number, (x, y), radius, turned(0.3, 0.2, 0.1), True)
    draw_one(cut, clip, number, (x, y), radius, turned(0.3, 0.2, 0.1), True)
    assert (cut[9:31, 12:37] == whole[9:31, 12:37]).all()
    cut[9:31, 12:37] = FELT_PIXEL
    assert (cut == FELT_PIXEL).all()


odd = st.one_of(st.floats(allow_nan=True, allow_infinity=True), st.floats(-10, 70))


@given(st.lists(odd, min_size=14, max_size=14), st.integers(-3, 20))
@settings(max_examples=100, deadline=None)
def test_nothing_breaks_the_kernel(values, number):
    first, clip = canvas(30, 20)
    second, _ = canvas(30, 20)
    turn = np.array(values[5:14]).reshape(3, 3)
    for pixels in (first, second):
        with np.errstate(all="ignore"):
            draw_one(pixels, clip, number, values[:2], values[2], turn, True, values[3], (values[4], 5.0))
    assert (first == second).all()


def test_arrays_that_do_not_fit_are_refused():
    pixels, clip = canvas()
    good = [np.zeros((2, 2)), np.ones(2), np.zeros(2, np.int64), np.zeros((2, 3, 3))]
    painter = BallPainter(FELT)
    painter.draw(pixels, clip, ScreenBalls(*good), (0.0, 0.0), 100.0)
    for i in range(1, 4):
        bad = list(good)
        bad[i] = bad[i][:1]
        with pytest.raises(ValueError, match="balls: "):
            painter.draw(pixels, clip, ScreenBalls(*bad), (0.0, 0.0), 100.0)
    for scale in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="scale"):
            painter.draw(pixels, clip, ScreenBalls(*good), (0.0, 0.0), scale)


def test_pictures_of_single_balls():
    with pytest.raises(ValueError, match="number 26"):
        ball_picture(26, 10.0, np.eye(3), FELT)
    for radius in (0.0, math.nan, 1e9):
        with pytest.raises(ValueError, match="radius"):
            ball_picture(3, radius, np.eye(3), FELT)
    assert ball_chip(3, 9.0, (23, 30, 36)) is ball_chip(3, 9.0, (23, 30, 36))
    spotted = pygame.surfarray.array3d(ball_picture(0, 20.0, np.eye(3), FELT)).astype(int)
    plain = pygame.surfarray.array3d(plain_ball_picture(20.0, FELT)).astype(int)
    assert plain[22, 22].min() > 200 > spotted[22, 22].min()


@given(st.floats(-4, 4), st.floats(-4, 4), st.floats(-4, 4))
def test_turns_are_rotations(x, y, z):
    turn = turned(x, y, z)
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    axis = np.array((x, y, z))
    assert turn @ axis == pytest.approx(axis, abs=1e-9)
