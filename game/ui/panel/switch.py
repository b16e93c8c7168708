"""Switches of the panel: a ball that slides in its tray and wears a tick when it is on."""

from __future__ import annotations

from collections.abc import Callable

import pygame

from game.stage import SetParameter, StageEvent, Toggle
from game.ui.look import motion
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc, draw_polygon
from game.ui.panel.rows import Context, Row, Source, draw_changed


class SwitchRow(Row):
    """A switch with its words."""

    height = 32

    def __init__(
        self, context: Context, top: int, label: str, tip: str, is_on: Callable[[], bool],
        changed: Callable[[], bool], wish: Callable[[bool], StageEvent], follows: str = "",
    ) -> None:  # fmt: skip
        self.label, self.tip = label, tip
        self.is_on, self.changed, self.wish = is_on, changed, wish
        self._slide = motion.Fade(0.0 if context.look.less_motion else motion.SEGMENT_S, is_on())
        super().__init__(context, top, follows)

    def advance(self, dt_s: float) -> bool:
        return self._slide.update(dt_s, self.is_on())

    def shows(self) -> tuple[object, ...]:
        return (self.is_on(), self._slide.amount, self.changed())

    def release(self, x: float, y: float) -> None:
        if 0 <= x < self.rect.w and 0 <= y < self.rect.h:
            self.context.send(self.wish(not self.is_on()))

    def key(self, key: int) -> None:
        if key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE):
            self.context.send(self.wish(not self.is_on()))
        elif key in (pygame.K_LEFT, pygame.K_RIGHT) and self.is_on() != (key == pygame.K_RIGHT):
            self.context.send(self.wish(key == pygame.K_RIGHT))

    def paint(self, surface: pygame.Surface) -> None:
        middle = self.rect.h / 2
        draw_switch(surface, self.look, (self.left, round(middle)), self._slide.amount, self._lit.amount)
        color = "text1" if self.is_on() else "text3"
        space = self.right - self.left - self.look.px(44)
        label = self.look.fonts.fit(self.label, 13, "medium", space)
        self.look.text(surface, label, (self.left + self.look.px(44), middle), 13, "medium", color)
        if self.changed():
            draw_changed(surface, self.look, middle)


def toggle_row(context: Context, top: int, parameter: Toggle, source: Source) -> SwitchRow:
    """The switch of a parameter."""
    return SwitchRow(
        context, top, parameter.label, parameter.help,
        is_on=lambda: source.values[parameter.name],
        changed=lambda: source.changed(parameter),
        wish=lambda on: SetParameter(parameter.name, on),
        follows=parameter.name,
    )  # fmt: skip


def draw_switch(
    surface: pygame.Surface, look: Look, left_middle: tuple[int, int], amount: float, lit: float
) -> None:
    """A switch whose ball is ``amount`` of the way to on; a tick shows when it is there."""
    theme, px = look.theme, look.px
    rect = pygame.Rect(left_middle[0], 0, px(32), px(18))
    rect.centery = left_middle[1]
    off = theme.hover.lerp(theme.line2, 0.3 * lit)
    fill = off.lerp(theme.accent, amount)
    edge = theme.line2.lerp(theme.accent, max(amount, 0.6 * lit))
    draw_box(surface, rect, rect.h / 2, fill, edge, look.border)
    radius = 6.8 * look.k
    x = rect.x + rect.h / 2 + amount * (rect.w - rect.h)
    ball = theme.text2.lerp(theme.knob, amount) if theme.name == "dark" else theme.knob
    outline = None if theme.name == "dark" else edge
    draw_disc(surface, (x, rect.y + rect.h / 2), radius, ball, outline)
    if amount > 0.5:
        draw_tick(
            surface,
            (x, rect.y + rect.h / 2),
            0.52 * radius,
            theme.panel if theme.name == "dark" else theme.accent,
        )


def draw_tick(surface: pygame.Surface, center: tuple[float, float], size: float, color: pygame.Color) -> None:
    """A small tick about a centre."""
    x, y = center
    outline = ((-1.0, 0.1), (-0.3, 0.8), (1.0, -0.5), (0.68, -0.82), (-0.3, 0.16), (-0.68, -0.22))
    draw_polygon(surface, [(x + dx * size, y + dy * size) for dx, dy in outline], color)
