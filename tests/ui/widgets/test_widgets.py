"""Bar, hints, messages, tool tips, legend, loading card, shapes: places, commands, timing, any size."""

from __future__ import annotations

import math

import numpy as np
import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.ui.look import motion
from game.ui.look.layout import arrange
from game.ui.look.look import Look
from game.ui.look.motion import Fade
from game.ui.look.shapes import SurfaceStore, box, draw_box, draw_disc, draw_line, shadow
from game.ui.look.theme import DARK
from game.ui.widgets.hintbar import HintBar
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.legend import Legend, draw_mark
from game.ui.widgets.loading import LoadingCard, draw_shell, seconds_text
from game.ui.widgets.overlay import Overlay
from game.ui.widgets.toasts import Toasts
from game.ui.widgets.tooltips import ToolTip
from game.ui.widgets.topbar import BarState, TopBar, speed_text
from game.ui.widgets.wishes import Wish
from tests.ui.pointing import click, down, event, move, press, up

READOUTS = (("time", 12.48, "s"), ("particles", 12112.0, ""), ("step", 52e-6, "s"), ("frame", 0.0031, "s"))
STATE = BarState("C04", "Particle fountain", readouts=READOUTS)
SIZES = [(1, 1), (40, 40), (320, 240), (500, 400), (760, 480), (1280, 720), (1920, 1080)]


def picture(surface):
    return pygame.image.tobytes(surface, "RGB")


# -- shapes --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("radius", [3.0, 8.5, 40.0])
def test_a_disc_covers_its_area(radius):
    surface = pygame.Surface((100, 100), 0, 32)
    draw_disc(surface, (50.25, 49.5), radius, pygame.Color(255, 255, 255))
    covered = pygame.surfarray.array3d(surface)[:, :, 0].sum() / 255.0
    assert covered == pytest.approx(math.pi * radius**2, rel=0.01)


def test_a_box_covers_its_area_and_keeps_its_border_inside():
    surface = pygame.Surface((80, 60), 0, 32)
    draw_box(surface, pygame.Rect(10, 10, 50, 30), 9, pygame.Color(255, 255, 255), pygame.Color(0, 255, 0), 2)
    pixels = pygame.surfarray.array3d(surface)
    assert pixels[:, :, 1].sum() / 255.0 == pytest.approx(50 * 30 - (4 - math.pi) * 81, rel=0.01)
    assert tuple(pixels[10, 25]) == (0, 255, 0) and tuple(pixels[12, 25]) == (255, 255, 255)
    assert not pixels[:10].any() and not pixels[60:].any()


@given(
    st.floats(allow_nan=True, allow_infinity=True),
    st.floats(allow_nan=True),
    st.floats(-1, 50),
    st.floats(0, 5),
)
def test_shapes_at_absurd_places(x, y, radius, border):
    surface = pygame.Surface((20, 20), 0, 32)
    draw_disc(surface, (x, y), radius, DARK.panel, DARK.line, border)
    draw_box(surface, pygame.Rect(0, 0, 0, 5), radius, DARK.panel)
    if math.isfinite(x) and abs(x) < 1e5 and math.isfinite(y) and abs(y) < 1e5:
        draw_line(surface, DARK.line, (x, y), (1.0, 1.0), border)
    if not math.isfinite(x + y):
        assert not pygame.surfarray.array3d(surface).any()


def test_a_shadow_is_strongest_in_the_middle_and_gone_at_its_edge():
    alpha = pygame.surfarray.array_alpha(shadow((60, 40), 6.0, 0.5))
    assert alpha.shape == (60 + 36, 40 + 36)
    assert alpha[48, 38] == pytest.approx(0.5 * 255, abs=2)
    assert alpha[0, 0] == 0 and alpha[0, 38] <= 1


def test_kept_pictures_stay_within_the_budget():
    store = SurfaceStore(1000)
    for i in range(50):
        store.get(("a", i), lambda: pygame.Surface((10, 10)))
    assert len(store._kept) == 10
    first = store.get(("a", 45), lambda: pygame.Surface((1, 1)))
    assert first.get_size() == (10, 10)
    assert box((30, 20), 4, DARK.panel) is box((30, 20), 4, DARK.panel)


# -- hotspots and motion -------------------------------------------------------------------------------


def test_activation_is_a_press_and_a_release_over_one_place():
    spots = Hotspots()
    spots.place([Hotspot("a", pygame.Rect(0, 0, 10, 10)), Hotspot("b", pygame.Rect(20, 0, 10, 10), False)])
    assert click(spots, (5, 5)) == "a"
    spots.handle(down(5, 5))
    assert spots.handle(up(25, 5)) is None and spots.handle(up(5, 5)) is None
    assert click(spots, (25, 5)) is None  # not enabled
    spots.handle(down(5, 5))
    spots.handle(event(pygame.WINDOWFOCUSLOST))
    assert spots.handle(up(5, 5)) is None


def test_keyboard_focus_goes_round_the_enabled_places():
    spots = Hotspots()
    spots.place([Hotspot(name, pygame.Rect(i * 20, 0, 10, 10), name != "b") for i, name in enumerate("abc")])
    assert [spots.focus_next() for _ in range(3)] == ["a", "c", None]
    assert [spots.focus_next(True) for _ in range(3)] == ["c", "a", None]
    spots.focus_next()
    assert spots.handle(press(pygame.K_RETURN)) == "a"
    spots.place([Hotspot("c", pygame.Rect(0, 0, 1, 1))])
    assert spots.focused is None


def test_hover_takes_eighty_milliseconds_however_the_frames_fall(look):
    for steps in (1, 4, 16):
        spots = Hotspots()
        spots.place([Hotspot("a", pygame.Rect(0, 0, 10, 10))])
        spots.handle(move(5, 5))
        for _ in range(steps):
            spots.update(0.04 / steps, look)
        assert spots.hover("a") == pytest.approx(1 - 0.5**3, abs=1e-9)
        spots.update(0.05, look)
        assert spots.hover("a") == 1.0 and not spots.update(0.1, look)
    assert Look(DARK, less_motion=True).less_motion


def test_a_fade_without_duration_is_there_at_once():
    fade = Fade(0.0)
    assert fade.update(0.0, True) and fade.amount == 1.0 and fade.resting


# -- top bar -------------------------------------------------------------------------------------------


def bar_at(look, size, state=STATE):
    bar = TopBar(look)
    bar.place(arrange(*size, look.k).top_bar, look)
    bar.update(1.0, state)
    return bar


def test_every_button_gives_its_command(look):
    bar = bar_at(look, (1280, 720))
    found = {name: click(bar, bar.spots.find(name).rect.center) for name in (s.name for s in bar.spots.spots)}
    assert found["pause"] == Wish("pause") and found["menu"] == Wish("menu")
    assert found["slower"] == Wish("speed", -1) and found["faster"] == Wish("speed", 1)
    assert set(found) == {
        "menu", "reset", "step-back", "pause", "step", "slower", "speed", "faster", "panel", "help",
        "screenshot", "film", "tools",
    }  # fmt: skip
    assert bar.spots.find("pause").rect.center == (552, 24)


def test_transport_is_dead_while_loading(look):
    bar = bar_at(look, (1280, 720), STATE._replace(ready=False))
    assert click(bar, bar.spots.find("step").rect.center) is None
    assert click(bar, bar.spots.find("menu").rect.center) == Wish("menu")


@pytest.mark.parametrize("size", SIZES)
def test_buttons_never_overlap_and_stay_inside(any_look, size):
    bar = bar_at(any_look, size)
    surface = pygame.Surface(size, 0, 32)
    bar.draw(surface)
    if size[0] < 320 * any_look.k:
        return
    rects = [spot.rect for spot in bar.spots.spots if spot.name != "speed"]
    assert all(bar.rect.contains(rect) for rect in rects)
    assert all(rect.collidelist(rects[i + 1 :]) == -1 for i, rect in enumerate(rects))


def test_the_speed_that_is_reached_stands_in_amber_where_it_falls_short(look):
    """In the tray between the two buttons, and nowhere else."""
    bar = bar_at(look, (1280, 720))
    pictures = []
    for reached in (None, 1.5):
        surface = pygame.Surface((1280, 720), 0, 32)
        bar.update(0.3, STATE._replace(speed=4.0, reached=reached))
        bar.draw(surface)
        pictures.append(pygame.surfarray.array3d(surface).astype(int))
    tray = bar.spots.find("speed").rect.inflate(look.px(8), look.px(6))
    changed = np.abs(pictures[1] - pictures[0]).any(axis=2)
    assert changed.any()
    changed[tray.left : tray.right, tray.top : tray.bottom] = False
    assert not changed.any()
    inside = pictures[1][tray.left : tray.right, tray.top : tray.bottom]
    amber = np.array(look.color("amber")[:3])
    assert (np.abs(inside - amber).sum(axis=2) < 40).any()


def test_numbers_change_when_they_are_fresh_and_only_then_is_it_painted(look):
    bar = bar_at(look, (1280, 720))
    surface = pygame.Surface((1280, 720), 0, 32)
    bar.draw(surface)
    first = picture(surface)
    other = STATE._replace(readouts=(("time", 13.0, "s"), *READOUTS[1:]))
    bar.update(0.3, other, fresh=False)
    bar.draw(surface)
    assert picture(surface) == first
    bar.update(0.01, other, fresh=True)
    bar.draw(surface)
    assert picture(surface) != first


@pytest.mark.parametrize("width", [700, 960, 1100, 1280, 1920])
@pytest.mark.parametrize("value", [1.85e-11, -4.5e-13, 123456789.0, 3.0, math.nan])
def test_no_number_runs_into_its_neighbour(any_look, width, value):
    readouts = (("time", 2.05, "s"), ("off", value, "°"), ("L", value, "kg m²/s"), ("frame", 0.0, "s"))
    bar = bar_at(any_look, (width, 720), STATE._replace(readouts=readouts))
    faster, picture_button = bar.spots.find("faster"), bar.spots.find("tools") or bar.spots.find("screenshot")
    left_of_it = picture_button.rect.x if picture_button else 0
    for x, _, words in bar.columns():
        assert x < left_of_it
        left_of_it = x - any_look.fonts.size(words, 13, "semibold")[0]
        assert left_of_it > faster.rect.right


def test_no_caption_is_cut_and_none_runs_into_its_neighbour(any_look):
    """A readout whose name is longer than its number has the room of its name."""
    readouts = (("time", 2.05, "s"), ("time dominoes below the top", 3.0, "s"), *READOUTS[2:])
    bar = bar_at(any_look, (round(1280 * any_look.k), 720), STATE._replace(readouts=readouts))
    left_of_it = bar.spots.find("tools").rect.x
    columns = bar.columns()
    assert any(caption == "time dominoes below the top" for _, caption, _ in columns)
    for x, caption, _ in columns:
        assert x < left_of_it
        left_of_it = x - any_look.fonts.size(caption, 11, "medium")[0]
        assert left_of_it > bar.spots.find("faster").rect.right


def test_a_long_number_takes_room_from_the_left_and_the_first_readout_goes_if_there_is_none(look):
    usual = [(x, caption) for x, caption, _ in bar_at(look, (1280, 720)).columns()]
    assert [caption for _, caption in usual] == ["frame", "step", "particles", "time"]
    long = STATE._replace(readouts=(READOUTS[0], ("off", 1.85e-11, "°"), *READOUTS[2:]))
    wide = [(x, caption) for x, caption, _ in bar_at(look, (1280, 720), long).columns()]
    assert wide[:2] == usual[:2] and wide[2][0] == usual[2][0] and wide[3][0] < usual[3][0]
    narrow = next(w for w in range(1280, 640, -1) if len(bar_at(look, (w, 720)).columns()) < 4) + 1
    assert [caption for _, caption, _ in bar_at(look, (narrow, 720), long).columns()] == [
        "frame",
        "step",
        "off",
    ]


@pytest.mark.parametrize(
    ("speed", "text"),
    [(1.0, "1×"), (0.0625, "1/16×"), (4.0, "4×"), (0.3, "0.3×"), (math.nan, "–"), (0.0, "–")],
)
def test_speed_in_words(speed, text):
    assert speed_text(speed) == text


# -- hints, messages, tips -----------------------------------------------------------------------------


def test_hints_drop_from_the_right_and_fade(look):
    hints = HintBar(look)
    hints.place(pygame.Rect(0, 0, 300, 32), look)
    hints.show([((key,), f"do {key}") for key in "ABCDEFGH"])
    surface = pygame.Surface((300, 32), 0, 32)
    hints.draw(surface)
    assert 0 < hints.used_width <= 300 - 12
    full = picture(surface)
    hints.update(11.0)
    hints.draw(surface)
    assert picture(surface) == full
    hints.update(3.0)
    hints.draw(surface)
    faded = picture(surface)
    assert faded != full
    hints.wake()
    hints.draw(surface)
    assert picture(surface) == full


def test_a_message_comes_stays_and_goes(look):
    toasts, surface, row = Toasts(look), pygame.Surface((960, 120), 0, 32), pygame.Rect(0, 88, 960, 32)
    empty = picture(surface)
    toasts.add("Saved.", "Picture in the pictures folder.")
    toasts.add("Saved.", "Picture in the pictures folder.")
    toasts.update(0.2)
    toasts.draw(surface, row)
    assert picture(surface) != empty and toasts.shown.cause == "Saved."
    toasts.update(3.9)
    assert toasts.shown is not None
    toasts.update(0.5)
    assert toasts.shown is None


def test_a_message_grows_clear_stays_clear_and_fades(look):
    """How much of it is seen, frame by frame: up, then all of it for its time, then down."""
    toasts, ground = Toasts(look), pygame.Rect(0, 88, 960, 32)
    toasts.add("Saved.", "Picture in the pictures folder.")
    seen = []
    while toasts.shown is not None:
        surface = pygame.Surface((960, 120), 0, 32)
        toasts.draw(surface, ground)
        seen.append(int(pygame.surfarray.array3d(surface).astype(np.int64).sum()))
        toasts.update(1.0 / 60.0)
    most = max(seen)
    clear = [number for number, light in enumerate(seen) if light == most]
    assert seen[0] < 0.1 * most and seen[-1] < 0.5 * most
    assert clear == list(range(clear[0], clear[-1] + 1))
    assert clear[0] / 60.0 == pytest.approx(motion.TOAST_IN_S, abs=0.05)
    assert len(clear) / 60.0 >= motion.TOAST_STAY_S
    rising, falling = seen[: clear[0] + 1], seen[clear[-1] :]
    assert rising == sorted(rising) and falling == sorted(falling, reverse=True)


@pytest.mark.parametrize("height", [28, 32, 40, 80])
def test_a_message_stays_inside_its_row(look, height):
    """What is drawn above the hints, a line below a table say, is not covered."""
    toasts, surface = Toasts(look), pygame.Surface((960, 120), 0, 32)
    row = pygame.Rect(0, 120 - height, 960, height)
    toasts.add("Saved.", "Picture in the pictures folder.")
    toasts.update(0.5)
    toasts.draw(surface, row)
    drawn = np.flatnonzero(pygame.surfarray.array3d(surface).any(axis=(0, 2)))
    assert drawn[0] >= row.top and drawn[-1] < row.bottom and len(drawn) >= 24


def test_messages_wait_their_turn_and_never_pile_up(look):
    toasts = Toasts(look)
    for i in range(50):
        toasts.add(f"Message {i}", kind="warning")
    assert toasts.shown.cause == "Message 0"
    seen = []
    while toasts.shown is not None:
        if toasts.shown.cause not in seen:
            seen.append(toasts.shown.cause)
        toasts.update(0.1)
    assert len(seen) == 4 and seen[-1] == "Message 49"


def test_a_message_is_withdrawn_and_the_next_one_stays_its_whole_time(look):
    toasts = Toasts(look)
    for name in ("first", "second", "third"):
        toasts.add(name, f"What is said of the {name}.")
    toasts.update(1.0)
    toasts.withdraw("What is said of the first.")
    toasts.withdraw("What is said of the third.")
    toasts.withdraw("What was never said.")
    toasts.update(3.9)
    assert toasts.shown.cause == "second"
    toasts.update(0.5)
    assert toasts.shown is None


def test_a_message_is_as_wide_as_its_words_but_no_wider_than_its_row(look: Look):
    toasts = Toasts(look)
    assert toasts.width(4000) == 0
    toasts.add("Saved.")
    usual = toasts.width(4000)
    toasts.clear()
    toasts.add("Saved.", "a word and " * 20)
    words = look.fonts.size("Saved.", 13, "semibold")[0] + look.fonts.size("a word and " * 20, 13)[0]
    assert toasts.width(4000) > max(words, usual) and toasts.width(300) == 300


def test_a_tip_shows_after_half_a_second_inside_the_window(look):
    tip, surface = ToolTip(look), pygame.Surface((200, 100), 0, 32)
    about = ("A long explanation of the thing that is under the pointer now", pygame.Rect(190, 90, 10, 10))
    for _ in range(4):
        tip.update(0.1, about)
        tip.draw(surface)
    assert not pygame.surfarray.array3d(surface).any()
    tip.update(0.2, about)
    tip.draw(surface)
    assert pygame.surfarray.array3d(surface).any()
    surface.fill("black")
    tip.update(0.1, None)
    tip.draw(surface)
    assert not pygame.surfarray.array3d(surface).any()


# -- legend, loading, overlay --------------------------------------------------------------------------

MARKS = (
    "disc", "ring", "body", "box", "dashed-box", "line", "dash", "arrow", "diamond", "square", "triangle-up",
    "triangle-down", "plus", "cross",
)  # fmt: skip


@pytest.mark.parametrize("shape", MARKS)
def test_every_mark_has_a_picture_of_its_own(look, shape):
    pictures = set()
    for name in MARKS:
        surface = pygame.Surface((40, 40), 0, 32)
        draw_mark(surface, look, f"{name}:amber", (20.0, 20.0))
        if name == shape:
            assert pygame.surfarray.array3d(surface).any()
        pictures.add(picture(surface))
    assert len(pictures) == len(MARKS)
    with pytest.raises(ValueError, match="no such shape"):
        draw_mark(pygame.Surface((9, 9), 0, 32), look, "blob:amber", (4, 4))


def test_a_count_stands_until_it_is_fresh_and_words_change_at_once(look):
    legend, stage = Legend(look), pygame.Rect(0, 0, 960, 400)
    shown = []
    for words, count in (("boxes", "1"), ("boxes", "2"), ("balls", "3")):
        surface = pygame.Surface((960, 400), 0, 32)
        legend.draw(surface, stage, [("box:vermilion", words, count)], fresh=False)
        shown.append(pygame.image.tobytes(surface, "RGB"))
    assert shown[0] == shown[1] != shown[2]
    surface = pygame.Surface((960, 400), 0, 32)
    legend.draw(surface, stage, [("box:vermilion", "balls", "4")], fresh=True)
    assert pygame.image.tobytes(surface, "RGB") != shown[2]


def test_a_legend_never_shrinks_with_its_counts(look):
    legend, surface, stage = Legend(look), pygame.Surface((960, 512), 0, 32), pygame.Rect(0, 48, 960, 400)
    widths = []
    for count in ("9", "123456789012", "9"):
        legend.draw(surface, stage, [("box:vermilion", "overlapping boxes that are many", count)])
        widths.append(legend.rect.w)
    assert widths[1] > widths[0] and widths[2] == widths[1]
    assert legend.rect.topleft == (16, 64)
    legend.draw(surface, pygame.Rect(0, 0, 60, 40), [("disc:amber", "no room", "")])
    assert legend.rect.w == 0
    legend.draw(surface, stage, ())
    assert legend.rect.w == 0


@pytest.mark.parametrize("size", SIZES)
def test_the_loading_card_in_any_window(any_look, size):
    layout = arrange(*size, any_look.k)
    surface = pygame.Surface(size, 0, 32)
    draw_shell(surface, layout, any_look)
    before = pygame.image.tobytes(surface, "RGB")
    card = LoadingCard(any_look)
    for done, total in ((0, 0), (0, 12), (5, 12), (12, 12), (3, 200)):
        card.update(0.1, done, total)
        card.draw(surface, layout.stage, "Sweep and prune", done, total, "sort_endpoints", 2.3)
    roomy = layout.stage.w - any_look.px(16) >= any_look.px(160) and layout.stage.h >= any_look.px(208)
    assert (pygame.image.tobytes(surface, "RGB") != before) == roomy


def test_the_ball_rolls_with_its_way(look):
    card = LoadingCard(look)
    front, turned, back = (card.ball(5, 13.0, angle) for angle in (0.0, 1.0, 2.0 * math.pi))
    assert np.array_equal(pygame.surfarray.array3d(front), pygame.surfarray.array3d(back))
    assert not np.array_equal(pygame.surfarray.array3d(front), pygame.surfarray.array3d(turned))
    assert pygame.surfarray.array_alpha(front).sum() / 255 == pytest.approx(math.pi * 169, rel=0.03)


def test_time_in_words():
    assert [seconds_text(s) for s in (8.7, 80.0, 95.0, math.nan)] == ["9 s", "80 s", "1 min 35 s", "–"]


def test_an_overlay_comes_and_goes(look):
    overlay = Overlay(look, 600)
    overlay.place(pygame.Rect(0, 0, 1280, 720), look)
    surface = pygame.Surface((1280, 720), 0, 32)
    surface.fill("white")
    overlay.draw_veil(surface)
    overlay.draw_card(surface, overlay.background())
    assert picture(surface) == b"\xff" * (1280 * 720 * 3)  # not yet
    assert overlay.update(0.5)
    overlay.draw_veil(surface)
    overlay.draw_card(surface, overlay.background())
    assert surface.get_at(overlay.card.center)[:3] == DARK.panel[:3]
    assert surface.get_at((5, 5))[0] < 120
    overlay.leave()
    assert overlay.update(0.1) and not overlay.update(0.2)


def test_the_gallery_draws_every_screen(any_look):
    from tests.ui import gallery

    stage = gallery.sample_stage()
    size = (round(1280 * any_look.k), round(720 * any_look.k))
    pictures = set()
    for draw in (gallery.draw_scene, gallery.draw_loading, gallery.draw_help, gallery.draw_accuracy):
        surface = pygame.Surface(size, 0, 32)
        draw(surface, any_look, stage)
        pictures.add(picture(surface))
    assert len(pictures) == 4
