"""The card of a thing that was clicked: a measured value in its head costs no new rows."""

from __future__ import annotations

from types import SimpleNamespace

import pygame

from game.stage import Inspected
from game.ui.panel import card as module
from game.ui.panel.card import InspectorCard


class NoSheet:
    """Rows that only say how high they are."""

    height, reach, typing = 60, 0, False

    def __init__(self, *given) -> None:
        self.picture = pygame.Surface((220, 60))
        self.close = self.mark_stale = lambda: None
        self.is_behind = lambda: False
        self.set_idle = self.update = lambda given: None


def test_a_value_that_changes_is_drawn_and_builds_nothing_anew(look, monkeypatch):
    built = []
    monkeypatch.setattr(module, "PanelSheet", lambda *given: built.append(1) or NoSheet())
    monkeypatch.setattr(module, "Contents", lambda *given, **more: None)
    monkeypatch.setattr(module, "Source", lambda scene: SimpleNamespace(scene=scene, idle=dict))
    shown = [Inspected("Pin 3", ("a",), "card", "1 N")]
    scene = SimpleNamespace(inspected=lambda: shown[0], values={})
    card = InspectorCard(look)
    card.place(pygame.Rect(0, 0, 900, 700), look)
    pictures = set()
    for told in ("1 N", "2 N", ""):
        shown[0] = shown[0]._replace(told=told)
        card.update(0.02, scene)
        surface = pygame.Surface((900, 700), 0, 32)
        card.draw(surface)
        pictures.add(pygame.image.tobytes(surface, "RGB"))
    assert len(built) == 1 and len(pictures) == 3
    shown[0] = shown[0]._replace(title="Pin 4")
    card.update(0.02, scene)
    assert len(built) == 2
    card.close()
