"""The card of a person's strokes for ever: pots made beside the map's chances, by distance and by cut."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np
import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.stagehand.stroke_file import read_strokes
from game.billiards.career.strokes import (
    CHANCES,
    CUTS,
    DISTANCES,
    POINT,
    POT,
    WAYS,
    Share,
    by_opponent,
    csv_of,
    shares,
    summary_of,
    summary_words,
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
NONE = {POT: "No pots", POINT: "No points"}
MADE = {POT: "you pot", POINT: "you score"}
CHARTS = 0.58  # share of the height
CHARTED = {  # by kind of stroke: figures, units and classes of both charts
    POT: (("distance", "m", DISTANCES), ("cut", "°", CUTS)),
    POINT: (("chance", "", CHANCES), ("cushions", "before the first ball", WAYS)),
}


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
        self.kind = POT  # of the strokes whose charts are shown
        if any(one.kind == POINT for one in self.facts[-1:]):
            self.kind = POINT
        super().__init__(host)
        self.restyle()

    @property
    def heading(self) -> str:
        return f"Strokes of {self.person}" if self.person else "Strokes"

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        y = card.bottom - px(FOOT) + (px(FOOT) - px(BUTTON)) // 2
        last = pygame.Rect(card.right - px(32 + WIDE), y, px(WIDE), px(BUTTON))
        return [Hotspot("kind", last.move(-px(WIDE + GAP), 0)), Hotspot("csv", last)]

    def state(self) -> object:
        return self.kind

    def pressed(self, name: str) -> None:
        if name == "kind":
            self.kind = POINT if self.kind == POT else POT
            self.refresh()
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
        for area, (by, unit, edges) in zip((left, right), CHARTED[self.kind], strict=True):
            self._paint_chart(picture, area, shares(self.facts, edges, by, self.kind), (by, unit))
        y = left.bottom + px(18)
        rows = [("all", summary_of(self.facts))]
        for name, found in by_opponent(self.facts).items():
            rows.append((BY_NAME[name].title if name in BY_NAME else name, found))
        for words in (summary_words(name, found) for name, found in rows):
            if y > picture.get_height() - px(FOOT):
                break
            fitted = look.fonts.fit(words, 13, "medium", picture.get_width() - px(64))
            look.text(picture, fitted, (px(32), y), 13, "medium", "text1")
            y += px(LINE)
        other = "Points of carom" if self.kind == POT else "Pots"
        self.draw_button(picture, "kind", other, primary=False)
        self.draw_button(picture, "csv", "Write all strokes as CSV", primary=True)

    def _paint_chart(
        self, picture: pygame.Surface, area: pygame.Rect, found: Sequence[Share], over: tuple[str, str]
    ) -> None:
        """The share made, and what the map's geometry gives a hand of usual noise, in classes."""
        if not found:
            look = self.host.look
            draw_box(picture, area, look.px(10), look.theme.inset)
            words = look.fonts.fit(
                f"{NONE[self.kind]} yet, to be shown by {over[0]}.", 13, "medium", area.w - look.px(16)
            )
            look.text(picture, words, area.center, 13, "medium", "text2", "center")
            return
        made = np.array([(one.middle, 100.0 * one.made) for one in found])
        expected = np.array([(one.middle, 100.0 * one.expected) for one in found])
        names = (MADE[self.kind], "the map's chance")
        draw_comparison(picture, self.host.look, area, Comparison(made, expected, names, "%", *over), 1.0)
