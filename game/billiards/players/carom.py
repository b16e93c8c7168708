"""Computer players at carom: which stroke they choose, by its chance and by what it leaves."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame
from game.billiards.game.games.artistic import Artistic
from game.billiards.game.games.artistic_figures import LETTERS
from game.billiards.game.games.carom import ACCEPT, PLAY_AWAY, RESPOT
from game.billiards.map.carom import SEED, THOROUGH, CaromMap, Group, Position, Search, whole_map
from game.billiards.map.leaving import leaving
from game.billiards.map.routes import RAILS, Wanted, touches
from game.billiards.players.taste import PLAIN, Hand, Taste
from game.billiards.players.weighing import noise_of
from game.billiards.search.strokes import Noise, draw_noise, with_noise
from game.billiards.table.carom import BALL_RADIUS, RED
from game.physics.kernels import elementwise


class CaromGrade(NamedTuple):
    """A grade of players. unsteady: times the usual noise of a hand. looks: how hard it looks. planned: so
    many of the surest strokes are weighed by what they leave, which counts `ahead` times the chance of the
    next point.
    """

    name: str
    title: str
    about: str
    unsteady: float
    looks: Search
    planned: int = 0
    ahead: float = 0.0
    taste: Taste = PLAIN
    hand: Hand = Hand()

    @property
    def noise(self) -> Noise:
        """How unsteady the hand is."""
        return noise_of(self.hand, self.unsteady)

    @property
    def supposed(self) -> Noise:
        """How unsteady the player takes its hand to be."""
        return noise_of(self.hand, self.unsteady / self.taste.confidence)


NEAR = 48  # strokes near a figure's known one that are tried
FIGURE_STEPS = np.array([0.12, 0.006, 0.0, 0.03, 0.03])  # m/s, rad, rad, radii; how far they lie from it
_PLAIN = THOROUGH._replace(aims=120, groups=6, candidates=3, moves=0, draws=24)
CAROM_GRADES = {
    grade.name: grade
    for grade in (
        CaromGrade("novice", "Novice", "Takes the way that looks shortest, and hopes.", 4.5, _PLAIN),
        CaromGrade(
            "club", "Club player", "Knows the usual ways round the table.", 2.8, _PLAIN._replace(groups=10)
        ),
        CaromGrade("expert", "Expert", "Sees every way, and leaves itself something.", 1.6, THOROUGH, 3, 0.5),
        CaromGrade("master", "Master", "Plays each point for the one after it.", 0.8, THOROUGH, 6, 0.8),
    )
}


class Choice(NamedTuple):
    """A stroke that was considered: the group, what it leaves (chance of the next), what it is worth."""

    group: Group
    left: float
    worth: float


class CaromDecision(NamedTuple):
    """What a player does. option: that it takes, "" if none was open. stroke: as it is meant. choices: what
    it considered, the best first.
    """

    option: str = ""
    stroke: Stroke | None = None
    choices: tuple[Choice, ...] = ()


def cushions_of(code: int) -> int:
    """How many cushions the cue ball touches before the last thing of its way. code: see `map.routes`."""
    return sum(1 for touched in touches(code) if 1 <= touched <= RAILS)


def wanted_of(frame: CaromFrame) -> Wanted:
    """What scores for a frame's player."""
    game = frame.game
    code = 0
    if isinstance(game, Artistic):
        for letter in game.now.route:
            code = 8 * code + 1 + LETTERS.index(letter)
    return Wanted(game.cushions, game.opening, game.must_leave(frame.positions), code)


def position_of(frame: CaromFrame) -> Position:
    """The position that a frame's player is at."""
    return Position(frame.positions, frame.game.cue, frame.table, frame.physics, wanted_of(frame))


def weigh(position: Position, drawn: CaromMap, grade: CaromGrade, seed: int = SEED) -> tuple[Choice, ...]:
    """What a player makes of a map: the surest strokes, weighed by what they leave; the best first."""
    choices = []
    for place, group in enumerate(drawn.groups):
        left = leaving(position, group, grade.supposed, seed=seed) if place < grade.planned else 0.0
        worth = group.chance * (1.0 + grade.ahead * left)
        if grade.taste.bank:
            worth += grade.taste.bank * group.chance * cushions_of(group.code)
        choices.append(Choice(group, left, worth))
    return tuple(sorted(choices, key=lambda choice: -choice.worth))


def decide_carom(frame: CaromFrame, grade: CaromGrade, seed: int = SEED) -> CaromDecision:
    """What a player of a grade plays, or chooses; the same for the same frame, grade and seed.

    ValueError if the game is over.
    """
    game = frame.game
    if game.ended:
        raise ValueError("game: it is over")
    if game.options:
        names = [option.name for option in game.options]
        if RESPOT.name not in names:
            return CaromDecision(ACCEPT.name)
        free = frame.replace(game=game.choose(PLAY_AWAY.name, frame.positions).game)
        drawn = whole_map(position_of(free), grade.noise, grade.looks, seed)
        good = bool(drawn.groups) and drawn.groups[0].chance > 0.3
        return CaromDecision(PLAY_AWAY.name if good else RESPOT.name)
    position = position_of(frame)
    if isinstance(game, Artistic):
        return CaromDecision("", _figure_stroke(position, game.now.stroke, grade, seed))
    choices = weigh(position, whole_map(position, grade.supposed, grade.looks, seed), grade, seed)
    stroke = choices[0].group.stroke if choices else _straight_at_red(position)
    return CaromDecision("", stroke, choices)


def hand_of(stroke: Stroke, grade: CaromGrade, seed: int) -> Stroke:
    """What the player's hand makes of a stroke, the same for the same seed."""
    made = with_noise(np.array([stroke], dtype=np.float64), draw_noise(seed, 1), grade.noise, BALL_RADIUS)
    return Stroke(*made[0].tolist())


def _figure_stroke(position: Position, known: Stroke, grade: CaromGrade, seed: int) -> Stroke:
    """A figure's stroke as a player finds it on this cloth: the surest near the known one."""
    random = np.random.default_rng(seed)
    near = np.array([known]) + random.normal(0.0, 1.0, (NEAR, 5)) * FIGURE_STEPS
    near[0] = known
    near[:, 2] = np.maximum(near[:, 2], 0.0)
    draws = draw_noise(seed + 1, grade.looks.first_draws)
    played = position.play(with_noise(near, draws, grade.noise, BALL_RADIUS))
    chances = position.wanted.scores(played).reshape(NEAR, -1).mean(axis=1)
    return Stroke(*near[int(np.argmax(chances))].tolist())


def _straight_at_red(position: Position) -> Stroke:
    """Where nothing scores: at the red ball, so that it is touched at least."""
    dx, dy = (position.places[RED] - position.places[position.cue]).tolist()
    return Stroke(2.5, float(elementwise.arctan2(dy, dx)))
