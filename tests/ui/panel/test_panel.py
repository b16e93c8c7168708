"""The panel: what the pointer and the keys do to it comes out as stage events; values from elsewhere show."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.levels import Level
from game.stage import Param, ParameterError, SetEffect, SetParameter, Stage, Table
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.panel.effects import COLORS, CostBar, EffectRow
from game.ui.panel.panel import Panel
from game.ui.panel.rows import Heading, Measure, SegmentsRow
from game.ui.panel.slider import SliderRow, read_value, share_of, shown_value, value_at
from game.ui.panel.switch import SwitchRow
from game.ui.panel.table import LegendRow, TableLine
from game.ui.widgets.wishes import Wish
from tests.ui.pointing import click, down, event, move, press, up
from tests.ui.sample_scene import Sample

RECT = pygame.Rect(960, 48, 320, 672)
LEVELS = [SimpleNamespace(title="First", value="a"), SimpleNamespace(title="Second", value="b")]
METER = SimpleNamespace(costs={"test-gravity": 4e-6, "test-ground": 20e-6, "test-drag": 9e-6}, bare=8e-6)


class Desk:
    """A panel on a stage, as the window has it."""

    def __init__(self, look=None, rect=RECT, **options):
        self.look = look or Look(DARK)
        self.stage = Stage(Sample, **options)
        self.panel = Panel(self.look, Sample, LEVELS)
        self.panel.place(rect, self.look)
        self.surface = pygame.Surface((rect.right, rect.bottom), 0, 32)
        self.frame(0.3)

    def frame(self, dt=1 / 60):
        self.panel.update(dt, self.stage, METER)
        self.panel.draw(self.surface)

    def row(self, kind, name):
        for row in self.panel._sheet.rows:
            if isinstance(row, kind) and name in (
                getattr(getattr(row, "parameter", None), "name", None),
                getattr(getattr(row, "effect", None), "name", None),
                getattr(row, "label", None),
            ):
                return row
        raise AssertionError(f"no row {name}")

    def place(self, row, x, y):
        """Window pixel of a place in a row, after scrolling it into view."""
        self.panel._reveal((row.rect.top, row.rect.bottom))
        return (
            self.panel.rect.x + x,
            self.panel.rect.y + row.rect.y + y - self.panel.scroll,
        )

    def apply(self, wishes):
        """Do what the app does with wishes: post the stage events, keep the rest."""
        rest = []
        for wish in wishes:
            if isinstance(wish, Wish):
                rest.append(wish)
            else:
                self.stage.post(wish)
        self.frame()
        return rest

    def picture(self):
        self.frame(0.3)
        return pygame.image.tobytes(self.surface.subsurface(self.panel.rect), "RGB")


@pytest.fixture
def desk():
    made = Desk()
    yield made
    made.panel.close()


def test_a_click_on_the_track_sets_the_value(desk):
    row = desk.row(SliderRow, "restitution")
    assert click(desk.panel, desk.place(row, 16 + 8 + 272, 30)) == [SetParameter("restitution", 1.0)]
    wishes = click(desk.panel, desk.place(row, 16 + 8, 30))
    assert wishes == [SetParameter("restitution", 0.0)]
    desk.apply(wishes)
    assert row.value == 0.0


def test_a_drag_follows_the_pointer_even_outside_and_ends_with_the_button(desk):
    row = desk.row(SliderRow, "restitution")
    x, y = desk.place(row, 24, 30)
    desk.apply(desk.panel.handle(down(x, y)))
    desk.apply(desk.panel.handle(move(x + 1000, y - 400)))
    assert desk.stage.scene.restitution == 1.0
    desk.apply(desk.panel.handle(up(x + 1000, y)))
    desk.apply(desk.panel.handle(move(x, y)))
    assert desk.stage.scene.restitution == 1.0


def test_a_parameter_that_rebuilds_is_sent_on_release(desk):
    row = desk.row(SliderRow, "drop")
    x, y = desk.place(row, 24, 30)
    assert desk.panel.handle(down(x, y)) == []
    assert row.value == 0.5  # shown while dragged
    assert desk.panel.handle(up(x, y)) == [SetParameter("drop", 0.5)]


def test_losing_the_window_drops_a_drag(desk):
    row = desk.row(SliderRow, "drop")
    x, y = desk.place(row, 24, 30)
    desk.panel.handle(down(x, y))
    assert desk.panel.handle(event(pygame.WINDOWFOCUSLOST)) == []
    assert row.value == 3.0 and not row.held
    assert desk.panel.handle(move(x + 50, y)) == []


def test_a_double_click_goes_back_to_the_default(desk):
    row = desk.row(SliderRow, "restitution")
    desk.apply([SetParameter("restitution", 0.9)])
    place = desk.place(row, 60, 10)
    assert click(desk.panel, place) == []
    assert click(desk.panel, place) == [SetParameter("restitution", 0.5)]


def type_in(desk, row, text, key=pygame.K_RETURN):
    click(desk.panel, desk.place(row, 262, 10))
    assert desk.panel.typing
    for letter in text:
        desk.panel.handle(event(pygame.TEXTINPUT, text=letter))
    desk.frame()
    wishes = desk.panel.handle(press(key))
    assert not desk.panel.typing
    return wishes


def test_a_number_is_typed_in_the_unit_shown(desk):
    row = desk.row(SliderRow, "hold")
    assert shown_value(row.parameter, row.value) == ("4.00", "ms")
    assert type_in(desk, row, "25") == [SetParameter("hold", 0.025)]
    assert type_in(desk, row, "0.05 s") == [SetParameter("hold", 0.05)]
    assert type_in(desk, row, "7", pygame.K_ESCAPE) == []


@pytest.mark.parametrize("text", ["1.5", "nan", "inf", "abc", "-0.1", "1e400"])
def test_a_refused_number_is_told_and_the_old_value_stays(desk, text):
    wishes = type_in(desk, desk.row(SliderRow, "restitution"), text)
    assert [wish.name for wish in wishes] == ["refused"]
    assert "\n" not in wishes[0].value
    assert desk.stage.scene.restitution == 0.5


def test_a_click_elsewhere_takes_over_what_was_typed(desk):
    row = desk.row(SliderRow, "restitution")
    click(desk.panel, desk.place(row, 262, 10))
    desk.panel.handle(event(pygame.TEXTINPUT, text="1"))
    wishes = click(desk.panel, desk.place(desk.row(SliderRow, "rate"), 40, 10))
    assert SetParameter("restitution", 1.0) in wishes and not desk.panel.typing


def test_segments_switches_and_effects(desk):
    row = desk.row(SegmentsRow, "method")
    assert click(desk.panel, desk.place(row, 40, 16)) == [SetParameter("method", "explicit-euler")]
    assert click(desk.panel, desk.place(row, 280, 16)) == []  # already chosen
    assert click(desk.panel, desk.place(desk.row(SwitchRow, "shadow".capitalize()), 30, 16)) == [
        SetParameter("shadow", False)
    ]
    row = desk.row(EffectRow, "test-gravity")
    wishes = click(desk.panel, desk.place(row, 30, 16))
    assert wishes == [SetEffect("test-gravity", False)]
    desk.apply(wishes)
    assert not row.is_on()


def test_the_costs_of_a_step_lie_side_by_side_above_the_effects(desk):
    (bar,) = (row for row in desk.panel._sheet.rows if isinstance(row, CostBar))
    (heading,) = (
        row for row in desk.panel._sheet.rows if isinstance(row, Heading) and row.title == "Effects"
    )
    first = desk.row(EffectRow, next(iter(desk.stage.scene.effects)).name)
    assert heading.rect.bottom <= bar.rect.top and bar.rect.bottom <= first.rect.top
    desk.stage.post(SetEffect("test-ground", True))
    desk.frame(0.3)
    left, y = desk.place(bar, 0, 4)
    desk.frame(0.3)
    line = [tuple(desk.surface.get_at((left + x, y)))[:3] for x in range(bar.left, bar.right)]
    shares = []
    for i, effect in enumerate(desk.stage.scene.effects):
        if effect in desk.stage.scene.active:
            shares.append((METER.costs[effect.name], line.count(tuple(desk.look.color(COLORS[i]))[:3])))
    assert len(shares) > 1
    scale = sum(METER.costs.values()) + METER.bare
    for cost, pixels in shares:
        assert pixels == pytest.approx(len(line) * cost / scale, abs=6)


def test_letting_go_beside_a_switch_changes_nothing(desk):
    x, y = desk.place(desk.row(SwitchRow, "Shadow"), 30, 16)
    desk.panel.handle(down(x, y))
    assert desk.panel.handle(up(x, y + 60)) == []


def test_a_level_is_chosen_from_the_list(desk):
    menu = desk.panel._sheet.menus[""]
    click(desk.panel, (RECT.x + 100, RECT.y + 30))
    desk.frame()
    assert menu.is_open
    wishes = click(desk.panel, (RECT.x + 100, RECT.y + 16 + 32 + 80))  # below "No level" and "First"
    assert wishes == [Wish("level", "b")]


def shown_level(desk):
    """Title in the box of the levels, and the titles of the list."""
    desk.frame()
    menu = desk.panel._sheet.menus[""]
    return menu.selected_option[0], [title for title, _ in menu.options]


def test_the_list_shows_the_level_in_play_also_when_it_is_none_of_the_scene(desk):
    assert shown_level(desk) == ("No level", ["No level", "First", "Second"])
    for path, title, shown in (
        ("b", "Second", ("Second", ["First", "Second"])),
        ("elsewhere", "Mine", ("Mine", ["Mine", "First", "Second"])),
        (None, "As recorded", ("As recorded", ["As recorded", "First", "Second"])),
        ("a", "First", ("First", ["First", "Second"])),
    ):
        desk.stage.load_level(Level(scene=Sample.name, title=title, path=path and Path(path)))
        assert shown_level(desk) == shown
        sheet = desk.panel._sheet
        desk.frame()
        assert desk.panel._sheet is sheet  # made again once


def test_levels_that_come_later_are_offered(desk):
    desk.stage.load_level(Level(scene=Sample.name, title="Mine", path=Path("c")))
    assert shown_level(desk) == ("Mine", ["Mine", "First", "Second"])
    desk.panel.offer([*LEVELS, SimpleNamespace(title="Mine", value=Path("c"))])
    assert shown_level(desk) == ("Mine", ["First", "Second", "Mine"])
    sheet = desk.panel._sheet
    desk.panel.offer(desk.panel.levels)
    assert desk.panel._sheet is sheet


def test_the_level_in_play_chosen_again_is_no_wish(desk):
    desk.panel._sheet._send_choice("", "")
    assert desk.panel._wishes == []


def test_a_long_choice_is_a_list_and_opens_within_reach(desk):
    menu = desk.panel._sheet.menus["order"]
    desk.panel._reveal((menu.rect.top, menu.rect.bottom))
    place = (RECT.x + 100, RECT.y + menu.rect.centery - desk.panel.scroll)
    click(desk.panel, place)
    desk.frame()
    desk.panel.handle(move(*place))
    assert menu.is_open and menu.foot <= desk.panel.scroll + desk.panel.view.h
    row = (RECT.x + 100, RECT.y + menu.rect.bottom + 32 * 3 + 16 - desk.panel.scroll)
    assert click(desk.panel, row) == [SetParameter("order", "as-printed")]


def test_the_value_that_stands_closes_the_list_too(desk):
    menu = desk.panel._sheet.menus[""]
    before = menu.selected_option
    click(desk.panel, (RECT.x + 100, RECT.y + 30))
    desk.frame()
    rows = menu.menu_states["expanded"].options_selection_list
    at = next(i for i, row in enumerate(rows.item_list) if row["selected"])
    assert click(desk.panel, (RECT.x + 100, RECT.y + 16 + 32 + 16 + 32 * at)) == []
    desk.frame()
    assert not menu.is_open and menu.selected_option == before


def test_escape_closes_an_open_list(desk):
    menu = desk.panel._sheet.menus[""]
    click(desk.panel, (RECT.x + 100, RECT.y + 30))
    desk.frame()
    assert menu.is_open and desk.panel.has_open_list
    assert desk.panel.handle(pygame.Event(pygame.KEYDOWN, key=pygame.K_ESCAPE)) == []
    desk.frame()
    assert not desk.panel.has_open_list


def test_values_from_elsewhere_show(desk):
    before = desk.picture()
    desk.stage.post(SetParameter("restitution", 0.9))
    changed = desk.picture()
    assert changed != before
    desk.stage.post(SetParameter("order", "joint"))
    desk.picture()
    assert desk.panel._sheet.menus["order"].selected_option[1] == "joint"
    desk.stage.post(SetParameter("order", "pairwise"))
    desk.stage.post(SetParameter("restitution", 0.5))
    assert desk.picture() == before


def test_a_quiet_panel_that_follows_the_scene_shows_what_a_new_one_shows(desk):
    """Rows that follow the scene one by one, without a pointer, against the whole sheet drawn again."""
    for _ in range(60):
        desk.frame()  # at rest
    sheet = desk.panel._sheet
    for value, method in ((0.9, "explicit-euler"), (0.2, "explicit-euler"), (0.7, desk.stage.scene.method)):
        desk.stage.post(SetParameter("restitution", value))
        desk.stage.post(SetParameter("method", method))
        for _ in range(40):
            desk.frame()
    assert desk.panel._sheet is sheet
    followed = desk.picture()
    desk.panel._unrest_s = 1.0
    sheet._drawn = []
    assert desk.picture() == followed


def test_two_clicks_far_apart_in_time_are_no_double_click(desk):
    row = desk.row(SliderRow, "restitution")
    desk.apply([SetParameter("restitution", 0.9)])
    place = desk.place(row, 60, 10)
    click(desk.panel, place)
    for _ in range(60):
        desk.frame()
    assert click(desk.panel, place) == []


def test_a_linear_parameter_with_a_grain_keeps_its_unit():
    time = Param(0.0, 0.0, 1.0, unit="s", step=0.001)
    time.name = "time"
    assert shown_value(time, 0.004) == ("0.004", "s")
    assert read_value(time, "0.5", shown_value(time, 0.004).unit) == 0.5
    assert read_value(time, "4ms", "s") == 0.004


def test_another_scene_of_the_type_takes_over_without_a_new_sheet(desk):
    sheet = desk.panel._sheet
    desk.stage.reset()
    desk.frame(0.3)
    assert desk.panel._sheet is sheet
    desk.stage.post(SetParameter("restitution", 0.25))
    desk.frame()
    assert desk.row(SliderRow, "restitution").value == 0.25


def test_measures_show_what_the_bar_has_no_room_for(desk):
    names = [row.name for row in desk.panel._sheet.rows if isinstance(row, Measure)]
    assert names == ["pot.", "kin.", "now", "exact", "step"]
    row = next(row for row in desk.panel._sheet.rows if isinstance(row, Measure) and row.name == "now")
    assert row.value == pytest.approx(3.0)


def test_keys_move_the_focused_control(desk):
    assert desk.panel.focus_next()
    assert desk.panel.handle(press(pygame.K_RIGHT)) == [SetParameter("drop", 3.1)]
    assert desk.panel.focus_next()
    wishes = desk.panel.handle(press(pygame.K_LEFT))
    assert wishes[0].name == "rate" and wishes[0].value < 8000
    rounds = 0
    while desk.panel.focus_next():
        rounds += 1
    assert rounds > 5
    assert desk.panel.handle(press(pygame.K_RIGHT)) == [] and not desk.panel.has_keys


def test_a_press_of_the_mouse_gives_no_keyboard_focus(desk):
    desk.apply(click(desk.panel, desk.place(desk.row(SwitchRow, "Shadow"), 30, 16)))
    assert not desk.panel.has_keys and desk.panel.handle(press(pygame.K_SPACE)) == []
    assert desk.panel.focus_next() and desk.panel.has_keys
    click(desk.panel, desk.place(desk.row(SliderRow, "rate"), 60, 10))
    assert not desk.panel.has_keys


def test_wheel_and_thumb_scroll_within_the_ends(desk):
    desk.panel.handle(move(RECT.x + 100, RECT.y + 300))
    desk.panel.handle(event(pygame.MOUSEWHEEL, y=-100, x=0))
    low = desk.panel.scroll
    assert low == desk.panel._reach() - desk.panel.view.h > 0
    thumb = desk.panel._thumb()
    desk.panel.handle(down(*thumb.center))
    desk.panel.handle(move(thumb.centerx, -500))
    desk.panel.handle(up(thumb.centerx, -500))
    assert desk.panel.scroll == 0


def test_foot_and_tips(desk):
    reset = desk.panel.foot.spots.find("defaults")
    assert click(desk.panel, reset.rect.center) == [Wish("defaults")]
    row = desk.row(SliderRow, "rate")
    desk.panel.handle(move(*desk.place(row, 60, 10)))
    assert desk.panel.tip()[0] == "Particles each second.\n1 1/s to 26 000 1/s".replace(" 000", "\u202f000")


def test_an_idle_frame_paints_nothing(desk):
    for _ in range(30):
        desk.frame(0.02)
    drawn = desk.panel._sheet._drawn
    desk.frame(0.001)
    assert desk.panel._sheet._drawn is drawn


@pytest.mark.parametrize("size", [(1, 1), (320, 10), (5, 600), (200, 120), (640, 1400)])
def test_any_size(any_look, size):
    desk = Desk(any_look, pygame.Rect(10, 10, *size))
    for place in ((12, 12), (100, 60)):
        click(desk.panel, place)
    desk.panel.handle(event(pygame.MOUSEWHEEL, y=-3, x=0))
    desk.frame()
    desk.panel.place(pygame.Rect(0, 0, 320, 500), any_look)
    desk.frame()
    assert desk.panel.rect == pygame.Rect(0, 0, 320, 500)
    desk.panel.close()


def test_a_thousand_random_events(desk):
    rng = np.random.default_rng(3)
    kinds = [move, down, up]
    for _ in range(1000):
        x, y = int(rng.integers(RECT.x - 40, RECT.right)), int(rng.integers(RECT.y - 20, RECT.bottom + 10))
        roll = rng.random()
        if roll < 0.9:
            made = kinds[int(rng.integers(3))](x, y)
        elif roll < 0.95:
            made = event(pygame.MOUSEWHEEL, y=int(rng.integers(-3, 4)), x=0)
        else:
            made = press(
                int(rng.choice([pygame.K_RETURN, pygame.K_LEFT, pygame.K_ESCAPE, pygame.K_BACKSPACE]))
            )
        desk.apply(desk.panel.handle(made))
    scene = desk.stage.scene
    assert all(
        parameter.check(scene.values[name]) == scene.values[name]
        for name, parameter in scene.declared_parameters().items()
    )
    assert desk.stage.fault is None


# -- numbers on a track --------------------------------------------------------------------------------

PARAMS = (
    Param(1.0, 0.0, 10.0),
    Param(5, 1, 64, whole=True),
    Param(1e-3, 1e-6, 1.0, log=True, unit="s"),
    Param(0.5, -1.0, 1.0, step=0.01),
    Param(100, 1, 100000, whole=True, log=True),
    Param(0.3, 0.1, 0.9, step=0.25),
)


@given(st.sampled_from(PARAMS), st.floats(-0.5, 1.5))
def test_every_place_on_a_track_is_a_value_the_parameter_takes(parameter, share):
    value = value_at(parameter, share)
    assert parameter.check(int(value) if parameter.whole else value) == value
    assert abs(share_of(parameter, value) - min(max(share, 0.0), 1.0)) < 0.5


@given(st.sampled_from(PARAMS))
def test_the_ends_of_a_track_are_the_ends_of_the_range(parameter):
    assert value_at(parameter, 0.0) == parameter.minimum
    assert parameter.maximum - value_at(parameter, 1.0) < (parameter.step or 1e-9)


@given(st.sampled_from(PARAMS), st.floats(0.0, 1.0))
def test_what_is_shown_can_be_typed_back(parameter, share):
    value = value_at(parameter, share)
    number, unit = shown_value(parameter, value)
    for text in (number, f"{number} {unit}"):
        try:
            back = read_value(parameter, text, unit)
        except ParameterError:
            assert abs(value - parameter.minimum) < 1e-6  # three digits of it may lie below the range
            continue
        assert abs(back - value) <= 6e-3 * abs(value) + 1e-12


class Listed(Sample):
    """A scene with its legend in the panel, and a table."""

    name = "listed"
    legend_in_panel = True
    count, pointed = 2, None

    def legend(self):
        return [("disc:chalk", "spheres", str(self.count)), ("line:green", "walls", "")]

    def panel_table(self):
        if not self.count:
            return None
        rows = tuple((f"row {i}", f"{0.5 * i}") for i in range(self.count))
        return Table(
            "Figures", ("name", "length m"), rows, tuple(range(70, 70 + self.count)), 3, "what it is"
        )

    def point_at(self, key):
        self.pointed = key


def listed_panel():
    look = Look(DARK)
    stage, panel = Stage(Listed), Panel(look, Listed, LEVELS)
    panel.place(RECT, look)
    panel.update(0.3, stage)
    return stage, panel


def test_a_table_and_a_legend_stand_below_the_levels():
    stage, panel = listed_panel()
    kinds = [type(row) for row in panel._sheet.rows[:7]]
    assert kinds == [LegendRow, LegendRow, Heading, TableLine, TableLine, TableLine, TableLine]
    lines = panel._sheet.rows[3:7]
    assert [line.cells for line in lines] == [("name", "length m"), ("row 0", "0.0"), ("row 1", "0.5"), ()]
    assert lines[0].tip == "what it is"
    assert [row.shows()[1:] for row in panel._sheet.rows[:2]] == [("spheres", "2"), ("walls", "")]
    stage.scene.count = 0
    panel.update(0.3, stage)
    assert not any(isinstance(row, TableLine) for row in panel._sheet.rows)


def test_the_row_under_the_pointer_is_told_to_the_scene():
    stage, panel = listed_panel()
    for line, key in zip(panel._sheet.rows[3:7], (None, 70, 71, None), strict=True):
        panel.handle(move(RECT.x + 50, RECT.y + line.rect.centery))
        panel.update(1 / 60, stage)
        panel.update(1 / 60, stage)
        assert stage.scene.pointed == key
    panel.handle(move(RECT.x + 50, RECT.y + panel._sheet.rows[5].rect.centery))
    panel.update(1 / 60, stage)
    panel.update(1 / 60, stage)
    assert stage.scene.pointed == 71
    panel.place(pygame.Rect(RECT.right, RECT.y, 0, RECT.h), panel.look)
    panel.update(1 / 60, stage)
    assert stage.scene.pointed is None, "a panel that is shut points at nothing"


@pytest.mark.parametrize(
    ("typed", "shown", "said"),
    [
        ("999", "ms", "Lecture's step: 999 ms is outside 0.5 to 50 ms"),
        ("0.1", "ms", "Lecture's step: 0.1 ms is outside 0.5 to 50 ms"),
        ("3 s", "ms", "Lecture's step: 3 s is outside 0.0005 to 0.05 s"),
        ("9000µs", "ms", None),
        ("60000 µs", "ms", "Lecture's step: 60000 µs is outside 500 to 50000 µs"),
    ],
)
def test_what_is_refused_is_told_in_the_unit_that_was_typed(typed, shown, said):
    step = Param(1 / 60, 0.0005, 0.05, unit="s", log=True, label="Lecture's step")
    step.name = "lecture_step"
    if said is None:
        assert read_value(step, typed, shown) == pytest.approx(0.009)
        return
    with pytest.raises(ParameterError) as refused:
        read_value(step, typed, shown)
    assert str(refused.value) == said
