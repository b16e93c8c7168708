"""Players without a hand at any cue game: computer players decide, and the table plays by itself."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, ClassVar, Protocol

from game.physics.kernels import elementary
from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.minds.hurry import patience
from game.scenes.shared.tables.minds.thoughts import Told
from game.scenes.shared.tables.minds.walking import Edge, Walk
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Decision

NEXT_STROKE_S = 0.7  # s of rest before the next stroke of a computer player, or of the table itself
LATEST_S = 3.0  # s of rest after which it plays from wherever it stands
TOLD_IN = ("striking", "rolling", "aiming")  # phases in which its thoughts are told
CHOICE_S = 3.0  # s of rest before it chooses: so long a person reads why there is something to be chosen


class Course(Protocol):
    """What these players know of a game's course."""

    phase: str
    rest_s: float

    @property
    def model(self) -> Any:
        """With the ``frame`` as it stands, and the ``word`` that its chances are drawn from."""

    @property
    def grip(self) -> Any:
        """What a person's hand holds, if anything."""

    @property
    def person_plays(self) -> bool:
        """Whether a person is at turn."""

    @property
    def plays_itself(self) -> bool:
        """Whether the table plays, and no player."""

    @property
    def plays_alone(self) -> bool:
        """Whether computer players are among themselves."""

    def grade_of(self, player: int) -> str:
        """The grade of a player."""


class TableOpponents:
    """The thinker for computer players, and what was considered last; no part of the state.

    ``think`` answers for a player. A subclass says how long a game that is over stays, and how many bytes of
    the model's word make a seed. It says what is done when thinking failed, and what the table does by
    itself.
    """

    stays_s: ClassVar[float] = 3.0
    seed_bytes: ClassVar[int] = 6

    def __init__(
        self,
        course: Course,
        think: Callable[[Question], Thought],
        warm_ups: Sequence[Callable[[], None]] = (),
        thinking_grades: Sequence[str] = (),
    ) -> None:
        self.course: Any = course
        self.thinker = Thinker(think, *warm_ups)
        self.considered: tuple[Any, ...] = ()
        self.told = Told()
        self.walk = Walk()
        self._prepared_for = thinking_grades

    @property
    def question(self) -> Question:
        """What a computer player at turn is asked."""
        model = self.course.model
        key = (model.frame.strokes, model.word)
        seed = int.from_bytes(key[1].encode()[: self.seed_bytes], "little")
        return Question(key, model.frame, self.course.grade_of(model.frame.game.turn), seed)

    @property
    def is_over(self) -> bool:
        """Whether the game is."""
        return bool(self.course.model.frame.game.over)

    def decisions(self, at_once: bool = False) -> list[Decision]:
        """What the computer player at turn has decided, if it is one and has. at_once: it does so now."""
        course, players = self.course, self.course.model.frame.game.players
        grades = self._prepared_for
        if grades and not at_once and any(course.grade_of(k) in grades for k in range(len(players))):
            self.thinker.prepare()
        computer = not course.person_plays and not course.plays_itself and not self.is_over
        if not computer or course.phase != AIMING or course.grip:
            self.thinker.forget()
            return []
        rested = course.rest_s > (CHOICE_S if course.model.frame.game.options else NEXT_STROKE_S)
        self._walk_on(None)
        if at_once:
            thought = self.thinker.answer(self.question) if rested else None
        else:
            thought = self.thinker.ask(self.question)
        if thought is None:
            return []
        self.considered = thought.considered
        self.told = thought.told if thought.told is not None else Told()
        arrived = self._walk_on(thought) or course.rest_s > patience(course, LATEST_S)
        if not rested or not (arrived or at_once):
            return []
        return list(thought.decisions) or self.instead()

    @property
    def walks(self) -> bool:
        """Whether a computer player is at turn and walks round the table."""
        course = self.course
        computer = not course.person_plays and not course.plays_itself and not self.is_over
        return bool(computer and course.phase == AIMING and not course.model.frame.game.options)

    @property
    def words_of_thoughts(self) -> Told:
        """What is to be told of what the computer player thought, if that is asked for."""
        course = self.course
        return self.told if course.parameters.considered and course.phase in TOLD_IN else Told()

    def likely(self) -> tuple[tuple[float, float], float] | None:
        """The cue ball (x, y) m and the direction, rad, to the nearest ball that may be hit, if known."""
        frame = self.course.model.frame
        place, first = frame.cue_ball, set(frame.game.legal_first())
        found = [
            (elementary.hypot(x - place[0], y - place[1]), elementary.atan2(y - place[1], x - place[0]))
            for number, x, y in frame.layout.places
            if place is not None and number in first
        ]
        return (place, min(found)[1]) if place is not None and found else None

    def _walk_on(self, thought: Thought | None) -> bool:
        """Go on round the table, to where the stroke that was decided is played, or a likely one."""
        aim = self._decided(thought) or self.likely()
        if aim is None:
            return True
        table = self.course.model.frame.table
        edge = Edge(table.width, table.length)
        return self.walk.go(edge, edge.stance(*aim), float(self.course.rest_s))

    def _decided(self, thought: Thought | None) -> tuple[tuple[float, float], float] | None:
        """Cue ball and direction of the stroke that has been decided."""
        strokes = [one for one in thought.decisions if len(one.values) >= 5] if thought is not None else []
        places = [one.values for one in thought.decisions if len(one.values) == 2] if thought else []
        likely = None if places else self.likely()
        if not strokes or not (places or likely):
            return None
        place = (float(places[0][0]), float(places[0][1])) if places else likely[0] if likely else (0.0, 0.0)
        return place, float(strokes[0].values[1])

    def instead(self) -> list[Decision]:
        """What is done if thinking has failed, so that the game goes on."""
        return []

    def play_on(self) -> None:
        """A new game when one is over and no person plays; the table's own strokes while it plays itself."""
        course = self.course
        if course.phase != AIMING or not (course.plays_itself or course.plays_alone):
            return
        if self.is_over:
            if course.rest_s > self.stays_s:
                self.begin_again()
        elif course.plays_itself and course.rest_s > NEXT_STROKE_S:
            self.play_itself()

    def begin_again(self) -> None:
        """The next game."""
        raise NotImplementedError

    def play_itself(self) -> None:
        """A stroke of the table, or an option taken."""
        raise NotImplementedError


def check_option(number: float, options: Sequence[Any]) -> int:
    """The number of an option; ValueError if there is none of that number."""
    if not 0 <= int(number) < len(options):
        raise ValueError(f"option {int(number)}: there are {len(options)}")
    return int(number)
