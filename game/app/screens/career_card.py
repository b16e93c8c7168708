"""The card of a career: the ladder, the rating over time, records and cups, and the next match."""

from __future__ import annotations

import time
from typing import ClassVar

import msgspec
import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.career_parts import LADDER_ROW, paint_cups, paint_ladder, paint_rating, paint_records
from game.app.screens.career_prizes import PRIZES_HEIGHT, paint_prizes
from game.app.screens.host import Host
from game.app.screens.question import Question
from game.app.stagehand.career_file import keep_career, load_career
from game.app.stagehand.career_opening import begin_match
from game.app.stagehand.start_choices import own_choices
from game.app.window.commands import Actions
from game.billiards.career.career import LONGEST_NAME, Career, Match, Player
from game.billiards.career.matches import (
    cup_match,
    fair_head_start,
    is_newcomer,
    new_cup,
    next_opponent,
    opponents_at,
)
from game.billiards.game.register import REGISTER
from game.billiards.players.ladder import BY_NAME
from game.ui.widgets.hotspots import Hotspot
from game.ui.widgets.list_row import ListRow

LEFT, GAP, FOOT, BUTTON = 268, 20, 84, 38  # design px: width of the ladder, between columns, foot, buttons
FAIR, LEVEL = "fair", "level"
NEWCOMERS, EIGHT_PLAYERS = "newcomers", "eight"
CUPS = (
    ListRow("Newcomers' cup", "two short matches with the weakest three, half an hour", value=NEWCOMERS),
    ListRow("Tournament of eight", "three rounds with the strongest", value=EIGHT_PLAYERS),
)
NAME = Question("Your name", "It stands on the score board, and your career is kept under it.", "Begin", "",
                "A name of your own", LONGEST_NAME)  # fmt: skip
BUTTONS = ("player", "game", "start", "cup", "statistics", "play")  # from the left


class CareerCard(CardScreen):
    """Enter plays; a row of the ladder chooses the opponent; Esc leads back."""

    called: ClassVar[str] = "The career"
    width: ClassVar[float] = 1080.0
    height: ClassVar[float] = 620.0

    def __init__(self, host: Host) -> None:
        self.career, complaint = load_career()
        if complaint:
            host.tell("Career.", complaint, "warning")
        last = self.player.results[-1].match.game if self.player and self.player.results else "eight-ball"
        self.game = last if last in REGISTER else "eight-ball"
        self.opponent = ""
        self.start = FAIR if self.player and self.player.cup and self.player.cup.fair else LEVEL
        self.in_cup = True  # if one goes on
        super().__init__(host)
        self._choose_next()
        self.restyle()
        self._asked = self.player is not None

    # -- the career ---------------------------------------------------------------------------------

    @property
    def player(self) -> Player | None:
        """Who plays; None before a name has been given."""
        return self.career.player

    @property
    def heading(self) -> str:
        return f"Career of {self.player.name}" if self.player else "Career"

    @property
    def match(self) -> Match | None:
        """The match that Play begins: of the tournament if one goes on, else the one that is chosen."""
        player = self.player
        if player is None:
            return None
        match = (cup_match(player) if self.in_cup else None) or Match(self.game, self.opponent)
        short = match.cup and player.cup is not None and player.cup.newcomers
        start = fair_head_start(player, match.opponent, match.game, short) if self.start == FAIR else 0
        return msgspec.structs.replace(match, head_start=start)

    @property
    def shown_game(self) -> str:
        """The game whose ladder is shown."""
        match = self.match
        return match.game if match is not None else self.game

    def _choose_next(self) -> None:
        """The next opponent on the ladder of the game."""
        player = self.player or Player("?")
        self.opponent = next_opponent(player, self.game).name

    def _keep(self, career: Career) -> None:
        """Keep another state of the career, and show it."""
        self.career = career
        if complaint := keep_career(career):
            self.host.tell("Career.", complaint, "warning")
        self.refresh()

    def _named(self, name: str) -> None:
        """Somebody with a name plays from now on."""
        if name:
            self._keep(self.career.named(name))
            self._choose_next()
            self.refresh()

    # -- what can be done ---------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        return {"back": self.close}

    def pressed(self, name: str) -> None:
        kind, _, value = name.partition("=")
        if kind == "opponent":
            self.opponent, self.in_cup = value, False
            self.refresh()
        elif kind == "play":
            self.begin()
        elif kind == "game":
            self._open_games()
        elif kind == "player":
            self._open_players()
        elif kind == "start":
            self.start = LEVEL if self.start == FAIR else FAIR
            self.refresh()
        elif kind == "statistics":
            self.host.cards.open_statistics(self.player.name if self.player else "")
        elif kind == "cup":
            self._begin_cup()

    def begin(self) -> None:
        """Begin the match at its table."""
        match, player = self.match, self.player
        if match is None or player is None:
            self._ask_name()
            return
        career = self.career
        if match.cup and player.cup is not None:  # the next rounds are played with the same kind of start
            cup = msgspec.structs.replace(player.cup, fair=self.start == FAIR)
            career = career.with_player(player.replace(cup=cup))
        family = REGISTER[match.game].family
        own = own_choices(self.host.catalogue, family, self.host.settings.start, player)
        begun = begin_match(career, match, own)
        self.career = begun.career
        if begun.complaint:
            self.host.tell("Career.", begun.complaint, "warning")
        self.host.open_scene(begun.scene, opening=begun.opening)

    def _begin_cup(self) -> None:
        """The draw of a tournament; while one goes on, its match or another one is played next."""
        player = self.player
        if player is None:
            self._ask_name()
        elif player.cup is not None:
            self.in_cup = not self.in_cup
            self.refresh()
        else:
            first = NEWCOMERS if is_newcomer(player) else EIGHT_PLAYERS
            self.host.cards.open_choices("Tournament", CUPS, self._take_cup, first)

    def _take_cup(self, kind: str) -> None:
        """A tournament of a kind begins; who plays is in it."""
        player = self.player
        if player is None:
            return
        self.in_cup = True
        seed = time.time_ns() % 1_000_000
        self._keep(self.career.with_player(new_cup(player, self.game, seed, kind == NEWCOMERS)))

    def _open_games(self) -> None:
        """The list of all games that are registered."""
        rows = [ListRow(one.title, f"won by {one.won}", value=one.name) for one in REGISTER.values()]
        self.host.cards.open_choices("Game", rows, self._take_game, self.game)

    def _take_game(self, game: str) -> None:
        self.game, self.in_cup = game, False
        self._choose_next()
        self.refresh()

    def _open_players(self) -> None:
        """The list of those who play here, and a new name."""
        rows = [
            ListRow(one.name, f"{len(one.results)} matches", value=one.name) for one in self.career.players
        ]
        rows.append(ListRow("Somebody else", "a new name", value=""))
        present = self.player.name if self.player else ""
        self.host.cards.open_choices("Who plays?", rows, self._take_player, present)

    def _take_player(self, name: str) -> None:
        if name:
            self._named(name)
        else:
            self._ask_name()

    def _ask_name(self) -> None:
        self.host.cards.open_name(NAME, self._named)

    def handle(self, event: pygame.Event) -> None:
        enter = event.type == pygame.KEYDOWN and event.key in (pygame.K_RETURN, pygame.K_KP_ENTER)
        if enter and not self.leaving and self.spots.focused is None:
            self.begin()
            return
        super().handle(event)

    def update(self, elapsed_s: float) -> None:
        super().update(elapsed_s)
        if not self._asked and not self.leaving:
            self._asked = True
            self._ask_name()

    # -- places -------------------------------------------------------------------------------------

    def _areas(self) -> tuple[pygame.Rect, pygame.Rect, pygame.Rect]:
        """Ladder, rating with records, and cups, on the card's own surface."""
        px, card = self.host.look.px, self.veil.card
        top, bottom, edge = px(HEAD - 8), card.h - px(FOOT), px(32)
        left = pygame.Rect(edge, top, min(px(LEFT), card.w // 3), max(bottom - top, 1))
        rest = max(card.w - 2 * edge - left.w - 2 * px(GAP), 2)
        middle = pygame.Rect(left.right + px(GAP), top, rest * 55 // 100, left.h)
        right = pygame.Rect(middle.right + px(GAP), top, rest - middle.w, left.h)
        return left, middle, right

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        ladder = self._areas()[0]
        spots = []
        for row, one in enumerate(reversed(opponents_at(self.shown_game))):
            place = pygame.Rect(
                ladder.x, ladder.y + px(24) + row * px(LADDER_ROW), ladder.w, px(LADDER_ROW - 4)
            )
            if place.bottom <= ladder.bottom:
                spots.append(Hotspot(f"opponent={one.name}", place.move(card.topleft)))
        width = (card.w - 2 * px(32) - (len(BUTTONS) - 1) * px(10)) // len(BUTTONS)
        y = card.bottom - px(FOOT) + (px(FOOT) - px(BUTTON)) // 2
        for k, name in enumerate(BUTTONS):
            spots.append(
                Hotspot(name, pygame.Rect(card.x + px(32) + k * (width + px(10)), y, width, px(BUTTON)))
            )
        return spots

    # -- picture ------------------------------------------------------------------------------------

    def state(self) -> object:
        return self.career, self.game, self.opponent, self.start, self.in_cup

    def paint(self, picture: pygame.Surface) -> None:
        look, player = self.host.look, self.player or Player("You")
        ladder, middle, right = self._areas()
        rows = [
            (one, self.spots.find(f"opponent={one.name}")) for one in reversed(opponents_at(self.shown_game))
        ]
        places = [(one, self.inner(spot.rect)) for one, spot in rows if spot is not None]
        match = self.match
        chosen = match.opponent if match is not None else self.opponent
        paint_ladder(picture, look, ladder, places, (player, self.shown_game, chosen), self.spots)
        chart = pygame.Rect(middle.x, middle.y, middle.w, middle.h * 58 // 100)
        paint_rating(picture, look, chart, player, (chosen, self.shown_game))
        paint_records(
            picture, look, pygame.Rect(middle.x, chart.bottom, middle.w, middle.bottom - chart.bottom), player
        )
        foot = look.px(PRIZES_HEIGHT)
        paint_cups(picture, look, pygame.Rect(right.x, right.y, right.w, max(right.h - foot, 1)), player)
        paint_prizes(picture, look, pygame.Rect(right.x, right.bottom - foot, right.w, foot), player)
        for name, words in self._words(match).items():
            self.draw_button(picture, name, words, primary=name == "play")

    def _words(self, match: Match | None) -> dict[str, str]:
        """What the buttons say."""
        game = REGISTER[self.shown_game].title
        start = "level" if self.start == LEVEL else _start_words(match)
        running = self.player is not None and self.player.cup is not None
        other = BY_NAME[match.opponent].title if match is not None and match.opponent in BY_NAME else "…"
        return {
            "player": self.player.name if self.player else "Your name",
            "game": f"Game: {game}",
            "start": f"Start: {start}",
            "cup": ("In the tournament" if self.in_cup else "Beside the tournament")
            if running
            else "New tournament",
            "statistics": "Statistics",
            "play": f"Play {other}" if self.player else "Begin",
        }


def _start_words(match: Match | None) -> str:
    """A fair head start in words."""
    if match is None or match.head_start == 0:
        return "fair, none"
    who = "you" if match.head_start > 0 else "them"
    return f"fair, {abs(match.head_start)} for {who}"
