"""The hand at the billiard table: what pointer and wheel do, in each phase of the game.

What it holds is `Play.grip`, since a new phase of the game takes it away.
"""

from __future__ import annotations

from game.billiards.game.rules import CUE_BALL
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.buttons import POWER_STEP, Buttons
from game.scenes.billiards.modes import Replay, SetUp
from game.scenes.billiards.play import AIMING, REPLAY, SET_UP, Play
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.choices import LARGEST_TIP
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.eye.inset import Inset
from game.scenes.shared.tables.grip import NOTHING, Held
from game.stage import Part, Pointer


class BilliardsHand(Part):
    """What the pointer takes hold of, and what becomes of it."""

    def __init__(self, play: Play, replay: Replay, set_up: SetUp, buttons: Buttons) -> None:
        self.play = play
        self.aiming = play.aiming
        self.replay = replay
        self.set_up = set_up
        self.buttons = buttons
        self.side = buttons.side
        self.maker = buttons.maker
        self.inset = Inset(play.parameters, play.model)
        self.spin_from = (0.0, 0.0)  # m; where the tip would be in the middle of the ball

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        if event.kind == "cancel" or (event.kind == "down" and event.button == 3 and self.play.grip):
            self._let_go()
        elif event.kind == "down" and event.button == 3:
            self._begin_spin(event)
        elif event.kind == "down" and event.button == 1 and not self.play.grip:
            self._press(event)
        elif event.kind == "up" and event.button == (3 if self.play.grip == grip.TIP_FREELY else 1):
            self._release(event)
        elif event.kind == "move":
            self._move(event)
        elif event.kind == "wheel":
            self._wheel(event)

    def _let_go(self) -> None:
        """Take back what is held."""
        if self.play.grip == grip.CUE:
            self.aiming.take_back()
            self.play.push.let_go()
        self.play.grip = NOTHING

    def _begin_spin(self, event: Pointer) -> None:
        """With the right button the tip is moved from anywhere on the table, while one watches the line."""
        if self.play.may_aim and layout.TABLE.holds(event.x, event.y):
            chosen = self.play.parameters
            dx, dy = layout.spin_offset(chosen.tip_left, chosen.tip_up)
            self.spin_from = (event.x - dx, event.y - dy)
            self.play.grip = grip.TIP_FREELY
            self.play.hold_aim()

    def _press(self, event: Pointer) -> None:
        """Take hold of what lies under the pointer."""
        play, x, y = self.play, event.x, event.y
        button = self.buttons.at(x, y)
        if self.side.holds(x, y):
            play.grip = grip.LIST
        elif self.inset.grasps(x, y):
            play.grip = grip.EYE
        elif button:
            play.grip = button
            if play.may_aim and button.name in ("strike", "safety", "view", "hint"):
                self.play.keep_aim()
        elif play.phase == REPLAY:
            if layout.SCRUBBER.holds(x, y):
                play.grip = grip.REPLAY
                self._move(event)
        elif play.phase == SET_UP:
            self._press_set_up(x, y)
        elif play.plays_itself:
            play.plays_itself = False
            play.messages.say("The cue is yours. Pull back and let go.")
        elif play.person_plays:
            self._take_instrument(event)

    def _press_set_up(self, x: float, y: float) -> None:
        """A ball; while a drill is made also a pocket, or a zone on the bare cloth."""
        play, maker = self.play, self.maker
        ball = self.set_up.ball_at(x, y)
        maker.moved = False
        if ball >= 0:
            play.grip = grip.ball(ball)
        elif maker.active and not maker.click(x, y) and maker.begin_zone(x, y):
            play.grip = grip.ZONE

    def _take_instrument(self, event: Pointer) -> None:
        """Power bar, spin, elevation; or on the table the cue ball in hand, or the cue."""
        play, x, y = self.play, event.x, event.y
        if layout.POWER.holds(x, y):
            play.grip = grip.POWER
        elif layout.on_spin(x, y):
            play.grip = grip.TIP
        elif layout.on_elevation(x, y):
            play.grip = grip.ELEVATION
        if play.grip:
            self.play.keep_aim()
            self._move(event)
            return
        frame = play.model.frame
        cue_ball = frame.cue_ball
        if play.phase != AIMING or not frame.playable or cue_ball is None:
            return
        if frame.game.in_hand and layout.near(cue_ball, x, y, float(frame.layout.balls.radii[CUE_BALL])):
            play.grip = grip.CUE_BALL
        elif layout.TABLE.holds(x, y):
            play.grip = grip.CUE
            self.aiming.begin_pull(event, cue_ball)
            if play.push.chosen:
                play.push.begin(event, self.aiming.cue.aim)

    def _call_at(self, x: float, y: float) -> bool:
        """Call the pocket or the ball at a point; False if there is none to be called."""
        frame, call = self.play.model.frame, self.aiming.call
        for row, (px, py, radius) in enumerate(frame.table.pockets.tolist()):
            if layout.near((px, py), x, y, radius):
                self.aiming.call = call._replace(pocket=None if call.pocket == row else row, safety=False)
                return True
        for number, bx, by in frame.layout.places:
            if number != CUE_BALL and layout.near((bx, by), x, y, 0.8 * BALL_RADIUS):
                self.aiming.call = call._replace(ball=None if call.ball == number else number, safety=False)
                return True
        return False

    def _release(self, event: Pointer) -> None:
        """Let go: a button acts, the cue strikes."""
        held, self.play.grip = self.play.grip, NOTHING
        if held.kind in (Held.BUTTON, Held.CARD, Held.OPTION):
            if self.buttons.at(event.x, event.y) == held:
                self.buttons.press(held)
        elif held.kind is Held.LIST:
            self.side.click(event)
        elif held.kind is Held.BALL:
            self.set_up.put_down(held.number, event.x, event.y)
            if self.maker.active and not self.maker.moved:
                self.maker.click(event.x, event.y)
        elif held.kind is Held.CUE:
            self._release_cue(event)

    def _release_cue(self, event: Pointer) -> None:
        """Strike with the pull, or take it as a change of mind; a click calls, or locks and frees the aim."""
        frame = self.play.model.frame
        if frame.cue_ball is None or self.play.phase != AIMING:
            self.aiming.cue.let_go()
            return
        if self.play.push.held:
            self.play.push.let_go()
            done = self.aiming.lay_down(event)
        else:
            done = self.aiming.release(event, frame.cue_ball)
        if done == "click":
            if frame.game.needs_call() and self._call_at(event.x, event.y):
                self.play.keep_aim()
            else:
                self.play.toggle_lock()
        elif done == "strike":
            self.play.strike_by_hand()
            self.aiming.keep_pull()

    def _move(self, event: Pointer) -> None:
        """What is held follows the pointer; else the cue turns to it."""
        play, x, y = self.play, event.x, event.y
        kind = play.grip.kind
        if kind is Held.POWER:
            self.aiming.set_power(layout.power_at(x, MAX_SPEED))
        elif kind is Held.TIP:
            self.aiming.set_tip(*layout.spin_at(x, y, LARGEST_TIP))
        elif kind is Held.TIP_FREELY:
            dx, dy = event.x - self.spin_from[0], event.y - self.spin_from[1]
            self.aiming.set_tip(*layout.spin_at(layout.SPIN[0] + dx, layout.SPIN[1] + dy, LARGEST_TIP))
        elif kind is Held.ELEVATION:
            self.aiming.set_elevation(layout.elevation_at(x, y))
        elif kind is Held.EYE:
            self.inset.drag(x, y)
        elif kind is Held.REPLAY:
            self.replay.scrub(layout.share_of_scrubber(y))
        elif kind is Held.CUE_BALL:
            if play.model.frame.game.in_hand and play.phase == AIMING:
                play.model.move_cue_ball(x, y)
        elif kind is Held.ZONE:
            self.maker.draw_zone(x, y)
        elif kind is Held.BALL:
            self.maker.moved = True
            self.set_up.drag(play.grip.number, x, y)
        elif play.may_aim:
            self._aim(event)

    def _aim(self, event: Pointer) -> None:
        """Turn the cue to the pointer, or draw it back."""
        cue_ball = self.play.model.frame.cue_ball
        if cue_ball is None:
            return
        if self.play.grip == grip.CUE and self.play.push.held:
            self.aiming.note(event)
            if self.play.push.move(event):
                self.play.strike_by_hand()
        elif self.play.grip == grip.CUE:
            self.aiming.pull(event, cue_ball)
        elif layout.TABLE.holds(event.x, event.y) and not self._may_call_pocket(event.x, event.y):
            self.aiming.turn_to(event, cue_ball)
        else:
            self.aiming.follows = False

    def _may_call_pocket(self, x: float, y: float) -> bool:
        """True over a pocket that a click would call, where the cue does not follow."""
        frame = self.play.model.frame
        return frame.game.needs_call() and any(
            layout.near((px, py), x, y, radius) for px, py, radius in frame.table.pockets.tolist()
        )

    def _wheel(self, event: Pointer) -> None:
        """The wheel turns the cue finely; over the power bar, or with Control, it sets the power."""
        play = self.play
        if self.inset.holds(event.x, event.y):
            self.inset.wheel(event.wheel)
            return
        if self.side.holds(event.x, event.y):
            self.side.wheel(event)
        elif self.maker.active:
            (self.maker.change_tries if event.control else self.maker.change_needed)(round(event.wheel))
        if play.phase != AIMING or not play.person_plays or self.side.holds(event.x, event.y):
            return
        if event.control or layout.POWER.holds(event.x, event.y):
            self.aiming.set_power(play.parameters.power + POWER_STEP * event.wheel)
        elif not play.grip and play.model.frame.cue_ball is not None:
            self.aiming.turn_finely(event, play.model.frame.cue_ball)
