"""The sheet of the panel: all its rows in pygame_gui's tree, in coordinates of their own, on one picture.

It is as high as its rows and a little more, for a list that opens at the foot. The picture is drawn again
only when some row has another picture or place.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

import pygame
from pygame_gui.elements import UITextEntryLine

from game.stage import Scene, SetParameter, StageEvent
from game.ui.look.look import Look
from game.ui.look.numerals import NARROW_SPACE, NOTHING, format_si
from game.ui.panel.effects import CostBar, EffectRow
from game.ui.panel.flow import LEVEL, Contents, Flow
from game.ui.panel.manager import DropDown, PanelManager
from game.ui.panel.rows import Caption, Context, Heading, Measure, Row
from game.ui.panel.slider import SliderRow, shown_value
from game.ui.panel.table import HEADER, LegendRow, TableLine
from game.ui.widgets.wishes import Wish

PanelWish = StageEvent | Wish  # what a panel asks for
LIST_ROOM = 8 * 32  # design px below the last row, for an open list
NOWHERE = (-1, -1)
STILL = (Heading, Caption, Measure, CostBar, LegendRow, TableLine)  # rows without a control


class PanelSheet:
    """Rows, drop-downs and the text field of one panel at one width and look."""

    def __init__(
        self, look: Look, width: int, least_height: int, contents: Contents, send: Callable[[PanelWish], None]
    ) -> None:
        self.look = look
        self.contents = contents
        self._send = send
        measured = Flow(look, width, None)
        measured.fill(contents)
        height = max(measured.height, least_height) + look.px(LIST_ROOM)
        self.manager = PanelManager((width, height), look)
        flow = Flow(look, width, Context(self.manager, look, width, send))
        flow.fill(contents)
        self.height = flow.height  # of the rows
        self.rows, self.menus = flow.rows, flow.menus
        self.effects = [row for row in self.rows if isinstance(row, EffectRow)]
        self.picture = pygame.Surface((width, height), 0, 32)
        self._drawn: list[tuple[object, tuple[int, ...]]] = []
        self._field: tuple[SliderRow, UITextEntryLine] | None = None

    def close(self) -> None:
        """Free pygame_gui's elements."""
        self._field = None
        self.manager.clear_and_reset()

    @property
    def reach(self) -> int:
        """Height that can be scrolled over: the rows, and an open list."""
        return max([self.height, *(menu.foot for menu in self.menus.values())])

    @property
    def typing(self) -> bool:
        """Whether a number is being typed."""
        return self._field is not None

    @property
    def has_keys(self) -> bool:
        """Whether a row has the keyboard focus."""
        return any(row.has_keys for row in self.rows)

    @property
    def has_open_list(self) -> bool:
        """Whether some drop-down shows its list."""
        return any(menu.is_open for menu in self.menus.values())

    @property
    def is_held(self) -> bool:
        """Whether some row holds the pointer."""
        return any(row.held for row in self.rows)

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event, inside: bool) -> tuple[int, int] | None:
        """A pointer event in the sheet's coordinates; what of the sheet must be in view after it."""
        if event.type == pygame.MOUSEBUTTONDOWN:
            self.drop_keys()
            if self._field is not None and not self._field[1].rect.collidepoint(event.pos):
                self.commit()
            if not inside and self.has_open_list:
                self.manager.set_focus_set(None)  # closes the list
        self.manager.point(event.pos if inside else NOWHERE)
        if inside or self.is_held:
            self.manager.tell(event)
        return self._follow_up()

    def leave(self) -> None:
        """The pointer or the window's focus is gone: drop what was held."""
        self.manager.point(NOWHERE)
        for row in self.rows:
            row.held = False
            row.cancel()

    def key(self, event: pygame.event.Event) -> tuple[int, int] | None:
        """A key for an open list, the text field, or the row that has the focus."""
        if event.key == pygame.K_ESCAPE and self.has_open_list:
            self.manager.set_focus_set(None)
        elif self._field is None:
            for row in self.rows:
                if row.has_keys and not row.idle:
                    row.key(event.key)
                    return self._follow_up()
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_TAB):
            self.commit()
        elif event.key == pygame.K_ESCAPE:
            self._close_field()
        else:
            self.manager.tell(event)
        return None

    def write(self, event: pygame.event.Event) -> None:
        """Letters for the text field."""
        if self._field is not None:
            self.manager.tell(event)

    def focus_next(self, backward: bool) -> tuple[int, int] | None:
        """Move the keyboard focus to the next control; its top and bottom, or None after the last."""
        rows = [row for row in self.rows if not isinstance(row, STILL) and not row.idle]
        if backward:
            rows.reverse()
        index = next((i for i, row in enumerate(rows) if row.has_keys), -1) + 1
        self.drop_keys()
        if index >= len(rows):
            return None
        rows[index].has_keys = rows[index].stale = True
        return rows[index].rect.top, rows[index].rect.bottom

    def drop_keys(self) -> None:
        """Take the keyboard focus from all rows."""
        for row in self.rows:
            row.stale = row.stale or row.has_keys
            row.has_keys = False

    def _follow_up(self) -> tuple[int, int] | None:
        """Wishes of drop-downs, and the field that a row asks for; an open list must be in view."""
        shown = None
        for name, menu in self.menus.items():
            taken = menu.taken()
            if taken is not None:
                self._send_choice(name, taken)
            if menu.is_open:
                shown = menu.rect.top, menu.foot
        for row in self.rows:
            if isinstance(row, SliderRow) and row.wants_field:
                row.wants_field = False
                self._open_field(row)
        return shown

    def _send_choice(self, name: str, value: str) -> None:
        """Wish what was chosen of a list; the present level, if it is none of the scene's, stays as it is."""
        if name != LEVEL:
            self._send(SetParameter(name, value))
            return
        row = next((row for row in self.contents.levels if str(row.value) == value), None)
        if row is not None:
            self._send(Wish("level", row.value))

    # -- typing -------------------------------------------------------------------------------------

    def _open_field(self, row: SliderRow) -> None:
        """Put a text field over the row's number, all of it chosen."""
        self.commit()
        field = UITextEntryLine(row.field_rect(), self.manager, object_id="#number")
        text = shown_value(row.parameter, row.value).number
        field.set_text(text.replace(NARROW_SPACE, "").replace("−", "-"))
        self.manager.set_focus_set(field.get_focus_set())
        field.select_range = [0, len(field.get_text())]
        field.rebuild()
        row.typed = row.stale = True
        self._field = (row, field)

    def commit(self) -> None:
        """Take over what stands in the field."""
        if self._field is not None:
            row, field = self._field
            text = field.get_text()
            self._close_field()
            if text.strip():
                row.type(text)

    def _close_field(self) -> None:
        if self._field is not None:
            row, field = self._field
            row.typed, row.stale = False, True
            field.kill()
            self._field = None

    # -- time and picture ---------------------------------------------------------------------------

    def is_behind(self) -> bool:
        """Whether a drop-down shows another value than the scene has, so the sheet must be made again."""
        values = self.contents.source.values
        present = self.contents.present_level()
        return any(
            menu.follow(present if name == LEVEL else str(values[name])) for name, menu in self.menus.items()
        )

    def refresh(self, readouts: Sequence[Any]) -> None:
        """New measured numbers and costs."""
        costs, scene = self.contents.costs, self.contents.source.scene
        known = {readout.name: readout for readout in readouts}
        each = [costs.of(effect.name) for effect in scene.effects]
        most = max((cost for cost in each if math.isfinite(cost)), default=0.0)
        for row in self.rows:
            if isinstance(row, Measure) and row.name in known:
                row.value, row.unit = known[row.name].value, known[row.name].unit
            elif isinstance(row, EffectRow):
                row.scale_to(most)
            elif isinstance(row, Heading) and row.title == "Effects":
                row.note = f"{format_si(costs.step, 's')} a step" if math.isfinite(costs.step) else NOTHING
        self._fill_table(scene)
        self.mark_stale()

    def _fill_table(self, scene: Scene) -> None:
        """Take over the scene's table."""
        lines = [row for row in self.rows if isinstance(row, TableLine)]
        table = scene.panel_table() if lines else None
        if table is None:
            return
        for line in lines:
            there = HEADER < line.index < len(table.rows)
            line.row_key = table.keys[line.index] if there else None
            if line.index == HEADER:
                line.cells, line.tip = table.columns, table.help
            else:
                line.cells = table.rows[line.index] if there else ()

    @property
    def pointed(self) -> int | None:
        """Key of the table's row that is under the pointer, if there is one."""
        return next((row.row_key for row in self.rows if isinstance(row, TableLine) and row.hovered), None)

    def mark_stale(self, names: Collection[str] | None = None) -> None:
        """What rows show may have changed: those of the parameters named, or all."""
        for row in self.rows:
            if names is None or row.follows in names:
                row.stale = True

    def set_idle(self, reasons: Mapping[str, str]) -> None:
        """Why parameters change nothing now, by name; the others act."""
        for row in self.rows:
            reason = reasons.get(row.follows, "")
            if row.idle != reason:
                row.idle, row.stale = reason, True
                if row.held and reason:
                    row.held = False
                    row.cancel()
        for name, menu in self.menus.items():
            menu.set_idle(reasons.get(name, ""))

    @property
    def is_quiet(self) -> bool:
        """Whether it is left alone: then rows follow the scene without pygame_gui's turn."""
        return not (self.typing or self.is_held or self.has_keys or self.has_open_list)

    def follow(self, dt_s: float) -> None:
        """Repaint the rows that are stale or move, and draw those alone; for a quiet sheet."""
        for row in self.rows:
            if not (row.stale or row.moves):
                continue
            before = row.image
            row.update(dt_s)
            if row.image is not before:
                self.picture.fill(self.look.theme.panel, row.rect)
                self.picture.blits([row.blit_data])

    def update(self, dt_s: float) -> None:
        """Let controls move on, and draw the sheet again if any picture on it is another or elsewhere."""
        self.manager.update(dt_s)
        pictures = self.manager.pictures()
        same = len(pictures) == len(self._drawn) and all(
            new[0] is old[0] and new[1] == old[1] for new, old in zip(pictures, self._drawn, strict=True)
        )
        if same and self._field is None:
            return
        self._drawn = pictures
        self.picture.fill(self.look.theme.panel)
        self.manager.draw_ui(self.picture)

    def tip_at(self, position: tuple[int, int]) -> tuple[str, pygame.Rect] | None:
        """What the thing at a place is, and where it lies on the sheet."""
        if self.has_open_list:
            return None
        things: tuple[DropDown | Row, ...] = (*self.menus.values(), *self.rows)
        for thing in things:
            named = thing.tip or thing.idle
            if thing.rect.collidepoint(position) and named and not getattr(thing, "held", False):
                words = "\n".join(filter(None, (thing.idle, thing.tip)))
                return words, pygame.Rect(thing.rect)
        return None
