"""What is practised in sets, and how the set stands: racks against the ghost, tries of a drill."""

from __future__ import annotations

import hashlib

from game.billiards.game.games import Drill, Ghost, RunDrill
from game.billiards.game.goals import described
from game.billiards.game.rules import Game
from game.levels import Level
from game.scenes.billiards import layout
from game.scenes.billiards.level import BilliardsContent
from game.scenes.billiards.play import Play
from game.scenes.shared.tables.choices import PERSON
from game.stage.records.history import Practised

GHOST_TITLES = {"nine-ball": "9-ball ghost", "ten-ball": "10-ball ghost", "eight-ball": "8-ball ghost"}
MOST_TITLE = 120


def standing_set(play: Play, level: Level | None) -> Practised | None:
    """How the set of a person stands; None for what is no practice, or where the computer plays."""
    game = play.model.frame.game
    if play.plays_itself or play.grade_of(0) != PERSON:
        return None
    if isinstance(game, Ghost):
        title = GHOST_TITLES[game.discipline]
        return Practised(
            f"ghost {game.discipline} {game.racks}", title, game.won[0], sum(game.won), game.racks
        )
    if isinstance(game, Drill):
        title = drill_title(game, level) or "Drill"
        return Practised(drill_key(play.model.content, game), title, game.made, game.attempts, game.tries)
    if isinstance(game, RunDrill):
        title, count = drill_title(game, level), game.count
        key = drill_key(play.model.content, game)
        return Practised(key, title, game.potted, game.attempts * count, game.tries * count)
    return None


def drill_key(content: BilliardsContent, game: Drill | RunDrill) -> str:
    """Equal for drills with the same balls and the same goals, whatever they are called."""
    balls = sorted((ball.number, *ball.position) for ball in content.balls)
    goals = (
        (game.goal, game.more) if isinstance(game, Drill) else (game.ordered, game.pocket, game.off_cushions)
    )
    said = repr((balls, goals, content.in_hand))
    return f"drill {hashlib.blake2b(said.encode(), digest_size=8).hexdigest()}"


def drill_title(game: Game, level: Level | None) -> str:
    """What a drill is called: as its level, or by its goal; "" for what is no drill."""
    if isinstance(game, RunDrill):
        return level.title if level is not None and level.title else "Drill"
    if not isinstance(game, Drill):
        return ""
    content = level.content if level is not None else None
    if (
        isinstance(content, BilliardsContent)
        and content.goal == game.goal
        and level is not None
        and level.title
    ):
        return level.title
    words = " ".join(described(game.goal, layout.POCKETS)).rstrip(".")
    return f"Drill: {words[:1].lower()}{words[1:]}"[:MOST_TITLE]
