"""The hand at the snooker table: the cue is aimed and pulled, instruments are set, colours nominated."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.actions import OPTIONS
from game.scenes.shared.tables.choices import (
    GUIDE_BUTTONS,
    LARGEST_TIP,
    LEAST_POWER,
    STEEPEST_DEG,
    next_player,
)
from game.scenes.shared.tables.course import AIMING, REPLAY, ROLLING
from game.scenes.shared.tables.cue import AIMING as CUE_AIMING
from game.scenes.shared.tables.cue import LEAST_SPEED, MAX_SPEED
from game.scenes.shared.tables.eye.choices import SIDES
from game.scenes.shared.tables.eye.inset import Inset
from game.scenes.shared.tables.grip import NOTHING, Grip, Held
from game.scenes.shared.tables.seats.cup import after_match
from game.scenes.snooker import layout
from game.scenes.snooker.columns import COLUMN
from game.scenes.snooker.course import Course
from game.stage import Part, Pointer

NOTCH = math.radians(0.05)  # rad, that a notch of the wheel turns the cue
FINER = 0.1  # of it while Shift is held
POWER_STEP, TIP_STEP = 0.1, 0.05  # m/s, ball radii, for a key or a notch
CLICK = 0.008  # m; a pointer that moves no farther while it presses has clicked, not pulled


class SnookerHand(Part):
    """What the pointer takes hold of, and what becomes of it; `Course.grip` says what is held."""

    def __init__(self, course: Course) -> None:
        self.course = course
        self.inset = Inset(course.parameters, course.model)
        self.pressed_at = (0.0, 0.0)
        self.moved = 0.0  # m, how far the pointer has gone since it pressed
        self.power_before = 0.0

    def buttons(self) -> list[tuple[str, str, bool]]:
        """Buttons right of the table, from below: action, words, whether it is on."""
        course, game = self.course, self.course.model.game
        if course.phase == REPLAY:
            return [("replay", "Back", True), ("side", SIDES[course.from_side], False)]
        rows = [("undo", "Undo", False), ("replay", "Replay", False),
                ("eye", "Sight", bool(course.parameters.eye)),
                ("view", GUIDE_BUTTONS[course.guide], False),
                ("coach", "Coach", bool(course.parameters.coach))]  # fmt: skip
        if len(game.players) == 2 and not game.over and course.person_plays:
            claims = game.may_claim and not game.options
            sure = course.asked == course.model.word
            rows.append(("concede", "Claim" if claims else "Sure?" if sure else "Concede", claims or sure))
        if game.may_restart and len(game.players) == 2:
            rows.append(("restart", "Stalemate", False))
        if course.learning.lesson is not None:
            rows.append(("lesson", "Next lesson", course.learning.best > 0))
        if game.over:
            if course.may_film:
                rows.append(("film-strokes", "Film", False))
            words = "Again" if game.drill else "New match" if game.match_over else "Next frame"
            rows.append(("rack", after_match(course) or words, True))
        elif course.may_aim:
            rows.append(("strike", "Strike", True))
        return rows

    # -- the pointer --------------------------------------------------------------------------------

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        course = self.course
        if event.kind == "cancel" or (event.kind == "down" and event.button == 3):
            course.cue.let_go()
            course.push.let_go()
            if course.grip == grip.CUE:
                course.parameters.power = self.power_before
            course.grip = NOTHING
        elif event.kind == "down" and event.button == 1 and not course.grip:
            self.pressed_at, self.moved = (event.x, event.y), 0.0
            self._press(event)
        elif event.kind == "up" and event.button == 1:
            self._release(event)
        elif event.kind == "move":
            self._move(event)
        elif event.kind == "wheel":
            self._wheel(event)

    def _press(self, event: Pointer) -> None:
        """Take hold of what lies under the pointer."""
        course, x, y = self.course, event.x, event.y
        if course.plays_itself:
            course.plays_itself = False
            course.messages.say("The cue is yours. Pull back and let go.")
        button = self._button_at(x, y)
        if self.inset.grasps(x, y):
            course.grip = grip.EYE
        elif button:
            course.grip = button
        elif not course.may_aim:
            return
        elif layout.POWER.holds(x, y):
            course.grip = grip.POWER
        elif layout.on_spin(x, y):
            course.grip = grip.TIP
        elif layout.on_elevation(x, y):
            course.grip = grip.ELEVATION
        elif layout.chip_at(x, y) is not None:
            course.nominate(layout.chip_at(x, y) or 0)
        else:
            self._press_table(event)
        if course.grip in (grip.POWER, grip.TIP, grip.ELEVATION):
            course.locked = True
            self._move(event)

    def _press_table(self, event: Pointer) -> None:
        """The cue ball in hand, else the cue."""
        course, place = self.course, self.course.model.frame.cue_ball
        if place is None or not layout.TABLE.holds(event.x, event.y):
            return
        if course.model.game.in_hand and layout.near(place, event.x, event.y):
            course.grip = grip.CUE_BALL
        else:
            course.grip = grip.CUE
            self.power_before = course.parameters.power
            course.cue.pointer(event, *place, ready=True)
            if course.push.chosen:
                course.push.begin(event, course.cue.aim)

    def _button_at(self, x: float, y: float) -> Grip:
        """The button, card or option at a point; NOTHING if there is none."""
        for row, (name, _, _) in enumerate(self.buttons()):
            if layout.button_box(row).holds(x, y):
                return grip.button(name)
        if self.course.parameters.coach and COLUMN.row_at(x, y) == COLUMN.rows - 1:
            return grip.button("ask")
        game = self.course.model.game
        if len(game.players) == 2:
            for player in range(2):
                if layout.card_box(player).holds(x, y):
                    return grip.card(player)
        if self.course.phase == AIMING and self.course.person_plays:
            for row in range(len(game.options)):
                if layout.option_box(row, len(game.options)).holds(x, y):
                    return grip.option(row)
        return NOTHING

    def _move(self, event: Pointer) -> None:
        """What is held follows the pointer; else the cue turns to it."""
        course, kind, parameters = self.course, self.course.grip.kind, self.course.parameters
        self.moved = max(self.moved, elementary.dist((event.x, event.y), self.pressed_at))
        if kind is Held.POWER:
            course.set_power(layout.power_at(event.x, MAX_SPEED))
        elif kind is Held.TIP:
            left, up = layout.spin_at(event.x, event.y, LARGEST_TIP)
            parameters.tip_left, parameters.tip_up = round(left, 3), round(up, 3)
        elif kind is Held.ELEVATION:
            parameters.elevation = min(layout.elevation_at(event.x, event.y), STEEPEST_DEG)
        elif kind is Held.EYE:
            self.inset.drag(event.x, event.y)
        elif kind is Held.CUE_BALL:
            if course.model.game.in_hand and course.phase == AIMING:
                course.model.move_cue_ball(event.x, event.y)
        elif course.may_aim and course.model.frame.cue_ball is not None:
            self._aim(event, course.model.frame.cue_ball)

    def _aim(self, event: Pointer, place: tuple[float, float]) -> None:
        """Turn the cue to the pointer unless it is locked, or draw it back."""
        course = self.course
        if course.grip == grip.CUE and course.push.held:
            if course.push.move(event):
                course.grip = NOTHING
                course.cue.let_go()
                course.strike_by_hand()
        elif course.grip == grip.CUE:
            course.cue.pointer(event, *place, ready=True)
            if course.cue.speed >= LEAST_SPEED and self.moved > CLICK:
                course.parameters.power = min(max(course.cue.speed, LEAST_POWER), MAX_SPEED)
        elif not course.grip and not course.locked and layout.TABLE.holds(event.x, event.y):
            course.cue.pointer(event, *place, ready=True)

    def _release(self, event: Pointer) -> None:
        """Let go: a button acts where it was pressed; a pulled cue strikes; a click nominates or locks."""
        course, held = self.course, self.course.grip
        course.grip = NOTHING
        if held.kind in (Held.BUTTON, Held.CARD, Held.OPTION):
            if self._button_at(event.x, event.y) == held:
                self._press_button(held)
        elif held.kind is Held.CUE and course.model.frame.cue_ball is not None:
            self._let_fly(event, course.model.frame.cue_ball)

    def _let_fly(self, event: Pointer, place: tuple[float, float]) -> None:
        course = self.course
        if course.push.held:
            course.push.let_go()
            course.cue.let_go()
            if self.moved <= CLICK:
                self._click(event)
            return
        course.cue.pointer(event, *place, ready=True)
        strikes = course.cue.phase != CUE_AIMING and self.moved > CLICK
        course.cue.data[1:3] = 0.0, CUE_AIMING
        if strikes:
            course.strike_by_hand()
            return
        course.cue.let_go()
        course.parameters.power = self.power_before
        if self.moved <= CLICK:
            self._click(event)

    def _click(self, event: Pointer) -> None:
        """Nominate a colour where one is asked for, else lock the aim or free it."""
        course = self.course
        if course.model.game.needs_call():
            for number, x, y in course.model.frame.layout.places:
                if number and layout.near((x, y), event.x, event.y) and number > 15:
                    course.nominate(number)
                    return
        course.locked = not course.locked

    def _wheel(self, event: Pointer) -> None:
        """The wheel turns the cue finely; over the power bar, or with Control, it sets the power."""
        course = self.course
        if self.inset.holds(event.x, event.y):
            self.inset.wheel(event.wheel)
            return
        if not course.may_aim:
            return
        if event.control or layout.POWER.holds(event.x, event.y):
            course.set_power(course.parameters.power + POWER_STEP * event.wheel)
        elif not course.grip:
            course.cue.point_to(course.cue.aim - NOTCH * event.wheel * (FINER if event.shift else 1.0))
            course.locked = True

    # -- keys and buttons ---------------------------------------------------------------------------

    def _press_button(self, held: Grip) -> None:
        """A button, a player's card or an option has been pressed and let go."""
        if held.kind is Held.CARD:
            self.course.set_grade(held.number, next_player(self.course.grade_of(held.number)))
        elif held.kind is Held.OPTION:
            self.course.take_option(held.number)
        elif held.name == "film-strokes":
            self.course.films += 1
        else:
            self.act(held.name)

    def act(self, name: str) -> None:
        """A named action."""
        course, parameters = self.course, self.course.parameters
        kind, _, which = name.partition("-")
        if name in OPTIONS and course.person_plays:
            course.take_option(OPTIONS.index(name))
        elif kind == "nominate":
            course.nominate(14 + int(which))
        elif kind == "spin":
            self._nudge_tip(which)
        elif name in ("left", "right") and course.may_aim:
            course.cue.nudge(name)
            course.locked = True
        elif name in ("harder", "softer"):
            course.set_power(parameters.power + (POWER_STEP if name == "harder" else -POWER_STEP))
        elif name == "centre":
            parameters.tip_left = parameters.tip_up = parameters.elevation = 0.0
        else:
            self._command(name)

    def _command(self, name: str) -> None:
        course = self.course
        if name == "strike":
            self._strike_or_skip()
        elif name == "coach":
            course.parameters.coach = not course.parameters.coach
        elif name == "ask":
            course.ask_coach()
        elif name == "breath":
            course.push.breathe()
        elif name == "chalk":
            course.messages.say(course.push.chalk())
        elif name == "thoughts":
            course.parameters.considered = not course.parameters.considered
        elif name == "undo":
            course.undo()
        elif name == "replay":
            course.replay()
        elif name == "side":
            course.replay(from_side=True)
        elif name == "eye":
            parameters = course.parameters
            parameters.eye = not parameters.eye
        elif name == "view":
            course.next_guide()
        elif name == "lesson":
            course.learning.go_on()
        elif name == "rack":
            course.next_one()
        elif name == "lock":
            course.locked = not course.locked
        elif name == "concede" and course.person_plays:
            course.concede()
        elif name == "restart" and course.person_plays:
            course.restart()
        elif name == "demo":
            course.plays_itself = not course.plays_itself
            course.grip = NOTHING
            course.rest_s = 0.0

    def _strike_or_skip(self) -> None:
        """Strike with the power that is set; while balls roll, go to the end; after a frame, the next."""
        course = self.course
        if course.phase in (ROLLING, REPLAY):
            course.skip()
        elif course.phase == AIMING and course.model.game.over:
            course.next_one()
        elif course.may_aim:
            course.strike_by_hand()

    def _nudge_tip(self, which: str) -> None:
        parameters = self.course.parameters
        left = {"left": TIP_STEP, "right": -TIP_STEP}.get(which, 0.0)
        up = {"up": TIP_STEP, "down": -TIP_STEP}.get(which, 0.0)
        parameters.tip_left = min(max(round(parameters.tip_left + left, 3), -LARGEST_TIP), LARGEST_TIP)
        parameters.tip_up = min(max(round(parameters.tip_up + up, 3), -LARGEST_TIP), LARGEST_TIP)
