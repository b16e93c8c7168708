"""Canvas: shapes land where the camera says, in their colours; absurd input draws and raises nothing."""

from __future__ import annotations

import math

import numpy as np
import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.grid import round_spacing
from game.ui.look.look import Look
from game.ui.look.theme import DARK

WILD = st.one_of(
    st.floats(-3.0, 3.0), st.sampled_from([math.nan, math.inf, -math.inf, 1e300, -1e300, 1e12, 0.0, 5e-324])
)


WIDE = Frame(-2.0, -1.0, 2.0, 1.0)


def begun(size=(200, 100), frame=WIDE, rect=None, **turns):
    surface = pygame.Surface(size, 0, 32)
    canvas, camera = Canvas(Look(DARK)), Camera(**turns)
    rect = pygame.Rect(0, 0, *size) if rect is None else rect
    camera.fit(frame, rect, 0.0)
    canvas.begin(surface, rect, camera)
    canvas.fill()
    return canvas


def at(canvas, x, y):
    px, py = canvas.camera.to_screen(x, y)
    return canvas.surface.get_at((math.floor(px), math.floor(py)))


def test_a_disc_is_where_the_camera_says():
    canvas = begun()
    canvas.circle((1.0, 0.5), 0.2, fill="amber")
    assert at(canvas, 1.0, 0.5)[:3] == DARK.amber.mark[:3]
    assert at(canvas, -1.0, 0.5)[:3] == DARK.stage[:3]
    assert at(canvas, 1.0, -0.5)[:3] == DARK.stage[:3]


@pytest.mark.parametrize("turns", range(4))
@pytest.mark.parametrize("y_up", [True, False])
def test_every_shape_follows_turns_and_the_sense_of_y(turns, y_up):
    canvas = begun((120, 120), Frame(-1.0, -1.0, 1.0, 1.0), y_up=y_up, quarter_turns=turns)
    canvas.polygon([(0.2, 0.3), (0.8, 0.3), (0.8, 0.9), (0.2, 0.9)], fill="green")
    canvas.arrow((-0.9, -0.8), (0.0, 1.2), "chalk", width=8.0)
    canvas.arc((0.0, 0.0), 0.6, -0.3, -1.2, "pink", width=6.0)
    assert at(canvas, 0.5, 0.6)[:3] == DARK.green.mark[:3]
    assert at(canvas, -0.9, -0.3)[:3] == DARK.chalk.mark[:3]
    middle = (0.6 * math.cos(-0.75), 0.6 * math.sin(-0.75))
    assert at(canvas, *middle)[:3] == DARK.pink.mark[:3]
    assert at(canvas, middle[0], -middle[1])[:3] != DARK.pink.mark[:3]


def test_later_shapes_lie_on_earlier_ones_text_too():
    canvas = begun()
    canvas.label((0.0, 0.0), "IIII", "text1", size=40, halo=False)
    canvas.circle((0.0, 0.0), 0.9, fill="violet")
    assert at(canvas, 0.0, 0.0)[:3] == DARK.violet.mark[:3]


def test_a_group_of_labels_has_room_where_it_is_asked_for_or_beside_what_stands_there():
    """Where nothing stands, the offset that was asked for; where a label does, one that is clear of it."""
    canvas = begun((400, 200))
    assert canvas.room_for((0.2, 0.1), (60.0, 20.0), (25.0, -12.0)) == pytest.approx((25.0, -12.0), abs=1.0)
    canvas.label((0.2, 0.1), "words", offset=(25.0, -12.0))
    x, y = canvas.room_for((0.2, 0.1), (60.0, 20.0), (25.0, -12.0))
    assert abs(x - 25.0) >= 30.0 or abs(y + 12.0) >= 10.0


def test_nothing_is_drawn_outside_its_part():
    surface = pygame.Surface((200, 100), 0, 32)
    surface.fill("#010203")
    rect = pygame.Rect(50, 20, 60, 40)
    canvas, camera = Canvas(Look(DARK)), Camera()
    camera.fit(Frame(-1, -1, 1, 1), rect, 0.0)
    canvas.begin(surface, rect, camera)
    canvas.fill()
    canvas.grid(labels="xy")
    canvas.ground(0.5)
    canvas.circle((0, 0), 50.0, fill="amber", outline="chalk", dash=(3, 3))
    canvas.line((-99, 0), (99, 0), width=9)
    canvas.label((1.0, 1.0), "a long label that does not fit")
    canvas.end()
    outside = surface.copy()
    outside.fill("#010203", rect)
    assert pygame.transform.average_color(outside)[:3] == (1, 2, 3)
    assert surface.get_clip() == surface.get_rect()


def test_a_subsurface_takes_the_same_picture():
    whole, other = pygame.Surface((300, 200), 0, 32), pygame.Surface((100, 100), 0, 32)
    for surface in (whole.subsurface((150, 50, 100, 100)), other):
        canvas, camera = Canvas(Look(DARK)), Camera()
        camera.fit(Frame(-1, -1, 1, 1), surface.get_rect(), 0.0)
        canvas.begin(surface, surface.get_rect(), camera)
        canvas.fill()
        canvas.body((0.1, 0.2), 0.5, 1.0)
        canvas.arrow((0, 0), (0.5, 0.5), label="v_1")
        canvas.discs([(0.5, -0.5)], [0.2], "pink")
        canvas.label((0, -0.5), "words")
        canvas.end()
    part = whole.subsurface((150, 50, 100, 100))
    assert pygame.image.tobytes(part, "RGB") == pygame.image.tobytes(other, "RGB")


@settings(max_examples=60, deadline=None)
@given(a=WILD, b=WILD, c=WILD, d=WILD)
def test_absurd_numbers_draw_nothing_and_raise_nothing(a, b, c, d):
    canvas = begun((40, 30), rect=pygame.Rect(8, 6, 20, 15))
    canvas.line((a, b), (c, d))
    canvas.line((a, b), (c, d), dash=(4, 4))
    canvas.polyline([(a, b), (c, d), (0.0, 0.0)], dash=(5, 3), closed=True)
    canvas.polygon([(a, b), (c, d), (0.0, 1.0)], fill="body", outline="text1")
    canvas.circle((a, b), c, fill="body", outline="text1")
    canvas.circle((a, b), abs(c), outline="text1", dash=(3, 3))
    canvas.arc((a, b), c, d, a)
    canvas.arrow((a, b), (c, d), label="F")
    canvas.body((a, b), c, d)
    canvas.ghost((a, b), c, d)
    canvas.dot((a, b))
    canvas.ring((a, b))
    canvas.handle((a, b))
    canvas.contact((a, b), chosen=True)
    canvas.label((a, b), "x", offset=(c, d))
    canvas.formula((a, b), "x^2")
    canvas.discs([(a, b), (c, d)], abs(c))
    canvas.discs([(a, b)], [d])
    canvas.streaks([(a, b)], [(c, d)])
    canvas.particles([(a, b)])
    canvas.segments([(a, b)], [(c, d)])
    canvas.ground(a)
    canvas.grid(b)
    canvas.end()
    canvas.surface.fill(0, (8, 6, 20, 15))
    assert not pygame.surfarray.array3d(canvas.surface).any()  # nothing outside its part


@pytest.mark.parametrize("size", [(1, 1), (3, 700), (700, 3)])
def test_tiny_parts(size):
    canvas = begun(size)
    canvas.grid(labels="xy")
    canvas.body((0, 0), 0.5, 0.1)
    canvas.arrow((0, 0), (1, 1), label="v")
    canvas.end()
    assert len(np.unique(pygame.surfarray.array2d(canvas.surface))) > 1 or size == (1, 1)


def test_no_points_at_all():
    canvas = begun()
    for call in (canvas.polyline, canvas.polygon, canvas.particles):
        call(np.empty((0, 2)))
    canvas.discs([], 0.1)
    canvas.segments([], [])
    canvas.streaks([], [])
    with pytest.raises(ValueError, match="points"):
        canvas.polyline(np.zeros((3, 3)))


def test_colours_by_name_and_by_hand():
    canvas = begun()
    assert canvas.ink("amber") == 0xFB9F17
    canvas.circle((0, 0), 0.3, fill=pygame.Color("#102030"))
    assert at(canvas, 0, 0)[:3] == (0x10, 0x20, 0x30)
    with pytest.raises(ValueError, match="expected one of bg, stage"):
        canvas.dot((0, 0), color="beige")


def test_many_discs_keep_their_own_colours():
    canvas = begun()
    inks = np.array([canvas.ink("amber"), canvas.ink("green")], np.uint32)
    canvas.discs([(-1.0, 0.0), (1.0, 0.0)], 0.3, inks)
    assert at(canvas, -1.0, 0.0)[:3] == DARK.amber.mark[:3]
    assert at(canvas, 1.0, 0.0)[:3] == DARK.green.mark[:3]


def test_the_same_calls_make_the_same_picture():
    pictures = []
    for _ in range(2):
        canvas = begun()
        canvas.grid(labels="xy")
        rng = np.random.default_rng(5)
        points, velocities = rng.uniform(-2, 2, (500, 2)), rng.normal(0, 3, (500, 2))
        canvas.streaks(points, velocities, canvas.speed_colors(velocities, 9.0))
        canvas.end()
        pictures.append(pygame.image.tobytes(canvas.surface, "RGB"))
    assert pictures[0] == pictures[1]


@given(st.floats(1e-12, 1e12))
def test_grid_spacing_is_round_and_just_large_enough(least):
    spacing = round_spacing(least)
    assert least * (1 - 1e-6) <= spacing <= 2.5 * least * (1 + 1e-6)
    mantissa = spacing / 10 ** math.floor(math.log10(spacing) + 1e-9)
    assert min(abs(mantissa - m) for m in (1.0, 2.0, 5.0, 10.0)) < 1e-6


@pytest.mark.parametrize("labels", ["x", "y"])
def test_numbers_of_the_grid_keep_clear_of_what_covers_the_edges(monkeypatch, labels):
    canvas = begun((600, 400), Frame(-3.0, -2.0, 3.0, 2.0))
    canvas.insets = left, top, right, bottom = 50, 40, 60, 30
    drawn = []
    monkeypatch.setattr(type(canvas.fonts), "draw", lambda self, onto, text, at, *rest: drawn.append(text))
    canvas.grid(0.1, labels)
    k, places = canvas.k, {}
    for number in range(-30, 31):
        x, y = canvas.camera.to_screen(0.1 * number, 0.1 * number)
        clear = (
            left + 24 * k < int(x) < 600 - right - 64 * k if labels == "x"
            else top + 24 * k < int(y) < 400 - bottom - 8 * k
        )  # fmt: skip
        places[number] = clear
    assert [round(10.0 * float(text.split()[0].replace("\N{MINUS SIGN}", "-"))) for text in drawn] == [
        number for number, clear in places.items() if clear
    ]
    assert 5 < len(drawn) < 55


def test_what_is_drawn_within_a_box_stays_in_it():
    canvas = begun()
    with canvas.within((-0.5, -0.5), (0.5, 0.2)):
        canvas.circle((0.0, 0.0), 0.9, fill="amber")
    amber = canvas.look.color("amber")
    painted = pygame.mask.from_threshold(canvas.surface, amber, (1, 1, 1, 255))
    (x0, y0), (x1, y1) = canvas.camera.to_screen(-0.5, 0.2), canvas.camera.to_screen(0.5, -0.5)
    assert painted.get_bounding_rects() == [pygame.Rect(round(x0), round(y0), round(x1 - x0), round(y1 - y0))]
    canvas.circle((1.5, 0.0), 0.2, fill="amber")
    assert at(canvas, 1.5, 0.0) == amber
