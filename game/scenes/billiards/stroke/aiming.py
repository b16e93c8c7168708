"""How the stroke is set that is played next: the cue, the instruments, and what is called."""

from __future__ import annotations

import math

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.physics.kernels import elementary
from game.scenes.billiards.parameters import BilliardsParameters
from game.scenes.billiards.stroke.motion import cue_speed_of, power_in_range, power_of
from game.scenes.shared.tables.choices import LARGEST_TIP, STEEPEST_DEG
from game.scenes.shared.tables.cue import PULLING, CueControl
from game.scenes.shared.tables.cue import STRIKING as LET_GO
from game.stage import Part, Pointer

AT_THE_RACK = 0.5 * math.pi  # azimuth of a cue that points along the table, rad
NOTCH = math.radians(0.05)  # rad, that a notch of the wheel turns the cue
FINER = 0.1  # of it while Shift is held
STICKY = math.radians(2.0)  # the pointer turns so far before an aim that was made finely is given up
CLICK = 0.008  # m; a pointer that moves no farther while it presses has clicked, not pulled
REST_S = 0.4  # s; an aim that stands for so long is meant
TRAVEL_S = 1.5  # s; so long after it the hand is still on its way to an instrument
TIP_STEP = 0.05  # ball radii, for a key

Point = tuple[float, float]


class Aiming(Part):
    """The cue and its instruments. The cue's array belongs to the state.

    announced: what the player has announced by hand; announced_along: the only direction of the cue, rad, for
    which it holds, nan if for any. locked: the cue does not follow the pointer; follows: the
    pointer is where the cue would follow it. rested: the last aim that a hand let stand, or set by key or
    wheel, rad, nan if none; away_s: how long the cue has followed the pointer since. fine_at: direction of
    the pointer at which the aim was made finely, rad. power_before: what was set before the cue was drawn
    back; pulled: power of the stroke that it was drawn back for; m/s.
    """

    def __init__(self, parameters: BilliardsParameters) -> None:
        self.parameters = parameters
        self.cue = CueControl(AT_THE_RACK)
        self.announced = Call()
        self.announced_along = math.nan
        self.locked = False
        self.follows = False
        self.rested = math.nan
        self.still_s = self.away_s = 0.0
        self._aim_before = self.cue.aim
        self.moved = 0.0  # m, how far the pointer has gone since it grasped the cue
        self.fine_at = math.nan
        self.power_before = parameters.power
        self.pulled = math.nan

    @property
    def stroke(self) -> Stroke:
        """The stroke that cue and instruments are set to."""
        chosen = self.parameters
        return Stroke(
            cue_speed_of(chosen.power), self.cue.aim, math.radians(chosen.elevation), chosen.tip_left,
            chosen.tip_up,
        )  # fmt: skip

    @property
    def call(self) -> Call:
        """What is announced for the stroke that is set."""
        along = self.announced_along
        return self.announced if math.isnan(along) or along == self.cue.aim else Call()

    @call.setter
    def call(self, call: Call) -> None:
        self.announced, self.announced_along = call, math.nan

    def call_this(self, call: Call) -> None:
        """Announce a ball and a pocket for the aim that is set, and no other."""
        self.announced, self.announced_along = call, self.cue.aim

    @property
    def pulling(self) -> bool:
        """True while the cue is drawn back."""
        return self.cue.phase == PULLING

    def aim_as(self, stroke: Stroke) -> None:
        """Set cue and instruments to a stroke."""
        self.point_along(stroke.azimuth)
        self.locked = True
        self.set_power(power_of(stroke.cue_speed))
        self.set_tip(stroke.tip_left, stroke.tip_up)
        self.set_elevation(stroke.elevation)

    def point_along(self, azimuth: float) -> None:
        """Let the cue go and point it in a direction, rad; it follows the pointer again."""
        self.cue.let_go()
        self.cue.point_to(azimuth)
        self.locked = self.follows = False
        self.rested = math.nan

    # -- an aim that stands -------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Notice where the aim stands for a while."""
        if not self.follows or self.locked:
            return
        self.still_s = self.still_s + dt if self.cue.aim == self._aim_before else 0.0
        self._aim_before = self.cue.aim
        self.away_s += dt
        if self.still_s >= REST_S:
            self._stand()

    def _stand(self) -> None:
        self.rested, self.away_s = self.cue.aim, 0.0

    def keep(self) -> None:
        """The hand has gone to an instrument or a pocket: lock the aim that stood before it set out."""
        if not self.locked and self.away_s <= TRAVEL_S and not math.isnan(self.rested):
            self.cue.point_to(self.rested)
            self.locked = True

    def hold(self) -> None:
        """Lock the aim as it is."""
        self.locked = True
        self._stand()

    def toggle_lock(self) -> None:
        """Lock the aim, or let the cue follow the pointer again."""
        self.locked = not self.locked
        self._stand()

    # -- instruments --------------------------------------------------------------------------------

    def set_power(self, power: float) -> None:
        """Set the power, m/s, as near as can be."""
        self.parameters.power = power_in_range(power)

    def set_tip(self, left: float, up: float) -> None:
        """Set where the tip strikes, in ball radii."""
        self.parameters.tip_left = min(max(left, -LARGEST_TIP), LARGEST_TIP)
        self.parameters.tip_up = min(max(up, -LARGEST_TIP), LARGEST_TIP)

    def set_elevation(self, elevation: float) -> None:
        """Set how far the butt is raised, rad."""
        self.parameters.elevation = min(max(math.degrees(elevation), 0.0), STEEPEST_DEG)

    def nudge_tip(self, name: str) -> None:
        """Move the tip a little: "spin-left", "spin-right", "spin-up" or "spin-down"."""
        left = {"spin-left": TIP_STEP, "spin-right": -TIP_STEP}.get(name, 0.0)
        up = {"spin-up": TIP_STEP, "spin-down": -TIP_STEP}.get(name, 0.0)
        self.set_tip(round(self.parameters.tip_left + left, 3), round(self.parameters.tip_up + up, 3))

    def centre(self) -> None:
        """Strike the middle of the ball with a level cue."""
        self.parameters.tip_left = self.parameters.tip_up = self.parameters.elevation = 0.0

    # -- the cue ------------------------------------------------------------------------------------

    def turn_to(self, event: Pointer, ball: Point) -> None:
        """Turn the cue to the pointer, unless it is locked; trembling does not spoil a fine aim."""
        self.follows = True
        if self.locked:
            return
        bearing = elementary.atan2(event.y - ball[1], event.x - ball[0])
        if event.shift:
            self.fine_at = bearing
        elif abs(math.remainder(bearing - self.fine_at, 2.0 * math.pi)) < STICKY:
            self.cue.data[5] = bearing
            return
        else:
            self.fine_at = math.nan
        self.cue.pointer(event, *ball, ready=True)

    def turn_finely(self, event: Pointer, ball: Point) -> None:
        """Turn the cue by notches of the wheel."""
        self.cue.point_to(self.cue.aim - NOTCH * event.wheel * (FINER if event.shift else 1.0))
        self.fine_at = elementary.atan2(event.y - ball[1], event.x - ball[0])
        self._stand()

    def nudge(self, name: str) -> None:
        """Turn the cue a little, "left" or "right"."""
        self.cue.nudge(name)
        self.fine_at = float(self.cue.data[5])
        self._stand()

    def begin_pull(self, event: Pointer, ball: Point) -> None:
        """The cue is grasped."""
        self.power_before = self.parameters.power
        self.moved = 0.0
        self.cue.pointer(event, *ball, ready=True)

    def note(self, event: Pointer) -> None:
        """How far the pointer has gone since it grasped the cue."""
        self.moved = max(self.moved, elementary.dist((event.x, event.y), self.cue.data[3:5].tolist()))

    def pull(self, event: Pointer, ball: Point) -> None:
        """The cue is drawn back, which sets the power."""
        self.note(event)
        self.cue.pointer(event, *ball, ready=True)
        self.set_power(self.cue.speed)

    def take_back(self) -> None:
        """Give up a stroke that the cue is drawn back for."""
        self.parameters.power = self.power_before
        self.cue.let_go()

    def release(self, event: Pointer, ball: Point) -> str:
        """Let go of the cue: "strike", "click", or "" if the pull was taken back."""
        self.note(event)
        if self.moved <= CLICK:
            self.take_back()
            return "click"
        self.cue.pointer(event, *ball, ready=True)
        if self.cue.phase != LET_GO:
            self.parameters.power = self.power_before
            return ""
        self.set_power(self.cue.speed)
        self.cue.data[2] = 0.0
        return "strike"

    def lay_down(self, event: Pointer) -> str:
        """Let go of a cue that has not been pushed through: "click", or "" if it was moved."""
        self.note(event)
        self.cue.let_go()
        return "click" if self.moved <= CLICK else ""

    def keep_pull(self) -> None:
        """A stroke has begun with the power that the cue was drawn back for."""
        self.pulled = self.parameters.power

    def forget_pull(self) -> None:
        """The next line is shown for the power that is set, not for how hard this stroke was."""
        if self.parameters.power == self.pulled:
            self.parameters.power = self.power_before
        self.pulled = math.nan
