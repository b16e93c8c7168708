"""A card with a list to choose from: levels, files to open, what to do in a pause."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, ClassVar

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.widgets.hotspots import Hotspot
from game.ui.widgets.list_row import ListRow

ROW, ROW_GAP, WHEEL_ROWS = 52, 4, 2  # design px; rows for a notch
LINE = 16  # design px that a second line of words takes


class ChoiceCard(CardScreen):
    """Rows under a title; ``chosen`` is called with the value of the one taken, and the card goes."""

    called: ClassVar[str] = "The list"
    width = 720.0

    def __init__(
        self,
        host: Host,
        heading: str,
        rows: Sequence[ListRow],
        chosen: Callable[[Any], object],
        present: Any = None,
    ):
        self._heading = heading
        self.rows = tuple(rows)
        self._chosen = chosen
        self._present = present
        self._first = 0
        self.focus = next((i for i, row in enumerate(self.rows) if row.value == present), 0)
        super().__init__(host)
        self._row = ROW + (LINE if any(len(self.lines(row)) > 1 for row in self.rows) else 0)
        wanted = HEAD + len(self.rows) * (self._row + ROW_GAP) + 24
        self.veil.size = (self.width, min(max(wanted, 160), 640))
        self.restyle()

    @property
    def heading(self) -> str:
        return self._heading

    @property
    def _fits(self) -> int:
        """Rows that there is space for."""
        look = self.host.look
        return max(1, (self.veil.card.h - look.px(HEAD) - look.px(16)) // look.px(self._row + ROW_GAP))

    def places(self) -> list[Hotspot]:
        self._first = min(max(self._first, self.focus - self._fits + 1, 0), max(self.focus, 0))
        self._first = max(0, min(self._first, len(self.rows) - self._fits))
        px, card = self.host.look.px, self.veil.card
        spots = []
        for i in range(self._first, min(self._first + self._fits, len(self.rows))):
            y = card.y + px(HEAD) + (i - self._first) * px(self._row + ROW_GAP)
            spots.append(Hotspot(f"row-{i}", pygame.Rect(card.x + px(24), y, card.w - px(48), px(self._row))))
        return spots

    def state(self) -> object:
        return self.focus, self._first

    def handle(self, event: pygame.Event) -> None:
        step = 0
        if event.type == pygame.KEYDOWN:
            step = self._steps().get(event.key, 0)
            if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER) and self.rows and not self.leaving:
                self.pressed(f"row-{self.focus}")
                return
        elif event.type == pygame.MOUSEWHEEL:
            step = -WHEEL_ROWS * event.y
        if step and self.rows:
            self.focus = min(max(self.focus + step, 0), len(self.rows) - 1)
            self.refresh()
            return
        super().handle(event)
        if event.type == pygame.MOUSEMOTION and (self.spots.hovered or "").startswith("row-"):
            self.focus = int(str(self.spots.hovered)[4:])

    def _steps(self) -> dict[int, int]:
        """How far each key moves the choice; it stays within the list."""
        return {
            pygame.K_DOWN: 1,
            pygame.K_UP: -1,
            pygame.K_PAGEDOWN: self._fits,
            pygame.K_PAGEUP: -self._fits,
            pygame.K_HOME: -len(self.rows),
            pygame.K_END: len(self.rows),
        }

    def pressed(self, name: str) -> None:
        if name.startswith("row-") and not self.leaving:
            value = self.rows[int(name[4:])].value
            self.close()
            self._chosen(value)

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        if not self.rows:
            look.text(picture, "There is nothing here yet.", (px(32), px(HEAD + 20)), 13, "medium", "text2")
        for spot in self.spots.spots:
            if spot.name.startswith("row-"):
                self._paint_row(picture, self.inner(spot.rect), int(spot.name[4:]))
        if len(self.rows) > self._fits:
            track = pygame.Rect(
                picture.get_width() - px(14), px(HEAD), px(4), self._fits * px(self._row + ROW_GAP)
            )
            thumb = track.copy()
            thumb.h = max(px(16), track.h * self._fits // len(self.rows))
            thumb.y += (track.h - thumb.h) * self._first // max(1, len(self.rows) - self._fits)
            draw_box(picture, track, px(2), look.theme.inset)
            draw_box(picture, thumb, px(2), look.theme.line2)

    def lines(self, row: ListRow) -> list[str]:
        """What is said of a row, in two lines at most; the second may be cut."""
        look = self.host.look
        space = look.px(self.width - 2 * 24 - 2 * 12 - (14 if row.marked else 0))
        if row.chip:
            space -= look.fonts.size(row.chip, 11, "semibold")[0] + look.px(2 * 6 + 12)
        lines = look.fonts.wrap(row.about, 12, "medium", space) if row.about else []
        return [*lines[:1], " ".join(lines[1:])] if len(lines) > 1 else lines

    def _paint_row(self, picture: pygame.Surface, rect: pygame.Rect, i: int) -> None:
        look, px, row = self.host.look, self.host.look.px, self.rows[i]
        if i == self.focus:
            draw_box(picture, rect, px(8), look.theme.accent_soft)
        x, right = rect.x + px(12), rect.right - px(12)
        if row.chip:
            words = look.fonts.size(row.chip, 11, "semibold")[0]
            chip = pygame.Rect(0, 0, words + 2 * px(6), px(20))
            chip.midright = (right, rect.centery)
            draw_box(picture, chip, px(5), look.theme.inset)
            look.text(picture, row.chip, chip.center, 11, "semibold", "accent", "center")
            right = chip.x - px(12)
        if row.marked:
            draw_disc(picture, (x + px(3), rect.y + px(17)), px(3), look.color("amber"))
            x += px(14)
        y = rect.y + px(17) if row.about else rect.centery
        weight = "semibold" if row.value == self._present else "medium"
        look.text(picture, look.fonts.fit(row.title, 13, weight, right - x), (x, y), 13, weight)
        for line, said in enumerate(self.lines(row)):
            about = look.fonts.fit(said, 12, "medium", right - x)
            look.text(picture, about, (x, rect.y + px(36 + LINE * line)), 12, "medium", "text3")
