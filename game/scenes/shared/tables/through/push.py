"""A stroke that is pushed: the cue goes as the pointer goes, and strikes as fast as it crosses the ball.

Pressed, drawn back along the aim, pushed forward: the speed of the cue is the slope of the pointer's last
places along the aim. A pointer that drifts aside turns the cue about the bridge hand. So the tip strikes
aside too, and squirt takes part of that back, as with a natural pivot length (Alciatore, technical proof
A.31). The aim sways besides. Places and times are those of recorded events: a replay makes the same stroke.
"""

from __future__ import annotations

import math
from typing import Any

from game.billiards.game.arrangement import Stroke
from game.billiards.shot.cue import speed_ratio
from game.billiards.shot.miscue import TipStroke, miscue, slip_limit, slips
from game.billiards.table.rack import BALL_MASS
from game.physics.kernels import elementary
from game.scenes.shared.tables.choices import LARGEST_TIP
from game.scenes.shared.tables.cue import FULL_PULL, MAX_SPEED, REST_GAP
from game.scenes.shared.tables.through.breath import Breath
from game.scenes.shared.tables.through.choices import AUTO, ON, PUSH
from game.stage import Part, Pointer

MISCUE = "A miscue: the tip slipped, too far"
CHALKED = "The tip is chalked."
BARE = 0.25  # friction of a tip without chalk, where it has not been chosen smaller; assumed
WORN_AFTER = 6.0  # strokes after which the chalk's share of the friction has fallen by e; assumed
WINDOW_S = 0.06  # s of the pointer's path from which its speed is told
LEAST_BACK = 0.02  # m, that a cue must have been drawn back before it strikes
LEAST_SPEED = 0.05  # m/s of the cue
MOST_KEPT = 16  # places of the pointer
BRIDGE = 0.25  # m from the bridge hand to the tip
GRIP = 0.9  # m from the bridge hand to the hand that pushes
WIDEST_TURN = math.radians(10.0)  # of a cue about the bridge


class Push(Part):
    """The cue in the hand.

    clock_s: simulated time. held: it is grasped; aim: along which, rad; origin: where the pointer is when the
    tip touches nothing yet and rests, m. back: how far it is drawn back now, furthest: at most, m. turned_at:
    how far aside the pointer was there. path: (s, m along, m aside) of the last places. turn: of the cue
    about the bridge, rad. struck: speed of the cue m/s, sway and turn, rad, as it crossed the ball. slipped:
    the last tip did; limit: how far out it held, ball radii; since_chalk: strokes of a person since it was
    chalked. ball_mass kg; ball_per_cue: speed of a ball struck in its middle to that of the cue.
    """

    def __init__(self, parameters: Any, ball_mass: float = BALL_MASS) -> None:
        self.parameters = parameters
        self.ball_mass = ball_mass
        self.ball_per_cue = speed_ratio(ball_mass)
        self.breath = Breath(parameters)
        self.clock_s = 0.0
        self.held = False
        self.aim = 0.0
        self.origin = (0.0, 0.0)
        self.back = self.furthest = self.turned_at = self.turn = 0.0
        self.path: tuple[tuple[float, float, float], ...] = ()
        self.struck: tuple[float, float, float] | None = None
        self.slipped = False
        self.limit = 1.0
        self.since_chalk = 0

    @property
    def chosen(self) -> bool:
        """True if strokes are pushed."""
        return bool(self.parameters.stroke_by == PUSH)

    @property
    def gap(self) -> float:
        """Distance from tip to ball, m."""
        return REST_GAP + min(max(self.back, -REST_GAP), FULL_PULL)

    @property
    def sway(self) -> float:
        """How far the whole cue has swayed about the ball, rad."""
        return self.breath.sway_at(self.clock_s)

    @property
    def swayed(self) -> float:
        """How far the cue points beside the aim now, rad."""
        return self.sway + self.turn if self.chosen else 0.0

    def breathe(self) -> None:
        """Hold the breath, if strokes are pushed and it has come back."""
        if self.chosen:
            self.breath.hold()

    def advance(self, dt: float) -> None:
        """One step of time."""
        self.clock_s += dt
        if self.breath.stirs:
            self.breath.advance(dt)

    # -- the pointer --------------------------------------------------------------------------------

    def begin(self, event: Pointer, aim: float) -> None:
        """The cue is grasped, and points along ``aim`` (rad)."""
        self.held, self.aim = True, aim
        self.origin = (event.x, event.y)
        self.back = self.furthest = self.turned_at = self.turn = 0.0
        self.path = ((self.clock_s, 0.0, 0.0),)
        self.struck = None

    def let_go(self) -> None:
        """Nothing is struck."""
        self.held = False
        self.back = self.turn = 0.0

    def move(self, event: Pointer) -> bool:
        """The pointer has moved; True if the cue has crossed the ball: then ``struck`` says how."""
        along, aside = self._place(event)
        if self.furthest < LEAST_BACK and along > 0.0:  # not drawn back yet: the tip rests at the ball
            reach = float(self.parameters.reach)
            cosine, sine = elementary.cos(self.aim), elementary.sin(self.aim)
            x, y = self.origin
            self.origin = (x + along / reach * cosine, y + along / reach * sine)
            along = 0.0
        self.back = -along
        if self.back >= self.furthest:
            self.furthest, self.turned_at = self.back, aside
        drift = elementary.atan2(aside - self.turned_at, GRIP)
        self.turn = min(max(drift, -WIDEST_TURN), WIDEST_TURN)
        self.path = (*self._kept(), (self.clock_s, along, aside))
        if self.furthest < LEAST_BACK or along < REST_GAP:
            return False
        speed = min(max(self.speed, LEAST_SPEED), MAX_SPEED / self.ball_per_cue)
        self.struck = (speed, self.sway, self.turn)
        self.let_go()
        return True

    def _place(self, event: Pointer) -> tuple[float, float]:
        """Where the hand is from the origin, m: along the aim, and to its left."""
        x, y = event.x - self.origin[0], event.y - self.origin[1]
        cosine, sine = elementary.cos(self.aim), elementary.sin(self.aim)
        reach = float(self.parameters.reach)
        return reach * (cosine * x + sine * y), reach * (cosine * y - sine * x)

    def _kept(self) -> tuple[tuple[float, float, float], ...]:
        """The places from which the speed is told: those of the window, at least the last one before now.

        Of several in one step only the last counts.
        """
        before = [place for place in self.path if place[0] < self.clock_s]
        recent = [place for place in before if place[0] >= self.clock_s - WINDOW_S]
        return tuple((recent or before[-1:])[-MOST_KEPT:])

    @property
    def speed(self) -> float:
        """Speed along the aim at the last place, m/s: the slope of the last places by least squares."""
        count = len(self.path)
        if count < 2:
            return 0.0
        middle_s = sum(place[0] for place in self.path) / count
        middle = sum(place[1] for place in self.path) / count
        spread = sum((place[0] - middle_s) * (place[0] - middle_s) for place in self.path)
        shared = sum((place[0] - middle_s) * (place[1] - middle) for place in self.path)
        return shared / spread if spread > 0.0 else 0.0

    @property
    def words(self) -> str:
        """What stands beside a cue that is held: what to do, or how fast the ball would go, m/s."""
        if self.furthest < LEAST_BACK:
            return "draw back"
        return f"{self.speed * self.ball_per_cue:.1f} m/s" if self.speed > 0.0 else "push through"

    # -- the stroke ---------------------------------------------------------------------------------

    def made(self, meant: Stroke, radius: float) -> Stroke:
        """What the push that has crossed the ball makes of the stroke that is set. radius of the ball, m.

        The whole cue sways about the ball, which changes the azimuth alone; the drift of the hand turns it
        about the bridge.
        """
        assert self.struck is not None
        (speed, sway, turn), self.struck = self.struck, None
        tip_left = meant.tip_left + (BRIDGE + radius) * elementary.sin(turn) / radius
        size = math.sqrt(tip_left * tip_left + meant.tip_up * meant.tip_up)
        most = 0.95 if self.may_slip else max(LARGEST_TIP, abs(meant.tip_up))
        shrink = min(1.0, most / size) if size > 0.0 else 1.0
        return Stroke(
            speed, meant.azimuth + sway + turn, meant.elevation, tip_left * shrink, meant.tip_up * shrink
        )

    @property
    def may_slip(self) -> bool:
        """True if a tip slips that strikes too far out."""
        chosen = self.parameters.miscues
        return bool(chosen == ON or (chosen == AUTO and self.chosen))

    @property
    def friction(self) -> float:
        """Coefficient of tip and ball: as chosen, less with each stroke if the chalk wears off."""
        fresh = float(self.parameters.chalk)
        if not self.parameters.wear:
            return fresh
        bare = min(BARE, fresh)
        return bare + (fresh - bare) * elementary.exp(-self.since_chalk / WORN_AFTER)

    def chalk(self) -> str:
        """Chalk the tip; what to say of it."""
        self.since_chalk = 0
        return f"{CHALKED} It holds up to {slip_limit(self.friction):.2f} R from the middle."

    def miscue_words(self, stroke: Stroke) -> str:
        """What a miscue is called. stroke: as the tip struck."""
        if abs(stroke.tip_left) > abs(stroke.tip_up):
            side = "left" if stroke.tip_left > 0.0 else "right"
        else:
            side = "up" if stroke.tip_up > 0.0 else "down"
        return f"{MISCUE} {side}: it held up to {self.limit:.2f} R."

    def after_the_tip(self, stroke: Stroke) -> Stroke:
        """The stroke by which the ball moves: another one if the tip slips, see `miscue`."""
        friction = self.friction
        self.limit = slip_limit(friction)
        self.since_chalk += bool(self.parameters.wear)
        self.slipped = self.may_slip and slips(stroke.tip_left, stroke.tip_up, friction)
        return Stroke(*miscue(TipStroke(*stroke), friction, self.ball_mass)) if self.slipped else stroke
