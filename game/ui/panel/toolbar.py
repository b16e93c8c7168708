"""The bar of tools on the stage: a sign for each, lit while it is in the hand, with its key beside it."""

from __future__ import annotations

from collections.abc import Sequence

import pygame

from game.stage import Action, ToolButton
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.keycap import key_name

CELL, SIGN, INSET, APART, MARGIN = 34, 20, 4, 9, 10  # design px
OPACITY = 0.96


class ToolBar:
    """Buttons in rows at the foot of the stage, in its middle; nothing where a scene has none."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.buttons: tuple[ToolButton, ...] = ()
        self.spots = Hotspots()
        self._stage = pygame.Rect(0, 0, 0, 0)
        self._shown: tuple[object, ...] = ()
        self._picture: pygame.Surface | None = None

    def place(self, stage: pygame.Rect, look: Look) -> None:
        """Take a part of the window and an appearance."""
        self.look, self._stage = look, pygame.Rect(stage)
        self._lay_out()

    def show(self, buttons: Sequence[ToolButton]) -> None:
        """The tools that there are now, and which of them is in the hand."""
        buttons = tuple(buttons)
        if buttons != self.buttons:
            others = [one.action for one in buttons] != [one.action for one in self.buttons]
            self.buttons = buttons
            if others:
                self._lay_out()

    def handle(self, event: pygame.Event) -> Action | None:
        """Follow the pointer; the action of the tool that was pressed."""
        if not self.buttons or event.type == pygame.KEYDOWN:
            return None
        name = self.spots.handle(event)
        return Action(name) if name is not None else None

    def covers(self, position: tuple[int, int]) -> bool:
        """Whether a place in the window is on the bar."""
        return bool(self.buttons) and bool(self.rect.collidepoint(position))

    def update(self, dt_s: float) -> None:
        """Let hover lights move on."""
        self.spots.update(dt_s, self.look)

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """What the tool under the pointer does, its key, and where it is."""
        spot = self.spots.find(self.spots.hovered) if self.spots.hovered and self.buttons else None
        return (spot.tip, spot.rect) if spot is not None else None

    def draw(self, surface: pygame.Surface) -> None:
        """Show it, painted again only when something on it has changed."""
        if not self.buttons or not self.rect.w:
            return
        shown = (self.buttons, self.spots.state(), self.look.theme.name, self.rect.size)
        if self._picture is None or shown != self._shown:
            self._shown, self._picture = shown, self._paint()
        surface.blit(self._picture, self.rect)

    def _rows(self) -> list[list[ToolButton]]:
        """Buttons in as few rows as the stage is wide enough for; a group is not torn while it fits."""
        room = self._stage.w - 2 * self.look.px(MARGIN + INSET)
        groups: list[list[ToolButton]] = []
        for button in self.buttons:
            if button.apart or not groups:
                groups.append([])
            groups[-1].append(button)
        rows: list[list[ToolButton]] = [[]]
        for group in groups:
            if rows[-1] and self._width([*rows[-1], *group]) > room:
                rows.append([])
            for button in group:
                if rows[-1] and self._width([*rows[-1], button]) > room:
                    rows.append([])
                rows[-1].append(button)
        return rows

    def _width(self, row: Sequence[ToolButton]) -> int:
        return len(row) * self.look.px(CELL) + self.look.px(APART) * sum(one.apart for one in row[1:])

    def _lay_out(self) -> None:
        px, self._picture = self.look.px, None
        rows = self._rows()
        width = max(self._width(row) for row in rows) + 2 * px(INSET)
        self.rect = pygame.Rect(0, 0, width, len(rows) * px(CELL) + 2 * px(INSET))
        self.rect.midbottom = self._stage.centerx, self._stage.bottom - px(MARGIN)
        if not self.buttons or self.rect.h > self._stage.h // 2:
            self.rect.size = (0, 0)
            self.spots.place(())
            return
        spots = []
        for number, row in enumerate(rows):
            x = self.rect.centerx - self._width(row) // 2
            for k, button in enumerate(row):
                x += px(APART) if button.apart and k else 0
                rect = pygame.Rect(x, self.rect.y + px(INSET) + number * px(CELL), px(CELL), px(CELL))
                spots.append(Hotspot(button.action, rect, tip=_tip(button)))
                x += px(CELL)
        self.spots.place(spots)

    def _paint(self) -> pygame.Surface:
        look, px = self.look, self.look.px
        theme = look.theme
        picture = pygame.Surface(self.rect.size, pygame.SRCALPHA, 32)
        draw_box(picture, picture.get_rect(), px(10), theme.panel, theme.line, look.border)
        for button in self.buttons:
            spot = self.spots.find(button.action)
            if spot is None:
                continue
            cell = spot.rect.move(-self.rect.x, -self.rect.y).inflate(-2 * px(1), -2 * px(1))
            lit = self.spots.hover(button.action)
            ink = theme.text1.lerp(theme.text2, 1.0 - lit)
            if button.chosen:
                draw_box(picture, cell, px(7), theme.accent)
                ink = theme.on_accent
            elif lit > 0.0 or self.spots.pressed == button.action:
                pressed = self.spots.pressed == button.action
                draw_box(picture, cell, px(7), theme.line2 if pressed else theme.panel.lerp(theme.hover, lit))
            sign = icon(button.icon, px(SIGN), ink)
            picture.blit(sign, sign.get_rect(center=(cell.centerx - px(2), cell.centery - px(1))))
            if button.key:
                at = (cell.right - px(3), cell.bottom - px(6))
                color = theme.on_accent if button.chosen else theme.text3
                look.text(picture, key_name(button.key), at, 11, "semibold", color, "right")
        picture.set_alpha(round(255 * OPACITY))
        return picture


def _tip(button: ToolButton) -> str:
    return f"{button.label} ({key_name(button.key)})" if button.key else button.label
