"""Computer players in grades: how unsteady their hand is, and how far they think.

A player decides what to play (`decide`); what its hand makes of it is another matter (`stroke_of_hand`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Arrangement, Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.games.eight_ball import IN_HAND, SPOT_EIGHT
from game.billiards.game.games.rotation import PASS_BACK, PLAY
from game.billiards.game.games.straight_pool import StraightPool
from game.billiards.game.rules import CUE_BALL, Call, Game
from game.billiards.players.taste import PLAIN, SAFETY, Hand, Taste
from game.billiards.players.weighing import noise_of, weighed, weighed_safe
from game.billiards.search.aims import aims_of
from game.billiards.search.breaking import best_break, safe_break
from game.billiards.search.candidates import BALL, KIND, KINDS, NO_POT
from game.billiards.search.finding import DRAWS, FoundShot, named_shots, processors, search, thread_pool
from game.billiards.search.legality import board_of, legality_of
from game.billiards.search.looking import Effort, Looked
from game.billiards.search.outcomes import NO_LINE
from game.billiards.search.placing import BallInHand, place_cue_ball
from game.billiards.search.rating import FOULED, Aims
from game.billiards.search.safety import look_for_push_out, look_for_safety
from game.billiards.search.strokes import Noise, draw_noise, with_noise
from game.billiards.search.view import Clock, View
from game.billiards.table.rack import BALL_RADIUS

FULLY = 2  # places of a cue ball in hand that are looked at in full
SHOWN = 6  # shots that a decision shows as considered
PUSH_OUT_BELOW = 0.45  # worth of the best stroke, below which a player pushes out
SAFE_BELOW = 0.9  # chance of the best pot, below which a player looks for safety too
POINT_FROM = 0.6  # chance from which a pot is played where each ball is a point
AS_SURE = 0.85  # share of the best chance that a pot for a point must have to be weighed by what it leaves


class Grade(NamedTuple):
    """A grade of players.

    unsteady: how many times the usual noise of a hand. effort: how hard it looks. placing: how hard it looks
    at each of `places` where a cue ball in hand could go, of which it keeps `kept`. safe: safe strokes it
    samples (0: none). careful: it weighs what a stroke leaves; else it takes what goes down most often.
    break_speed m/s of the cue; breaks: samples for each way to break (0: straight from the middle). taste:
    what it likes beside what wins; hand: where aim, speed and spin are not equally unsteady.
    """

    name: str
    title: str
    about: str
    unsteady: float
    effort: Effort
    placing: Effort
    places: int = 12
    kept: int = 1
    safe: int = 0
    careful: bool = True
    break_speed: float = 6.0
    breaks: int = 0
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


_GLANCE = Effort(
    kinds=("direct",), speeds=(0.7, 1.2, 2.0), ups=(-0.3, 0.0, 0.3), lefts=(0.0,), candidates=2, rays=13,
    finalists=4, samples=8,
)  # fmt: skip

NOVICE = Grade(
    "novice", "Novice", "Sees the straight shots, hits the middle of the ball, and hopes.", 4.5,
    Effort(("direct",), (1.2, 2.2), (0.0,), (0.0,), candidates=4, rays=17, finalists=4, samples=12),
    _GLANCE, places=4, careful=False, break_speed=5.8,
)  # fmt: skip
CLUB = Grade(
    "club", "Club player", "Plays draw and follow, and thinks of the next ball.", 2.8,
    Effort(
        ("direct", "bank"), (0.8, 1.4, 2.2), (-0.3, 0.0, 0.3), (0.0,), candidates=6, rays=17, finalists=12,
        samples=16,
    ),
    _GLANCE, places=8, safe=6, break_speed=6.0,
)  # fmt: skip
EXPERT = Grade(
    "expert", "Expert", "Knows spin, banks and combinations, and when to play safe.", 1.9,
    Effort(
        ("direct", "bank", "combination"), (0.6, 0.9, 1.4, 2.0, 3.0), (-0.4, -0.2, 0.0, 0.2, 0.4),
        (-0.3, 0.0, 0.3), candidates=6, rays=17, finalists=32, samples=24,
    ),
    _GLANCE, places=16, kept=2, safe=12, break_speed=6.2, breaks=24,
)  # fmt: skip
MASTER = Grade(
    "master", "Master", "Plays every shot for the one after it.", 1.0,
    Effort(
        ("direct", "bank", "combination", "kick"), (0.5, 0.8, 1.2, 1.7, 2.4, 3.4),
        (-0.4, -0.2, 0.0, 0.2, 0.4), (-0.3, 0.0, 0.3), candidates=6, rays=17, finalists=48, samples=32,
        deep=8, deep_samples=10, after=_GLANCE._replace(candidates=3, rays=11),
    ),
    _GLANCE, places=16, kept=3, safe=16, break_speed=6.5, breaks=48,
)  # fmt: skip
GRADES = {grade.name: grade for grade in (NOVICE, CLUB, EXPERT, MASTER)}


class Decision(NamedTuple):
    """What a player has decided.

    option: the name of the option it chooses, "" if there was nothing to choose. place: where it puts the
    cue ball (m), None if that is not in hand. stroke: as meant, None with an option. considered: what it
    thought of, the best first. worth: its estimate of the chance to win. chance: that the stroke does what it
    is meant to, kind: of KINDS or "safety", both as it thought; safe: what the best safe stroke was worth to
    it, NaN if it looked for none.
    """

    option: str = ""
    place: tuple[float, float] | None = None
    stroke: Stroke | None = None
    call: Call = Call()
    considered: tuple[FoundShot, ...] = ()
    worth: float = 0.0
    chance: float = math.nan
    kind: str = ""
    safe: float = math.nan


def decide(
    frame: Frame,
    grade: Grade,
    seed: int = 0,
    seconds: float | None = None,
    threads: int | None = None,
    alone: bool = False,
) -> Decision:
    """What a player of a grade plays, or chooses. Without `seconds` it depends on frame, grade and seed only.

    seconds: think for about so long (the stage under way is finished, which takes up to half a second).
    alone: only clearing the table in this visit counts. ValueError if the rack is over.
    """
    game = frame.game
    if game.over:
        raise ValueError("game: the rack is over")
    mind = _Mind(grade, seed, Clock(seconds), threads, alone)
    if game.options:
        return Decision(option=mind.option(frame))
    if game.opening and game.in_hand:
        return mind.break_off(frame)
    if not game.in_hand:
        return mind.stroke(frame)
    layouts = mind.places(frame)
    if len(layouts) > 1 and grade.effort.deep:
        layouts = mind.likeliest(frame, layouts, FULLY)
    return mind.best_of(frame, layouts)


def stroke_of_hand(stroke: Stroke, grade: Grade, seed: int, radius: float = BALL_RADIUS) -> Stroke:
    """A stroke as the player's hand does it. radius of the cue ball, m."""
    draw = np.random.default_rng(seed).standard_normal((1, 5))
    return Stroke(*with_noise(np.array([stroke]), draw, grade.noise, radius)[0].tolist())


class _Mind:
    """What a player needs while it thinks about one turn."""

    def __init__(self, grade: Grade, seed: int, clock: Clock, threads: int | None, alone: bool) -> None:
        self.grade = grade
        self.alone = alone
        self.seed = seed
        self.clock = clock
        self.threads = processors() if threads is None else threads
        self.pool = thread_pool(self.threads)
        self.draws = draw_noise(seed, DRAWS)

    def option(self, frame: Frame) -> str:
        """One of the options that the rules offer."""
        names = [option.name for option in frame.game.options]
        for name in (IN_HAND.name, SPOT_EIGHT.name):
            if name in names:
                return name
        here = self.stroke(frame.replace(game=_without_options(frame.game))).worth
        if PLAY.name in names:
            return PLAY.name if here >= 0.5 else PASS_BACK.name
        return names[0] if here >= 0.5 else names[1]

    def break_off(self, frame: Frame) -> Decision:
        """The break."""
        numbers = frame.layout.with_ball(CUE_BALL, (0.0, 0.0)).numbers
        aims = aims_of(frame.game, numbers)[0]
        some = frame.game.legal_first()
        every = sum(1 << row for row, number in enumerate(numbers) if number in frame.game.on_table)
        first = sum(1 << row for row, number in enumerate(numbers) if number in some)
        aims = aims._replace(first=first, score=every, called=False, lose=0)
        if isinstance(frame.game, StraightPool):
            safe = safe_break(
                frame.layout, frame.table, frame.physics, aims, self.grade.noise,
                self.draws[: self.grade.safe], self.pool,
            )  # fmt: skip
            return Decision(place=safe.place, stroke=safe.stroke, call=Call(safety=True), worth=safe.merit)
        found = best_break(
            frame.layout, frame.table, frame.physics, aims, self.grade.noise, self.grade.break_speed,
            self.draws[: self.grade.breaks], self.pool,
        )  # fmt: skip
        return Decision(place=found.place, stroke=found.stroke, worth=found.merit)

    def places(self, frame: Frame) -> list[Arrangement]:
        """Where the cue ball in hand could go."""
        layout = frame.layout.without(CUE_BALL)
        ball = BallInHand(layout, frame.table, frame.physics, frame.game.in_hand, self.grade.noise)
        layouts: list[Arrangement] = []
        for aims in self._aims(frame, layout.with_ball(CUE_BALL, (0.0, 0.0))):
            layouts += place_cue_ball(
                ball, aims, self.grade.placing, self.draws, self.grade.kept, self.grade.places, self.pool,
                self.clock,
            )  # fmt: skip
        return layouts

    def _aims(self, frame: Frame, layout: Arrangement) -> list[Aims]:
        """What to be after; from behind the line no ball that lies there, too (6.11)."""
        found = aims_of(frame.game, layout.numbers, self.alone)
        line = legality_of(frame).line
        if line == NO_LINE:
            return found
        beyond = sum(1 << row for row, y in enumerate(layout.positions[:, 1]) if y > line)
        return [aims._replace(first=aims.first & beyond) for aims in found]

    def likeliest(self, frame: Frame, layouts: list[Arrangement], most: int) -> list[Arrangement]:
        """The places from which the best strokes are worth most, without a look at the stroke after them."""
        shallow = self.grade.effort._replace(deep=0)
        worths: list[float] = []
        for layout in layouts:
            if worths and self.clock.is_out():
                break
            worths.append(self.stroke(frame.replace(layout=layout), shallow).worth)
        return [layouts[i] for i in np.argsort(-np.array(worths), kind="stable")[:most].tolist()]

    def best_of(self, frame: Frame, layouts: list[Arrangement]) -> Decision:
        """The best decision of all places, as far as time allows."""
        best: Decision | None = None
        for layout in layouts:
            if best is not None and self.clock.is_out():
                break
            found = self.stroke(frame.replace(layout=layout))
            if best is None or found.worth > best.worth:
                best = found._replace(place=layout.place_of(CUE_BALL))
        assert best is not None
        return best

    def stroke(self, frame: Frame, effort: Effort | None = None) -> Decision:
        """The best stroke from where the cue ball lies, a safe one and a push-out among them.

        effort: how hard to look; left out, that of the grade.
        """
        grade = self.grade
        effort = grade.effort if effort is None else effort
        view = View(board_of(frame), grade.supposed)
        found: list[tuple[Looked, Aims]] = []
        every_aim = self._aims(frame, frame.layout)
        for aims in every_aim:
            looked = search(view, aims, effort, self.seed, self.threads, self.clock)
            if looked is not None:
                found.append((looked, aims))
        surest = max((float(looked.chance[0]) for looked, _ in found), default=0.0)
        alone = every_aim[0].solo
        if not found or (grade.safe and not alone and surest < SAFE_BELOW and not self.clock.is_out()):
            finalists = max(grade.safe, 1)
            draws = self.draws[: effort.samples]
            found.append((look_for_safety(view, every_aim[0], finalists, draws, self.pool), every_aim[0]))
        if isinstance(frame.game, StraightPool) and surest >= POINT_FROM:
            return self._for_a_point(frame, view, found[0][0])
        looked, aims = max(found, key=lambda pair: float(self._scores(pair[0]).max()))
        shots = [shot for some, _ in found for shot in named_shots(view, some, SHOWN)]
        considered = tuple(sorted(shots, key=lambda shot: -shot.worth)[:SHOWN])
        best = int(np.argmax(self._scores(looked)))
        worth, chance = float(looked.worth[best]), float(looked.chance[best])
        if frame.game.may_push_out() and worth < PUSH_OUT_BELOW and grade.careful:
            stroke = look_for_push_out(view, aims, self.seed, self.pool)
            return Decision("", None, Stroke(*stroke.tolist()), Call(push_out=True), considered, 0.5)
        call = self._call(frame, looked, best)
        kind = (*KINDS, SAFETY)[int(looked.candidates[best, KIND])]
        safes = [float(some.worth.max()) for some, _ in found if _is_safe(some)]
        return Decision(
            "", None, Stroke(*looked.strokes[best].tolist()), call, considered, worth,
            _legal(looked, best) if kind == SAFETY else chance, kind, safes[0] if safes else math.nan,
        )  # fmt: skip

    def _for_a_point(self, frame: Frame, view: View, looked: Looked) -> Decision:
        """Where each ball is a point, no table need be cleared: the sure pot that leaves most."""
        sure = looked.chance >= AS_SURE * float(looked.chance.max())
        worth = looked.worth if self.grade.careful else looked.chance
        best = int(np.argmax(np.where(sure, worth, -1.0)))
        shots = tuple(named_shots(view, looked, SHOWN))
        stroke = Stroke(*looked.strokes[best].tolist())
        chance, kind = float(looked.chance[best]), KINDS[int(looked.candidates[best, KIND])]
        return Decision("", None, stroke, self._call(frame, looked, best), shots, chance, chance, kind)

    def _scores(self, looked: Looked) -> Floats:
        """What each of the strokes (f,) counts for the player."""
        if not self.grade.careful:
            return looked.chance
        if _is_safe(looked):
            return weighed_safe(looked.worth, self.grade.taste)
        return weighed(looked.worth, looked.chance, looked.candidates, self.grade.taste)

    def _call(self, frame: Frame, looked: Looked, best: int) -> Call:
        """Ball and pocket of a stroke, or a safety."""
        ball, pocket = (int(value) for value in looked.candidates[best, BALL : BALL + 2])
        if ball < 0:
            return Call(safety=True)
        return Call(frame.layout.numbers[ball], pocket)


def _is_safe(looked: Looked) -> bool:
    """Whether these strokes are not meant to pot."""
    return int(looked.candidates[0, KIND]) == NO_POT


def _legal(looked: Looked, row: int) -> float:
    """How often a stroke's samples were no foul."""
    return float((looked.kinds[row] < FOULED).mean())


def _without_options(game: Game) -> Game:
    """The game as if the option had been taken to play on as the table layouts."""
    return game.choose(game.options[0].name).game
