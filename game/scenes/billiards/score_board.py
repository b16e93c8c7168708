"""The score board above the table: who plays, with what, how it stands; and the line below that says why."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import pygame

from game.billiards.game.games import CombinationMatch, Drill, EightBall, NineBall, Practice
from game.billiards.game.games.eight_ball import GROUPS
from game.billiards.game.goals import described
from game.billiards.game.rules import listed
from game.scenes.billiards import layout
from game.scenes.billiards.play import AIMING, REPLAY, ROLLING, SET_UP, STRIKING
from game.scenes.billiards.prediction import stroke_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.look.theme import FELT_COOL, FELT_LINE
from game.ui.painters.ball_picture import ball_chip

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

COLORS = ("amber", "accent")  # of the two players
GAME_TITLES = {
    EightBall: "8-ball", NineBall: "9-ball", CombinationMatch: "Combination", Practice: "Practice",
    Drill: "Drill",
}  # fmt: skip
MOST_CHIPS = 9
KEY = (("white ball", FELT_LINE, False), ("after the hit", FELT_LINE, True), ("other balls", FELT_COOL, True))


class Card(NamedTuple):
    """What the card of a player says. lit: at turn, or the winner. chips: balls; those gone are ticked."""

    name: str
    status: str
    lit: bool
    chips: tuple[tuple[int, bool], ...] = ()


class Standing(NamedTuple):
    """All that the board says."""

    title: str
    under: str
    cards: tuple[Card, ...]
    score: str
    caption: str


def standing_of(scene: Billiards) -> Standing:
    """How the game stands."""
    game = scene.round.game
    title = GAME_TITLES.get(type(game), "")
    if scene.phase == SET_UP:
        title, under = "Set up", "free placing"
    elif scene.phase == REPLAY:
        under = "replay"
    else:
        under = _situation(scene)
    if len(game.players) == 1:
        return Standing(title, under, (_single(scene),), "", "")
    cards = tuple(_card(scene, player) for player in range(2))
    score = f"{game.won[0]} : {game.won[1]}"
    caption = "racks"
    if isinstance(game, CombinationMatch):
        score, caption = f"{game.points[0]} : {game.points[1]}", "balls"
    return Standing(title, under, cards, score, caption)


def _situation(scene: Billiards) -> str:
    game = scene.round.game
    if game.over:
        return "rack over"
    if game.opening:
        return "break"
    if isinstance(game, EightBall) and game.open_table:
        return "open table"
    return f"{len(game.on_table)} on the table"


def _card(scene: Billiards, player: int) -> Card:
    """The card of one of two players."""
    game = scene.round.game
    active = game.turn == player and not game.over
    won = game.over and game.winner == player
    doing = _doing(scene) if active else "won the rack" if won else ""
    parts = []
    chips: tuple[tuple[int, bool], ...] = ()
    if isinstance(game, EightBall) and game.groups[player]:
        group = GROUPS[game.groups[player]]
        left = game.balls_of(player)
        chips = tuple((ball, ball not in left) for ball in group)
        count = "" if doing else f", {len(left)} left"  # at the turn the chips alone tell it: room is scarce
        if not won:
            parts.append(f"{game.groups[player]}{count}" if left else "on the 8")
    elif isinstance(game, NineBall) and active and not game.options:
        parts.append(f"on {listed(game.legal_first())}")
    if game.fouls_in_row[player] and isinstance(game, NineBall):
        parts.append(f"{game.fouls_in_row[player]} foul{'s' * (game.fouls_in_row[player] > 1)} in a row")
    if doing:
        parts.append(doing)
    grade = scene.grade_of(player)
    name = game.players[player] if grade == "person" else f"{game.players[player]} ({grade})"
    return Card(name, " · ".join(parts), active or won, chips)


def _doing(scene: Billiards) -> str:
    """What the player at turn does."""
    game = scene.round.game
    if scene.phase in (SET_UP, REPLAY):
        return ""
    if scene.phase in (STRIKING, ROLLING):
        return "plays"
    if game.options:
        return "chooses"
    if scene.plays_itself:
        return "plays by itself"
    if not scene.person_plays:
        return "thinks" if scene.thinker.warm else "gets ready (once, some seconds)"
    if scene.call.safety:
        return "plays safe"
    if scene.call.push_out:
        return "pushes out"
    return "white ball in hand" if game.in_hand else "aims"


def _single(scene: Billiards) -> Card:
    """The card of the only player."""
    game = scene.round.game
    if isinstance(game, Drill):
        stars = "★" * game.best + "☆" * (1 + len(game.more) - game.best)
        tries = (
            f"{game.made} of {game.attempts} made, {game.streak} in a row" if game.attempts else "first try"
        )
        title = scene.level.title if scene.level is not None and scene.level.title else game.players[0]
        return Card(title, f"{stars}   {tries}", True)
    if isinstance(game, Practice):
        strokes = f"{game.strokes} stroke{'s' * (game.strokes != 1)}"
        status = f"{game.potted} potted with {strokes}, run of {game.run}"
        return Card(
            game.players[0], status, True, tuple((ball, False) for ball in game.on_table[:MOST_CHIPS])
        )
    return Card(game.players[0], "", True)


# -- drawing ------------------------------------------------------------------------------------------


def draw_board(scene: Billiards, canvas: Canvas, look: Look) -> None:
    """Title, cards and score; and the line below the table."""
    rect = layout.rect_of(canvas, layout.BOARD)
    if rect.w < 60 or rect.h < 16:
        return
    picture = _board_picture(standing_of(scene), rect.size, look)
    canvas.surface.blit(picture, rect)
    if scene.phase not in (SET_UP, REPLAY):
        _draw_line(scene, canvas, look)


@lru_cache(maxsize=12)
def _board_picture(standing: Standing, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The board as a picture, made anew only when it says something else."""
    picture = pygame.Surface(size, pygame.SRCALPHA, 32)
    px, height = look.px, size[1]
    look.text(picture, standing.title, (px(4), 0.5 * height - px(10)), 15, "semibold", "text1")
    look.text(picture, standing.under, (px(4), 0.5 * height + px(10)), 12, "medium", "text3")
    if len(standing.cards) == 1:
        box = pygame.Rect(px(layout.CARD_FROM), 0, size[0] - 2 * px(layout.CARD_FROM), height)
        _draw_card(picture, box, standing.cards[0], 0, look)
        return picture
    width = px(layout.CARD)
    boxes = (
        pygame.Rect(px(layout.CARD_FROM), 0, width, height),
        pygame.Rect(size[0] - px(layout.CARD_FROM) - width, 0, width, height),
    )
    for player, (card, box) in enumerate(zip(standing.cards, boxes, strict=True)):
        _draw_card(picture, box, card, player, look)
    middle = 0.5 * size[0]
    look.text(picture, standing.score, (middle, 0.5 * height - px(8)), 24, "display", "text1", "center")
    look.text(picture, standing.caption, (middle, 0.5 * height + px(17)), 12, "medium", "text3", "center")
    return picture


def _draw_card(picture: pygame.Surface, box: pygame.Rect, card: Card, player: int, look: Look) -> None:
    """One card; the second player's is mirrored."""
    theme, px = look.theme, look.px
    fill, line = (theme.accent_soft, theme.accent) if card.lit else (theme.panel, theme.line)
    draw_box(picture, box, px(8), fill, line, max(2, px(2)) if card.lit else look.border)
    side = 1 if player == 0 else -1
    edge = box.left if player == 0 else box.right
    align = "left" if player == 0 else "right"
    badge = (edge + side * px(26), box.centery)
    draw_disc(picture, badge, px(15), look.color(COLORS[player]))
    ink = theme.ink_on_amber if player == 0 else theme.on_accent
    look.text(picture, card.name[:1], badge, 15, "bold", ink, "center")
    x = edge + side * px(50)
    room = box.w - px(62)
    chips_width = len(card.chips) * px(18)
    if room - chips_width < px(100):
        chips_width = 0
    name = look.fonts.fit(card.name, 15, "semibold", room - chips_width)
    status = look.fonts.fit(card.status, 12, "medium", room - chips_width)
    look.text(picture, name, (x, box.centery - px(10)), 15, "semibold", "text1", align)
    look.text(picture, status, (x, box.centery + px(10)), 12, "medium", "text2", align)
    if not chips_width:
        return
    far = box.right - px(16) if player == 0 else box.left + px(16)
    for place, (number, gone) in enumerate(reversed(card.chips) if player == 0 else card.chips):
        at = (far - side * place * px(18), box.centery)
        if gone:
            draw_disc(picture, at, px(7), None, theme.line2, look.border)
            tick = icon("check", px(10), theme.text3)
            picture.blit(tick, tick.get_rect(center=at))
        else:
            chip = ball_chip(number, max(8.0 * look.k, 2.0), (fill.r, fill.g, fill.b))
            picture.blit(chip, chip.get_rect(center=at))


def _draw_line(scene: Billiards, canvas: Canvas, look: Look) -> None:
    """What was said last, or what to do now."""
    rect = layout.rect_of(canvas, layout.FOOT)
    words, foul = line_of(scene)
    if not words:
        _draw_key(scene, canvas, look, rect)
        return
    x = rect.x + look.px(4)
    if foul:
        mark = icon("warning", look.px(18), look.color("vermilion"))
        canvas.surface.blit(mark, mark.get_rect(midleft=(x, rect.centery)))
        x += look.px(26)
    room = rect.right - x - _draw_key(scene, canvas, look, rect)
    text = look.fonts.fit(words, 14, "medium", room)
    look.text(canvas.surface, text, (x, rect.centery), 14, "medium", "vermilion" if foul else "text1")


def _draw_key(scene: Billiards, canvas: Canvas, look: Look, rect: pygame.Rect) -> int:
    """What the lines on the cloth mean, at the right end of the row; the width it takes, px."""
    if scene.phase != AIMING or not (scene.prediction and scene.person_plays and scene.round.playable):
        return 0
    picture = _key_picture(rect.h, look)
    canvas.surface.blit(picture, picture.get_rect(midright=(rect.right - look.px(4), rect.centery)))
    return picture.get_width() + look.px(22)


@lru_cache(maxsize=4)
def _key_picture(height: int, look: Look) -> pygame.Surface:
    """The words and samples of the lines."""
    gap, sample = look.px(18), look.px(24) + look.px(8)
    widths = [look.fonts.size(words, 12)[0] + sample for words, _, _ in KEY]
    picture = pygame.Surface((sum(widths) + gap * (len(KEY) - 1), max(height, 1)), pygame.SRCALPHA, 32)
    x, middle = 0, height // 2
    for (words, color, dashed), wide in zip(KEY, widths, strict=True):
        for k in range(3 if dashed else 1):
            box = pygame.Rect(
                x + k * look.px(9), middle - 1, look.px(6 if dashed else 24), max(2, look.px(2))
            )
            on_paper = color is FELT_LINE and look.theme.name != "dark"
            draw_box(picture, box, 0, look.theme.text1 if on_paper else color)
        look.text(picture, words, (x + sample, middle), 12, "medium", "text3")
        x += wide + gap
    return picture


def line_of(scene: Billiards) -> tuple[str, bool]:
    """The line below the table, and whether it tells of a foul."""
    game, round_ = scene.round.game, scene.round
    if scene.phase in (STRIKING, ROLLING):
        return _announced(scene), False
    if scene.hint_shown and scene.phase == AIMING and scene.content.solution is not None:
        return f"Hint: {', '.join(stroke_words(scene.content.solution.stroke()))}.", False
    if round_.words:
        return " ".join(round_.words), round_.foul
    if isinstance(game, Drill):
        return " ".join(described(game.goal, layout.POCKETS)), False
    if scene.phase != AIMING or scene.plays_itself or not scene.person_plays:
        return "", False
    alone = len(game.players) == 1
    if game.in_hand:
        where = " behind the line" if game.in_hand == "behind the line" else ""
        who = "The white ball is" if alone else f"{game.shooter} has the white ball"
        return f"{who} in hand: drag it{where}, then pull the cue back and let go.", False
    return "Aim, pull the cue back and let go." if alone else f"{game.shooter} plays.", False


def _announced(scene: Billiards) -> str:
    """What was called before the stroke, in words."""
    last = scene.round.last
    call = scene.call if scene.phase == STRIKING or last is None else last.call
    if call.safety:
        return "A safety."
    if call.push_out:
        return "A push-out."
    if call.ball is None or call.pocket is None or not scene.round.game.needs_call():
        return ""
    return f"Called: the {call.ball} into the {layout.pocket_words(call.pocket)}."
