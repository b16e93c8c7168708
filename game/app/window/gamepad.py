"""Gamepads in the words of keyboard and mouse, so that no screen needs to know of them.

In menus and cards the stick and the cross are the arrow keys. In a scene the left stick moves a pointer and
button A presses it. So a cue is aimed, pulled back and let go as with a mouse.
"""

from __future__ import annotations

import contextlib
import math
from typing import Literal

import pygame

Mode = Literal["keys", "pointer"]

DEAD_ZONE = 0.22  # of the stick's way, where it counts as let go
POINTER_SPEED = 0.55  # window heights per second at full way; squared below it, for fine aiming
REPEAT_FIRST_S = 0.35  # s before a held stick moves on in a menu
REPEAT_S = 0.13  # s between further moves

_PRESS = 0  # A or cross
_KEYS = {
    1: (pygame.K_ESCAPE, pygame.KSCAN_ESCAPE),  # B or circle
    2: (pygame.K_TAB, pygame.KSCAN_TAB),  # X
    3: (pygame.K_F1, pygame.KSCAN_F1),  # Y
    4: (pygame.K_COMMA, pygame.KSCAN_COMMA),  # left shoulder
    5: (pygame.K_PERIOD, pygame.KSCAN_PERIOD),  # right shoulder
    6: (pygame.K_SPACE, pygame.KSCAN_SPACE),  # back
    7: (pygame.K_p, pygame.KSCAN_P),  # start
}
_RETURN = (pygame.K_RETURN, pygame.KSCAN_RETURN)
_ARROWS = {
    (-1, 0): (pygame.K_LEFT, pygame.KSCAN_LEFT),
    (1, 0): (pygame.K_RIGHT, pygame.KSCAN_RIGHT),
    (0, -1): (pygame.K_UP, pygame.KSCAN_UP),
    (0, 1): (pygame.K_DOWN, pygame.KSCAN_DOWN),
}
_OF_A_PAD = (
    pygame.JOYAXISMOTION,
    pygame.JOYBALLMOTION,
    pygame.JOYHATMOTION,
    pygame.JOYBUTTONDOWN,
    pygame.JOYBUTTONUP,
    pygame.JOYDEVICEADDED,
    pygame.JOYDEVICEREMOVED,
)


def key_event(key: tuple[int, int], down: bool = True) -> pygame.Event:
    """A key press or release as the keyboard would send it."""
    code, scancode = key
    kind = pygame.KEYDOWN if down else pygame.KEYUP
    return pygame.Event(kind, key=code, scancode=scancode, mod=0, unicode="")


class Gamepads:
    """All gamepads together: they act as one."""

    def __init__(self) -> None:
        self._pads: dict[int, pygame.joystick.JoystickType] = {}
        self._stick = [0.0, 0.0]
        self._held = (0, 0)
        self._repeat_s = 0.0
        self.pointer: tuple[float, float] | None = None  # px; None until a stick has moved it
        self._pressed = False
        with contextlib.suppress(pygame.error):
            pygame.joystick.init()

    def translate(self, event: pygame.Event, mode: Mode) -> list[pygame.Event] | None:
        """Events for the screens in place of a gamepad's, or None for an event that is of no gamepad."""
        if event.type == pygame.MOUSEMOTION:
            self.pointer = None  # the mouse has taken over
        if event.type not in _OF_A_PAD:
            return None
        if event.type == pygame.JOYDEVICEADDED:
            with contextlib.suppress(pygame.error):
                pad = pygame.joystick.Joystick(event.device_index)
                self._pads[pad.get_instance_id()] = pad
        elif event.type == pygame.JOYDEVICEREMOVED:
            self._pads.pop(event.instance_id, None)
            self._stick = [0.0, 0.0]
        elif event.type == pygame.JOYAXISMOTION and event.axis < 2:
            self._stick[event.axis] = event.value
        elif event.type == pygame.JOYHATMOTION:
            arrow = _ARROWS.get((event.value[0], -event.value[1]))
            return [key_event(arrow)] if arrow else []
        elif event.type in (pygame.JOYBUTTONDOWN, pygame.JOYBUTTONUP):
            return self._button(event.button, event.type == pygame.JOYBUTTONDOWN, mode)
        return []

    def _button(self, button: int, down: bool, mode: Mode) -> list[pygame.Event]:
        if button != _PRESS:
            return [key_event(_KEYS[button], down)] if button in _KEYS else []
        if mode == "keys" or self.pointer is None:
            return [key_event(_RETURN, down)]
        self._pressed = down
        kind = pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP
        return [pygame.Event(kind, pos=self._place(), button=1, touch=False)]

    def update(self, elapsed_s: float, mode: Mode, size: tuple[int, int]) -> list[pygame.Event]:
        """What a held stick does in the course of time."""
        x, y = self._stick
        length = math.sqrt(x * x + y * y)
        if length < DEAD_ZONE:
            self._held = (0, 0)
            return []
        if mode == "keys":
            return self._repeat(elapsed_s, x, y)
        strength = min(1.0, (length - DEAD_ZONE) / (1.0 - DEAD_ZONE))
        way = POINTER_SPEED * size[1] * elapsed_s * strength * strength / length
        from_x, from_y = self.pointer or (size[0] / 2.0, size[1] / 2.0)
        to_x = min(max(from_x + x * way, 0.0), size[0] - 1.0)
        to_y = min(max(from_y + y * way, 0.0), size[1] - 1.0)
        self.pointer = (to_x, to_y)
        rel = (round(to_x - from_x), round(to_y - from_y))
        buttons = (int(self._pressed), 0, 0)
        return [pygame.Event(pygame.MOUSEMOTION, pos=self._place(), rel=rel, buttons=buttons, touch=False)]

    def _repeat(self, elapsed_s: float, x: float, y: float) -> list[pygame.Event]:
        way = (int(math.copysign(1, x)), 0) if abs(x) > abs(y) else (0, int(math.copysign(1, y)))
        self._repeat_s -= elapsed_s
        if way == self._held and self._repeat_s > 0.0:
            return []
        self._repeat_s = REPEAT_S if way == self._held else REPEAT_FIRST_S
        self._held = way
        return [key_event(_ARROWS[way])]

    def _place(self) -> tuple[int, int]:
        x, y = self.pointer or (0.0, 0.0)
        return round(x), round(y)
