"""What the card of a career shows: ladder, rating over time, records, and the cups."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pygame

from game.billiards.career.bracket import rounds_of
from game.billiards.career.career import Hand, Player, rating_history, rating_of, records_of, strength_of
from game.billiards.game.register import REGISTER
from game.billiards.players.ladder import BY_NAME, LadderPlayer
from game.billiards.players.ladder_ratings import ladder_ratings
from game.stage import Comparison
from game.ui.charts.comparison import draw_comparison
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspots

LADDER_ROW = 50  # design px
LINE = 22  # design px of a line of words
MOST_CUPS = 6  # on the shelf
NEWCOMERS_CUP = "Newcomers' cup"
FIRST_CUP = (
    "Your first cup will stand here.",
    "The newcomers' cup is two short matches:",
    "New tournament begins it.",
)
REACHED = ("quarter-final", "semi-final", "final", "cup")


def paint_ladder(
    picture: pygame.Surface,
    look: Look,
    area: pygame.Rect,
    places: Sequence[tuple[LadderPlayer, pygame.Rect]],
    shown: tuple[Player, str, str],
    spots: Hotspots,
) -> None:
    """The players of a game, the strongest above, each with the rating that was measured. shown: the person,
    the game, who is chosen.
    """
    player, game, chosen = shown
    px, theme, family = look.px, look.theme, REGISTER[game].family
    own = rating_of(player, family) or rating_of(player)
    mine = f"you {own.points:.0f} ± {own.error:.0f}" if own is not None else f"you: {unrated(player)[0]}"
    look.text(picture, f"Ladder of {REGISTER[game].title}", (area.x, area.y + px(8)), 13, "semibold", "text1")
    look.text(picture, mine, (area.right, area.y + px(8)), 12, "semibold", "amber", "right")
    beaten = {one.match.opponent for one in player.results if one.victory and one.match.game == game}
    for one, rect in places:
        name = f"opponent={one.name}"
        on, lit = one.name == chosen, spots.hover(name)
        fill = theme.accent_soft if on else theme.inset.lerp(theme.hover, lit)
        draw_box(picture, rect, px(8), fill, theme.accent if on else None, max(1, px(1)))
        title = look.fonts.fit(one.title, 14, "semibold", rect.w - px(110))
        look.text(picture, title, (rect.x + px(12), rect.y + px(14)), 14, "semibold", "text1")
        style = look.fonts.fit(one.style, 12, "medium", rect.w - px(110))
        look.text(picture, style, (rect.x + px(12), rect.y + px(32)), 12, "medium", "text2")
        rating = ladder_ratings(family).get(one.name)
        words = f"{rating.points:.0f} ± {rating.error:.0f}" if rating is not None else ""
        look.text(picture, words, (rect.right - px(30), rect.centery), 13, "medium", "text1", "right")
        if one.name in beaten:
            mark = icon("check", px(14), look.color("green"))
            picture.blit(mark, mark.get_rect(center=(rect.right - px(16), rect.centery)))
        if spots.focused == name:
            draw_box(picture, rect.inflate(px(4), px(4)), px(10), None, theme.accent, max(2, px(2)))


def unrated(player: Player) -> tuple[str, str, str]:
    """Why a person has no rating yet: in a word or two, and in two lines."""
    if player.results:
        return (
            "not rated yet",
            "Matches with points given do not count for your rating.",
            "Play one at level.",
        )
    first = "Your rating is worked out after the first match,"
    return "no match yet", first, "on FargoRate's scale: 100 points are 2 : 1."


def paint_rating(
    picture: pygame.Surface, look: Look, area: pygame.Rect, player: Player, chosen: tuple[str, str]
) -> None:
    """One's own rating match by match, beside that of the opponent at a game. chosen: opponent, game."""
    history = [one.points for one in rating_history(player)]
    if not history:
        draw_box(picture, area, look.px(10), look.theme.inset)
        for k, line in enumerate(unrated(player)[1:]):
            fitted = look.fonts.fit(line, 13, "medium", area.w - look.px(24))
            at = (area.centerx, area.centery + (2 * k - 1) * look.px(10))
            look.text(picture, fitted, at, 13, "medium", "text2", "center")
        return
    other = strength_of(*chosen)
    last = float(len(history))
    level = history[-1] if other is None else other
    expected = np.array([(1.0, level), (max(last, 2.0), level)])
    measured = np.array([(float(k), points) for k, points in enumerate(history, start=1)])
    title = BY_NAME[chosen[0]].title if chosen[0] in BY_NAME else "opponent"
    shown = Comparison(measured, expected, ("your rating", title), "", "match")
    draw_comparison(picture, look, area, shown, 1.0)


def hand_words(hand: Hand) -> str:
    """The noise of a person's hand, as it was measured."""
    return f"±{math.degrees(hand.azimuth):.2f}°, ±{hand.speed:.2f} m/s, {hand.strokes} strokes"


def paint_records(picture: pygame.Surface, look: Look, area: pygame.Rect, player: Player) -> None:
    """Matches, highest breaks and runs, the best tournament."""
    px, found = look.px, records_of(player)
    lines = [("Matches", f"{found.played}, won {found.victories}")]
    best = REACHED[found.best_cup] if found.best_cup >= 0 else "none yet"
    lines.append(("Best tournament", best))
    if player.hand is not None:
        lines.append(("Your hand", hand_words(player.hand)))
    for game, most in list(found.highest.items())[-4:]:
        entry = REGISTER.get(game)
        if entry is not None:
            what = "highest break" if entry.family == "snooker" else "longest run"
            lines.append((f"{entry.title}, {what}", str(most)))
    y = area.y + px(22)
    for label, value in lines:
        if y > area.bottom:
            return
        room = area.w - look.fonts.size(value, 13, "semibold")[0] - px(12)
        look.text(picture, look.fonts.fit(label, 13, "medium", room), (area.x, y), 13, "medium", "text2")
        look.text(picture, value, (area.right, y), 13, "semibold", "text1", "right")
        y += px(LINE)


def paint_cups(picture: pygame.Surface, look: Look, area: pygame.Rect, player: Player) -> None:
    """The running tournament's rounds, and the shelf with what was won before."""
    px = look.px
    y = area.y + px(8)
    if player.cup is not None:
        kind = NEWCOMERS_CUP if player.cup.newcomers else "Tournament"
        words = f"{kind}: {REGISTER[player.cup.game].title}"
        fitted = look.fonts.fit(words, 13, "semibold", area.w)
        look.text(picture, fitted, (area.x, y), 13, "semibold", "text1")
        y += px(LINE)
        for name, matches in rounds_of(player.cup.knockout):
            look.text(picture, name, (area.x, y), 12, "semibold", "text3")
            y += px(18)
            for one in matches:
                y = _paint_match(picture, look, (area, y), one, player.name)
            y += px(6)
    else:
        look.text(picture, "Cup shelf", (area.x, y), 13, "semibold", "text1")
        y += px(LINE + 4)
    for cup in list(reversed(player.cups))[:MOST_CUPS]:
        if y + px(20) > area.bottom:
            return
        won = cup.reached == 3
        sign = icon("cup", px(18), look.color("amber" if won else "text3"))
        picture.blit(sign, sign.get_rect(midleft=(area.x, y)))
        entry = REGISTER.get(cup.game)
        played = entry.title if entry else cup.game
        title = f"{NEWCOMERS_CUP}, {played}" if cup.newcomers else played
        came = title if won else f"{title}: {REACHED[cup.reached]}"  # the sign says that it was won
        dated, room = f"{came}, {cup.when[:10]}", area.w - px(26)
        fits = look.fonts.size(dated, 12, "medium")[0] <= room
        fitted = look.fonts.fit(dated if fits else came, 12, "medium", room)
        look.text(picture, fitted, (area.x + px(26), y), 12, "medium", "text1" if won else "text2")
        y += px(24)
    if not player.cups and player.cup is None:
        for k, line in enumerate(FIRST_CUP):
            words = look.fonts.fit(line, 12, "medium", area.w)
            look.text(picture, words, (area.x, y + k * px(18)), 12, "medium", "text2")


def _paint_match(
    picture: pygame.Surface, look: Look, at: tuple[pygame.Rect, int], match: tuple[str, str, str], person: str
) -> int:
    """One match of a tournament, its winner bold; the height below it."""
    (area, y), px = at, look.px
    x = area.x + px(6)
    for k, name in enumerate(match[:2]):
        title = BY_NAME[name].title if name in BY_NAME else name or "…"
        weight = "semibold" if name and name == match[2] else "medium"
        color = (
            "amber" if name == person and name else "text1" if not match[2] or name == match[2] else "text3"
        )
        fitted = look.fonts.fit(title, 12, weight, area.w // 2 - px(14))
        look.text(picture, fitted, (x + k * (area.w // 2), y), 12, weight, color)
    return y + px(18)
