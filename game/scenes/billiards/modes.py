"""Replay and set-up: two modes to look at the billiard table, or lay it out, without playing."""

from __future__ import annotations

from game.billiards.game.arrangement import is_free, nearest_free, racked
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.play import AIMING, REPLAY, REPLAY_S, SET_UP, Play
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.moments import pace_at
from game.stage import Part

REPLAY_SPEEDS = (0.0625, 0.125, 0.25, 0.5, 1.0, 2.0)


class Replay(Part):
    """The last stroke seen once more: whether it runs, how fast, and whether from its side, then slowly about
    the moments that decide.
    """

    def __init__(self, play: Play) -> None:
        self.play = play
        self.runs = True
        self.speed = 1.0
        self.from_side = False

    @property
    def time(self) -> float:
        """The moment of the stroke that is shown, s."""
        return float(self.play.clock[REPLAY_S])

    def begin(self, from_side: bool = False) -> None:
        """Show the last stroke, if there is one."""
        if self.play.model.frame.last is None:
            self.play.messages.say("Nothing to show. No stroke has been played.")
            return
        self.play.let_go()
        self.play.clock[REPLAY_S] = 0.0
        self.runs, self.from_side = True, from_side
        self.play.start_phase(REPLAY)

    def advance(self, dt: float) -> None:
        """Go on; it stops at the end of the stroke."""
        if self.play.phase != REPLAY or not self.runs or self.play.grip == grip.REPLAY:
            return
        self.play.clock[REPLAY_S] = min(self.time + dt * self.speed * self._pace, self.play.shown_s)
        if self.time >= self.play.shown_s:
            self.runs = False

    @property
    def _pace(self) -> float:
        """How fast it goes on now: seen from the side, slowly where balls meet, drop or hang."""
        moments = self.play.model.moments if self.from_side else None
        return pace_at(self.time, moments) if moments is not None else 1.0

    def toggle(self) -> None:
        """Run or stand; from the end it begins again."""
        if not self.runs and self.time >= self.play.shown_s:
            self.play.clock[REPLAY_S] = 0.0
        self.runs = not self.runs

    def change_speed(self) -> None:
        """The next slower speed, and after the slowest the fastest."""
        place = REPLAY_SPEEDS.index(self.speed)
        self.speed = REPLAY_SPEEDS[(place - 1) % len(REPLAY_SPEEDS)]

    def scrub(self, share: float) -> None:
        """Go to a share of the stroke, 0 to 1."""
        self.play.clock[REPLAY_S] = share * self.play.shown_s

    def end(self) -> None:
        """Back to the game."""
        self.play.grip = grip.NOTHING
        self.play.start_phase(AIMING)


class SetUp(Part):
    """Balls placed freely."""

    def __init__(self, play: Play) -> None:
        self.play = play

    def begin(self) -> None:
        """Let balls be placed."""
        self.play.let_go()
        self.play.plays_itself = False
        self.play.model.begin_set_up()
        self.play.start_phase(SET_UP)

    def end(self) -> None:
        """Back to the game; what was set up is practised."""
        self.play.model.end_set_up()
        self.play.grip = grip.NOTHING
        self.play.start_phase(AIMING)

    def fill(self, full: bool) -> None:
        """All balls racked, or the cue ball alone."""
        if self.play.phase != SET_UP:
            return
        frame = self.play.model.frame
        balls = racked(frame.table, "eight-ball", frame.layout.balls)
        self.play.model.set_up(balls if full else balls.without(*range(1, 16)))

    def ball_at(self, x: float, y: float) -> int:
        """Number of the ball on the table or in the tray at a point; -1 if there is none."""
        for number, bx, by in self.play.model.frame.layout.places:
            if layout.near((bx, by), x, y, BALL_RADIUS):
                return number
        for number in range(16):
            if layout.near(layout.tray_place(number), x, y, BALL_RADIUS):
                return number
        return -1

    def drag(self, number: int, x: float, y: float) -> None:
        """The ball goes where the pointer is, if it may lie there."""
        if self.play.phase != SET_UP or not layout.TABLE.holds(x, y):
            return
        balls, table = self.play.model.frame.layout, self.play.model.frame.table
        if not is_free(balls, table, number, x, y):
            try:
                x, y = nearest_free(balls, table, number, x, y)
            except ValueError:
                return
        self.play.model.set_up(balls.with_ball(number, (x, y)))

    def put_down(self, number: int, x: float, y: float) -> None:
        """A ball let go beside the table goes back into the tray."""
        balls = self.play.model.frame.layout
        if self.play.phase == SET_UP and not layout.TABLE.holds(x, y) and number in balls.numbers:
            self.play.model.set_up(balls.without(number))


def leave(replay: Replay, set_up: SetUp) -> None:
    """Out of whichever of the two goes on."""
    if replay.play.phase == REPLAY:
        replay.end()
    elif set_up.play.phase == SET_UP:
        set_up.end()
