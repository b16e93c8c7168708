"""Everything around a scene's picture: bar, panel, charts, hints, legend, tool tips; laid out, fed, drawn."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import pygame

from game.app.screens.host import Host
from game.app.window.commands import COMMANDS
from game.ui.look.beat import Beat
from game.ui.look.layout import arrange, arrange_over
from game.ui.look.look import Look
from game.ui.look.pace import Pace
from game.ui.panel.card import InspectorCard
from game.ui.panel.toolbar import ToolBar
from game.ui.widgets.hintbar import HintBar
from game.ui.widgets.legend import Legend
from game.ui.widgets.lesson import LessonSheet
from game.ui.widgets.line_field import LineField
from game.ui.widgets.list_row import ListRow
from game.ui.widgets.loading import LoadingCard, draw_shell
from game.ui.widgets.tooltips import ToolTip
from game.ui.widgets.topbar import BarState, TopBar

if TYPE_CHECKING:
    from game.stage import Readout, Scene, Stage, Strip
    from game.stage.catalogue import Entry
    from game.teaching import Teaching
    from game.ui.charts.strips import Strips
    from game.ui.panel.panel import Panel


def _without(strips: Iterable[Strip], hidden: Sequence[str]) -> list[Strip]:
    """Charts without the readouts that are hidden; those of which nothing is left are left out."""
    left = []
    for strip in strips:
        series = tuple(name for name in strip.series if name not in hidden)
        colors = tuple(
            color for name, color in zip(strip.series, strip.colors, strict=False) if name not in hidden
        )
        if series:
            left.append(strip._replace(series=series, colors=colors))
    return left


FOCUS_KEYS = (pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN, pygame.K_RETURN, pygame.K_KP_ENTER)
TYPING_ENDS = (pygame.K_ESCAPE, pygame.K_TAB)
TRANSPORT = ("pause", "step", "step-back")  # their hints come before those of the scene's own


class Shell:
    """The widgets of a scene's screen."""

    def __init__(self, host: Host, entry: Entry):
        self.host = host
        self.entry = entry
        look = host.look
        self.bar = TopBar(look)
        self.hints = HintBar(look)
        self.legend = Legend(look)
        self.tip = ToolTip(look)
        self.beat = Beat()
        self.pace = Pace()
        self.loading = LoadingCard(look)
        self.strips: Strips | None = None
        self.panel: Panel | None = None
        self.lesson = LessonSheet(look)
        self.tools = ToolBar(look)
        self.card = InspectorCard(look)
        self.filming = False
        self.bare = False  # a story is shown as a film: no tools over it
        self._grabbed = False
        self._declared_strips: tuple[Strip, ...] | None = None
        self.place()
        self.hints.show([((host.keys.label("back"),), "back to the menu")])

    def open(self, stage: Stage, levels: Sequence[ListRow]) -> None:
        """The scene is there: make what is built from its declarations."""
        from game.ui.charts.strips import Strips
        from game.ui.panel.panel import Panel

        scene_type = type(stage.scene)
        self.strips = Strips(self.host.look, scene_type.strips)
        self._declared_strips = scene_type.strips
        self.panel = Panel(self.host.look, scene_type, levels)
        self.hints.show(self._hint_rows(stage.scene))
        self.place()

    def _hint_rows(self, scene: Scene) -> list[tuple[tuple[str, ...], str]]:
        label, scene_type = self.host.keys.label, type(scene)
        before: list[tuple[tuple[str, ...], str]] = []
        after: list[tuple[tuple[str, ...], str]] = []
        for command in COMMANDS:
            if command.hint and (command.name != "accuracy" or scene_type.study is not None):
                rows = before if command.name in TRANSPORT else after
                rows.append(((label(command.name),), command.hint))
        own = [(tuple(hint.keys), hint.text) for hint in scene.hints_now()]
        if "wheel" not in scene_type.takes:
            own.append((("Wheel",), "zoom"))
        return before + own + after

    def place(self) -> None:
        """Lay out for the present window, scale and theme."""
        host, look = self.host, self.host.look
        panel = host.settings.panel_in_games if self.entry.roomy else host.settings.panel
        strips = len(self.strips.strips) if self.strips is not None else 3
        picked = self.strips is not None and self.strips.strips != self.strips.declared
        if self.entry.roomy and not panel and not picked:
            self.layout = arrange_over(*host.size, look.k)
        else:
            self.layout = arrange(
                *host.size,
                look.k,
                panel=panel,
                strips=strips,
                tall=self.strips is not None and self.strips.tall,
            )
        self._place_lesson(look)
        self.bar.place(self.layout.top_bar, look, slim=self.layout.overlaid)
        self.hints.place(self.layout.hint_bar, look)
        for widget in (self.legend, self.tip, self.loading):
            widget.place(look)
        if self.strips is not None:
            self.strips.place(self.layout, look)
        if self.panel is not None:
            self.panel.place(self.layout.panel, look)
        self.tools.place(self.layout.free_stage, look)
        self.card.place(self._clear_stage, look)

    def _place_lesson(self, look: Look) -> None:
        """The sheet of a teaching level takes its part of the stage."""
        stage = self.layout.stage
        width = self.lesson.width_in(self.layout.free_stage, look)
        top = self.layout.top_bar.bottom if self.layout.overlaid else stage.y
        bottom = self.layout.hint_bar.y if self.layout.overlaid else stage.bottom
        self.lesson.place(pygame.Rect(stage.x, top, width, max(bottom - top, 0)), look)
        if width:
            rest = pygame.Rect(stage.x + width, stage.y, max(stage.w - width, 1), stage.h)
            self.layout = self.layout._replace(stage=rest)

    def teach(self, teaching: Teaching | None, locked: str) -> None:
        """Another level's task, or none: its sheet, and what it hides."""
        if teaching is None and self.lesson.teaching is None:
            return
        self.lesson.show(teaching, locked)
        if self.strips is not None and self._declared_strips is not None:
            hidden = teaching.hidden_readouts if teaching is not None else []
            gone = teaching is not None and "charts" in teaching.hidden
            self.strips.declare(() if gone else tuple(_without(self._declared_strips, hidden)))
        self.place()

    # -- events -------------------------------------------------------------------------------------

    def wants_key(self, event: pygame.Event) -> bool:
        """Whether a key is for the control that has the keyboard focus, or moves that focus (Shift+Tab)."""
        typed = event.key in TYPING_ENDS or LineField.wants(event)
        if self.card.typing or (self.lesson.typing and typed):
            return True
        panel = self.panel
        if panel is None or not self.layout.panel.w:
            return False
        if event.key == pygame.K_TAB and event.mod & pygame.KMOD_SHIFT:
            return True
        if event.key == pygame.K_ESCAPE and panel.has_open_list:
            return True
        return panel.typing or (panel.has_keys and event.key in FOCUS_KEYS)

    def handle(self, event: pygame.Event) -> tuple[bool, list[Any]]:
        """Whether a widget took the event, and what it asks for: commands and stage events."""
        wishes: list[Any] = []
        if self.panel is not None and self.layout.panel.w:
            wishes += self.panel.handle(event)
        wishes += self.lesson.handle(event)
        wishes += self.card.handle(event)
        asked: list[Any] = [self.bar.handle(event), self.tools.handle(event)]
        asked.append(self.strips.handle(event) if self.strips is not None else None)
        wishes += [wish for wish in asked if wish is not None]
        inside = self._inside_a_widget(event)
        taken = bool(wishes) or inside or self._grabbed
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            self._grabbed = inside  # what was pressed here is not the scene's until it is let go
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._grabbed = False
        return taken, wishes

    def _inside_a_widget(self, event: pygame.Event) -> bool:
        """Whether a mouse event belongs to what lies beside or over the stage."""
        position = getattr(event, "pos", None)
        if position is None:
            return False
        if self.tools.covers(position) or self.card.covers(position):
            return True
        if self.layout.overlaid:
            if self.lesson.rect.collidepoint(position):
                return True
            return self.bar.covers(position) or self.layout.hint_bar.collidepoint(position)
        return not self.layout.stage.collidepoint(position) or bool(
            self.layout.drawer and self.layout.panel.collidepoint(position)
        )

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, elapsed_s: float, stage: Stage | None, costs: Any) -> None:
        """Let time pass and show what the stage is like now."""
        step, still = (stage.step_number, stage.paused) if stage is not None else (0, True)
        fresh = self.beat.pass_time(elapsed_s, step, still)
        if stage is not None:
            self.pace.pass_time(elapsed_s, stage)
        self.bar.update(elapsed_s, self._bar_state(stage, fresh), fresh)
        self.hints.update(elapsed_s)
        self.lesson.update(elapsed_s)
        if stage is not None and fresh:
            self.hints.show(self._hint_rows(stage.scene))
        if stage is not None and self.panel is not None and self.strips is not None:
            self.panel.update(elapsed_s, stage, costs, fresh)
            self.strips.update(elapsed_s, stage, fresh)
        self.tools.show(stage.scene.tool_bar() if stage is not None and not self.bare else ())
        self.tools.update(elapsed_s)
        self.card.update(elapsed_s, stage.scene if stage is not None and not self.bare else None)
        widgets = (self.bar, self.panel, self.lesson, self.strips, self.tools, self.card)
        tips = (widget.tip() for widget in widgets if widget is not None)
        self.tip.update(elapsed_s, next((about for about in tips if about is not None), None))

    def shown(self, stage: Stage) -> list[Readout]:
        """The readouts that may be seen."""
        level = stage.level
        hidden = level.teaching.hidden_readouts if level is not None and level.teaching is not None else ()
        return [one for one in stage.readouts() if one.name not in hidden]

    def rest(self, elapsed_s: float) -> None:
        """Let time pass for bar and hints alone: the scene cannot be asked for what the others show."""
        self.bar.update(elapsed_s, self.bar.state._replace(paused=True, ready=True), False)
        self.hints.update(elapsed_s)
        self.tip.update(elapsed_s, self.bar.tip())

    def _bar_state(self, stage: Stage | None, measured: bool) -> BarState:
        """What the bar shows; ``measured``: with new numbers, which cost as much as some scenes' step."""
        panel = bool(self.layout.panel.w)
        frame = ("frame", self.host.meter.median_s, "s")
        if stage is None:
            empty = (("time", 0.0, "s"), ("step", 0.0, "s"), frame)
            return BarState(self.entry.task, self.entry.title, True, 1.0, panel, empty, ready=False)
        readouts = self.bar.state.readouts
        if measured or not self.bar.state.ready:
            own = tuple((r.name, r.value, r.unit) for r in tuple(self.shown(stage))[:1])
            readouts = (("time", stage.time_s, "s"), *own, ("step", stage.step_cost_s, "s"), frame)
        return BarState(
            self.entry.task, self.entry.title, stage.still, stage.speed, panel, readouts,
            reached=self.pace.speed, filming=self.filming,
        )  # fmt: skip

    @property
    def _clear_stage(self) -> pygame.Rect:
        """The part of the stage that the bar, with its way back, does not lie over."""
        stage = pygame.Rect(self.layout.free_stage)
        if self.layout.overlaid:
            top = self.layout.top_bar.bottom
            stage.y, stage.h = top, max(stage.bottom - top, 0)
        return stage

    def draw(self, surface: pygame.Surface, stage: Stage, legend: Iterable[tuple[str, str, str]]) -> None:
        """Draw the widgets round and over the picture of the scene."""
        self.lesson.draw(surface)
        hidden = self.lesson.teaching is not None and "legend" in self.lesson.teaching.hidden
        if not hidden and not (stage.scene.legend_in_panel and self.layout.panel.w):
            self.legend.draw(surface, self._clear_stage, tuple(legend), self.beat.fresh)
        self.tools.draw(surface)
        self.card.draw(surface)
        if self.strips is not None:
            self.strips.draw(surface)
        self.draw_foot(surface)
        if self.panel is not None:
            self.panel.draw(surface)
        self.bar.draw(surface)
        self.tip.draw(surface)

    def draw_foot(self, surface: pygame.Surface) -> None:
        """The row of hints, cut where a message stands."""
        row = self.layout.hint_bar
        taken = self.host.toasts.width(row.w)
        self.hints.draw(surface, row.w - taken - self.host.look.px(16) if taken else None)

    def draw_loading(self, surface: pygame.Surface, done: int, total: int, name: str, seconds: float) -> None:
        """The shell before there is a scene, ``seconds`` after the beginning: ``done`` of ``total`` kernels.

        ``name``: of the kernel that is being compiled.
        """
        draw_shell(surface, self.layout, self.host.look)
        self.loading.draw(
            surface,
            self.layout.free_stage,
            self.entry.title,
            done,
            total,
            name,
            seconds,
        )
        self.draw_foot(surface)
        self.bar.draw(surface)
