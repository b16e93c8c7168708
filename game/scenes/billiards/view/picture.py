"""How the billiard game is drawn: table, balls at any moment, cue, aim, and the instruments round them."""

from __future__ import annotations

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import CUE_BALL
from game.billiards.search.legality import legality_of
from game.levels import Level
from game.scenes.billiards import layout
from game.scenes.billiards.buttons import Buttons
from game.scenes.billiards.modes import Replay
from game.scenes.billiards.opponents.deciding import Opponents
from game.scenes.billiards.play import AIMING, PHASE_S, REPLAY, REPLAY_S, ROLLING, SET_UP, STRIKING, Play
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.practice.sets import drill_title
from game.scenes.billiards.view.balls import balls_at_rest
from game.scenes.billiards.view.beside.on_cloth import OnCloth
from game.scenes.billiards.view.close_up import CloseUpView
from game.scenes.billiards.view.cloth import dress_of
from game.scenes.billiards.view.cue import draw_players_cue
from game.scenes.billiards.view.end_card import EndCard, is_shown
from game.scenes.billiards.view.instruments import Instruments
from game.scenes.billiards.view.marks import draw_marks
from game.scenes.billiards.view.over_cue import OverCue
from game.scenes.billiards.view.score_board import draw_board, draw_line, key_rows
from game.scenes.billiards.view.standing import standing_of
from game.scenes.billiards.view.words import foul_of, line_of
from game.scenes.shared.tables import boxes, grip
from game.scenes.shared.tables.choices import FIRST, NONE
from game.scenes.shared.tables.minds.walking import draw_walk
from game.scenes.shared.tables.odds import Asked, Odds, OddsMeter
from game.scenes.shared.tables.prediction import FIRST_BALL, Foresight, Sight
from game.scenes.shared.tables.referee.banner import draw_call
from game.scenes.shared.tables.referee.calls import pool_call
from game.scenes.shared.tables.referee.remark import draw_remark, said
from game.scenes.shared.tables.rolling import balls_at
from game.scenes.shared.tables.sight import draw_considered, draw_fan, draw_label, draw_sight
from game.scenes.shared.tables.through.recoil import draw_recoil
from game.scenes.shared.tables.unsteady import SURE, spread_of
from game.scenes.shared.tables.view import Balls, draw_balls, draw_table
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import FELT_WARM

EDGE = 2.0  # px of the frame that may be out of the picture
HINT_EVENTS = 200  # to the end of its shot


class BilliardsView:
    """The picture of the game. level: the one it began with."""

    def __init__(
        self,
        play: Play,
        replay: Replay,
        buttons: Buttons,
        opponents: Opponents,
        on_cloth: OnCloth,
        level: Level | None,
    ) -> None:
        self.play = play
        self.buttons = buttons
        self.opponents = opponents
        self.on_cloth = on_cloth
        self.level = level
        self.instruments = Instruments(play, replay, buttons)
        self._foresight = Foresight()
        self._hint_foresight = Foresight()
        self._odds = OddsMeter()
        self._close_up = CloseUpView()
        self._over_cue = OverCue(play, replay)
        self._end_card = EndCard()

    def draw(self, canvas: Canvas, alpha: float, clock_before: Floats | None) -> None:
        """The game, ``alpha`` of the step from the clock before to the clock now."""
        play, frame = self.play, self.play.model.frame
        dress = dress_of(play)
        draw_table(canvas, frame.table, dress=dress)
        canvas.halo = dress.felt
        time = self._moment(alpha, clock_before)
        near = self._close_up.part(play, time, canvas.look.less_motion)
        sight = None
        if self._over_cue.from_side:
            self._over_cue.draw_side(canvas, self.balls_at(time), time)
        elif near is not None:
            self._close_up.draw(canvas, frame.table, self.balls_at(time), near, dress.felt)
        else:
            sight = self._draw_play(canvas, time)
            self._over_cue.draw_inset(canvas, self.balls_at(time), sight, time)
        if canvas.pixels_per_unit >= layout.LEAST_PIXELS and self._in_view(canvas):
            self._draw_around(canvas, look_of(canvas), self._odds_of(sight))
        last = frame.last
        if play.phase == ROLLING and last is not None and last.stroke == play.done:
            draw_recoil(canvas, play.parameters, last.stroke, time)

    def _in_view(self, canvas: Canvas) -> bool:
        """Whether all that stands round the table is seen: nearer, it would be cut off at the edges."""
        seen, whole = canvas.camera.visible(), layout.FRAME
        slack = EDGE / canvas.pixels_per_unit
        return (
            seen.bottom <= whole.bottom + slack and seen.top >= whole.top - slack
            and seen.left <= whole.left + slack and seen.right >= whole.right - slack
        )  # fmt: skip

    def _draw_play(self, canvas: Canvas, time: float) -> Sight | None:
        """What lies and moves on the table at a time of the phase, s; what is foreseen of an aimed stroke."""
        play, frame = self.play, self.play.model.frame
        draw_marks(canvas, play)
        self.on_cloth.draw(canvas)
        shows_aim = play.may_aim and play.guide != NONE and play.grip != grip.CUE_BALL
        sight = self._draw_aim(canvas) if shows_aim else None
        if self.hint is not None and play.phase == AIMING:
            self._draw_hint(canvas, self.hint)
        landing = self.on_cloth.draw_cloud(canvas)
        draw_balls(canvas, self.balls_at(time), frame.table, felt=dress_of(play).felt)
        self.on_cloth.draw_cloud_words(canvas, landing)
        if sight is not None:
            foul = foul_of(frame.game, play.aiming.call, sight.target, sight.short)
            radius = float(frame.layout.balls.radii[CUE_BALL])
            draw_label(canvas, sight, frame.layout.places, frame.table, radius, foul)
        if play.parameters.considered and play.phase == STRIKING and not play.person_plays:
            shots = self.opponents.considered
            draw_considered(canvas, shots, frame.layout.places, frame.table, played=False)
        draw_players_cue(canvas, play, time)
        if self.opponents.walks:
            draw_walk(canvas, frame.table, self.opponents.walk)
        return sight

    def _odds_of(self, sight: Sight | None) -> Odds | None:
        """Of the stroke that is aimed at a ball; none at the break, which is no pot."""
        frame = self.play.model.frame
        if sight is None or sight.target is None or frame.game.opening:
            return None
        return self._odds.of(frame, self.play.aiming.stroke, self._asked(sight.target))

    def _asked(self, ball: int) -> Asked:
        """The pot that was chosen on the map, while its stroke is set; else that of the ball aimed at."""
        play = self.play
        pot = self.on_cloth.advisor.aimed
        free = play.aiming.call.push_out
        legality = None if free else legality_of(play.model.frame)
        noise = hand_of(play).noise
        if pot is not None:
            return Asked(pot.ball, pot.pocket, legality, noise)
        return Asked(ball, None, legality, noise)

    @property
    def hint(self) -> Stroke | None:
        """The solution of a puzzle while it is shown."""
        solution = self.play.model.content.solution
        return solution.stroke() if self.buttons.hint_shown and solution is not None else None

    def _moment(self, alpha: float, clock_before: Floats | None) -> float:
        """Time of the phase, or place in the replay, that is shown, s."""
        column = REPLAY_S if self.play.phase == REPLAY else PHASE_S
        time = float(self.play.clock[column])
        if clock_before is None or self.play.phase not in (STRIKING, ROLLING, REPLAY):
            return time
        before = float(clock_before[column])
        return before + alpha * (time - before) if before <= time <= before + 0.1 else time

    def balls_at(self, time: float) -> Balls:
        """The balls as they are drawn: at rest, or on their paths at a time of the shot, s."""
        model = self.play.model
        played = model.played if self.play.phase in (ROLLING, REPLAY) else None
        if played is None or model.frame.last is None:
            return balls_at_rest(model)
        return balls_at(model.frame.last.frame, played.trajectory, model.turns_before, time)

    def _draw_aim(self, canvas: Canvas) -> Sight | None:
        """Cue line and paths of the stroke that is set; what is foreseen, None if it cannot be played."""
        play, frame = self.play, self.play.model.frame
        stroke, events = play.aiming.stroke, int(play.parameters.events)
        sight = self._foresight.of(frame, stroke, FIRST_BALL if play.guide == FIRST else events)
        if sight is None:
            return None
        radii = frame.layout.balls.radii.tolist()
        draw_fan(canvas, sight, SURE * spread_of(stroke, str(play.parameters.hand), radii[CUE_BALL]))
        target = radii[sight.target] if sight.target is not None else 0.0
        foul = foul_of(frame.game, play.aiming.call, sight.target, sight.short)
        draw_sight(canvas, sight, radii[CUE_BALL], target, bool(foul))
        return sight

    def _draw_hint(self, canvas: Canvas, stroke: Stroke) -> None:
        """The paths of a puzzle's solution; the line below the table says in words how it is struck."""
        sight = self._hint_foresight.of(self.play.model.frame, stroke, HINT_EVENTS)
        if sight is None:
            return
        for points in (sight.approach, sight.after, *(other.points for other in sight.others)):
            if len(points) > 1:
                canvas.polyline(points, FELT_WARM, 2.0, alpha=0.75)

    def _draw_call(self, canvas: Canvas, look: Look) -> None:
        """What the referee calls after a stroke."""
        play, played = self.play, self.play.model.played
        if play.phase != AIMING or played is None:
            return
        run = played.frame.tallies[played.frame.game.turn].run
        spoken = pool_call(played.verdict, run, play.match_over)
        draw_call(canvas, look, layout.TABLE, spoken, play.called_s)
        draw_remark(canvas, look, layout.TABLE, said(play, self.opponents.told.tried), play.called_s)

    def _draw_around(self, canvas: Canvas, look: Look, odds: Odds | None) -> None:
        """Score board, line of words, instruments."""
        play = self.play
        title = drill_title(play.model.frame.game, self.level)
        draw_board(canvas, look, standing_of(play, self.opponents.thinker, title))
        if play.phase not in (SET_UP, REPLAY):
            line = self.opponents.words_of_thoughts.beside(line_of(play, self.hint))
            shaky = play.parameters.hand != "none"
            if not play.asked:  # the options stand there then
                draw_line(canvas, look, line, key_rows(play.guide, shaky) if play.may_aim else ())
        self.instruments.draw(canvas, look, odds)
        self._draw_call(canvas, look)
        if is_shown(play):
            self._end_card.draw(canvas, look, play)


def look_of(canvas: Canvas) -> Look:
    """Letters and lines in the measure of the table's picture."""
    return boxes.look_of(canvas, layout.PIXELS)
