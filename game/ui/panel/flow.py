"""Which control stands for which parameter, and where: rows below each other from a scene's declarations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import pygame

from game.stage import Choice, Param, Parameter, Scene, Toggle
from game.ui.look.look import Look
from game.ui.panel.effects import COLORS, CostBar, EffectCosts, EffectRow
from game.ui.panel.manager import DropDown, PanelManager
from game.ui.panel.rows import (
    PADDING,
    Caption,
    Context,
    Heading,
    Measure,
    Row,
    SegmentsRow,
    Source,
    fits_in_segments,
)
from game.ui.panel.slider import SliderRow
from game.ui.panel.switch import toggle_row
from game.ui.panel.table import HEADER, LegendRow, TableLine
from game.ui.widgets.list_row import ListRow

UNGROUPED = "Parameters"
LEVEL = ""  # name of the drop-down of levels
UNTITLED = "No level"


class Contents(NamedTuple):
    """What a panel shows: scene, levels (rows with ``title`` and ``value``), names of measures, costs, and
    what stands of legend and table."""

    source: Source
    levels: tuple[ListRow, ...]
    measures: tuple[str, ...]
    costs: EffectCosts
    legend: tuple[str, ...] = ()  # words of the rows, for a scene that has its legend here
    table: tuple[str, int] | None = None  # title and capacity of the scene's table
    hidden: tuple[str, ...] = ()  # parts and parameters that the level hides: see `hidden_of`
    only: tuple[str, ...] = ()  # parameters of a card on the stage; none: those of the panel

    def present_level(self) -> str:
        """Path of the level that the scene was made from, as the drop-down knows it."""
        level = self.source.scene.level
        return str(level.path or "") if level is not None else ""

    def level_tip(self) -> str:
        """What the present level is, in all its words."""
        level = self.source.scene.level
        return "\n".join(filter(None, (level.title, level.about))) if level is not None else "Level"

    def level_options(self) -> list[tuple[str, str]]:
        """Title and path of each level; first the present one, if it is none of them."""
        options = [(row.title, str(row.value)) for row in self.levels]
        present, level = self.present_level(), self.source.scene.level
        if any(value == present for _, value in options):
            return options
        return [((level.title if level is not None else "") or UNTITLED, present), *options]


def hidden_of(scene: Scene) -> tuple[str, ...]:
    """Parts of the panel that the scene's level hides, and parameters as "parameter NAME"."""
    level = scene.level
    if level is None or level.teaching is None:
        return ()
    return (*level.teaching.hidden, *(f"parameter {name}" for name in level.teaching.hidden_parameters))


class Flow:
    """Puts rows below each other; without a context it only measures."""

    def __init__(self, look: Look, width: int, context: Context | None) -> None:
        self.look, self.width, self.context = look, width, context
        self.height = 0
        self.rows: list[Row] = []
        self.menus: dict[str, DropDown] = {}

    def fill(self, contents: Contents) -> None:
        """All rows of a panel, from the levels to the measures."""
        source = contents.source
        hidden = contents.hidden
        if contents.levels and "levels" not in hidden:
            self.space(16)
            self._menu(LEVEL, contents.level_options(), contents.present_level(), contents.level_tip())
            self.space(8)
        for index in range(len(contents.legend) if "legend" not in hidden else 0):
            self._row(LegendRow, source, index)
        if contents.table is not None and "table" not in hidden:
            title, space = contents.table
            self._row(Heading, title)
            for index in range(HEADER, space):
                self._row(TableLine, index)
        parameters = source.scene.declared_parameters().values()
        only = contents.only
        chosen = [one for one in parameters if (one.name in only if only else one.in_panel)]
        shown = [one for one in chosen if f"parameter {one.name}" not in hidden]
        for title, declared in grouped(shown) if "parameters" not in hidden else ():
            if not only:  # a card has a title of its own
                self._row(Heading, title)
            for parameter in declared:
                self._parameter(parameter, title, source)
        effects = tuple(source.scene.effects)
        if effects and "effects" not in hidden:
            self._row(Heading, "Effects")
            self._row(CostBar, source, contents.costs)
            for i, effect in enumerate(effects):
                self._row(EffectRow, source, effect, COLORS[i % len(COLORS)], contents.costs)
        if contents.measures and "measured" not in hidden:
            self._row(Heading, "Measured")
            for name in contents.measures:
                self._row(Measure, name)
        self.space(8)

    def space(self, design_px: float) -> None:
        """Leave space."""
        self.height += self.look.px(design_px)

    def _row(self, kind: type[Row], *arguments: Any) -> None:
        if self.context is not None:
            self.rows.append(kind(self.context, self.height, *arguments))
        self.space(kind.height)

    def _menu(self, name: str, options: Sequence[tuple[str, str]], chosen: str, tip: str) -> None:
        px = self.look.px
        if self.context is not None:
            width = self.width - 2 * px(PADDING)
            rect = pygame.Rect(px(PADDING), self.height, width, px(32))
            fitted = [
                (self.look.fonts.fit(label, 13, "medium", width - px(48)), value) for label, value in options
            ]
            manager = self.context.manager
            assert isinstance(manager, PanelManager)
            self.menus[name] = DropDown(fitted, chosen, rect, manager, tip)
        self.space(32)

    def _parameter(self, parameter: Parameter[Any], group: str, source: Source) -> None:
        """The control that suits a parameter."""
        if isinstance(parameter, Param):
            self._row(SliderRow, parameter, source)
        elif isinstance(parameter, Toggle):
            if self.context is not None:
                self.rows.append(toggle_row(self.context, self.height, parameter, source))
            self.space(32)
        elif isinstance(parameter, Choice):
            if parameter.label != group:
                self._row(Caption, parameter, source)
            if fits_in_segments(self.look, parameter, self.width):
                self._row(SegmentsRow, parameter, source)
            else:
                options = list(zip(parameter.labels, parameter.options, strict=True))
                self._menu(parameter.name, options, source.values[parameter.name], parameter.help)
                self.space(8)


def grouped(declared: Iterable[Parameter[Any]]) -> list[tuple[str, list[Parameter[Any]]]]:
    """Parameters by group, groups in the order of their first parameter."""
    found: dict[str, list[Parameter[Any]]] = {}
    for parameter in declared:
        found.setdefault(parameter.group or UNGROUPED, []).append(parameter)
    return list(found.items())
