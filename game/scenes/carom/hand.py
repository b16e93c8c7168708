"""The hand at the carom table: balls are dragged, the cue is aimed and pulled, the map is clicked on."""

from __future__ import annotations

from game.scenes.carom import layout
from game.scenes.carom.advisor import Advisor
from game.scenes.carom.course import Course
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.actions import OPTIONS
from game.scenes.shared.tables.choices import LARGEST_TIP, LEAST_POWER
from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.cue import AIMING as CUE_AIMING
from game.scenes.shared.tables.cue import LEAST_SPEED, MAX_SPEED
from game.scenes.shared.tables.eye.inset import Inset, Places
from game.scenes.shared.tables.grip import NOTHING, Grip, Held
from game.stage import Part, Pointer

LEFT_MATCH = ("What you set up is practice.", "U goes back to the match.")


class CaromInset(Inset):
    """The view from the cue lies over a corner without the ball that is struck."""

    def lying(self) -> tuple[tuple[float, float] | None, Places]:
        frame = self.model.frame
        cue = frame.game.cue
        return frame.places[cue], [place for ball, place in enumerate(frame.places) if ball != cue]


class CaromHand(Part):
    """What the pointer takes hold of, and what becomes of it; `Course.grip` says what is held."""

    def __init__(self, course: Course, advisor: Advisor) -> None:
        self.course = course
        self.advisor = advisor
        self.inset = CaromInset(course.parameters, course.model)
        self.moved = False  # a ball has been moved since it was grasped

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        if event.kind == "cancel" or (event.kind == "down" and event.button == 3):
            self.course.cue.let_go()
            self.course.push.let_go()
            self.course.grip = NOTHING
        elif event.kind == "down" and event.button == 1 and not self.course.grip:
            self._press(event)
        elif event.kind == "up" and event.button == 1:
            self._release(event)
        elif event.kind == "move":
            self._move(event)
        elif event.kind == "wheel" and self.inset.holds(event.x, event.y):
            self.inset.wheel(event.wheel)

    def _press(self, event: Pointer) -> None:
        """Take hold of what lies under the pointer."""
        course, x, y = self.course, event.x, event.y
        if course.plays_itself:
            course.plays_itself = False
            course.messages.say("The table is yours.")
        button = next((k for k in range(len(layout.BUTTONS)) if layout.button_box(k).holds(x, y)), -1)
        if button >= 0:
            course.grip = Grip(Held.BUTTON, layout.BUTTONS[button], button)
        elif self.inset.grasps(x, y):
            course.grip = grip.EYE
        elif layout.LIST.holds(x, y):
            course.grip = grip.LIST
        elif course.phase != AIMING:
            return
        elif course.model.frame.game.options and course.person_plays:
            course.grip = Grip(Held.OPTION)
        elif layout.on_tip(x, y):
            course.grip = grip.TIP
            self._move(event)
        else:
            self._press_table(event)

    def _press_table(self, event: Pointer) -> None:
        """A ball, else the cue."""
        course, x, y = self.course, event.x, event.y
        places = course.model.frame.places
        ball = next((k for k in range(3) if layout.near(places[k], x, y)), -1)
        movable = course.person_plays and course.learning.lesson is None
        if ball >= 0 and movable and not course.model.frame.game.ended:
            course.grip = grip.ball(ball)
            self.moved = False
        elif course.may_aim and layout.TABLE.holds(x, y):
            course.grip = grip.CUE
            course.cue.pointer(event, *course.cue_ball, ready=True)
            if course.push.chosen:
                course.push.begin(event, course.cue.aim)

    def _move(self, event: Pointer) -> None:
        """What is held follows the pointer; else the cue turns to it."""
        course, held = self.course, self.course.grip
        if held.kind is Held.BALL:
            self._drag(held.number, event)
        elif held.kind is Held.EYE:
            self.inset.drag(event.x, event.y)
        elif held.kind is Held.TIP:
            left, up = layout.tip_at(event.x, event.y, LARGEST_TIP)
            course.parameters.tip_left, course.parameters.tip_up = round(left, 3), round(up, 3)
        elif held.kind is Held.CUE and course.push.held:
            if course.push.move(event):
                course.grip = NOTHING
                course.cue.let_go()
                course.strike_by_hand()
        elif held.kind is Held.CUE:
            course.cue.pointer(event, *course.cue_ball, ready=True)
            if course.cue.speed >= LEAST_SPEED:
                course.parameters.power = min(max(course.cue.speed, LEAST_POWER), MAX_SPEED)
        elif not held and course.may_aim and course.chosen is None and layout.TABLE.holds(event.x, event.y):
            course.cue.pointer(event, *course.cue_ball, ready=True)

    def _drag(self, ball: int, event: Pointer) -> None:
        """Move a ball; the first time that it moves, a match becomes practice."""
        course = self.course
        if not self.moved:
            x, y = course.model.frame.places[ball]
            if abs(event.x - x) + abs(event.y - y) < 0.2 * 0.03:
                return
            self.moved = True
            if course.model.begin_moving():
                for words in LEFT_MATCH:
                    course.messages.say(words)
            course.chosen = None
        course.model.move_ball(ball, event.x, event.y)
        course.rest_s = 0.0

    def _release(self, event: Pointer) -> None:
        """Let go: a button, a row or an option is taken where it was pressed; a pulled cue strikes."""
        course, held = self.course, self.course.grip
        course.grip = NOTHING
        if held.kind is Held.BUTTON:
            if layout.button_box(held.number).holds(event.x, event.y):
                self.press_button(held.name)
        elif held.kind is Held.LIST:
            if not course.parameters.coach:
                self.advisor.click(layout.row_at(event.x, event.y))
            elif layout.COLUMN.row_at(event.x, event.y) == layout.COLUMN.rows - 1:
                course.ask_coach()
        elif held.kind is Held.OPTION:
            count = len(course.model.frame.game.options)
            for row in range(count):
                if layout.option_box(row, count).holds(event.x, event.y):
                    course.take_option(row)
        elif held.kind is Held.CUE:
            self._let_fly(event)

    def _let_fly(self, event: Pointer) -> None:
        """The pulled cue strikes; a mere click frees the aim from the chosen stroke."""
        course = self.course
        if course.push.held:
            course.push.let_go()
            course.cue.let_go()
            return
        course.cue.pointer(event, *course.cue_ball, ready=True)
        strikes = course.cue.phase != CUE_AIMING
        course.cue.data[1:3] = 0.0, CUE_AIMING
        if strikes:
            course.strike_by_hand()
        else:
            course.cue.let_go()
            course.chosen = None

    def press_button(self, name: str) -> None:
        """One of the buttons, which are actions as well."""
        course = self.course
        if name == "strike":
            if course.may_aim:
                course.strike_by_hand()
            else:
                course.skip()
        elif name == "play":
            if course.may_aim and course.chosen is not None:
                course.begin_stroke(course.chosen)
        elif name == "undo":
            course.undo()
        elif name == "next":
            course.next_one()
        elif name == "film-strokes":
            if course.may_film:
                course.films += 1
        else:
            self._show(name)

    def _show(self, name: str) -> None:
        """What is shown beside the play, or put away."""
        course, parameters = self.course, self.course.parameters
        if name in ("replay", "side"):
            course.replay(from_side=name == "side")
        elif name in ("map", "explain", "ends", "eye", "coach"):
            setattr(parameters, name, not getattr(parameters, name))

    def act(self, name: str) -> None:
        """A key's action."""
        course, parameters = self.course, self.course.parameters
        if name in layout.BUTTONS:
            self.press_button(name)
        elif name == "safety" and course.may_aim:
            course.strike_by_hand(safety=True)
        elif name in ("side", "map", "explain", "ends"):
            self._show(name)
        elif name == "lesson":
            course.learning.go_on()
        elif name == "thoughts":
            parameters.considered = not parameters.considered
        elif name == "ask":
            course.ask_coach()
        elif name == "breath":
            course.push.breathe()
        elif name == "chalk":
            course.messages.say(course.push.chalk())
        elif name == "demo":
            course.plays_itself = not course.plays_itself
        elif name == "centre":
            parameters.tip_left = parameters.tip_up = parameters.elevation = 0.0
        elif name in ("left", "right") and course.may_aim:
            course.cue.nudge(name)
        elif name in OPTIONS and course.person_plays:
            course.take_option(OPTIONS.index(name))
