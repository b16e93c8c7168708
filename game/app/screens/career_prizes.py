"""What a career has unlocked, on its card: the colours and tables that are won, and what wins the next."""

from __future__ import annotations

import pygame

from game.billiards.career.career import Player
from game.billiards.career.prizes import PRIZES, next_prize, progress, unlocked_of
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

PRIZES_HEIGHT = 108  # design px
LINE, BAR = 20, 6  # design px


def prize_words(player: Player) -> list[str]:
    """The lines, without the head: what was won last, what is next, what it takes."""
    won = unlocked_of(player)
    titles = [one.title for one in PRIZES if one.name in won]
    lines = [f"{len(titles)} of {len(PRIZES)}" + (f", such as {titles[-1].lower()}" if titles else "")]
    prize = next_prize(player)
    if prize is None:
        return [*lines, "Nothing is locked any more."]
    done = min(progress(player, prize), prize.needed)
    count = f" ({done} of {prize.needed})" if prize.kind != "cup" and prize.needed > 1 else ""
    return [*lines, f"Next: {prize.title.lower()}", f"{prize.words}{count}"]


def paint_prizes(picture: pygame.Surface, look: Look, area: pygame.Rect, player: Player) -> None:
    """Head, lines, and a bar of how far the next prize is."""
    px = look.px
    look.text(picture, "Tables and cloths", (area.x, area.y + px(10)), 13, "semibold", "text1")
    for k, line in enumerate(prize_words(player)):
        color = "text1" if k == 1 else "text2"
        fitted = look.fonts.fit(line, 12, "medium", area.w)
        look.text(picture, fitted, (area.x, area.y + px(32) + k * px(LINE)), 12, "medium", color)
    prize = next_prize(player)
    if prize is None:
        return
    bar = pygame.Rect(area.x, area.y + px(34) + 3 * px(LINE), area.w, px(BAR))
    draw_box(picture, bar, px(3), look.theme.inset)
    share = min(progress(player, prize) / prize.needed, 1.0)
    if share > 0.0:
        bar.w = max(round(bar.w * share), px(BAR))
        draw_box(picture, bar, px(3), look.theme.accent)
