"""The course of the game: aiming, the cue's swing, balls rolling; undo, racks and choices."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill, Ghost
from game.billiards.game.log import Log
from game.billiards.game.rules import CUE_BALL, Call
from game.scenes.billiards.model import BilliardsModel
from game.scenes.billiards.parameters import BilliardsParameters
from game.scenes.billiards.stroke.aiming import AT_THE_RACK, Aiming
from game.scenes.billiards.stroke.calling import call_for
from game.scenes.billiards.stroke.guide import guide_of
from game.scenes.billiards.stroke.motion import DRAWN, PUSHED, StrokeMotion, stroke_motion
from game.scenes.shared.tables.choices import PERSON
from game.scenes.shared.tables.course import LONG_AGO_S
from game.scenes.shared.tables.grip import NOTHING
from game.scenes.shared.tables.minds.hurry import hurried
from game.scenes.shared.tables.moments import OFF, decider, pace_at
from game.scenes.shared.tables.seats.cup import goes_on
from game.scenes.shared.tables.seats.hot_seat import waits
from game.scenes.shared.tables.through.measured import news_of_hand
from game.scenes.shared.tables.through.push import Push
from game.scenes.shared.tables.unsteady import STEADY_HAND, shaken
from game.stage import Part
from game.stage.messages import Messages

if TYPE_CHECKING:
    from game.billiards.search.strokes import Noise

AIMING, STRIKING, ROLLING, REPLAY, SET_UP = "aiming", "striking", "rolling", "replay", "set-up"
PHASE_S, REPLAY_S = range(2)
MOST_OWN = 200  # strokes from which one's own hand is measured
SLOW, SLOW_BEFORE_S, SLOW_AFTER_S = 0.25, 0.30, 0.12  # of the pace; s of the shot before and after the pot


class Play(Part):
    """In which phase the game is, and since when.

    clock (2,) s: time of the phase, place in the replay; it belongs to the state. pending: the stroke for
    which the cue swings; begins: how, as of `stroke_motion`. grip: what the pointer holds, which a new
    phase takes from it. rest_s: how long nothing has been done, s. by_hand: how many strokes a hand has
    played; meant, done: the last of them as it was aimed, and as the hand did it. own: the last such pairs of
    strokes by a hand that strays. log: of all strokes. push: the cue of one that is pushed.
    called_s: since the referee last called, s; rack_s: how long the rack has lasted.
    seated: the player that has the cue, where it is handed over.
    advised: number of strokes at which the coach was asked last, coached: how often in this rack.
    rounds: how often the next round of a cup has been asked for.
    """

    def __init__(
        self, parameters: BilliardsParameters, model: BilliardsModel, aiming: Aiming, seed: int
    ) -> None:
        self.parameters = parameters
        self.model = model
        self.aiming = aiming
        self.cue = aiming.cue
        self.phase = AIMING
        self.clock = np.zeros(2)
        self.pending: Stroke | None = None
        self.begins = DRAWN
        self.push = Push(parameters)
        self.grip = NOTHING
        self.plays_itself = False
        self.seated = int(model.frame.game.turn)
        self.rest_s = 0.0
        self.lock_explained = False
        self.by_hand = 0
        self.meant: Stroke | None = None
        self.done: Stroke | None = None
        self.own: tuple[tuple[Stroke, Stroke], ...] = ()
        self.log = Log()
        self.rounds = 0
        self.advised = -1
        self.coached = 0
        self.called_s = LONG_AGO_S
        self.rack_s = 0.0
        self._seed = seed
        self.messages = Messages()

    # -- who plays ----------------------------------------------------------------------------------

    def grade_of(self, player: int) -> str:
        """ "person", or the grade of a computer player."""
        return str(self.parameters.first_player if player == 0 else self.parameters.second_player)

    def set_grade(self, player: int, grade: str) -> None:
        """Let a person, or a computer player of a grade, play."""
        if player == 0:
            self.parameters.first_player = grade
        else:
            self.parameters.second_player = grade

    @property
    def person_plays(self) -> bool:
        """True if the player at turn is a person."""
        return not self.plays_itself and self.grade_of(self.model.frame.game.turn) == PERSON

    @property
    def guide(self) -> str:
        """How much of the stroke that is aimed is shown: one of `stroke.guide.GUIDES`."""
        return guide_of(str(self.parameters.guide), self.model.frame.game)

    @property
    def racks_to_win(self) -> int:
        """Racks that win the match; 0 if it has no end."""
        game = self.model.frame.game
        two = len(game.players) == 2 and not isinstance(game, Ghost)
        return int(self.parameters.race) if two and self.parameters.race != "open" else 0

    @property
    def match_over(self) -> bool:
        """True if a player has won the match."""
        game = self.model.frame.game
        return game.over and (game.set_over or 0 < self.racks_to_win <= max(game.won))

    @property
    def plays_alone(self) -> bool:
        """True if no player is a person."""
        return all(self.grade_of(player) != PERSON for player in range(len(self.model.frame.game.players)))

    @property
    def aimed_and_done(self) -> tuple[Stroke, Stroke] | None:
        """The last stroke of a hand, as it was aimed and as it was done."""
        return (self.meant, self.done) if self.meant is not None and self.done is not None else None

    @property
    def own_strokes(self) -> tuple[tuple[Stroke, Stroke], ...]:
        """The last strokes of a person's hand, (meant, made) each."""
        return self.own

    @property
    def may_aim(self) -> bool:
        """True if a person may aim and strike now."""
        return self.phase == AIMING and self.person_plays and self.model.frame.playable and not waits(self)

    @property
    def asked(self) -> bool:
        """True if a person has to choose an option."""
        return bool(
            self.phase == AIMING and self.person_plays and self.model.frame.game.options
        ) and not waits(self)

    # -- phases -------------------------------------------------------------------------------------

    def start_phase(self, phase: str) -> None:
        """Go over to a phase, its clock at 0."""
        self.phase = phase
        self.clock[PHASE_S] = 0.0
        self.rest_s = 0.0

    def let_go(self) -> None:
        """The hand holds nothing any more, and no cue is drawn back."""
        self.grip = NOTHING
        self.aiming.cue.let_go()
        self.push.let_go()

    def advance(self, dt: float) -> None:
        """One step of what goes on by itself."""
        self.push.advance(dt)
        self.called_s += dt
        self.rack_s += 0.0 if self.model.frame.game.over else dt
        if self.phase == STRIKING:
            self.clock[PHASE_S] += dt
            self._swing()
        elif self.phase == ROLLING:
            pace = hurried(self, self.pace, self.model.decided is not None)
            self.clock[PHASE_S] = self.shown_s if math.isinf(pace) else self.clock[PHASE_S] + dt * pace
            self._roll()
        elif self.phase == AIMING:
            self.rest_s += dt
            self.aiming.advance(dt)

    @property
    def pace(self) -> float:
        """How fast a shot goes on: slowly while the ball that decides the rack is about to fall.

        So it is while one that a camera follows hangs over a pocket.
        """
        decided = self.model.decided
        if decided is None:
            follows = self.parameters.eye_follows != OFF
            return pace_at(float(self.clock[PHASE_S]), decider(self.model.moments, False)) if follows else 1.0
        left = decided.time - float(self.clock[PHASE_S])
        return SLOW if -SLOW_AFTER_S <= left <= SLOW_BEFORE_S else 1.0

    @property
    def motion(self) -> StrokeMotion:
        """How the cue moves for the pending or the last stroke."""
        stroke = self.pending
        if stroke is None:
            last = self.model.frame.last
            stroke = last.stroke if last is not None else Stroke(1.0, 0.0)
        return stroke_motion(stroke.cue_speed, self.begins)

    @property
    def shown_s(self) -> float:
        """How long the last stroke is shown: to its end, and until the cue has gone, s."""
        played, motion = self.model.played, self.motion
        end = played.trajectory.end_time if played is not None else 0.0
        return max(end, motion.end_s - motion.hit_s) + 0.05

    # -- a stroke -----------------------------------------------------------------------------------

    def begin_stroke(self, stroke: Stroke, call: Call, begins: str = DRAWN) -> None:
        """The cue starts to swing. ValueError if no stroke may be played now."""
        if self.phase != AIMING or not self.model.frame.playable:
            raise ValueError("stroke: none may be played now")
        self.pending, self.begins = stroke, begins
        self.aiming.call = call
        self.grip = NOTHING
        self.aiming.point_along(stroke.azimuth)
        self.start_phase(STRIKING)

    def strike_by_hand(self) -> None:
        """The stroke that is set, as the hand of a person does it."""
        frame, meant = self.model.frame, self.aiming.stroke
        call = call_for(frame, self.aiming.call, meant)
        radius = float(frame.layout.balls.radii[CUE_BALL])
        pushed = self.push.struck is not None
        if pushed:
            made = self.push.made(meant, radius)
        else:
            made = shaken(meant, str(self.parameters.hand), self._seed, self.by_hand, radius)
        done = self.push.after_the_tip(made)
        self.begin_stroke(done, call, PUSHED if pushed else DRAWN)
        self._strayed(meant, made)
        self.done = done
        if self.push.slipped:
            self.messages.say(self.push.miscue_words(made))
        if pushed and (news := news_of_hand(self.own, radius)):
            self.messages.say(news)

    def by_own_hand(self, meant: Stroke, noise: Noise) -> Stroke:
        """A stroke as a hand does it: the one that shakes as chosen, else one of that noise."""
        hand = str(self.parameters.hand)
        shakes = noise if hand == STEADY_HAND else hand
        radius = float(self.model.frame.layout.balls.radii[CUE_BALL])
        done = shaken(meant, shakes, self._seed, self.by_hand, radius)
        self._strayed(meant, done)
        return done

    def _strayed(self, meant: Stroke, done: Stroke) -> None:
        """A hand has played: what was meant, and what it did."""
        self.by_hand += 1
        self.meant, self.done = meant, done
        if done != meant:
            self.own = (*self.own, (meant, done))[-MOST_OWN:]

    def _swing(self) -> None:
        """When the tip has met the ball, the stroke is played."""
        late = float(self.clock[PHASE_S]) - self.motion.hit_s
        if late < 0.0 or self.pending is None:
            return
        stroke, self.pending = self.pending, None
        call, self.aiming.call = self.aiming.call, Call()
        try:
            self.model.strike(stroke, call)
        except ValueError as error:
            self.messages.say(f"The stroke cannot be played. {error}")
            self.start_phase(AIMING)
            return
        self.start_phase(ROLLING)
        self.clock[PHASE_S] = late
        self._roll()

    def _roll(self) -> None:
        """The balls where they are by now; at the end of the shot the next player aims."""
        time = float(self.clock[PHASE_S])
        self.model.roll(time)
        if time >= self.shown_s:
            struck, played = self.model.frame.last, self.model.played
            assert struck is not None and played is not None
            self.log = self.log.with_stroke(struck, played)
            self.model.settle()
            self.called_s = 0.0
            self.aiming.forget_pull()
            self.start_phase(AIMING)

    def skip(self) -> None:
        """On to the end of the shot."""
        if self.phase == ROLLING:
            self.clock[PHASE_S] = self.shown_s
            self._roll()

    def ask_coach(self) -> None:
        """Ask what to play; the score says so until the next rack."""
        strokes = self.model.frame.strokes
        if self.may_aim and self.advised != strokes:
            self.advised = strokes
            self.coached += 1

    def toggle_lock(self) -> None:
        """Lock the aim or free it."""
        self.aiming.toggle_lock()
        self._explain_lock()

    def keep_aim(self) -> None:
        """Lock the aim that stood before the hand went to an instrument."""
        self.aiming.keep()
        self._explain_lock()

    def hold_aim(self) -> None:
        """Lock the aim as it is."""
        self.aiming.hold()
        self._explain_lock()

    def _explain_lock(self) -> None:
        """Say, the first time, how a locked aim is freed."""
        if self.aiming.locked and not self.lock_explained:
            self.lock_explained = True
            self.messages.say("The aim is locked. A click on the table frees it.")

    # -- back, on, and again ------------------------------------------------------------------------

    def undo(self) -> None:
        """Before the last stroke of a person, aimed as it was."""
        if self.phase == STRIKING:
            self.pending = None
            self.start_phase(AIMING)
            return
        taken = self.model.frame
        if taken.game.final and taken.last is not None:
            self.messages.say("Nothing is taken back. This is counted.")
            return
        if taken.earlier is None:
            self.messages.say("Nothing to undo. No stroke has been played.")
            return
        while taken.earlier is not None:
            last = taken.last
            taken = taken.earlier
            if self.grade_of(taken.game.turn) == PERSON or self.plays_itself:
                break
        strokes = self.model.frame.strokes - taken.strokes - (self.phase == ROLLING)
        self.log = self.log.taken_back(strokes)
        self.model.go_back_to(taken)
        if last is not None and self.grade_of(taken.game.turn) == PERSON:
            self.aiming.aim_as(self.meant if self.meant and last.stroke == self.done else last.stroke)
            self._explain_lock()
        self.aiming.call = Call()
        self.start_phase(AIMING)

    def rack(self) -> None:
        """The next rack if the game is over, else this game, or this drill, from its beginning.

        After a match the next one; after a match of a cup its next round is asked for.
        """
        if goes_on(self):
            return
        self.model.rack(new_match=self.match_over)
        if not isinstance(self.model.frame.game, Drill):  # a shot that is tried again is aimed as it was
            self.aiming.point_along(AT_THE_RACK)
        self.pending, self.aiming.call = None, Call()
        self.advised, self.coached = -1, 0
        self.called_s, self.rack_s = LONG_AGO_S, 0.0
        self.let_go()
        self.start_phase(AIMING)

    def take_option(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0; nothing if there is no such."""
        if self.phase == AIMING and 0 <= row < len(self.model.frame.game.options):
            self.model.choose(row)
            self.rest_s = 0.0
