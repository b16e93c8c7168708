"""The card of a person's strokes for ever: pots made beside the map's chances, by distance and by cut."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar

import numpy as np
import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.stagehand.stroke_file import read_strokes
from game.billiards.career.strokes import (
    CUTS,
    DISTANCES,
    Share,
    Summary,
    by_opponent,
    csv_of,
    shares,
    summary_of,
)
from game.billiards.players.ladder import BY_NAME
from game.files import FileProblem, write_text
from game.folders import user_folder
from game.stage import Comparison
from game.ui.charts.comparison import draw_comparison
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot

CSV_NAME = "statistics.csv"
FOOT, BUTTON, WIDE, GAP, LINE = 72, 36, 220, 20, 22  # design px
CHARTS = 0.58  # share of the height


class StatisticsCard(CardScreen):
    """A button writes every stroke as CSV; Esc leads back."""

    called: ClassVar[str] = "The statistics"
    width: ClassVar[float] = 960.0
    height: ClassVar[float] = 580.0

    def __init__(self, host: Host, person: str) -> None:
        self.person = person
        try:
            self.facts = tuple(read_strokes().get(person, []))
        except ValueError as error:
            self.facts = ()
            host.tell("Statistics.", str(error), "warning")
        super().__init__(host)
        self.restyle()

    @property
    def heading(self) -> str:
        return f"Strokes of {self.person}" if self.person else "Strokes"

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        y = card.bottom - px(FOOT) + (px(FOOT) - px(BUTTON)) // 2
        return [Hotspot("csv", pygame.Rect(card.right - px(32 + WIDE), y, px(WIDE), px(BUTTON)))]

    def pressed(self, name: str) -> None:
        if name != "csv":
            return
        path = user_folder() / CSV_NAME
        try:
            write_text(path, csv_of(self.facts))
        except FileProblem as problem:
            self.host.tell("No CSV file.", f"{path.name}: {problem}", "warning")
            return
        self.host.tell(f"{len(self.facts)} strokes are written.", str(path))

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        width = (picture.get_width() - 2 * px(32) - px(GAP)) // 2
        high = round(CHARTS * (picture.get_height() - px(HEAD) - px(FOOT)))
        left = pygame.Rect(px(32), px(HEAD - 8), width, high)
        right = left.move(width + px(GAP), 0)
        self._paint_chart(picture, left, shares(self.facts, DISTANCES, by_cut=False), ("distance", "m"))
        self._paint_chart(picture, right, shares(self.facts, CUTS, by_cut=True), ("cut", "°"))
        y = left.bottom + px(18)
        rows = [("all", summary_of(self.facts))]
        for name, found in by_opponent(self.facts).items():
            rows.append((BY_NAME[name].title if name in BY_NAME else name, found))
        for words in (row_of(name, found) for name, found in rows):
            if y > picture.get_height() - px(FOOT):
                break
            fitted = look.fonts.fit(words, 13, "medium", picture.get_width() - px(64))
            look.text(picture, fitted, (px(32), y), 13, "medium", "text1")
            y += px(LINE)
        self.draw_button(picture, "csv", "Write all strokes as CSV", primary=True)

    def _paint_chart(
        self, picture: pygame.Surface, area: pygame.Rect, found: Sequence[Share], over: tuple[str, str]
    ) -> None:
        """The share made, and what the map's geometry gives a hand of usual noise, in classes."""
        if not found:
            look = self.host.look
            draw_box(picture, area, look.px(10), look.theme.inset)
            words = look.fonts.fit(
                f"No pots yet, to be shown by {over[0]}.", 13, "medium", area.w - look.px(16)
            )
            look.text(picture, words, area.center, 13, "medium", "text2", "center")
            return
        made = np.array([(one.middle, 100.0 * one.made) for one in found])
        expected = np.array([(one.middle, 100.0 * one.expected) for one in found])
        names = ("you pot", "the map's chance")
        draw_comparison(picture, self.host.look, area, Comparison(made, expected, names, "%", *over), 1.0)


def row_of(name: str, found: Summary) -> str:
    """A summary in a line."""
    words = f"{name}: {found.made} of {found.pots} pots, {found.expected:.1f} expected by the map"
    if math.isfinite(found.stray):
        words += f"; position {1000.0 * found.stray:.0f} mm off"
    if math.isfinite(found.break_speed):
        words += f"; break {found.break_speed:.1f} m/s"
    return words
