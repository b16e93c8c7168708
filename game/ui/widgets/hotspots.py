"""Places that can be pressed: one object tells hover, press, keyboard focus and activation for a widget.

A widget says each time it lays itself out which places it has. This object turns pointer and key events into
the name of the place activated. Activation is on release over the place pressed, as people expect to be able
to change their mind. Focus is moved by Tab and drawn only when it was the keyboard that moved it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.ui.look import motion
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box


class Hotspot(NamedTuple):
    """A place: its name, where it is, whether it answers, and what its tool tip says."""

    name: str
    rect: pygame.Rect
    enabled: bool = True
    tip: str = ""


class Hotspots:
    """Pointer and keyboard state over a set of places."""

    def __init__(self) -> None:
        self.spots: tuple[Hotspot, ...] = ()
        self.hovered: str | None = None
        self.pressed: str | None = None
        self.focused: str | None = None
        self._fades: dict[str, motion.Fade] = {}

    def place(self, spots: Sequence[Hotspot]) -> None:
        """Take new places; the state of those with the same names is kept."""
        self.spots = tuple(spots)
        names = {spot.name for spot in spots}
        self._fades = {name: fade for name, fade in self._fades.items() if name in names}
        if self.hovered not in names:
            self.hovered = None
        if self.pressed not in names:
            self.pressed = None
        if self.focused not in names:
            self.focused = None

    def find(self, name: str) -> Hotspot | None:
        """The place of that name."""
        return next((spot for spot in self.spots if spot.name == name), None)

    def at(self, position: tuple[int, int]) -> Hotspot | None:
        """The enabled place under a pixel; of several the last, which is drawn on top."""
        return next((s for s in reversed(self.spots) if s.enabled and s.rect.collidepoint(position)), None)

    def handle(self, event: pygame.event.Event) -> str | None:
        """Follow a pointer or key event; the name of the place that it activates, if any."""
        if event.type == pygame.MOUSEMOTION:
            spot = self.at(event.pos)
            self.hovered = spot.name if spot else None
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            spot = self.at(event.pos)
            self.pressed = self.hovered = spot.name if spot else None
            self.focused = None
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            spot, pressed = self.at(event.pos), self.pressed
            self.pressed = None
            if spot is not None and spot.name == pressed:
                return spot.name
        elif event.type == pygame.WINDOWLEAVE:
            self.hovered = None
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.hovered = self.pressed = None
        elif event.type == pygame.KEYDOWN and event.key in (
            pygame.K_RETURN,
            pygame.K_KP_ENTER,
            pygame.K_SPACE,
        ):
            spot = self.find(self.focused) if self.focused else None
            if spot is not None and spot.enabled:
                return spot.name
        return None

    def focus_next(self, backward: bool = False) -> str | None:
        """Move the keyboard focus to the next enabled place; None after the last, so that focus can leave."""
        names = [spot.name for spot in self.spots if spot.enabled]
        if backward:
            names.reverse()
        index = names.index(self.focused) + 1 if self.focused in names else 0
        self.focused = names[index] if index < len(names) else None
        return self.focused

    def update(self, dt_s: float, look: Look) -> bool:
        """Let hover colours move on; True while something changes."""
        changed = False
        for spot in self.spots:
            on = spot.name == self.hovered and spot.enabled
            fade = self._fades.get(spot.name)
            if fade is None:
                if not on:
                    continue
                fade = self._fades[spot.name] = motion.Fade(motion.HOVER_S)
            fade.duration_s = 0.0 if look.less_motion else motion.HOVER_S
            changed |= fade.update(dt_s, on)
        return changed

    def hover(self, name: str) -> float:
        """How far a place is lit by the pointer, 0 to 1."""
        fade = self._fades.get(name)
        return fade.amount if fade is not None else 0.0

    def state(self) -> tuple[object, ...]:
        """What the picture of a widget depends on, to be compared between frames."""
        lit = tuple((name, fade.amount) for name, fade in self._fades.items() if fade.amount > 0.0)
        return self.hovered, self.pressed, self.focused, lit

    def draw_focus(self, surface: pygame.Surface, look: Look, radius: float) -> None:
        """The ring about the place that has the keyboard focus: 2 px wide at 3 px distance."""
        spot = self.find(self.focused) if self.focused else None
        if spot is not None:
            reach = look.px(3) + max(2, look.px(2))
            ring = spot.rect.inflate(2 * reach, 2 * reach)
            draw_box(surface, ring, radius + reach, None, look.theme.accent, max(2, look.px(2)))
