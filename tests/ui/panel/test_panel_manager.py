"""The panel's manager: a theme is read once, and no manager leaves anything behind."""

from __future__ import annotations

import gc
import threading
import weakref

import pygame
import pytest
from pygame_gui import ui_manager
from pygame_gui.core.ui_appearance_theme import UIAppearanceTheme
from pygame_gui.elements import UIButton

from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from game.ui.panel import manager as panel_manager
from game.ui.panel.manager import MOST_THEMES, DropDown, PanelManager


@pytest.fixture(autouse=True)
def no_themes(monkeypatch: pytest.MonkeyPatch):
    pygame.font.init()
    monkeypatch.setattr(panel_manager, "_themes", {})


def test_a_theme_is_read_once_for_each_look():
    look, light = Look(theme_named("dark"), 1.0), Look(theme_named("light"), 1.0)
    first = PanelManager((300, 400), look).get_theme()
    assert PanelManager((500, 900), Look(theme_named("dark"), 1.0)).get_theme() is first
    assert PanelManager((300, 400), light).get_theme() is not first
    for i in range(20):
        PanelManager((300, 400), Look(theme_named("dark"), 1.0 + 0.1 * i))
    assert len(panel_manager._themes) == MOST_THEMES


def test_managers_of_one_look_draw_alike():
    pictures = []
    for _ in range(2):
        manager = PanelManager((200, 60), Look(theme_named("dark"), 1.0))
        UIButton(pygame.Rect(10, 10, 150, 30), "Words", manager)
        manager.update(0.0)
        surface = pygame.Surface((200, 60), 0, 32)
        manager.draw_ui(surface)
        pictures.append(pygame.image.tobytes(surface, "RGB"))
    assert pictures[0] == pictures[1] and len(set(pictures[0])) > 2


def test_the_theme_keeps_no_long_keys():
    manager = PanelManager((200, 600), Look(theme_named("dark"), 1.0))
    names = [(f"Word {i}", f"word {i}") for i in range(12)]
    menu = DropDown(names, "word 1", pygame.Rect(10, 10, 150, 30), manager)
    plain = UIAppearanceTheme.build_all_combined_ids(manager.get_theme(), ["a"], ["b"], [None], ["c"])
    assert manager.get_theme().build_all_combined_ids(["a"], ["b"], [None], ["c"]) == plain
    for kind in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
        manager.point((50, 20))
        manager.tell(pygame.Event(kind, pos=(50, 20), button=1))
    manager.update(0.1)
    assert menu.is_open
    keys = manager.get_theme().unique_theming_ids
    assert keys and sum(map(len, keys)) < 20_000


def test_managers_leave_nothing_behind():
    look = Look(theme_named("dark"), 1.0)
    PanelManager((200, 60), look)  # the very first is kept as the toolkit's default
    paths, threads = len(ui_manager.i18n.load_path), threading.active_count()
    kept = []
    for _ in range(10):
        manager = PanelManager((200, 60), look)
        UIButton(pygame.Rect(10, 10, 150, 30), "Words", manager)
        manager.clear_and_reset()
        kept.append(weakref.ref(manager))
        del manager
    gc.collect()
    assert [ref for ref in kept if ref() is not None] == []
    assert len(ui_manager.i18n.load_path) == paths and threading.active_count() <= threads
