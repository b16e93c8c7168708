"""A card on the stage: what a single thing that was clicked has of its own, by controls as in the panel."""

from __future__ import annotations

import pygame

from game.stage import Action, Inspected, Scene
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.panel.effects import EffectCosts
from game.ui.panel.flow import Contents
from game.ui.panel.rows import PADDING, Source
from game.ui.panel.sheet import PanelSheet, PanelWish
from game.ui.widgets.hotspots import Hotspot, Hotspots

WIDTH, HEAD, MARGIN, SIGN = 224, 34, 12, 16  # design px
CLOSE = "close"
_POINTER = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)


def _without_value(shown: Inspected | None) -> Inspected | None:
    """What the rows of a card depend on."""
    return None if shown is None else shown._replace(told="")


class InspectorCard:
    """Rows of the parameters that a scene names, at the top right of the stage, and a cross to close it."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.rect = pygame.Rect(0, 0, 0, 0)
        self.shown: Inspected | None = None
        self._stage = pygame.Rect(0, 0, 0, 0)
        self._sheet: PanelSheet | None = None
        self._source: Source | None = None
        self._spots = Hotspots()
        self._wishes: list[PanelWish] = []
        self._values: dict[str, object] = {}

    def place(self, stage: pygame.Rect, look: Look) -> None:
        """Take a part of the window and an appearance."""
        self.look, self._stage = look, pygame.Rect(stage)
        self._build()

    def close(self) -> None:
        """Free pygame_gui's elements."""
        if self._sheet is not None:
            self._sheet.close()
            self._sheet = None

    def _build(self) -> None:
        self.close()
        self.rect = pygame.Rect(0, 0, 0, 0)
        self._spots.place(())
        if self.shown is None or self._source is None:
            return
        px = self.look.px
        contents = Contents(
            self._source, (), (), EffectCosts(), hidden=("effects",), only=self.shown.parameters
        )
        sheet = PanelSheet(self.look, px(WIDTH), 1, contents, self._wishes.append)
        self.rect = pygame.Rect(0, 0, px(WIDTH), px(HEAD) + sheet.height)
        self.rect.topright = self._stage.right - px(MARGIN), self._stage.y + px(MARGIN)
        if not self._stage.contains(self.rect):
            sheet.close()
            self.rect.size = (0, 0)
            return
        self._sheet = sheet
        place = pygame.Rect(self.rect.right - px(HEAD), self.rect.y, px(HEAD), px(HEAD))
        self._spots.place((Hotspot(CLOSE, place, tip="Close"),))

    # -- events -------------------------------------------------------------------------------------

    @property
    def typing(self) -> bool:
        """Whether a number is being typed, so that keys are letters."""
        return self._sheet is not None and self._sheet.typing

    def covers(self, position: tuple[int, int]) -> bool:
        """Whether a place in the window is on the card, or on a list that it has opened."""
        return self._sheet is not None and bool(self._seen.collidepoint(position))

    @property
    def _seen(self) -> pygame.Rect:
        """Where the card is, with an open list."""
        assert self._sheet is not None
        reach = self.look.px(HEAD) + self._sheet.reach
        return pygame.Rect(self.rect.x, self.rect.y, self.rect.w, max(self.rect.h, reach))

    def handle(self, event: pygame.Event) -> list[PanelWish]:
        """Let an event act; the stage events that it makes."""
        sheet = self._sheet
        if sheet is None:
            return []
        if event.type in _POINTER:
            if self._spots.handle(event) == CLOSE and self.shown is not None:
                return [Action(self.shown.close)]
            top = self.rect.y + self.look.px(HEAD)
            moved = (event.pos[0] - self.rect.x, event.pos[1] - top)
            inside = self.covers(event.pos) and moved[1] >= 0
            sheet.handle(pygame.Event(event.type, {**event.dict, "pos": moved}), inside)
        elif event.type in (pygame.WINDOWLEAVE, pygame.WINDOWFOCUSLOST):
            sheet.leave()
        elif event.type == pygame.KEYDOWN and sheet.typing:
            sheet.key(event)
        elif event.type == pygame.TEXTINPUT:
            sheet.write(event)
        wishes, self._wishes[:] = list(self._wishes), []
        return wishes

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, dt_s: float, scene: Scene | None) -> None:
        """Follow the scene: what is clicked there, and its values."""
        wanted = scene.inspected() if scene is not None else None
        if scene is not None and (self._source is None or type(self._source.scene) is not type(scene)):
            self._source = Source(scene)
        if self._source is not None and scene is not None:
            self._source.scene = scene
        before, self.shown = self.shown, wanted
        if _without_value(wanted) != _without_value(before):
            self._build()
        if self._sheet is None or scene is None:
            return
        self._spots.update(dt_s, self.look)
        if self._sheet.is_behind():
            self._build()
        values = dict(scene.values)
        if values != self._values:
            self._values = values
            self._sheet.mark_stale()
        self._sheet.set_idle(self._source.idle() if self._source is not None else {})
        self._sheet.update(dt_s)

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """What the cross under the pointer does."""
        spot = self._spots.find(self._spots.hovered) if self._spots.hovered else None
        return (spot.tip, spot.rect) if spot is not None else None

    def draw(self, surface: pygame.Surface) -> None:
        """The card, its title, its rows, and a list that is open over what lies below."""
        if self._sheet is None or self.shown is None:
            return
        look, px = self.look, self.look.px
        seen = self._seen
        draw_box(surface, seen, px(10), look.theme.panel, look.theme.line2, look.border)
        middle = self.rect.y + px(HEAD) // 2
        room = self.rect.w - px(HEAD) - px(PADDING)
        words = look.fonts.fit(self.shown.title, 12, "semibold", room)
        taken = look.text(surface, words, (self.rect.x + px(PADDING), middle), 12, "semibold", "text1").w
        told = look.fonts.fit(self.shown.told, 12, "medium", max(room - taken - px(PADDING), 0))
        if told:
            end = self.rect.right - px(HEAD)
            look.text(surface, told, (end, middle), 12, "medium", "text2", "right")
        ink = look.theme.text3.lerp(look.theme.text1, self._spots.hover(CLOSE))
        cross = icon("close", px(SIGN), ink)
        surface.blit(cross, cross.get_rect(center=(self.rect.right - px(HEAD) // 2, middle)))
        inset = px(2)
        part = pygame.Rect(inset, 0, seen.w - 2 * inset, seen.h - px(HEAD) - px(8))
        surface.blit(self._sheet.picture, (seen.x + inset, seen.y + px(HEAD)), part)
