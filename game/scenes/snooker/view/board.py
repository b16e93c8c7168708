"""The score board above the table; words, colours to nominate and options below it."""

from __future__ import annotations

from functools import lru_cache

import pygame

from game.billiards.table.snooker import COLOURS
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.boxes import rect_of
from game.scenes.shared.tables.buttons import draw_button
from game.scenes.snooker import layout
from game.scenes.snooker.course import Course
from game.scenes.snooker.view.words import Card, Line, Standing
from game.ui.canvas.canvas import Canvas
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.look.theme import FELT_GREEN, FELT_LINE
from game.ui.painters.ball_look import CAROM_WHITE, SNOOKER_RED
from game.ui.painters.ball_picture import ball_chip

COLORS = ("amber", "accent")  # of the two players
MOST_LINES = 2  # of words before options


def look_number(ball: int) -> int:
    """The number by which painters know a ball of snooker."""
    return CAROM_WHITE if ball == 0 else SNOOKER_RED if ball <= 15 else SNOOKER_RED + ball - 15


def draw_board(canvas: Canvas, look: Look, standing: Standing) -> None:
    """Title, cards, score, what is on."""
    rect = rect_of(canvas, layout.BOARD)
    if rect.w >= 60 and rect.h >= 16:
        canvas.surface.blit(_board_picture(standing, rect.size, look), rect)


@lru_cache(maxsize=12)
def _board_picture(standing: Standing, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The board as a picture, made again only when it says something else."""
    picture = pygame.Surface(size, pygame.SRCALPHA, 32)
    px, height = look.px, size[1]
    look.text(picture, standing.title, (px(4), 0.5 * height - px(10)), 15, "semibold", "text1")
    look.text(picture, standing.under, (px(4), 0.5 * height + px(10)), 12, "medium", "text3")
    width, left = px(layout.CARD), px(layout.CARD_FROM)
    boxes = [pygame.Rect(left, 0, width, height), pygame.Rect(size[0] - left - width, 0, width, height)]
    for player, card in enumerate(standing.cards):
        _draw_card(picture, boxes[player], card, player, look)
    right = boxes[1].left if len(standing.cards) == 2 else size[0]
    middle = 0.5 * (boxes[0].right + right)
    if standing.score:
        look.text(
            picture, standing.score, (middle - px(70), 0.5 * height - px(8)), 22, "display", "text1", "center"
        )
        words = look.fonts.fit(standing.caption, 11, "medium", px(120))
        look.text(picture, words, (middle - px(70), 0.5 * height + px(15)), 11, "medium", "text3", "center")
        middle += px(58)
    if standing.chip is not None:
        place = (round(middle - px(42)), height // 2)
        draw_disc(picture, place, px(15), FELT_GREEN)
        picture.blit(_chip(look, standing.chip), _chip(look, standing.chip).get_rect(center=place))
    at = middle - px(24)
    on = look.fonts.fit(standing.on, 13, "semibold", round(right - px(6) - at))
    look.text(picture, on, (at, 0.5 * height - px(9)), 13, "semibold", "text1")
    points = look.fonts.fit(standing.left, 12, "medium", round(right - px(6) - at))
    look.text(picture, points, (at, 0.5 * height + px(10)), 12, "medium", "text2")
    return picture


def _draw_card(picture: pygame.Surface, box: pygame.Rect, card: Card, player: int, look: Look) -> None:
    """Badge, name, what the player does, points."""
    theme, px = look.theme, look.px
    fill, line = (theme.accent_soft, theme.accent) if card.lit else (theme.panel, theme.line)
    draw_box(picture, box, px(8), fill, line, max(2, px(2)) if card.lit else look.border)
    badge = (box.left + px(24), box.centery)
    draw_disc(picture, badge, px(14), look.color(COLORS[player]))
    ink = theme.ink_on_amber if player == 0 else theme.on_accent
    look.text(picture, card.name[:1], badge, 14, "bold", ink, "center")
    space = box.w - px(46) - px(74)
    name = look.fonts.fit(card.name, 15, "semibold", space)
    status = look.fonts.fit(card.status, 12, "medium", space + px(10))
    look.text(picture, name, (box.left + px(46), box.centery - px(10)), 15, "semibold", "text1")
    look.text(picture, status, (box.left + px(46), box.centery + px(10)), 12, "medium", "text2")
    at = (box.right - px(14), box.centery)
    look.text(picture, card.points, at, 26, "display", "text1", "right")


def draw_foot(canvas: Canvas, look: Look, course: Course, line: Line) -> None:
    """The line of words, with the colours that can be nominated; or the options."""
    if course.phase == "aiming" and course.model.game.options and course.person_plays:
        _draw_options(canvas, look, course, line)
        return
    rect = rect_of(canvas, layout.FOOT)
    right = rect.right
    if course.may_aim and course.model.game.needs_call():
        right = _draw_colours(canvas, look, course) - look.px(12)
    if not line.lead:
        return
    x = rect.x + look.px(4)
    if line.foul:
        mark = icon("warning", look.px(18), look.color("vermilion"))
        canvas.surface.blit(mark, mark.get_rect(midleft=(x, rect.centery)))
        x += look.px(26)
    color = "vermilion" if line.foul else "text1"
    lead = look.fonts.fit(line.lead, 14, "semibold", right - x)
    look.text(canvas.surface, lead, (x, rect.centery), 14, "semibold", color)
    x += look.fonts.size(lead, 14, "semibold")[0] + look.px(10)
    if line.more and right - x > look.px(60):
        more = look.fonts.fit(line.more, 12, "medium", right - x)
        look.text(canvas.surface, more, (x, rect.centery + look.px(1)), 12, "medium", "text2")


def _draw_colours(canvas: Canvas, look: Look, course: Course) -> int:
    """The colours that can be nominated, the nominated one in a ring; the px where they begin."""
    chosen, allowed = course.call.ball, course.model.game.legal_first()
    (x, y), (right, _) = (
        canvas.camera.to_screen(*layout.chip_place(colour)) for colour in (COLOURS[0], COLOURS[-1])
    )
    cloth = pygame.Rect(0, 0, round(right - x) + look.px(34), look.px(28))
    cloth.center = (round(0.5 * (x + right)), round(y))
    draw_box(canvas.surface, cloth, look.px(14), FELT_GREEN)
    for colour in COLOURS:
        x, y = (round(value) for value in canvas.camera.to_screen(*layout.chip_place(colour)))
        if colour in allowed:
            chip = _chip(look, colour)
            canvas.surface.blit(chip, chip.get_rect(center=(x, y)))
        if colour == chosen:
            draw_disc(canvas.surface, (x, y), look.px(12), None, FELT_LINE, max(2, look.px(2)))
    left = cloth.left
    words = "Nominate" if not course.model.game.free_ball else "Free ball"
    look.text(canvas.surface, words, (left - look.px(8), y), 12, "semibold", "text2", "right")
    return left - look.px(8) - look.fonts.size(words, 12, "semibold")[0]


def _chip(look: Look, ball: int) -> pygame.Surface:
    """A ball on the cloth."""
    return ball_chip(look_number(ball), max(9.5 * look.k, 2.0), (FELT_GREEN.r, FELT_GREEN.g, FELT_GREEN.b))


def _draw_options(canvas: Canvas, look: Look, course: Course, line: Line) -> None:
    """The player that chooses and why, and what may be chosen, in the row below the table."""
    game, rect = course.model.game, rect_of(canvas, layout.FOOT)
    said = f"{line.lead} {line.more}".strip() or f"{game.shooter} chooses."
    lines = look.fonts.wrap(said, 11, "medium", look.px(layout.ASKED - 12.0))
    if len(lines) > MOST_LINES:
        lines = [*lines[: MOST_LINES - 1], look.fonts.fit(" ".join(lines[MOST_LINES - 1 :]), 11, "medium",
                                                          look.px(layout.ASKED - 12.0))]  # fmt: skip
    for row, words in enumerate(lines):
        y = rect.centery + (row - 0.5 * (len(lines) - 1)) * look.px(13)
        look.text(canvas.surface, words, (rect.x + look.px(4), y), 11, "medium",
                  "vermilion" if line.foul and not row else "text1")  # fmt: skip
    for row, option in enumerate(game.options):
        box = layout.option_box(row, len(game.options))
        pressed = course.grip == grip.option(row)
        draw_button(canvas, look, box, f"{row + 1}  {option.words}", False, pressed)
