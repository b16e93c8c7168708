"""The hand in a scene: mouse in pixels to pointer events in world coordinates; pan and zoom of the view.

The left button and the bare motion are the scene's. Wheel, middle and right button move the view, unless
the scene takes them for itself (``takes``, a set of "wheel", "middle", "right").
"""

from __future__ import annotations

import pygame

from game.stage import Pointer, Scene
from game.ui.canvas.camera import Camera

LEFT, MIDDLE, RIGHT = 1, 2, 3
BUTTON_NAMES = {MIDDLE: "middle", RIGHT: "right"}
ZOOM_OF_A_NOTCH = 1.15


class ScenePointer:
    """Turns events into pointer events; ``waiting`` are those to be posted, in order."""

    def __init__(self, scene_type: type[Scene], camera: Camera):
        self.camera = camera
        self.waiting: list[Pointer] = []
        self.held = 0  # button that the scene has been told is down
        self._takes = scene_type.takes
        self._panning = 0
        self._last: tuple[float, float] | None = None

    def handle(self, event: pygame.Event, stage_rect: pygame.Rect) -> bool:
        """Follow a mouse event; True if it was this one's."""
        if event.type == pygame.MOUSEMOTION:
            return self._move(event, stage_rect)
        if event.type == pygame.MOUSEBUTTONDOWN and event.button in (LEFT, MIDDLE, RIGHT):
            return self._press(event, stage_rect)
        if event.type == pygame.MOUSEBUTTONUP and event.button in (LEFT, MIDDLE, RIGHT):
            return self._release(event)
        if event.type == pygame.MOUSEWHEEL:
            return self._turn_wheel(event, stage_rect)
        return False

    def cancel(self) -> bool:
        """Take back what has been begun; True if there was something."""
        begun = bool(self.held or self._panning)
        if self.held:
            x, y = self._last or (0.0, 0.0)
            self.waiting.append(Pointer("cancel", x, y, button=self.held))
        self.held = self._panning = 0
        return begun

    def take(self) -> list[Pointer]:
        """The events gathered since the last call; of moves that follow each other only the last."""
        events, self.waiting = self.waiting, []
        last = len(events) - 1
        return [
            event
            for i, event in enumerate(events)
            if not (event.kind == "move" and i < last and events[i + 1].kind == "move")
        ]

    def _add(self, kind: str, position: tuple[int, int], button: int, wheel: float = 0.0) -> None:
        x, y = self.camera.to_world(position[0] + 0.5, position[1] + 0.5)
        if kind == "move" and (x, y) == self._last:
            return
        self._last = (x, y)
        held = pygame.key.get_mods()
        shift, control = bool(held & pygame.KMOD_SHIFT), bool(held & pygame.KMOD_CTRL)
        self.waiting.append(Pointer(kind, x, y, button, wheel, shift, control))  # type: ignore[arg-type]

    def _move(self, event: pygame.Event, stage_rect: pygame.Rect) -> bool:
        if self._panning:
            self.camera.pan(*event.rel)
            return True
        if not self.held and not stage_rect.collidepoint(event.pos):
            return False
        self._add("move", event.pos, self.held)
        return bool(self.held)

    def _press(self, event: pygame.Event, stage_rect: pygame.Rect) -> bool:
        if not stage_rect.collidepoint(event.pos) or self.held or self._panning:
            return bool(self.held or self._panning)
        if event.button == LEFT or BUTTON_NAMES[event.button] in self._takes:
            self._add("move", event.pos, 0)
            self.held = event.button
            self._add("down", event.pos, event.button)
        else:
            self._panning = event.button
        return True

    def _release(self, event: pygame.Event) -> bool:
        if event.button == self._panning:
            self._panning = 0
            return True
        if event.button != self.held:
            return False
        self._add("up", event.pos, event.button)
        self.held = 0
        return True

    def _turn_wheel(self, event: pygame.Event, stage_rect: pygame.Rect) -> bool:
        position = getattr(event, "pos", None) or pygame.mouse.get_pos()
        if not stage_rect.collidepoint(position):
            return False
        turn = float(getattr(event, "precise_y", event.y))
        if "wheel" in self._takes:
            self._add("wheel", position, self.held, turn)
        else:
            self.camera.zoom(ZOOM_OF_A_NOTCH**turn, position)
        return True
