"""P02: bodies that tumble in a box, their collisions detected on a budget."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.spacetime import budget_study
from game.physics.spacetime.effects import TIMED
from game.scenes.spacetime import SPACETIME
from game.scenes.spacetime.figure import draw_levels
from game.scenes.spacetime.hand import SpaceTimeHand
from game.scenes.spacetime.level import DEFAULT, SpaceTimeContent
from game.scenes.spacetime.model import HALF, SpaceTimeModel
from game.scenes.spacetime.parameters import OF_PICTURE, SpaceTimeParameters
from game.scenes.spacetime.readouts import readouts_of
from game.scenes.spacetime.view import SpaceTimeView
from game.stage import Equation, Frame, Hint, Strip
from game.worlds.expectations import draw_captions
from game.worlds.scene import ModelScene, Told


class SpaceTime(ModelScene):
    """Stars, combs, letters and coast lines tumble in a box. Whether two of them touch is asked only from the
    time on at which they may: place, velocity and a bound of the acceleration say when that is.

    Then their circle trees are compared, level by level, for as many tests as the budget has. What is known
    when it ends is the answer: too small a budget makes bodies bounce off circles that they do not fill.

    In the equations: d and v relative place and velocity, R radii of bodies and circles, s radii of discs
    within the bodies, A bound of the acceleration, ω rates of turning, L distance of the outlines.
    """

    name, task, title = SPACETIME.names
    parameters_type = SpaceTimeParameters
    parameters: SpaceTimeParameters
    model: SpaceTimeModel
    effects = TIMED.known
    content_type = SpaceTimeContent
    at_once = True
    told = Told(readouts_of)
    default_content = DEFAULT
    study = budget_study
    figure = staticmethod(draw_levels)
    hints = (Hint(("Drag",), "pull a body, within the bound"),)
    strips = (
        Strip("Tests per step", "", ("tests",)),
        Strip("Distance of the two", "m", ("distance", "exact distance"), exact=("exact distance",)),
    )
    equations = (
        Equation("May touch from", r"\abs{\v{d} + \v{v} t} = R_1 + R_2 + A t^2", "Hubbard 1993"),
        Equation(
            "Known to be apart",
            r"(\abs{\v{v}} + \omega_1 R_1 + \omega_2 R_2) t + A t^2 = L",
            "the later counts",
        ),
        Equation("At least", r"\abs{\v{c}_1 - \v{c}_2} - R_1 - R_2", "circles about the parts"),
        Equation("At most", r"\abs{\v{w}_1 - \v{w}_2} - s_1 - s_2", "discs within the bodies"),
    )
    try_this = (
        "Lower Tests per step to 60: bodies bounce off circles; at 0 they pass through each other.",
        "Raise the bound: horns widen sooner, and more pairs are due.",
        "Switch Time bounds off and compare the tests per step.",
        "Drag a body as fast as you can: it lags, since the hand obeys the bound as well.",
    )

    def make(self, content: SpaceTimeContent) -> None:
        self.model = SpaceTimeModel(content, self.parameters, self.active, self.seed)
        self.hand = SpaceTimeHand(self.model)
        self.view = SpaceTimeView(self.model)

    def parameter_changed(self, name: str) -> None:
        if name not in OF_PICTURE:
            self.model.change_laws()

    def save_content(self) -> SpaceTimeContent:
        return SpaceTimeContent(bodies=self.model.entries(), expected=self.model.content.expected)

    def advance(self, dt: float) -> None:
        self.model.advance(dt, self.hand.held, (self.hand.x, self.hand.y))

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return (
            ("ring:vermilion", "circles left", ""),
            ("ring:yellow", "where it may be", ""),
            ("disc:amber", "due now", ""),
        )

    def frame(self) -> Frame:
        return Frame(-HALF[0] - 1.95, -HALF[1] - 0.2, HALF[0] + 1.75, HALF[1] + 0.2)

    def draw(self, canvas: Any, alpha: float) -> None:
        held = (self.hand.held, self.hand.x, self.hand.y)
        self.view.draw(canvas, self.previous, alpha, held, self.dt)
        draw_captions(canvas, (0.0, HALF[1] - 0.05), self.captions())
