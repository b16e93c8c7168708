"""Pointer and key events for the tests of widgets."""

from __future__ import annotations

import pygame


def event(kind, **values):
    """A pygame event."""
    return pygame.event.Event(kind, values)


def move(x, y):
    """The pointer moves there."""
    return event(pygame.MOUSEMOTION, pos=(round(x), round(y)), rel=(0, 0), buttons=(0, 0, 0))


def down(x, y, button=1):
    """A button goes down there."""
    return event(pygame.MOUSEBUTTONDOWN, pos=(round(x), round(y)), button=button)


def up(x, y, button=1):
    """A button comes up there."""
    return event(pygame.MOUSEBUTTONUP, pos=(round(x), round(y)), button=button)


def press(key, unicode=""):
    """A key goes down."""
    return event(pygame.KEYDOWN, key=key, mod=0, unicode=unicode, scancode=0)


def click(widget, place):
    """Press and release at a pixel; what ``handle`` gave for the release."""
    widget.handle(move(*place))
    first = widget.handle(down(*place))
    second = widget.handle(up(*place))
    return (first or []) + (second or []) if isinstance(second, list) else second
