"""What is said in words: how the game stands, the line below the table, fouls to come."""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.rules import ShotSummary
from game.billiards.game.snooker.rules import Snooker
from game.billiards.game.snooker.stroke import Seen, contact_penalties, on_words
from game.billiards.players.ladder import BY_NAME
from game.billiards.search.legality import Legality
from game.billiards.table.snooker import name_of
from game.scenes.shared.tables.choices import PERSON, player_words
from game.scenes.shared.tables.course import AIMING, REPLAY, ROLLING, STRIKING
from game.scenes.shared.tables.lessons.lesson import star_words
from game.scenes.shared.tables.referee.card import Counted, share_words, time_words
from game.scenes.shared.tables.seats.cup import after_match, with_round, won_with
from game.scenes.shared.thinker import Thinker
from game.scenes.snooker.coach import legality_for
from game.scenes.snooker.course import Course


class Card(NamedTuple):
    """What the card of a player says. lit: at turn, or the winner."""

    name: str
    status: str
    points: str
    lit: bool


class Standing(NamedTuple):
    """All that the board says. chip: the ball that is on, None if none is."""

    title: str
    under: str
    cards: tuple[Card, ...]
    score: str
    caption: str
    chip: int | None
    on: str
    left: str


class Line(NamedTuple):
    """The line below the table: what follows, and why; foul: it says a foul."""

    lead: str
    more: str = ""
    foul: bool = False


def standing_of(course: Course, thinker: Thinker, title: str) -> Standing:
    """How the game stands. title: of the level, which names a drill."""
    game = course.model.game
    name = "Six-red" if game.six_red else "Snooker"
    cards = tuple(_card(course, thinker, player, title) for player in range(len(game.players)))
    two = len(game.players) == 2
    under = "coached" if course.coached else _frame_words(game)
    under = "replay" if course.phase == REPLAY else "frame over" if game.over else under
    chip, on = _on(course)
    return Standing(
        name if two or not game.drill else "Practice", under, cards,
        f"{game.won[0]} : {game.won[1]}" if two else "",
        with_round(f"best of {game.best_of}" if game.best_of else "frames", course) if two else "",
        chip, on, "" if game.over else f"{game.points_left} left",
    )  # fmt: skip


def _frame_words(game: Snooker) -> str:
    if len(game.players) == 1:
        return {"break": "a miss ends it", "pot": "one pot", "escape": "hit the ball on", "": "practice"}[
            game.drill
        ]
    if game.black_again:
        return "black put back"
    return f"frame {sum(game.won) + 1}"


def _on(course: Course) -> tuple[int | None, str]:
    """The ball that is on, or nominated, and that in words."""
    game = course.model.game
    if game.over or not game.balls_on():
        return None, ""
    ball = course.call.ball if course.may_aim else None
    if game.free_ball:
        free = ball if ball is not None and ball not in game.balls_on() else None
        return (free, "free ball") if free is not None else (game.balls_on()[0], "free ball")
    if game.stage == "colour":
        return (ball, "nominated") if ball is not None else (None, "a colour on")
    return game.balls_on()[0], f"{name_of(game.balls_on()[0])} on"


def _card(course: Course, thinker: Thinker, player: int, title: str) -> Card:
    """The card of a player."""
    game = course.model.game
    active = player == game.turn and not game.over
    won = game.over and game.winner == player and len(game.players) == 2
    parts = []
    if won:
        parts.append("won the match" if game.match_over else "won the frame")
    elif active:
        parts.append(_doing(course, thinker))
    if active and game.run:
        parts.append(f"break {game.run}")
    needed = game.snookers_needed(player)
    if needed and not game.over:
        parts.append(f"needs {needed} snooker{'s' * (needed > 1)}")
    if game.high[player]:
        parts.append(f"highest {game.high[player]}")
    if course.learning.stars is not None:
        parts = [star_words(*course.learning.stars)]
    elif game.drill:
        parts = [f"{game.made} of {game.attempts} made" if game.attempts else "first try", *parts[1:]]
    grade = course.grade_of(player)
    name = game.players[player]
    if title and len(game.players) == 1:
        name = title
    elif grade in BY_NAME:
        name = BY_NAME[grade].title
    elif grade != PERSON:
        name = f"{name} ({player_words(grade)})"
    return Card(name, " · ".join(part for part in parts if part), str(game.points[player]), active or won)


def _doing(course: Course, thinker: Thinker) -> str:
    """What the player at turn does."""
    game = course.model.game
    if course.phase == REPLAY:
        return ""
    if course.phase in (STRIKING, ROLLING):
        return "plays"
    if game.options:
        return "chooses"
    if course.plays_itself:
        return "plays by itself"
    if not course.person_plays:
        return "thinks" if thinker.warm else thinker.getting_ready
    return "ball in hand" if game.in_hand else "aims"


def line_of(course: Course) -> Line:
    """The line below the table: what was said last, else what to do."""
    frame, game = course.model.frame, course.model.game
    if course.phase in (STRIKING, ROLLING):
        ball = course.called.ball
        return Line(f"Nominated: the {name_of(ball)}." if ball is not None else "")
    if course.phase != AIMING:
        return Line("Replay of the last stroke.")
    if frame.words:
        lead, *why = frame.words
        return Line(lead, " ".join(why), frame.foul)
    if course.learning.lesson is not None:
        return Line(course.learning.lesson.says)
    if game.options:
        return Line(f"{game.shooter} chooses.", "A free ball." if game.free_ball else "")
    if not course.person_plays or game.over:
        return Line("")
    if game.in_hand:
        where = "in the D" if game.in_hand == "in the D" else "anywhere"
        return Line(f"Drag the cue ball: it may lie {where}.", game.on_sentence())
    return Line(game.on_sentence(), "Aim, pull the cue back and let go.")


def foul_to_come(course: Course, first: int | None) -> str:
    """Why the first contact of a stroke is a foul, empty if it is none. first: the ball that is met."""
    if first is None:
        return ""
    target = course.model.game.target(course.call)
    seen = Seen({number: (x, y) for number, x, y in course.model.frame.layout.places})
    found = contact_penalties(target, ShotSummary(first=(first,)), seen)
    if not found:
        return ""
    pushed = found[0].foul.kind == "push stroke"
    return "foul: push stroke" if pushed else f"foul: {on_words(target)} is on"


def legality_to_come(course: Course) -> Legality:
    """What is asked of the stroke that is aimed."""
    return legality_for(course.model.game, course.call)


def counted_of(course: Course) -> Counted:
    """What the card at the end of a frame says."""
    frame, seconds = course.model.frame, course.frame_s
    game = frame.snooker
    assert game.winner is not None
    won = won_with(course, "match" if game.match_over else "frame")
    title = f"{game.players[game.winner]} wins the {won}"
    first, second = (
        (str(points), str(high), share_words(tally.scoring, tally.tries), str(tally.fouls))
        for points, high, tally in zip(game.points, game.high, frame.rack_tallies, strict=True)
    )
    heads = ("Points", "Highest break", "Pots", "Fouls")
    rows = (*zip(heads, first, second, strict=True), ("Time", "", time_words(seconds)))
    following = after_match(course).lower() or ("new match" if game.match_over else "next frame")
    return Counted(title, (game.players[0], game.players[1]), rows, f"Enter: {following}     U: undo")
