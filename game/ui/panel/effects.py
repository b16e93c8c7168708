"""The effects of a scene in the panel: a switch for each, and what each costs a step.

Above them lies one bar: the bare step in grey, a part for each effect that is on, a hollow one for each
that is off. Costs are measured by the stage; until they are known a dash stands for them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pygame

from game.stage import SetEffect
from game.ui.look.numerals import NOTHING, format_si
from game.ui.look.shapes import draw_box
from game.ui.panel.rows import Context, Row, Source, effect_key
from game.ui.panel.switch import SwitchRow

COLORS = ("chalk", "pink", "violet", "green", "yellow", "vermilion")
FREE = "≈ 0"  # no cost that exceeds the noise
BAR = 150  # design px from the left to the bar; the name has the space between switch and bar


class EffectCosts:
    """Seconds per step: of each effect by name, of the step without any, and of the step as it runs."""

    def __init__(self) -> None:
        self.costs: Mapping[str, float] = {}
        self.bare = math.nan
        self.step = math.nan

    def of(self, name: str) -> float:
        """Cost of an effect, 0 if none could be measured; nan if it is not known."""
        cost = self.costs.get(name, math.nan)
        return max(cost, 0.0) if math.isfinite(cost) else math.nan


class EffectRow(SwitchRow):
    """Switch, name, bar and cost of one effect."""

    def __init__(
        self, context: Context, top: int, source: Source, effect: Any, color: str, costs: EffectCosts
    ) -> None:
        self.effect, self.color, self.costs = effect, color, costs
        self._most = [math.nan]
        super().__init__(
            context, top, effect.label, effect.help,
            is_on=lambda: effect in source.scene.active,
            changed=lambda: False,
            wish=lambda on: SetEffect(effect.name, on),
            follows=effect_key(effect.name),
        )  # fmt: skip

    def scale_to(self, most: float) -> None:
        """The cost that fills a bar."""
        self._most[0] = most

    def shows(self) -> tuple[object, ...]:
        return (*super().shows(), _text(self.costs.of(self.effect.name), self.is_on()), self._width())

    def _width(self) -> int:
        cost, most = self.costs.of(self.effect.name), self._most[0]
        if not (math.isfinite(cost) and most > 0.0):
            return 0
        return 0 if cost == 0.0 else max(self.look.px(3), round(64 * self.look.k * min(cost / most, 1.0)))

    def paint(self, surface: pygame.Surface) -> None:
        super().paint(surface)
        look, px, on = self.look, self.look.px, self.is_on()
        middle = self.rect.h / 2
        words = _text(self.costs.of(self.effect.name), on)
        left = self.left + px(BAR)
        surface.fill(look.theme.panel, (left - px(4), 0, self.right - left + px(4), self.rect.h))
        bar = pygame.Rect(left, round(middle) - px(2), self._width(), px(4))
        if bar.w:
            if on:
                draw_box(surface, bar, px(2), look.color(self.color))
            else:
                draw_box(surface, bar.inflate(0, px(1)), px(2), None, look.theme.line2, look.border)
        weight, color = ("semibold", "text1") if on else ("medium", "text3")
        look.text(surface, words, (self.right, middle), 13, weight, color, "right")


def _text(cost: float, on: bool) -> str:
    if not math.isfinite(cost):
        return NOTHING
    if cost == 0.0:
        return FREE
    words = format_si(cost, "s")
    return words if on else f"+ {words}"


class CostBar(Row):
    """All costs of a step side by side."""

    height = 16

    def __init__(self, context: Context, top: int, source: Source, costs: EffectCosts) -> None:
        self.source, self.costs = source, costs
        self.tip = "Time of a step: grey without any effect, then each effect, hollow those that are off"
        super().__init__(context, top)

    def _parts(self) -> list[tuple[float, str, bool]]:
        """(cost, colour, on): the bare step, effects that are on, effects that are off."""
        parts = [(max(self.costs.bare, 0.0), "ghost", True)]
        effects = list(enumerate(self.source.scene.effects))
        for wanted in (True, False):
            for i, effect in effects:
                if (effect in self.source.scene.active) == wanted:
                    parts.append((self.costs.of(effect.name), COLORS[i % len(COLORS)], wanted))
        return [part for part in parts if part[0] > 0.0]

    def _widths(self) -> list[tuple[int, str, bool]]:
        parts, gap = self._parts(), self.look.px(2)
        total = sum(cost for cost, _, _ in parts)
        space = self.right - self.left - gap * max(len(parts) - 1, 0)
        if not total > 0.0 or not math.isfinite(self.costs.bare):
            return []
        return [(max(1, int(space * cost / total)), color, on) for cost, color, on in parts]

    def shows(self) -> tuple[object, ...]:
        return tuple(self._widths())

    def paint(self, surface: pygame.Surface) -> None:
        look, px, x = self.look, self.look.px, self.left
        parts = self._widths()
        if not parts:
            draw_box(surface, pygame.Rect(x, 0, self.right - x, px(8)), px(2), look.theme.inset)
        for width, color, on in parts:
            rect = pygame.Rect(x, 0, width, px(8))
            if on:
                draw_box(surface, rect, px(2), look.color(color))
            else:
                draw_box(surface, rect, px(1), None, look.theme.line2, look.border)
            x += width + px(2)
