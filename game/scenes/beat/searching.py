"""The searcher: a thread, or at once where no time passes."""

from __future__ import annotations

from game.billiards.rhythm.search import Rhythm, RhythmSearch
from game.scenes.beat.model import BeatModel
from game.scenes.beat.state import SEARCHING
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Decision

BEGINNINGS = 3  # of a search that has not found a shot without clicks off the beat
GOOD_S = 1e-6  # cost at which a search has no more to find


def think(question: Question) -> Thought:
    """Search as long as the question says."""
    beats, table, physics, rounds = question.frame
    best: Rhythm | None = None
    for again in range(BEGINNINGS):
        search = RhythmSearch(beats, table, physics, BEGINNINGS * question.seed + again)
        found = search.run(len(beats) - 1 + rounds, good_s=GOOD_S)
        if found is not None and (best is None or found.cost < best.cost):
            best = found
        if best is not None and best.cost <= GOOD_S:
            break
    if best is None:
        return Thought((Decision("nothing", ()),))
    return Thought((Decision("layout", best.candidate),))


class Searcher:
    """The search for the beat that is open; no part of the state."""

    def __init__(self, model: BeatModel) -> None:
        self.model = model
        self.thinker = Thinker(think)

    def decisions(self, at_once: bool) -> tuple[Decision, ...]:
        """What it has come to."""
        model = self.model
        if model.phase != SEARCHING:
            self.thinker.forget()
            return ()
        values = model.parameters
        seed = model.seed * 10_000 + int(values.seed)
        frame = (model.beats, model.table, model.physics, int(values.rounds))
        question = Question((model.beats, seed, int(values.rounds)), frame, "", seed)
        thought = self.thinker.answer(question) if at_once else self.thinker.ask(question)
        if thought is None:
            return ()
        return thought.decisions or (Decision("nothing", ()),)  # a search that failed has found nothing
