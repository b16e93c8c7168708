"""The score board above the table, words and buttons below it."""

from __future__ import annotations

import pygame

from game.billiards.game.games.artistic import ATTEMPTS, Artistic
from game.billiards.game.games.artistic_figures import FIGURES, LETTERS
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_kinds import TITLES
from game.billiards.map.words import explain
from game.billiards.players.ladder import BY_NAME
from game.scenes.carom import layout
from game.scenes.carom.advisor import Drawn
from game.scenes.carom.course import Course
from game.scenes.shared.tables.boxes import rect_of
from game.scenes.shared.tables.choices import player_words
from game.scenes.shared.tables.course import PERSON, REPLAY
from game.scenes.shared.tables.minds.thoughts import Told
from game.scenes.shared.tables.referee.card import Counted, time_words
from game.scenes.shared.tables.seats.cup import after_match, with_round, won_with
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.painters.ball_look import CAROM_WHITE
from game.ui.painters.ball_picture import ball_chip

BUTTON_WORDS = {"play": "Play it", "strike": "Strike", "undo": "Undo", "next": "New game", "eye": "Sight",
                "replay": "Replay", "coach": "Coach", "film-strokes": "Film"}  # fmt: skip
ROUTE_WORDS = dict(zip(LETTERS, ("long cushion", "long cushion", "short cushion", "short cushion", "yellow",
                                 "red"), strict=True))  # fmt: skip
CHOICES = 3  # that are put into words
TITLE = 156  # design px before the cards


def draw_board(canvas: Canvas, look: Look, course: Course) -> None:
    """Name of the game, and a card for each player."""
    rect = rect_of(canvas, layout.BOARD)
    game, px = course.model.frame.game, look.px
    look.text(
        canvas.surface, TITLES[game.kind], (rect.x + px(30), rect.centery - px(10)), 15, "semibold", "text1"
    )
    ends = f"race to {game.target}" if game.target else "no end"
    if isinstance(game, Artistic):
        ends = f"figure {game.figure + 1} of {len(FIGURES)}"
    if game.most_innings:
        ends = f"{ends}, {game.most_innings} innings" if game.target else f"{game.most_innings} innings"
    ends = with_round(ends, course)
    if course.coached:
        ends = f"{ends}, coached"
    look.text(canvas.surface, ends, (rect.x + px(30), rect.centery + px(10)), 12, "medium", "text3")
    count = len(game.players)
    width = (rect.w - px(TITLE) - px(10) * (count - 1)) // count
    for player in range(count):
        box = pygame.Rect(rect.x + px(TITLE) + player * (width + px(10)), rect.y, width, rect.h)
        _draw_card(canvas, look, box, course, player)


def _draw_card(canvas: Canvas, look: Look, box: pygame.Rect, course: Course, player: int) -> None:
    """Ball, name, points; run, average and high run under them."""
    game, theme, px = course.model.frame.game, look.theme, look.px
    lit = player == game.turn and not game.ended
    fill = theme.accent_soft if lit else theme.panel
    draw_box(
        canvas.surface, box, px(8), fill, theme.accent if lit else theme.line, max(1, px(2 if lit else 1))
    )
    ball = player if len(game.players) == 2 else game.alone_with
    chip = ball_chip(CAROM_WHITE + ball, max(11.0 * look.k, 3.0), (fill.r, fill.g, fill.b))
    canvas.surface.blit(chip, chip.get_rect(center=(box.x + px(24), box.centery)))
    x, room = box.x + px(46), box.w - px(46) - px(70)
    name = look.fonts.fit(_name(course, player), 15, "semibold", room)
    look.text(canvas.surface, name, (x, box.centery - px(10)), 15, "semibold", "text1")
    run = f"run {game.run}, " if lit else ""
    if isinstance(game, Artistic) and lit:
        run = f"attempt {game.attempts + 1} of {ATTEMPTS}, "
    had = f"{game.innings[player]} innings, average {game.average(player):.2f}"
    said = f"{run}{had}, high run {game.high_runs[player]}"
    room = box.w - px(46) - px(62)
    if look.fonts.size(said, 12, "medium")[0] > room:
        said = f"{run}average {game.average(player):.2f}, high run {game.high_runs[player]}"
    said = look.fonts.fit(said, 12, "medium", room)
    look.text(canvas.surface, said, (x, box.centery + px(10)), 12, "medium", "text2")
    look.text(
        canvas.surface,
        str(game.points[player]),
        (box.right - px(16), box.centery),
        26,
        "display",
        "text1",
        "right",
    )


def _name(course: Course, player: int) -> str:
    """A player's name, and of which grade it is."""
    grade = course.grade_of(player)
    name = course.model.frame.game.players[player]
    if grade in BY_NAME:
        return BY_NAME[grade].title
    return name if grade == PERSON else f"{name}, {player_words(grade)}"


def draw_foot(canvas: Canvas, look: Look, course: Course, drawn: Drawn | None, told: Told) -> None:
    """What was said last; options to choose; else what the computer player thought, or the first choices in
    words. And the buttons.
    """
    rect = rect_of(canvas, layout.FOOT)
    frame = course.model.frame
    y = rect.y + look.px(10)
    lesson = course.learning.lesson
    said = " ".join(frame.words) or (lesson.says if lesson is not None else figure_words(frame.game))
    if said:
        words = look.fonts.fit(said, 13, "semibold", rect.w)
        look.text(canvas.surface, words, (rect.x + look.px(4), y), 13, "semibold",
                  "vermilion" if frame.foul else "text1")  # fmt: skip
        y += look.px(20)
    if frame.game.options and course.person_plays:
        _draw_options(canvas, look, course)
    elif told.chosen:
        area = pygame.Rect(rect.x + look.px(4), y, rect.right - rect.x, rect.bottom - y)
        for k, words in enumerate((told.chosen, told.instead)):
            fitted = look.fonts.fit(words, 12, "medium", area.w)
            look.text(canvas.surface, fitted, (area.x, y + k * look.px(16)), 12, "medium", "text2")
    elif course.parameters.explain and drawn is not None and drawn.map.fine:
        _draw_choices(canvas, look, drawn, (rect.x + look.px(4), y, rect.right, rect.bottom))
    for row, name in enumerate(layout.BUTTONS):
        _draw_button(canvas, look, course, row, name)


def figure_words(game: Carom) -> str:
    """Which figure is to be made; "" for a game without."""
    if not isinstance(game, Artistic) or game.over:
        return ""
    return (
        f"{game.now.name}, {game.now.points} points: {', '.join(ROUTE_WORDS[one] for one in game.now.route)}."
    )


def _draw_choices(canvas: Canvas, look: Look, drawn: Drawn, area: tuple[float, float, float, float]) -> None:
    """The first three groups in sentences, as many lines as there is space for."""
    x, y, right, bottom = area
    pitch = look.fonts.line_height(11) - look.px(2)
    for place, group in enumerate(drawn.map.groups[:CHOICES]):
        words = f"{place + 1}. {' '.join(explain(drawn.position, group))}"
        for line in look.fonts.wrap(words, 11, "medium", int(right - x)):
            if y + 0.4 * pitch > bottom:
                return
            look.text(canvas.surface, line, (x, y), 11, "medium", "text2" if place else "text1")
            y += pitch
        y += look.px(2)


def _draw_options(canvas: Canvas, look: Look, course: Course) -> None:
    options = course.model.frame.game.options
    for row, option in enumerate(options):
        box = rect_of(canvas, layout.option_box(row, len(options)))
        draw_box(canvas.surface, box, look.px(6), look.theme.accent_soft, look.theme.accent, look.border)
        words = look.fonts.fit(f"{row + 1}  {option.words}", 12, "semibold", box.w - look.px(16))
        look.text(canvas.surface, words, box.center, 12, "semibold", "text1", "center")


def _draw_button(canvas: Canvas, look: Look, course: Course, row: int, name: str) -> None:
    box = rect_of(canvas, layout.button_box(row))
    usable = {
        "play": course.may_aim and course.chosen is not None,
        "strike": course.may_aim or course.phase == "rolling",
        "undo": course.model.frame.earlier is not None,
        "replay": course.phase == REPLAY or course.model.frame.last is not None,
        "film-strokes": course.may_film,
    }.get(name, True)
    main = usable and (
        name == "play"
        or (name == "next" and bool(course.learning.best or after_match(course)))
        or (name in ("eye", "coach") and getattr(course.parameters, name))
    )
    fill = look.theme.accent if main else look.theme.inset
    draw_box(canvas.surface, box, look.px(6), fill, None if main else look.theme.line, look.border)
    said = {("strike", "rolling"): "To the end", ("replay", REPLAY): "Back"}
    words = said.get((name, course.phase), BUTTON_WORDS[name])
    if name == "next":
        words = "Next lesson" if course.learning.best else after_match(course) or words
    color = "on_accent" if main else "text1" if usable else "text3"
    look.text(canvas.surface, words, box.center, 12, "semibold", color, "center")


def counted_of(course: Course) -> Counted:
    """What the card at the end of a game says."""
    game, seconds = course.model.frame.game, course.frame_s
    won = won_with(course, "")
    title = f"{game.players[game.winner]} wins{won and f' the {won}'}" if game.winner is not None else "Drawn"
    first, second = (
        (str(game.points[k]), str(game.innings[k]), f"{game.average(k):.2f}", str(game.high_runs[k]))
        for k in range(2)
    )
    heads = ("Points", "Innings", "Average", "High run")
    rows = (*zip(heads, first, second, strict=True), ("Time", "", time_words(seconds)))
    foot = f"N: {after_match(course).lower() or 'next game'}     U: undo"
    return Counted(title, (game.players[0], game.players[1]), rows, foot)
