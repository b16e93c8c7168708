"""The two-ball program of the lecture, with every step of its collision made visible."""

from __future__ import annotations

from typing import Any, ClassVar

from game.billiards.lecture.slips import SLIPS
from game.billiards.lecture.state import BALL_COLLISIONS, FRICTION, MINIMUM_SPEED, WALLS
from game.billiards.table import passing
from game.lab.studies.billiards.lecture_table import one_collision_study
from game.scenes.two_balls import LECTURE_BALLS, view
from game.scenes.two_balls.figure import draw_exchange
from game.scenes.two_balls.hand import TwoBallsHand
from game.scenes.two_balls.level import FRAME_RATE, LectureBallsContent
from game.scenes.two_balls.model import TwoBalls
from game.scenes.two_balls.parameters import LectureBallsParameters
from game.scenes.two_balls.readouts import readouts_of
from game.stage import Equation, Frame, Hint, SceneAction, Strip, WarmUp
from game.ui.painters import ball as ball_painter
from game.worlds.scene import ModelScene, Told


class LectureBalls(ModelScene):
    """Two balls in a window, as the lecture's program has them: pixels, and a velocity added to the position
    in every frame. A ball beyond a wall is put back by its overshoot and turned round. When the circles
    overlap, the program finds the angle of the line of centres, and moves both balls by half of the overlap.
    It turns the velocities into the frame of the collision, changes the parts along the line, and turns them
    back.

    On the right the last collision is held and these steps are shown one by one. Choose "as printed" to
    run the listing as the slides have it: in two places x and y are not swapped, one assignment exchanges
    what should stay, and the loss is taken from the whole velocities. The strip shows the momentum that
    disappears; with the conserving rule, restitution acts on the normal part alone, and momentum is kept to
    rounding.
    """

    name, task, title = LECTURE_BALLS.names
    parameters_type = LectureBallsParameters
    parameters: LectureBallsParameters
    model: TwoBalls
    effects = WALLS | BALL_COLLISIONS | FRICTION | MINIMUM_SPEED
    study = one_collision_study
    dt = 1.0 / FRAME_RATE
    unit = "px"
    y_up = False
    content_type = LectureBallsContent
    told = Told(readouts_of, TwoBalls.content_now)
    default_content: ClassVar[LectureBallsContent] = LectureBallsContent()

    strips = (
        Strip("Momentum", "", ("right", "down")),
        Strip("Energy", "", ("energy",)),
        Strip("Momentum lost", "", ("momentum lost",)),
    )
    hints = (Hint(("Drag",), "move a ball, or its arrow"), Hint(("H",), "go on from a held collision"))
    actions = (
        SceneAction("release", "go on", "H"),
        SceneAction("again", "start again", "R"),
    )
    figure = staticmethod(draw_exchange)
    equations = (
        Equation(
            "Speed and direction",
            r"\abs{\v{v}} = \sqrt{v_x^2 + v_y^2},  \phi = \atan2(v_y, v_x)",
            "of a velocity",
        ),
        Equation("Acceleration", r"\v{v}_{n+1} = \v{v}_n + \v{a}", "a frame is the unit of time"),
        Equation("Deceleration", r"\abs{\v{v}_{n+1}} = \max(\abs{\v{v}_n} - d, 0)", "against the motion"),
        Equation("Line of centres", r"\alpha = \atan2(y_1 - y_2, x_1 - x_2)", "the lecture"),
        Equation(
            "Into its frame",
            r"p_x = v_x \cos\alpha + v_y \sin\alpha,  p_y = v_y \cos\alpha - v_x \sin\alpha",
            "rotation by −α",
        ),
        Equation("Equal masses, no loss", r"p_{1x}' = p_{2x},  p_{2x}' = p_{1x}", "the lecture"),
        Equation(
            "Any masses, restitution e", r"j = \frac{(1+e)(p_{2x} - p_{1x})}{1/m_1 + 1/m_2}", "Newton 1687"
        ),
        Equation(
            "Back again",
            r"v_x = p_x \cos\alpha - p_y \sin\alpha,  v_y = p_y \cos\alpha + p_x \sin\alpha",
            "rotation by α",
        ),
        Equation("Slip 1 of the listing", r"p_y = v_x \cos\alpha - v_y \sin\alpha", "x, y not swapped"),
        Equation("Slip 2", r"p_{1y}' = p_{2y},  p_{2y}' = p_{1y}", "exchanged, should stay"),
        Equation("Slip 3", r"v_y = p_x \cos\alpha + p_y \sin\alpha", "x, y not swapped"),
    )
    try_this = (
        "Give both an acceleration of 0.3 px/frame² at 90°: they fall. Then a deceleration: they rest.",
        "Choose as printed and watch the momentum: " + SLIPS[0].effect,
        "Slip 2: " + SLIPS[1].effect,
        "Slip 3: " + SLIPS[2].effect,
        "Drag an arrow's head to aim one ball past the other: the thinner the hit, the less is exchanged.",
        "Make ball 2 a hundred times heavier: the light ball bounces off, the sum of momenta stays.",
    )

    # -- building and stepping ----------------------------------------------------------------------

    def make(self, content: LectureBallsContent) -> None:
        self.model = TwoBalls(content, self.parameters, self.active, self.seed)
        self.hand = TwoBallsHand(self.model)

    def parameter_changed(self, name: str) -> None:
        if name in ("bounce", "friction", "minimum_speed"):
            self.model.renew_balls()

    def advance(self, dt: float) -> None:
        self.model.advance(dt, self.hand.grasp)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("two balls", lambda: cls().advance(cls.dt)),
            WarmUp("unseen contacts", passing.warm_up),
            *(WarmUp(*row) for row in ball_painter.WARM_UPS),
        ]

    # -- the hand, and what is shown ----------------------------------------------------------------

    def action(self, name: str) -> None:
        if name == "release":
            self.model.release()
        elif name == "again":
            self.model.start_again()

    def frame(self) -> Frame:
        return view.FRAME

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(canvas, self.model, self.hand.grasp, self.previous, alpha)
