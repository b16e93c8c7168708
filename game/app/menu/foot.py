"""The menu's foot: key hints at the left, how many scenes there are at the right."""

from __future__ import annotations

import pygame

from game.app.menu.flow import MARGIN
from game.app.screens.host import Host
from game.app.window.commands import COMMANDS
from game.app.window.keys import chord_label, parse_chord
from game.ui.widgets import keycap

WORDS_FROM = 900  # design px of width below which only hints are shown


def paint_foot(picture: pygame.Surface, host: Host, foot: pygame.Rect, searching: bool, words: str) -> None:
    """Paint the foot at its place; hints are dropped from the right."""
    look, px = host.look, host.look.px
    picture.fill(look.theme.panel, foot)
    picture.fill(look.theme.line, (foot.x, foot.y, foot.w, look.border))
    right = foot.right - px(MARGIN)
    if foot.w >= px(WORDS_FROM):
        right -= look.text(picture, words, (right, foot.centery), 12, "medium", "text3", "right").w + px(24)
    x = foot.x + px(MARGIN)
    for keys, what in _hints(host, searching):
        end = x + keycap.keys_width(look, keys) + px(8) + look.fonts.size(what, 12)[0]
        if end > right:
            break
        x += keycap.draw_keys(picture, look, x, foot.centery, keys) + px(8)
        look.text(picture, what, (x, foot.centery), 12, "medium", "text2")
        x = end + px(20)


def _hints(host: Host, searching: bool) -> list[tuple[tuple[str, ...], str]]:
    label = host.keys.label
    hints: list[tuple[tuple[str, ...], str]] = [(("←", "↑", "↓", "→"), "choose")]
    hints.append(((chord_label(parse_chord("return")),), "open"))
    hints.append(((label("back"),), "all scenes") if searching else (("A", "…", "Z"), "search"))
    return hints + [((label(command.name),), command.foot) for command in COMMANDS if command.foot]
