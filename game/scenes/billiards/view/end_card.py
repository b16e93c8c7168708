"""The card at the end of a rack: who won it, what was counted of both players, the best stroke once more."""

from __future__ import annotations

import pygame

from game.billiards.game.frame import BestStroke, Frame, trajectory_of
from game.billiards.game.games import Ghost
from game.billiards.game.rules import ShotSummary, listed
from game.billiards.game.tally import Tally, balls_between
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table.table import Table
from game.scenes.billiards import layout
from game.scenes.billiards.play import AIMING, Play
from game.scenes.billiards.view.beside.record import rating_words
from game.scenes.billiards.view.cloth import dress_of
from game.scenes.shared.tables.referee.card import time_words
from game.scenes.shared.tables.rolling import balls_at
from game.scenes.shared.tables.seats.cup import after_match, won_with
from game.scenes.shared.tables.view import draw_balls, draw_table, frame_of
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING
from game.ui.look.shapes import draw_box

WIDTH, HEIGHT = 700.0, 264.0  # design px
TABLE_WIDTH, TABLE_HEIGHT = 330.0, 184.0  # of the picture of the best stroke
REST_S = 1.2  # s that the balls rest at its end before it begins again
HEADS = ("Potting rate", "Longest run", "Fouls")
IN_MATCH = "All racks: rate"

BOX = layout.Box(
    0.5 * (layout.TABLE.top + layout.TABLE.bottom - layout.metres(HEIGHT)),
    0.5 * (layout.TABLE.left + layout.TABLE.right - layout.metres(WIDTH)),
    0.5 * (layout.TABLE.top + layout.TABLE.bottom + layout.metres(HEIGHT)),
    0.5 * (layout.TABLE.left + layout.TABLE.right + layout.metres(WIDTH)),
)


def is_shown(play: Play) -> bool:
    """True when a rack of two players is over and nothing else is looked at."""
    game = play.model.frame.game
    return play.phase == AIMING and game.over and len(game.players) == 2


def figures_of(tally: Tally) -> tuple[str, ...]:
    """What is counted of a player, as it is written: HEADS."""
    rate = NOTHING if tally.rate is None else f"{100.0 * tally.rate:.0f} % of {tally.tries}"
    return rate, str(tally.longest), str(tally.fouls)


def words_of(summary: ShotSummary) -> str:
    """What a stroke that scored did, in a line."""
    balls = summary.balls_down
    words = f"{listed(balls)} down".replace(" or ", " and ")
    fallen = max(summary.pocketed, key=lambda one: (balls_between(one), one.rails))
    if balls_between(fallen):
        between = tuple(ball for ball in fallen.chain if ball not in (0, fallen.ball))
        words += f", by way of {listed(between)}".replace(" or ", " and ")
    if fallen.rails:
        words += f", off {fallen.rails} cushion{'s' * (fallen.rails != 1)}"
    return words[0].upper() + words[1:]


class EndCard:
    """The card, with the best stroke playing in it again and again."""

    def __init__(self) -> None:
        self._canvas: Canvas | None = None
        self._of: BestStroke | None = None
        self._trajectory: Trajectory | None = None

    def draw(self, canvas: Canvas, look: Look, play: Play) -> None:
        """Draw it in the middle of the table."""
        frame = play.model.frame
        rect, px = layout.rect_of(canvas, BOX), look.px
        draw_box(canvas.surface, rect, px(12), look.theme.panel, look.theme.line, look.border)
        game = frame.game
        assert game.winner is not None
        x, y = rect.x + px(24), rect.y + px(30)
        space = rect.w - px(TABLE_WIDTH + 72)
        won = won_with(play, "match" if play.match_over else "rack")
        title = look.fonts.fit(f"{game.players[game.winner]} wins the {won}", 20, "display", space)
        look.text(canvas.surface, title, (x, y), 20, "display", "text1")
        _draw_figures(canvas.surface, look, frame, x, y + px(44), space, time_words(play.rack_s))
        following = after_match(play).lower() or ("new match" if play.match_over else "next rack")
        words = f"Enter: {following}     U: undo"
        look.text(canvas.surface, words, (x, rect.bottom - px(24)), 12, "medium", "text3")
        if frame.best is not None:
            self._draw_best(canvas, look, play, frame.best, rect)

    def time(self, play: Play, best: BestStroke) -> float:
        """The moment of the best stroke that is shown, s: it is played over and over."""
        return play.rest_s % (self._path(best).end_time + REST_S)

    def _path(self, best: BestStroke) -> Trajectory:
        if self._of is not best or self._trajectory is None:
            self._of, self._trajectory = best, trajectory_of(best.struck)
        return self._trajectory

    def _draw_best(self, canvas: Canvas, look: Look, play: Play, best: BestStroke, rect: pygame.Rect) -> None:
        px = look.px
        place = pygame.Rect(0, 0, px(TABLE_WIDTH), px(TABLE_HEIGHT))
        place.topright = (rect.right - px(24), rect.y + px(44))
        look.text(canvas.surface, "Best stroke", (place.x, rect.y + px(28)), 13, "semibold", "text2")
        before, path = best.struck.frame, self._path(best)
        balls = balls_at(before, path, play.model.turns, min(self.time(play, best), path.end_time))
        inner = self._small_canvas(canvas)
        inner.begin(canvas.surface, place, _camera_on(before.table, place, canvas))
        try:
            dress = dress_of(play)
            draw_table(inner, before.table, dress=dress)
            draw_balls(inner, balls, before.table, felt=dress.felt)
        finally:
            inner.end()
        words = look.fonts.fit(words_of(best.summary), 12, "medium", place.w)
        look.text(canvas.surface, words, (place.x, place.bottom + px(16)), 12, "medium", "text2")

    def _small_canvas(self, canvas: Canvas) -> Canvas:
        if self._canvas is None or self._canvas.look is not canvas.look:
            self._canvas = Canvas(canvas.look)
            self._canvas.covered = True
        return self._canvas


def _camera_on(table: Table, place: pygame.Rect, canvas: Canvas) -> Camera:
    camera = Camera(y_up=canvas.camera.y_up, quarter_turns=1)
    camera.fit(frame_of(table), place, 0.0)
    return camera


def _draw_figures(
    surface: pygame.Surface, look: Look, frame: Frame, x: float, y: float, space: int, time: str
) -> None:
    """A row for each thing that is counted, a column for each player. time: that the rack took, in words."""
    px = look.px
    columns = x + 0.62 * space, x + space
    for column, name in zip(columns, frame.game.players, strict=True):
        name = look.fonts.fit(name, 13, "semibold", round(0.34 * space))
        look.text(surface, name, (column, y), 13, "semibold", "text1", "right")
    rows = [(HEADS[k], *(figures_of(tally)[k] for tally in frame.rack_tallies)) for k in range(len(HEADS))]
    if isinstance(frame.game, Ghost):
        won, lost = frame.game.won
        if frame.game.set_over:
            rows.append(("Rating", rating_words(won, lost), ""))
    elif frame.tallies != frame.rack_tallies:
        rows.append((IN_MATCH, *(figures_of(tally)[0] for tally in frame.tallies)))
    rows.append(("Time", "", time))
    for row, (head, *figures) in enumerate(rows, start=1):
        height = y + px(28) * row
        look.text(surface, head, (x, height), 13, "medium", "text2")
        for column, words in zip(columns, figures, strict=True):
            look.text(surface, words, (column, height), 13, "semibold", "text1", "right")
