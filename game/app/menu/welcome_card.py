"""The card of the very first start: what this is, the games there are, stories and the course."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, NamedTuple

import pygame

from game.app.menu.cards import round_corners
from game.app.menu.sketch import sketch
from game.app.screens.card import CardScreen
from game.app.screens.host import Host
from game.app.stagehand.level_index import lessons_of, next_lesson
from game.app.window.guard import Failure
from game.stage.catalogue import STORIES
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot
from game.ui.widgets.overlay import Overlay

LINES = (
    "Games of billiards, and a laboratory of the physics in it.",
    "Play a match, watch a story that is computed as it plays, or see step by step how that is done.",
)
TAUGHT = "billiards"  # the scene of the lessons
COURSE = "Course"  # the category of the menu
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE)
TOP, CHOICE, GAP, WORDS, RADIUS = 124, 212, 16, 68, 12  # design px
MANY_ROWS, NARROW_GAP = 6, 4  # rows, from which on they stand closer; design px
LOWER = 172  # design px, of a choice where there are two rows
BESIDE_FROM = 560  # design px of the card's width below which one choice stands above the next


class Choice(NamedTuple):
    """A way on: its name, its words, and the scene whose drawing it shows."""

    name: str
    title: str
    about: str
    scene: str


GAMES = (
    Choice("play", "Play billiards", "alone, with a friend or the computer", "billiards"),
    Choice("carom", "Play carom", "with a map of all that scores", "carom"),
    Choice("snooker", "Play snooker", "fifteen reds, six colours", "snooker"),
)
OTHERS = (
    Choice("stories", "Watch a story", "a billiard match, fireworks, fire", "a09"),
    Choice("lessons", "Learn the cue", "five strokes in ten minutes", "three-tables"),
    Choice("course", "See the course", "from key-frames to soft bodies", "c04"),
)


class WelcomeCard(CardScreen):
    """Large choices: several games above the others, a single one beside them. Esc, the cross or a press
    beside it close the card.
    """

    called: ClassVar[str] = "The first card"
    height: ClassVar[float] = TOP + CHOICE + 32.0
    width: ClassVar[float] = 900.0

    def __init__(self, host: Host, show_category: Callable[[str], object]) -> None:
        """``show_category``: has the menu below go to a category."""
        super().__init__(host)
        self._show_category = show_category
        names = {entry.name for entry in host.catalogue}
        games = tuple(game for game in GAMES if game.scene in names)
        others = OTHERS if TAUGHT in names else tuple(one for one in OTHERS if one.name != "lessons")
        self._rows: tuple[tuple[Choice, ...], ...] = (
            (games, others) if len(games) > 1 else ((*games, *others),)
        )
        self._choices = (*games, *others)
        if len(self._rows) > 1:
            self.veil = Overlay(host.look, TOP + 2 * LOWER + GAP + 32.0, self.width)
        self.restyle()

    @property
    def heading(self) -> str:
        return "Welcome to Carom"

    def places(self) -> list[Hotspot]:
        card, px = self.veil.card, self.host.look.px
        left, top = card.x + px(32), card.y + px(TOP)
        width, height = max(2, card.w - px(64)), max(2, card.bottom - px(16) - top)
        rows = self._rows
        if card.w < px(BESIDE_FROM):
            rows = tuple((choice,) for choice in self._choices)
        gap = px(GAP) if len(rows) < MANY_ROWS else px(NARROW_GAP)
        tall = max(1, min(px(CHOICE), (height - (len(rows) - 1) * gap) // len(rows)))
        spots = []
        for j, row in enumerate(rows):
            wide = max(1, (width - (len(row) - 1) * gap) // len(row))
            for i, choice in enumerate(row):
                rect = pygame.Rect(left + i * (wide + gap), top + j * (tall + gap), wide, tall)
                spots.append(Hotspot(choice.name, rect))
        return spots

    def handle(self, event: pygame.Event) -> None:
        key = event.key if event.type == pygame.KEYDOWN else None
        if event.type == pygame.MOUSEBUTTONDOWN and not self.veil.card.collidepoint(event.pos):
            self.close()
        elif key in (pygame.K_LEFT, pygame.K_RIGHT):
            names = [choice.name for choice in self._choices]
            at = names.index(self.spots.focused) if self.spots.focused in names else 0
            self.spots.focused = names[min(max(at + (1 if key == pygame.K_RIGHT else -1), 0), len(names) - 1)]
        elif key in ENTER and self.spots.focused is None:
            self.pressed(self._choices[0].name)
        else:
            super().handle(event)

    def pressed(self, name: str) -> None:
        if self.leaving:
            return
        scene = next((game.scene for game in GAMES if game.name == name), None)
        if name == "lessons":
            self.host.open_scene(TAUGHT, level=next_lesson(lessons_of(TAUGHT)).path)
        elif scene is not None:
            self.host.open_scene(scene)
        else:
            self._show_category(STORIES if name == "stories" else COURSE)
            self.close()

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        space = picture.get_width() - px(64)
        for i, line in enumerate(LINES):
            words = look.fonts.fit(line, 13, "medium", space)
            look.text(picture, words, (px(32), px(74) + i * px(20)), 13, "medium", "text2")
        for choice in self._choices:
            self._paint_choice(picture, choice)

    def _paint_choice(self, picture: pygame.Surface, choice: Choice) -> None:
        spot = self.spots.find(choice.name)
        if spot is None:
            return
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        rect, lit = self.inner(spot.rect), self.spots.hover(choice.name)
        draw_box(picture, rect, px(RADIUS), theme.inset.lerp(theme.hover, lit))
        upper = rect.h - px(WORDS)
        if upper > px(40):
            drawing = self._drawing(choice.scene, (rect.w, upper))
            picture.blit(round_corners(drawing, look, px(WORDS)), rect)
        x, middle, space = rect.x + px(16), rect.bottom - px(WORDS) // 2, rect.w - px(32)
        words = look.fonts.fit(choice.title, 18, "display", space)
        look.text(picture, words, (x, middle - px(11)), 18, "display", "text1")
        about = look.fonts.fit(choice.about, 12, "medium", space)
        look.text(picture, about, (x, middle + px(13)), 12, "medium", "text2")
        chosen = choice.name == (self.spots.focused or self._choices[0].name)
        edge, width = (theme.accent, max(2, px(2))) if chosen else (theme.line2, look.border)
        draw_box(picture, rect, px(RADIUS), None, edge, width)

    def _drawing(self, scene: str, size: tuple[int, int]) -> pygame.Surface:
        """The drawing of a scene's card; the empty stage for one that has none or fails."""
        drawing = pygame.Surface(size, 0, 32)
        drawing.fill(self.host.look.theme.stage)
        with self.host.guard.over("A drawing", self._tell_undrawn):
            entry = next((entry for entry in self.host.catalogue if entry.name == scene), None)
            if entry is not None:
                drawing = sketch(entry, size, self.host.look)
        return drawing

    def _tell_undrawn(self, failure: Failure) -> None:
        self.host.tell_of(failure, "cannot be shown")
