"""The panel at the right of a scene, made from its declarations: level, knobs by group, effects, measures.

Values come from the scene and go to it as stage events only, so a change from elsewhere (replay, step back,
a level) shows at once. The rows lie on one tall sheet that is drawn when something on it has changed;
scrolling moves the sheet behind the window of the panel, and the foot stays.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pygame
from pygame_gui.elements import UITextEntryLine

from game.stage import Choice, Knob, Param, Scene, SetKnob, Stage, StageEvent, Toggle
from game.ui.commands import Command
from game.ui.look import Look
from game.ui.numerals import NOTHING, format_si
from game.ui.panel_effects import COLORS, CostBar, EffectCosts, EffectRow
from game.ui.panel_foot import PanelFoot
from game.ui.panel_manager import DropDown, PanelManager
from game.ui.panel_rows import (
    PADDING,
    Caption,
    Context,
    Heading,
    Measure,
    Row,
    SegmentsRow,
    Source,
    fits_in_segments,
    toggle_row,
)
from game.ui.panel_slider import SliderRow, shown_value
from game.ui.shapes import draw_box

Wish = StageEvent | Command
FOOT, WHEEL, BESIDE_MEASURES = 64, 40, 1  # design px; readouts that the top bar shows
REFRESH_S = 0.25  # s between changes of measured numbers
UNREST_S = 0.2  # s that controls go on moving after a change
LIST_ROOM = 8 * 32  # design px below the last row, for an open list


class Panel:
    """A scene's controls. ``levels``: rows with ``title`` and ``value`` (a path), or nothing."""

    def __init__(self, look: Look, scene_type: type[Scene], levels: Sequence[Any] = ()) -> None:
        self.look = look
        self.scene_type = scene_type
        self.levels = tuple(levels)
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.foot = PanelFoot(look, scene_type.study is not None)
        self.scroll = 0
        self._source: Source | None = None
        self._manager: PanelManager | None = None
        self._rows: list[Row] = []
        self._menus: dict[str, DropDown] = {}  # by knob; "" for the levels
        self._wishes: list[Wish] = []
        self._costs = EffectCosts()
        self._measures: tuple[str, ...] = ()
        self._since_s = REFRESH_S
        self._field: tuple[SliderRow, UITextEntryLine] | None = None
        self._sheet = pygame.Surface((1, 1), 0, 32)
        self._drawn: list[Any] = []
        self._content = 0
        self._pointer = (-1, -1)
        self._bar_grip: int | None = None
        self._redraw = True
        self._seen: tuple[Any, ...] = ()
        self._unrest_s = UNREST_S  # time left until all that moves has come to rest

    # -- place and contents -------------------------------------------------------------------------

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window and an appearance."""
        anew = look is not self.look or rect.size != self.rect.size
        self.look, self.rect = look, pygame.Rect(rect)
        self.foot.place(pygame.Rect(rect.x, rect.bottom - look.px(FOOT), rect.w, look.px(FOOT)), look)
        if anew and self._source is not None:
            self._build()

    def close(self) -> None:
        """The scene is left: free pygame_gui's elements."""
        if self._manager is not None:
            self._manager.clear_and_reset()
        self._rows, self._menus, self._field, self._manager = [], {}, None, None

    @property
    def typing(self) -> bool:
        """Whether a number is being typed, so that keys are letters."""
        return self._field is not None

    @property
    def view(self) -> pygame.Rect:
        """The part of the window in which the sheet is seen."""
        return pygame.Rect(self.rect.x, self.rect.y, self.rect.w, max(0, self.rect.h - self.look.px(FOOT)))

    def _build(self) -> None:
        """Make all rows for the present scene, place and appearance."""
        look = self.look
        self.close()
        if self._source is None or self.rect.w < look.px(80) or self.view.h < 1:
            return
        height = self._lay_out(None)
        room = max(height, self.view.h) + look.px(LIST_ROOM)
        self._manager = PanelManager((self.rect.w, room), look)
        self._content = self._lay_out(Context(self._manager, look, self.rect.w, self._wishes.append))
        self._sheet = pygame.Surface((self.rect.w, room), 0, 32)
        self._drawn = []
        self._redraw = True
        self._scroll_to(self.scroll)

    def _lay_out(self, context: Context | None) -> int:
        """Put rows below each other, or only measure if there is no context; the height they take."""
        source = self._source
        assert source is not None
        scene, y = source.scene, _Flow(self, context, source)
        if self.levels:
            y.space(16)
            y.menu("", [(row.title, str(row.value)) for row in self.levels], self._present_level(), "Level")
            y.space(8)
        for title, knobs in _groups(scene.knobs().values()):
            y.row(Heading, title)
            for knob in knobs:
                y.knob(knob, title)
        if len(tuple(scene.effects)):
            y.row(Heading, "Effects")
            y.row(CostBar, source, self._costs)
            for i, effect in enumerate(scene.effects):
                y.row(EffectRow, source, effect, COLORS[i % len(COLORS)], self._costs)
        if self._measures:
            y.row(Heading, "Measured")
            for name in self._measures:
                y.row(Measure, name)
        return y.height + self.look.px(8)

    def _present_level(self) -> str:
        assert self._source is not None
        level = self._source.scene.level
        return str(level.path or "") if level is not None else ""

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> list[Wish]:
        """Let an event act; the stage events and commands that it makes."""
        manager = self._manager
        if manager is None:
            return []
        command = self.foot.handle(event)
        if command is not None:
            self._wishes.append(command)
        elif event.type in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            self._handle_mouse(manager, event)
        elif event.type == pygame.MOUSEWHEEL:
            if self.view.collidepoint(self._pointer):
                self._scroll_to(self.scroll - round(event.y * WHEEL * self.look.k))
        elif event.type in (pygame.WINDOWLEAVE, pygame.WINDOWFOCUSLOST):
            self._leave(manager)
        elif event.type == pygame.KEYDOWN and self._field is not None:
            self._handle_field_key(manager, event)
        elif event.type == pygame.KEYDOWN:
            self._handle_row_key(event)
        elif self._field is not None and event.type == pygame.TEXTINPUT:
            manager.tell(event)
        self._collect(manager)
        wishes, self._wishes[:] = list(self._wishes), []
        return wishes

    def _handle_mouse(self, manager: PanelManager, event: pygame.event.Event) -> None:
        """A pointer event in the sheet's coordinates; those outside reach only what is held."""
        inside = self.view.collidepoint(event.pos)
        if inside or self.view.collidepoint(self._pointer) or event.type != pygame.MOUSEMOTION:
            self._unrest_s = UNREST_S
        self._pointer = event.pos
        if self._drag_bar(event):
            return
        x, y = event.pos[0] - self.rect.x, event.pos[1] - self.rect.y + self.scroll
        if event.type == pygame.MOUSEBUTTONDOWN:
            if self._field is not None and not self._field[1].rect.collidepoint((x, y)):
                self._commit_field()
            if not inside:
                self._close_menus(manager)
                return
        manager.point((x, y) if inside else (-1, -1))
        held = any(row.held for row in self._rows)
        if inside or held:
            manager.tell(pygame.event.Event(event.type, {**event.dict, "pos": (x, y)}))

    def _drag_bar(self, event: pygame.event.Event) -> bool:
        """The scroll thumb at the right edge."""
        thumb = self._thumb()
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and thumb is not None:
            if thumb.inflate(self.look.px(8), 0).collidepoint(event.pos):
                self._bar_grip = event.pos[1] - thumb.y
                return True
        elif event.type == pygame.MOUSEBUTTONUP and self._bar_grip is not None:
            self._bar_grip = None
            return True
        if self._bar_grip is not None and thumb is not None and event.type == pygame.MOUSEMOTION:
            free = self.view.h - thumb.h
            share = (event.pos[1] - self._bar_grip - self.view.y) / max(free, 1)
            self._scroll_to(round(share * (self._reach() - self.view.h)))
            return True
        return False

    def _handle_field_key(self, manager: PanelManager, event: pygame.event.Event) -> None:
        if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_TAB):
            self._commit_field()
        elif event.key == pygame.K_ESCAPE:
            self._close_field()
        else:
            manager.tell(event)

    def _handle_row_key(self, event: pygame.event.Event) -> None:
        for row in self._rows:
            if row.is_focused:
                row.key(event.key)
                self._unrest_s = UNREST_S
                return

    def focus_next(self, backward: bool = False) -> bool:
        """Move the keyboard focus to the next control; False when there is none left."""
        manager = self._manager
        if manager is None:
            return False
        rows = [row for row in self._rows if not isinstance(row, (Heading, Caption, Measure, CostBar))]
        if backward:
            rows.reverse()
        index = next((i for i, row in enumerate(rows) if row.is_focused), -1) + 1
        self._unrest_s = UNREST_S
        for row in self._rows:
            row.stale = True
            row.unfocus()
        if index >= len(rows):
            return False
        rows[index].focus()
        self._reveal(rows[index].rect.top, rows[index].rect.bottom)
        return True

    def _leave(self, manager: PanelManager) -> None:
        """The pointer or the window's focus is gone: drop what was held."""
        self._pointer = (-1, -1)
        self._bar_grip = None
        manager.point((-1, -1))
        self._unrest_s = UNREST_S
        for row in self._rows:
            row.held = False
            if isinstance(row, SliderRow):
                row.cancel()

    def _close_menus(self, manager: PanelManager) -> None:
        """A press beside the panel closes an open list."""
        if any(menu.is_open for menu in self._menus.values()):
            manager.set_focus_set(None)

    def _collect(self, manager: PanelManager) -> None:
        """Wishes of drop-downs, and the field that a row asks for."""
        for name, menu in self._menus.items():
            taken = menu.taken()
            if taken is not None:
                self._wishes.append(SetKnob(name, taken) if name else self._level_wish(taken))
            if menu.is_open:
                self._reveal(menu.rect.top, menu.foot)
        for row in self._rows:
            if isinstance(row, SliderRow) and row.wants_field:
                row.wants_field = False
                self._open_field(manager, row)

    def _level_wish(self, value: str) -> Command:
        row = next(row for row in self.levels if str(row.value) == value)
        return Command("level", row.value)

    # -- typing -------------------------------------------------------------------------------------

    def _open_field(self, manager: PanelManager, row: SliderRow) -> None:
        """Put a text field over the row's number, all of it chosen."""
        self._commit_field()
        field = UITextEntryLine(row.field_rect(), manager, object_id="#number")
        text = shown_value(row.knob, row.value).number
        field.set_text(text.replace("\u202f", "").replace("\u2212", "-"))
        manager.set_focus_set(field.get_focus_set())
        field.select_range = [0, len(field.get_text())]
        field.rebuild()
        row.typed = True
        self._field = (row, field)

    def _commit_field(self) -> None:
        if self._field is not None:
            row, field = self._field
            text = field.get_text()
            self._close_field()
            if text.strip():
                row.type(text)

    def _close_field(self) -> None:
        if self._field is not None:
            row, field = self._field
            row.typed = False
            field.kill()
            self._field = None

    # -- time ---------------------------------------------------------------------------------------

    def update(self, dt_s: float, stage: Stage, meter: Any = None) -> None:
        """Follow the scene: its values at once, measured numbers four times a second."""
        self.foot.update(dt_s)
        self._since_s += dt_s
        refresh = self._since_s >= REFRESH_S
        names = self._measures
        if refresh:
            self._since_s = 0.0
            readouts = tuple(stage.readouts())[BESIDE_MEASURES:]
            names = tuple(readout.name for readout in readouts)
        anew = self._source is None or names != self._measures
        if self._source is None:
            self._source = Source(stage.scene)
        self._source.scene = stage.scene
        if anew or self._follow_menus():
            self._measures = names
            self._build()
        if self._manager is None or self.rect.w == 0:
            return
        if refresh:
            self._refresh(readouts, meter)
        scene = stage.scene
        now = (tuple(scene.values.values()), scene.active.mask)
        if refresh or now != self._seen:
            for row in self._rows:
                row.stale = True
        if now != self._seen:
            self._seen, self._unrest_s = now, UNREST_S
        if self._unrest_s > 0.0 or refresh or self._field is not None:
            self._manager.update(dt_s)
            self._redraw = True
        self._unrest_s -= dt_s

    def _follow_menus(self) -> bool:
        """Whether a drop-down shows another value than the scene has."""
        assert self._source is not None
        values = self._source.values
        return any(
            menu.follow(str(values[name]) if name else self._present_level())
            for name, menu in self._menus.items()
        )

    def _refresh(self, readouts: Sequence[Any], meter: Any) -> None:
        """New numbers for costs and measures."""
        assert self._source is not None
        scene = self._source.scene
        if meter is not None:
            self._costs.costs, self._costs.bare = dict(meter.costs), meter.bare
        known = {readout.name: readout for readout in readouts}
        most = max(
            [self._costs.of(effect.name) for effect in scene.effects if self._is_known(effect)], default=0.0
        )
        on = [effect.name for effect in scene.effects if effect in scene.active]
        for row in self._rows:
            if isinstance(row, Measure) and row.name in known:
                row.value, row.unit = float(known[row.name].value), known[row.name].unit
            elif isinstance(row, EffectRow):
                row.scale_to(most)
            elif isinstance(row, Heading) and row.title == "Effects":
                total = self._costs.total(on)
                row.note = f"{format_si(total, 's')} a step" if total == total else NOTHING

    def _is_known(self, effect: Any) -> bool:
        cost = self._costs.of(effect.name)
        return cost == cost

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """What the thing under the pointer is, and where it is in the window."""
        if not self.view.collidepoint(self._pointer) or self._manager is None:
            return self.foot.tip()
        x, y = self._pointer[0] - self.rect.x, self._pointer[1] - self.rect.y + self.scroll
        things: tuple[Any, ...] = (*self._menus.values(), *self._rows)
        for thing in things:
            if thing.rect.collidepoint(x, y) and thing.tip and not getattr(thing, "held", False):
                if getattr(thing, "is_open", False):
                    return None
                inset = -2 * self.look.px(PADDING)
                return thing.tip, thing.rect.move(self.rect.x, self.rect.y - self.scroll).inflate(inset, 0)
        return None

    # -- scrolling and picture ----------------------------------------------------------------------

    def _reach(self) -> int:
        """Height that can be scrolled over: the rows, and an open list."""
        return (
            max(self._content, *(menu.foot for menu in self._menus.values()), 0)
            if self._menus
            else self._content
        )

    def _scroll_to(self, y: int) -> None:
        self.scroll = min(max(y, 0), max(0, self._reach() - self.view.h))

    def _reveal(self, top: int, bottom: int) -> None:
        """Scroll as little as shows a part of the sheet."""
        if bottom > self.scroll + self.view.h:
            self._scroll_to(bottom - self.view.h)
        if top < self.scroll:
            self._scroll_to(top)

    def _thumb(self) -> pygame.Rect | None:
        """The scroll thumb in the window, if there is something to scroll."""
        reach, view, px = self._reach(), self.view, self.look.px
        if reach <= view.h or view.h < px(40):
            return None
        height = max(px(24), view.h * view.h // reach)
        y = view.y + (view.h - height) * self.scroll // max(reach - view.h, 1)
        return pygame.Rect(view.right - px(8), y, px(5), height)

    def draw(self, surface: pygame.Surface) -> None:
        """Show the part of the sheet in view, the thumb, the foot and the line at the left."""
        if self.rect.w < 1 or self.rect.h < 1:
            return
        theme, view = self.look.theme, self.view
        if self._manager is not None:
            self._draw_sheet(self._manager)
            surface.blit(self._sheet, view, pygame.Rect(0, self.scroll, view.w, view.h))
            thumb = self._thumb()
            if thumb is not None:
                lit = theme.text3 if self._bar_grip is not None else theme.line2
                draw_box(surface, thumb, thumb.w / 2, lit)
        else:
            surface.fill(theme.panel, self.rect)
        self.foot.draw(surface, self._reach() > view.h + self.scroll)
        surface.fill(theme.line, (self.rect.x, self.rect.y, self.look.border, self.rect.h))

    def _draw_sheet(self, manager: PanelManager) -> None:
        """Draw the sheet anew if any picture on it is another or elsewhere."""
        if not self._redraw:
            return
        self._redraw = False
        pictures = manager.pictures()
        same = len(pictures) == len(self._drawn) and all(
            new[0] is old[0] and new[1] == old[1] for new, old in zip(pictures, self._drawn, strict=True)
        )
        if same and self._field is None:
            return
        self._drawn = pictures
        self._sheet.fill(self.look.theme.panel)
        manager.draw_ui(self._sheet)


class _Flow:
    """Puts rows below each other; without a context it only measures."""

    def __init__(self, panel: Panel, context: Context | None, source: Source) -> None:
        self.panel, self.context, self.source = panel, context, source
        self.height = 0

    def space(self, design_px: float) -> None:
        self.height += self.panel.look.px(design_px)

    def row(self, kind: type[Row], *arguments: Any) -> None:
        if self.context is not None:
            self.panel._rows.append(kind(self.context, self.height, *arguments))
        self.space(kind.height)

    def menu(self, name: str, options: list[tuple[str, str]], chosen: str, tip: str) -> None:
        px = self.panel.look.px
        if self.context is not None:
            width = self.panel.rect.w - 2 * px(PADDING)
            rect = pygame.Rect(px(PADDING), self.height, width, px(32))
            fonts = self.panel.look.fonts
            options = [(fonts.fit(label, 13, "medium", width - px(48)), value) for label, value in options]
            self.panel._menus[name] = DropDown(options, chosen, rect, self.context.manager, tip)
        self.space(32)

    def knob(self, knob: Knob[Any], group: str) -> None:
        """The control that suits a knob."""
        source = self.source
        if isinstance(knob, Param):
            self.row(SliderRow, knob, source)
        elif isinstance(knob, Toggle):
            self._append(lambda context, top: toggle_row(context, top, knob, source), 32)
        elif isinstance(knob, Choice):
            if knob.label != group:
                self.row(Caption, knob, source)
            if fits_in_segments(self.panel.look, knob, self.panel.rect.w):
                self.row(SegmentsRow, knob, source)
            else:
                options = list(zip(knob.labels, knob.options, strict=True))
                self.menu(knob.name, options, source.values[knob.name], knob.help)
                self.space(8)

    def _append(self, make: Any, height: float) -> None:
        if self.context is not None:
            self.panel._rows.append(make(self.context, self.height))
        self.space(height)


def _groups(knobs: Any) -> list[tuple[str, list[Knob[Any]]]]:
    """Knobs by group, groups in the order of their first knob."""
    found: dict[str, list[Knob[Any]]] = {}
    for knob in knobs:
        found.setdefault(knob.group or "Parameters", []).append(knob)
    return list(found.items())
