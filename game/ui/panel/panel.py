"""The panel at the right of a scene, from its declarations: level, parameters by group, effects, measures.

Values come from the scene and go to it as stage events only. So a change from elsewhere (replay, step back, a
level) shows at once. Scrolling moves the sheet of rows behind the panel's window; the foot stays.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pygame

from game.physics.effects import EffectSet
from game.stage import Scene, Stage
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.panel.effects import EffectCosts
from game.ui.panel.flow import Contents, hidden_of
from game.ui.panel.foot import PanelFoot
from game.ui.panel.rows import PADDING, Source
from game.ui.panel.sheet import NOWHERE, PanelSheet, PanelWish
from game.ui.widgets.list_row import ListRow

FOOT, WHEEL = 64, 40  # design px
READOUTS_IN_BAR = 1  # of a scene's readouts, those that the top bar shows
UNREST_S = 0.2  # s that controls go on moving after a change
_POINTER = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)


class Panel:
    """A scene's controls. ``levels``: rows with ``title`` and ``value`` (a path), or nothing.

    ``meter`` in ``update`` says what effects cost: ``.costs`` by name and ``.bare``, s a step.
    """

    def __init__(self, look: Look, scene_type: type[Scene], levels: Sequence[ListRow] = ()) -> None:
        self.look = look
        self.levels = tuple(levels)
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.foot = PanelFoot(look, scene_type.study is not None)
        self.scroll = 0
        self._contents: Contents | None = None
        self._sheet: PanelSheet | None = None
        self._wishes: list[PanelWish] = []
        self._pointer = NOWHERE
        self._thumb_grip: int | None = None
        self._seen: tuple[dict[str, Any], EffectSet] | None = (
            None  # values of the parameters, effects that are on
        )
        self._idle: dict[str, str] = {}  # why parameters change nothing now
        self._unmeasured = True
        self._unrest_s = UNREST_S  # time left until all that moves has come to rest

    def place(self, rect: pygame.Rect, look: Look) -> None:
        """Take a place in the window and an appearance."""
        again = look is not self.look or rect.size != self.rect.size
        self.look, self.rect = look, pygame.Rect(rect)
        self.foot.place(pygame.Rect(rect.x, rect.bottom - look.px(FOOT), rect.w, look.px(FOOT)), look)
        if again:
            self._build()

    def offer(self, levels: Sequence[ListRow]) -> None:
        """The levels that there are to choose from now."""
        if tuple(levels) == self.levels:
            return
        self.levels = tuple(levels)
        if self._contents is not None:
            self._contents = self._contents._replace(levels=self.levels)
            self._build()

    def close(self) -> None:
        """The scene is left: free pygame_gui's elements."""
        if self._sheet is not None:
            self._sheet.close()
            self._sheet = None

    @property
    def typing(self) -> bool:
        """Whether a number is being typed, so that keys are letters."""
        return self._sheet is not None and self._sheet.typing

    @property
    def has_keys(self) -> bool:
        """Whether a control has the keyboard focus, so that arrows, Enter and Space are for it."""
        return self._sheet is not None and self._sheet.has_keys

    @property
    def has_open_list(self) -> bool:
        """Whether a drop-down shows its list, so that Esc closes it."""
        return self._sheet is not None and self._sheet.has_open_list

    @property
    def shows_effects(self) -> bool:
        """Whether the row of an effect is in view, so that what it costs is wanted."""
        if self._sheet is None or not (self.rect.w and self.view.h):
            return False
        seen = pygame.Rect(0, self.scroll, self.rect.w, self.view.h)
        return any(row.rect.colliderect(seen) for row in self._sheet.effects)

    @property
    def view(self) -> pygame.Rect:
        """The part of the window in which the sheet is seen."""
        return pygame.Rect(self.rect.x, self.rect.y, self.rect.w, max(0, self.rect.h - self.look.px(FOOT)))

    def _build(self) -> None:
        """Make the sheet for the present contents, place and appearance."""
        self.close()
        if self._contents is None or self.rect.w < self.look.px(80) or self.view.h < 1:
            return
        self._sheet = PanelSheet(self.look, self.rect.w, self.view.h, self._contents, self._wishes.append)
        self._sheet.set_idle(self._idle)
        self._unrest_s = UNREST_S
        self._unmeasured = True
        self._scroll_to(self.scroll)

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> list[PanelWish]:
        """Let an event act; the stage events and commands that it makes."""
        sheet = self._sheet
        if sheet is None or self.rect.w == 0:
            return []
        command = self.foot.handle(event)
        if command is not None:
            sheet.commit()
            self._wishes.append(command)
        elif event.type in _POINTER:
            self._handle_pointer(sheet, event)
        elif event.type == pygame.MOUSEWHEEL:
            if self.view.collidepoint(self._pointer):
                self._scroll_to(self.scroll - round(event.y * WHEEL * self.look.k))
        elif event.type in (pygame.WINDOWLEAVE, pygame.WINDOWFOCUSLOST):
            self._pointer, self._thumb_grip = NOWHERE, None
            sheet.leave()
            self._unrest_s = UNREST_S
        elif event.type == pygame.KEYDOWN:
            self._reveal(sheet.key(event))
            self._unrest_s = UNREST_S
        elif event.type == pygame.TEXTINPUT:
            sheet.write(event)
        wishes, self._wishes[:] = list(self._wishes), []
        return wishes

    def _handle_pointer(self, sheet: PanelSheet, event: pygame.event.Event) -> None:
        """A pointer event, told to the sheet in its own coordinates."""
        inside = self.view.collidepoint(event.pos)
        if inside or self.view.collidepoint(self._pointer) or event.type != pygame.MOUSEMOTION:
            self._unrest_s = UNREST_S
        self._pointer = event.pos
        if not self._drag_thumb(event):
            moved = pygame.event.Event(event.type, {**event.dict, "pos": self._on_sheet(event.pos)})
            self._reveal(sheet.handle(moved, inside))

    def _on_sheet(self, position: tuple[int, int]) -> tuple[int, int]:
        return position[0] - self.rect.x, position[1] - self.rect.y + self.scroll

    def _drag_thumb(self, event: pygame.event.Event) -> bool:
        """Scrolling by the thumb at the right edge; True if the event was for it."""
        thumb = self._thumb()
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1 and thumb is not None:
            if thumb.inflate(self.look.px(8), 0).collidepoint(event.pos):
                self._thumb_grip = event.pos[1] - thumb.y
                return True
        elif event.type == pygame.MOUSEBUTTONUP and self._thumb_grip is not None:
            self._thumb_grip = None
            return True
        if self._thumb_grip is None or thumb is None or event.type != pygame.MOUSEMOTION:
            return False
        share = (event.pos[1] - self._thumb_grip - self.view.y) / max(self.view.h - thumb.h, 1)
        self._scroll_to(round(share * (self._reach() - self.view.h)))
        return True

    def focus_next(self, backward: bool = False) -> bool:
        """Move the keyboard focus to the next control; False when there is none left."""
        shown = self._sheet.focus_next(backward) if self._sheet is not None else None
        self._reveal(shown)
        self._unrest_s = UNREST_S
        return shown is not None

    # -- time ---------------------------------------------------------------------------------------

    def update(self, dt_s: float, stage: Stage, meter: Any = None, fresh: bool = True) -> None:
        """Follow the scene: its values at once, measured numbers if they are ``fresh``."""
        self.foot.update(dt_s)
        if self._contents is None:
            self._contents = Contents(
                Source(stage.scene),
                self.levels,
                _measures(stage),
                EffectCosts(),
                *_beside(stage.scene),
                hidden=hidden_of(stage.scene),
            )
            self._build()
        contents = self._contents
        contents.source.scene = stage.scene
        shown = (_measures(stage), *_beside(stage.scene)) if fresh else None
        hidden = hidden_of(stage.scene)
        if hidden != contents.hidden:
            self._contents = contents = contents._replace(hidden=hidden, measures=_measures(stage))
            self._build()
        elif shown is not None and shown != (contents.measures, contents.legend, contents.table):
            measures, legend, table = shown
            self._contents = contents = contents._replace(measures=measures, legend=legend, table=table)
            self._build()
        elif self._sheet is not None and self._sheet.is_behind():
            self._build()
        if self._sheet is None:
            stage.scene.point_at(None)
            return
        if fresh or self._unmeasured:
            self._unmeasured = False
            if meter is not None:
                contents.costs.costs, contents.costs.bare = dict(meter.costs), meter.bare
            contents.costs.step = stage.step_cost_s
            self._sheet.refresh(stage.readouts())
        self._see(self._sheet, stage.scene)
        stage.scene.point_at(self._sheet.pointed)
        if self._unrest_s > 0.0 or not self._sheet.is_quiet:
            self._sheet.update(dt_s)
        else:
            self._sheet.follow(dt_s)
        self._unrest_s -= dt_s

    def _see(self, sheet: PanelSheet, scene: Scene) -> None:
        """Mark the rows of what has changed in the scene since the last look."""
        idle = Source(scene).idle()
        if idle != self._idle:
            self._idle = idle
            sheet.set_idle(idle)
            self._unrest_s = UNREST_S
        values, active = dict(scene.values), scene.active
        before, self._seen = self._seen, (values, active)
        if before is None or before[0].keys() != values.keys() or before[1] != active:
            sheet.mark_stale()
        elif before[0] != values:
            sheet.mark_stale({name for name, value in values.items() if before[0][name] != value})

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """What the thing under the pointer is, and where it is in the window."""
        if self._sheet is None or not self.view.collidepoint(self._pointer):
            return self.foot.tip()
        found = self._sheet.tip_at(self._on_sheet(self._pointer))
        if found is None:
            return None
        place = found[1].move(self.rect.x, self.rect.y - self.scroll)
        return found[0], place.inflate(-2 * self.look.px(PADDING), 0)

    # -- scrolling and picture ----------------------------------------------------------------------

    def _reach(self) -> int:
        return self._sheet.reach if self._sheet is not None else 0

    def _scroll_to(self, y: int) -> None:
        self.scroll = min(max(y, 0), max(0, self._reach() - self.view.h))

    def _reveal(self, part: tuple[int, int] | None) -> None:
        """Scroll as little as shows a part of the sheet, given by top and bottom."""
        if part is not None:
            top, bottom = part
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
        if self._sheet is None:
            surface.fill(theme.panel, self.rect)
        else:
            self._scroll_to(self.scroll)
            surface.blit(self._sheet.picture, view, pygame.Rect(0, self.scroll, view.w, view.h))
            thumb = self._thumb()
            if thumb is not None:
                lit = theme.text3 if self._thumb_grip is not None else theme.line2
                draw_box(surface, thumb, thumb.w / 2, lit)
        self.foot.draw(surface, self._reach() > view.h + self.scroll)
        surface.fill(theme.line, (self.rect.x, self.rect.y, self.look.border, self.rect.h))


def _beside(scene: Scene) -> tuple[tuple[str, ...], tuple[str, int] | None]:
    """Words of the legend's rows, if it stands in the panel, and title and capacity of the table."""
    table = scene.panel_table()
    legend = tuple(words for _, words, _ in scene.legend()) if scene.legend_in_panel else ()
    return legend, (table.title, table.room) if table is not None else None


def _measures(stage: Stage) -> tuple[str, ...]:
    """Names of the readouts that the top bar has no space for."""
    level, names = stage.level, [readout.name for readout in stage.readouts()]
    hidden = level.teaching.hidden_readouts if level is not None and level.teaching is not None else ()
    return tuple(name for name in names[READOUTS_IN_BAR:] if name not in hidden)
