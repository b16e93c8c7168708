"""What scenes of a game at a cue table have in common: their parts, and what each is asked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from game.arrays import Floats
from game.scenes.shared.tables import actions as keys
from game.scenes.shared.tables.course import REPLAY
from game.scenes.shared.tables.lessons.order import level_after
from game.scenes.shared.tables.minds.contest import contest_of, stroke_of
from game.scenes.shared.tables.seats.hot_seat import draw_hand_over, waits
from game.scenes.shared.tables.together.stroke_text import looks_like_a_stroke
from game.stage import Action, Decision, Equation, Hearing, Hint, Pointer, Scene, Stamped, Strip
from game.stage.records.contested import Contested, StrokeMeasured

ENERGY, CUE_BALL = Strip("Energy", "J", ("energy",)), Strip("Cue ball", "m/s", ("cue ball",))
SLIDING = Equation(
    "Sliding", r"\v{r} = \v{r}_0 + \v{v}_0 t - \frac{1}{2} \mu g t^2 \v{u}", "Leckie, Greenspan 2006"
)
PLAYS_ITSELF = Stamped(12, Action("demo"))  # and it goes on playing


class CueGameState(NamedTuple):
    """What is on the table at this moment.

    clock (1,) s: time of the phase; at a table with replays (2,), also the place in the replay.
    places (n, 2) m of the balls. turns, turns_before (n, 3, 3): how they are turned, and were before the
    last stroke. cue (7,). word: of the frame.
    """

    clock: Floats
    places: Floats
    turns: Floats
    turns_before: Floats
    cue: Floats
    word: str


class CueGameScene(Scene):
    """A game of parts that ``build`` makes: model, course, hand, opponents, sounds and view."""

    covers = True
    quarter_turns = 1

    model: Any
    course: Any
    hand: Any
    opponents: Any
    sounds: Any
    view: Any
    exchange: Any

    def state(self) -> CueGameState:
        model, course = self.model, self.course
        return CueGameState(
            course.clock, model.places, model.turns, model.turns_before, course.cue.data,
            f"{course.phase} {model.word}",
        )  # fmt: skip

    def restore(self, state: CueGameState) -> None:
        for mine, then in zip(self.state()[:-1], state[:-1], strict=True):
            mine[...] = then  # the frame comes back with the plain attributes

    def effects_changed(self) -> None:
        self.model.configure(self.active)

    def advance(self, dt: float) -> None:
        self.course.advance(dt)
        self.opponents.play_on()

    def pointer(self, event: Pointer) -> None:
        if not waits(self.course):
            self.hand.take(event)
        elif event.kind == "down":
            self.course.seated = int(self.course.model.frame.game.turn)

    def action(self, name: str) -> None:
        if not self.takes_seat(name):
            self.act(name)

    def act(self, name: str) -> None:
        """What an action does at the table."""
        self.hand.act(name)

    def takes_seat(self, name: str) -> bool:
        """Whether an action is answered by the card between two persons: striking takes the cue."""
        if not waits(self.course) or name != "strike":
            return False
        self.course.seated = int(self.course.model.frame.game.turn)
        return True

    def decisions(self, at_once: bool = False) -> list[Decision]:
        found: list[Decision] = self.opponents.decisions(at_once)
        return found

    def given_text(self) -> str:
        text: str = self.exchange.given()
        return text

    def take_text(self, text: str) -> tuple[Decision, ...] | None:
        if not looks_like_a_stroke(text):
            return None
        decisions: tuple[Decision, ...] = self.exchange.taken(text)
        return decisions

    @property
    def plays_alone(self) -> bool:
        return bool(self.course.plays_alone)

    @property
    def contest(self) -> Contested | None:
        return contest_of(self.course)

    @property
    def stars(self) -> tuple[int, int] | None:
        stars: tuple[int, int] | None = None if self.course.plays_itself else self.course.learning.stars
        return stars

    @property
    def level_wanted(self) -> str:
        path = self.level.path if self.level is not None else None
        return level_after(path.stem) if self.course.learning.to_next and path is not None else ""

    @property
    def round_wanted(self) -> int:
        return int(self.course.rounds)

    def stroke_measured(self) -> StrokeMeasured | None:
        return stroke_of(self.course)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, alpha, None if self.previous is None else self.previous.clock)
        draw_hand_over(canvas, self.course)

    def hearing(self) -> Hearing | None:
        heard: Hearing | None = self.sounds.hearing()
        return heard

    @property
    def way_out(self) -> str:
        return "replay" if self.course.phase == REPLAY else ""

    def hints_now(self) -> Sequence[Hint]:
        if not self.course.push.chosen:
            return self.hints
        pushed = {keys.PULL: (keys.PUSH, keys.BREATH)}
        return [one for hint in self.hints for one in pushed.get(hint, (hint,))]

    def messages(self) -> tuple[str, ...]:
        said: tuple[str, ...] = self.course.messages.take()
        return said
