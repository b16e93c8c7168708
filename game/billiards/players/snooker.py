"""Computer players at snooker: pots with position, the colour that pays, safety and escapes, and choices.

What is looked for are the strokes of `game.billiards.search`; what snooker values is weighed here: the points
of a pot, and that a ball on that is hit softly is no foul without a cushion.
"""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.snooker.frame import SnookerFrame
from game.billiards.game.snooker.rules import AGAIN, ANYWHERE, GO_SECOND, PLAY, REPLAY
from game.billiards.players.opponents import Decision
from game.billiards.players.snooker_ideas import (
    Idea,
    classes_of,
    idea_for_safety,
    ideas_of,
    moved,
    places_in_hand,
    safe_strokes,
    strokes_all_around,
)
from game.billiards.players.taste import PLAIN, SAFETY, Hand, Taste
from game.billiards.players.weighing import SNOOKER_POINTS, noise_of
from game.billiards.search.candidates import CHANCE, KIND, KINDS
from game.billiards.search.finding import DRAWS, FoundShot, named_shots, processors, thread_pool
from game.billiards.search.looking import Effort, look
from game.billiards.search.next_pot import best_chances
from game.billiards.search.outcomes import SCRATCH, Outcomes
from game.billiards.search.rating import FOULED, MISSED, SCORED
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.billiards.search.view import Clock, View
from game.billiards.table import snooker

FOUL_POINTS = 4.0  # that a foul costs at least
AFTER_FOUL = 0.4  # chance of the next pot that it leaves: a free ball, or the balls put back
IN_HAND = 0.6  # chance of the next pot with the cue ball in the D
SAFE_BELOW = 0.9  # chance of the best pot, below which a player looks for safety too
GOOD, POOR = 0.5, 0.2  # chances of the best pot: worth playing for, and better left to the other
COLOURS_TRIED = 3  # of those that can be nominated, the likeliest
HOPELESS = 5  # fouls that a player would need; it concedes once all reds are gone
SAFE_SPEEDS = (0.5, 0.9, 1.4, 2.0, 2.8)  # m/s of the cue
FEWEST_OPEN = 8  # strokes straight at balls on that are no foul; with fewer, all directions are tried
BREAK_SPEEDS = (1.8, 2.2, 2.6, 3.0)  # m/s of the cue
SHOWN = 6


class SnookerGrade(NamedTuple):
    """A grade of players. unsteady: times the usual noise of a hand. effort: how hard it looks for pots;
    safe: safe strokes that it samples. careful: it weighs what is left. building: points that it counts a
    good chance at the next ball as, its own or the other's. taste, hand: as of `Grade`.
    """

    name: str
    title: str
    about: str
    unsteady: float
    effort: Effort
    safe: int = 4
    careful: bool = True
    building: float = 12.0
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


SNOOKER_GRADES = {
    grade.name: grade
    for grade in (
        SnookerGrade(
            "novice", "Novice", "Pots what is straight and near, and hopes.", 2.6,
            Effort(("direct",), (1.2, 2.2), (0.0,), (0.0,), candidates=3, rays=13, finalists=3, samples=10),
            safe=4, careful=False, building=5.0,
        ),
        SnookerGrade(
            "club", "Club player", "Thinks of the next ball, and plays safe when nothing is on.", 1.3,
            Effort(("direct",), (0.9, 1.5, 2.4), (-0.3, 0.0, 0.3), (0.0,), candidates=5, rays=13,
                   finalists=10, samples=16),
            safe=8, building=9.0,
        ),
        SnookerGrade(
            "expert", "Expert", "Builds breaks, leaves snookers and escapes from them.", 0.7,
            Effort(("direct",), (0.7, 1.1, 1.7, 2.6), (-0.4, 0.0, 0.4), (0.0,), candidates=6, rays=13,
                   finalists=24, samples=20),
            safe=12, building=16.0,
        ),
        SnookerGrade(
            "master", "Master", "Plays every pot for the one after it.", 0.35,
            Effort(("direct",), (0.6, 0.9, 1.3, 1.9, 2.8), (-0.4, -0.2, 0.0, 0.2, 0.4), (-0.25, 0.0, 0.25),
                   candidates=6, rays=13, finalists=40, samples=24),
            safe=16, building=25.0,
        ),
    )
}  # fmt: skip


class Safe(NamedTuple):
    """A stroke (5,) that is not meant to pot, its worth, and how often it is no foul."""

    stroke: Floats
    worth: float
    legal: float


class _Mind:
    """What a player needs while it thinks about one turn."""

    def __init__(self, grade: SnookerGrade, seed: int, seconds: float | None, threads: int | None) -> None:
        self.grade = grade
        self.clock = Clock(seconds)
        self.pool: ThreadPoolExecutor | None = thread_pool(processors() if threads is None else threads)
        self.draws = draw_noise(seed, DRAWS)

    def view(self, frame: SnookerFrame) -> View:
        """The table as the search sees it."""
        return View(Board(frame.layout, frame.table, frame.physics), self.grade.supposed)

    def values(self, view: View, idea: Idea, outcomes: Outcomes) -> tuple[Floats, NDArray[np.int64]]:
        """Value in points (m,) of what strokes led to, and their classes."""
        kinds = classes_of(outcomes, idea)
        scored, foul = kinds == SCORED, kinds == FOULED
        chances = np.empty(len(kinds))
        playable = np.where(scored, idea.following, idea.others).astype(np.int64)
        best_chances(outcomes.places, view.geometry, playable, chances)
        chances = np.where(outcomes.facts[:, SCRATCH] != 0, IN_HAND, chances)
        chances = np.where(foul, np.maximum(chances, AFTER_FOUL), chances)
        later = self.grade.building * chances
        if idea.aims.solo:
            later = np.where(scored, later, 0.0)
        values = np.where(scored, idea.points + later, -later) - FOUL_POINTS * foul
        return values, kinds

    # -- pots ---------------------------------------------------------------------------------------

    def best_pot(self, frame: SnookerFrame, view: View) -> tuple[Decision | None, float]:
        """The best pot, and its chance; None without one."""
        best: Decision | None = None
        best_value, best_chance = -math.inf, 0.0
        shots: list[FoundShot] = []
        for idea in self._likely(frame, view):
            if best is not None and self.clock.is_out():
                break
            looked = look(view, idea.aims, self.grade.effort, self.draws, self.pool, self.clock)
            if looked is None:
                continue
            shots += named_shots(view, looked, SHOWN)
            values, kinds = self.values(view, idea, looked.outcomes)
            shape = (len(looked.strokes), -1)
            chance = (kinds == SCORED).reshape(shape).mean(axis=1)
            worth = values.reshape(shape).mean(axis=1) if self.grade.careful else chance * (1.0 + idea.points)
            if self.grade.taste.pot:
                points = self.grade.taste.pot * (idea.points + self.grade.building)
                worth = (1.0 - self.grade.taste.pot) * worth + points * chance
            row = int(np.argmax(worth))
            value = float(worth[row])
            if value > best_value:
                best_value, best_chance = value, float(chance[row])
                kind = KINDS[int(looked.candidates[row, KIND])]
                stroke = Stroke(*looked.strokes[row].tolist())
                best = Decision("", None, stroke, idea.call, (), value, best_chance, kind)
        if best is None:
            return None, 0.0
        shown = tuple(sorted(shots, key=lambda shot: -shot.chance)[:SHOWN])
        return best._replace(considered=shown), best_chance

    def _likely(self, frame: SnookerFrame, view: View) -> list[Idea]:
        """What to play for: of many colours those whose pots look best by geometry, points weighed."""
        ideas = ideas_of(frame)
        if len(ideas) <= COLOURS_TRIED:
            return ideas

        def promise(idea: Idea) -> float:
            found = view.candidates(idea.aims, ("direct",), 1)
            return float(found[0, CHANCE]) * (1.0 + 0.1 * idea.points) if len(found) else 0.0

        order = sorted(range(len(ideas)), key=lambda k: (-promise(ideas[k]), k))
        return [ideas[k] for k in order[:COLOURS_TRIED]]

    # -- safety and escapes -------------------------------------------------------------------------

    def safe_stroke(self, view: View, idea: Idea, speeds: tuple[float, ...] = SAFE_SPEEDS) -> Safe:
        """The stroke at a ball on after which the other has least, under noise; an escape if none is open."""
        strokes = safe_strokes(view, idea.aims.first, speeds)
        first, kinds = self.values(view, idea, view.board.play(strokes, self.pool))
        if int((kinds == MISSED).sum()) < FEWEST_OPEN:
            more = strokes_all_around(speeds)
            found = self.values(view, idea, view.board.play(more, self.pool))
            strokes = np.concatenate([strokes, more])
            first, kinds = np.concatenate([first, found[0]]), np.concatenate([kinds, found[1]])
        first = np.where(kinds == SCORED, -np.inf, first)  # a fluke, which no hand repeats
        best = np.argsort(-first, kind="stable")[: self.grade.safe]
        draws = self.draws[: max(self.grade.effort.samples, 8)]
        noisy = with_noise(strokes[best], draws, view.noise, view.board.radius)
        values, kinds = self.values(view, idea, view.board.play(noisy, self.pool))
        means = values.reshape(len(best), -1).mean(axis=1)
        row = int(np.argmax(means))
        legal = (kinds != FOULED).reshape(len(best), -1).mean(axis=1)
        return Safe(strokes[best[row]], float(means[row]), float(legal[row]))

    def stroke(self, frame: SnookerFrame) -> Decision:
        """The best stroke from where the cue ball lies."""
        view = self.view(frame)
        pot, chance = self.best_pot(frame, view)
        if pot is not None and (chance >= SAFE_BELOW or (len(frame.game.players) == 1 and chance > 0.0)):
            return pot
        idea = idea_for_safety(frame, view)
        safe = self.safe_stroke(view, idea)
        liked = safe.worth + SNOOKER_POINTS * self.grade.taste.safety
        if pot is not None and ((not self.grade.careful and chance > POOR) or pot.worth > liked):
            return pot._replace(safe=safe.worth)
        considered = pot.considered if pot is not None else ()
        stroke = Stroke(*safe.stroke.tolist())
        return Decision("", None, stroke, idea.call, considered, safe.worth, safe.legal, SAFETY, safe.worth)

    # -- the cue ball in hand, and choices ----------------------------------------------------------

    def from_hand(self, frame: SnookerFrame) -> Decision:
        """Where to put the cue ball in hand, and what to play from there."""
        best: Decision | None = None
        ranked = sorted(places_in_hand(frame), key=lambda pair: -self._glance(pair[1]))
        for place, placed in ranked[:2]:
            if best is not None and self.clock.is_out():
                break
            found = self.stroke(placed)
            if best is None or found.worth > best.worth:
                best = found._replace(place=place)
        assert best is not None
        return best

    def _glance(self, frame: SnookerFrame) -> float:
        """The likeliest pot by geometry alone, points weighed."""
        view = self.view(frame)
        best = 0.0
        for idea in ideas_of(frame):
            found = view.candidates(idea.aims, ("direct",), 1)
            if len(found):
                best = max(best, float(found[0, CHANCE]) * (1.0 + 0.05 * idea.points))
        return best

    def break_off(self, frame: SnookerFrame) -> Decision:
        """The break-off: a safe stroke at the pack from beside the yellow."""
        x, y = frame.nearest_place(snooker.MIDDLE + 0.6 * snooker.D_RADIUS, snooker.BAULK - 0.01)
        placed = moved(frame, x, y)
        view = self.view(placed)
        idea = ideas_of(placed)[0]
        safe = self.safe_stroke(view, idea, BREAK_SPEEDS)
        stroke = Stroke(*safe.stroke.tolist())
        return Decision("", (x, y), stroke, idea.call, (), safe.worth, safe.legal, SAFETY, safe.worth)

    def option(self, frame: SnookerFrame) -> str:
        """One of the choices after a foul, or at the black that was put back."""
        names = [option.name for option in frame.game.options]
        if GO_SECOND.name in names:
            return GO_SECOND.name
        if ANYWHERE.name in names:
            return ANYWHERE.name
        playing = frame.choose(PLAY.name).with_cue_ball()
        assert isinstance(playing, SnookerFrame)
        chance = self._glance(playing)
        if chance >= GOOD:
            return PLAY.name
        if REPLAY.name in names:
            return REPLAY.name
        return PLAY.name if chance >= POOR or frame.snooker.free_ball else AGAIN.name


def decide_snooker(
    frame: SnookerFrame, grade: SnookerGrade, seed: int = 0, seconds: float | None = None,
    threads: int | None = None,
) -> Decision:  # fmt: skip
    """What a player of a grade plays, or chooses; "concede" is among the options of a lost frame.

    Without `seconds` it depends on frame, grade and seed only. ValueError if the frame is over.
    """
    game = frame.snooker
    if game.over:
        raise ValueError("game: the frame is over")
    mind = _Mind(grade, seed, seconds, threads)
    if len(game.players) == 2 and not game.reds_left and game.snookers_needed(game.turn) >= HOPELESS:
        return Decision(option="concede")
    if game.options:
        return Decision(option=mind.option(frame))
    if game.opening and game.in_hand:
        return mind.break_off(frame)
    return mind.from_hand(frame) if game.in_hand else mind.stroke(frame)


def hand_of(stroke: Stroke, grade: SnookerGrade, seed: int) -> Stroke:
    """What the player's hand makes of a stroke, the same for the same seed."""
    draw = np.random.default_rng(seed).standard_normal((1, 5))
    return Stroke(
        *with_noise(np.array([stroke], dtype=np.float64), draw, grade.noise, snooker.BALL_RADIUS)[0].tolist()
    )
