"""The tour: the parts of a scene's window one after the other, each lit up, with its keys."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, ClassVar, NamedTuple

import pygame

from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.window.commands import Actions
from game.ui.look.layout import Layout
from game.ui.look.shapes import draw_box
from game.ui.widgets import keycap
from game.ui.widgets.buttons import HEIGHT as BUTTON
from game.ui.widgets.buttons import draw_button
from game.ui.widgets.hotspots import Hotspot, Hotspots

if TYPE_CHECKING:
    pass

CARD, PADDING, LINE, ROW = 360, 20, 20, 28  # design px
BESIDE = 16  # design px between a part and its words
LAST = "Begin"


class Stop(NamedTuple):
    """One part: its place, what it is called, what it does, and keys (commands of the program) with words."""

    part: str
    title: str
    words: str
    keys: tuple[tuple[tuple[str, ...], str], ...] = ()


STOPS = (
    Stop(
        "stage", "Touch it",
        "What is drawn can be dragged while it runs. Each scene begins with something to try.",
    ),
    Stop("hint_bar", "What the hand can do", "The line below names the gestures and keys of this scene."),
    Stop(
        "top_bar", "Time is yours", "Stop it, go step by step, forwards and back, or let it run slowly.",
        ((("pause",), "stop and go on"), (("step", "step-back"), "one step, one step back"),
         (("slower", "faster"), "1/16 to 4 times"), (("reset",), "begin again")),
    ),
    Stop(
        "panel", "Every number",
        "Drag a slider, or click a number and type. Effects can be left out; bars tell what each costs.",
        ((("panel",), "panel on and off"),),
    ),
    Stop("strips", "Measured", "The last ten seconds of what the scene is about: energy, error, pairs."),
    Stop(
        "", "There is more", "",
        ((("accuracy",), "what accuracy costs"), (("levels",), "levels and hard cases"),
         (("help",), "equations, and what to try"), (("previous", "next"), "the scenes beside"),
         (("tour",), "this tour"), (("back",), "all scenes")),
    ),
)  # fmt: skip

STORY_STOPS = (
    Stop(
        "track", "Any moment of it",
        "All that you see is computed as it plays. Drag along the bar, and go to another moment; "
        "a small picture shows what you have seen already.",
    ),
    Stop(
        "pause", "Stop and go on", "",
        ((("pause",), "stop and go on"), (("step", "step-back"), "one step, one step back")),
    ),
    Stop("story-speed", "How fast", "From a quarter to four times, beside the slow motion of the story."),
    Stop("story-chapters", "Chapters", "A click lists them by name, and leads to each."),
    Stop(
        "", "Touch it", "A touch makes the scene yours at any moment, and the story waits.",
        ((("story",), "take over, go on"), (("marks",), "names and measures"), (("tour",), "this tour"),
         (("back",), "all scenes")),
    ),
)  # fmt: skip

PANEL_OFF = (("panel",), "all that can be chosen and set")


class TourScreen(Screen):
    """Shown over a scene, which stands still; any way out of it counts as seen."""

    called: ClassVar[str] = "The tour"
    overlay: ClassVar[bool] = True

    def __init__(
        self, host: Host, layout: Callable[[], Layout], bar: Callable[[], Mapping[str, pygame.Rect]] | None
    ):
        """layout, bar: of the window now; ``bar``: parts of a story's bar, None where no story plays."""
        super().__init__(host)
        self._layout, self._bar = layout, bar
        self.at = 0
        self.spots = Hotspots()
        self.restyle()

    @property
    def stops(self) -> list[Stop]:
        """The parts that there are in this window; a panel that is off is named last by its key."""
        layout = self._layout()
        if self._bar is not None:
            return [stop for stop in STORY_STOPS if not stop.part or self._place(layout, stop.part).w > 0]
        stops = [stop for stop in STOPS if not stop.part or self._place(layout, stop.part).w > 0]
        if not layout.panel.w:
            stops[-1] = stops[-1]._replace(keys=(PANEL_OFF, *stops[-1].keys))
        return stops

    def _place(self, layout: Layout, part: str) -> pygame.Rect:
        if self._bar is not None:
            return self._bar().get(part, pygame.Rect(0, 0, 0, 0))
        rect: pygame.Rect = layout.free_stage if part == "stage" else getattr(layout, part)
        return rect if rect.h > 0 else pygame.Rect(0, 0, 0, 0)

    @property
    def stop(self) -> Stop:
        """The part that is lit now."""
        stops = self.stops
        return stops[min(self.at, len(stops) - 1)]

    def restyle(self) -> None:
        px = self.host.look.px
        card = self.card
        right = card.right - px(PADDING)
        spots = []
        for name, width in (("next", 88), ("skip", 72)):
            rect = pygame.Rect(0, 0, px(width), px(BUTTON))
            rect.bottomright = (right, card.bottom - px(PADDING))
            right = rect.x - px(8)
            spots.append(Hotspot(name, rect))
        self.spots.place(spots)

    @property
    def card(self) -> pygame.Rect:
        """Where the words stand: beside what is lit, within the window."""
        look, px = self.host.look, self.host.look.px
        window = pygame.Rect((0, 0), self.host.size)
        lines = (
            look.fonts.wrap(self.stop.words, 13, "medium", px(CARD - 2 * PADDING)) if self.stop.words else []
        )
        height = 2 * PADDING + 32 + LINE * len(lines) + ROW * len(self.stop.keys) + BUTTON + 16
        card = pygame.Rect(0, 0, min(px(CARD), window.w), min(px(height), window.h))
        if not self.stop.part:
            card.center = window.center
            return card
        lit = self._place(self._layout(), self.stop.part)
        if lit.h > window.h // 2 and lit.w > window.w // 2:
            card.center = lit.center  # at its edges stands what a scene has to say
        elif lit.h > window.h // 2:
            card.midright = (lit.x - px(BESIDE), lit.centery)
        elif lit.centery > window.centery:
            card.midbottom = (lit.centerx, lit.y - px(BESIDE))
        else:
            card.midtop = (lit.centerx, lit.bottom + px(BESIDE))
        return card.clamp(window)

    # -- input --------------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> None:
        if event.type == pygame.KEYDOWN:
            if event.key in (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE, pygame.K_RIGHT):
                self._go(1)
            elif event.key == pygame.K_LEFT:
                self._go(-1)
            return
        name = self.spots.handle(event)
        if name == "next":
            self._go(1)
        elif name == "skip":
            self._end()

    def wants_key(self, event: pygame.Event) -> bool:
        return event.key not in (pygame.K_ESCAPE, pygame.K_F2, pygame.K_F11, pygame.K_F12)

    @property
    def actions(self) -> Actions:
        return {"back": self._end}

    def _go(self, way: int) -> None:
        if self.at + way >= len(self.stops):
            self._end()
            return
        self.at = max(self.at + way, 0)
        self.restyle()

    def _end(self) -> None:
        self.host.pop()

    def update(self, elapsed_s: float) -> None:
        self.spots.update(elapsed_s, self.host.look)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Darken all but one part, ring it, and say what it is."""
        look, px = self.host.look, self.host.look.px
        veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA, 32)
        veil.fill(look.theme.scrim)
        if self.stop.part:
            lit = self._place(self._layout(), self.stop.part)
            veil.fill((0, 0, 0, 0), lit)
            surface.blit(veil, (0, 0))
            draw_box(surface, lit.inflate(-px(4), -px(4)), px(8), None, look.theme.accent, max(2, px(2)))
        else:
            surface.blit(veil, (0, 0))
        self._draw_card(surface)

    def _draw_card(self, surface: pygame.Surface) -> None:
        look, px, card = self.host.look, self.host.look.px, self.card
        draw_box(surface, card, px(12), look.theme.panel, look.theme.line2, look.border)
        x, y = card.x + px(PADDING), card.y + px(PADDING + 8)
        look.text(surface, self.stop.title, (x, y), 18, "display")
        y += px(30)
        space = card.w - 2 * px(PADDING)
        for line in look.fonts.wrap(self.stop.words, 13, "medium", space) if self.stop.words else ():
            look.text(surface, line, (x, y), 13, "medium", "text2")
            y += px(LINE)
        y += px(8)
        for commands, words in self.stop.keys:
            caps = [self.host.keys.label(command) for command in commands]
            keycap.draw_keys(surface, look, x, y, caps)
            look.text(surface, words, (x + px(112), y), 13, "medium", "text2")
            y += px(ROW)
        count = len(self.stops)
        place = (x, card.bottom - px(PADDING) - px(BUTTON) // 2)
        look.text(surface, f"{min(self.at, count - 1) + 1} of {count}", place, 12, "medium", "text3")
        for spot in self.spots.spots:
            last = self.at >= count - 1
            words = (LAST if last else "Next") if spot.name == "next" else "Skip"
            if spot.name == "skip" and last:
                continue
            draw_button(
                surface, look, spot.rect, words, primary=spot.name == "next",
                lit=self.spots.hover(spot.name), pressed=self.spots.pressed == spot.name,
            )  # fmt: skip

    def message_row(self) -> pygame.Rect:
        return self._layout().hint_bar
