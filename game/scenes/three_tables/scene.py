"""One stroke on three tables: the lecture's, a stepped one with all of the physics, and the exact one."""

from __future__ import annotations

from typing import Any

from game.billiards.shot_effects import EXACT_EFFECTS
from game.lab.studies.billiards.tables import billiards_study
from game.scenes.shared.tables import view as table_view
from game.scenes.three_tables import THREE_TABLES, view
from game.scenes.three_tables.figure import draw_chaos
from game.scenes.three_tables.hand import ThreeTablesHand
from game.scenes.three_tables.level import ThreeTablesContent
from game.scenes.three_tables.model import ThreeTablesModel
from game.scenes.three_tables.parameters import ThreeTablesParameters
from game.scenes.three_tables.readouts import APART, readouts_of
from game.scenes.three_tables.state import ThreeTablesState
from game.stage import Equation, Frame, Hint, Scene, SceneAction, Strip, WarmUp
from game.worlds.scene import ModelScene, Told


class ThreeTables(ModelScene):
    """The same stroke on three tables. The first is the lecture's: a velocity added to the position in every
    step, no spin. The second steps too, but with all of the physics: balls slide, roll and spin, throw each
    other, and rebound as Han's cushion has it. The third does not step at all. It computes the times of the
    next events, and between them every ball follows a formula, so that its picture is exact at any moment.

    The chart shows how far the balls are from those of the exact table. A small error at one contact is a
    larger one at the next: choose a perturbation of a picometre, and two exact tables differ by a metre
    after a hundred contacts. No table can be predicted for longer, however small its step.
    """

    name, task, title = THREE_TABLES.names
    parameters_type = ThreeTablesParameters
    parameters: ThreeTablesParameters
    effects = EXACT_EFFECTS
    quarter_turns = 1
    takes = frozenset(("right",))
    content_type = ThreeTablesContent
    default_content = ThreeTablesContent(plays_itself=True)
    told = Told(readouts_of)
    study = billiards_study

    strips = (
        Strip("Off the exact table", "m", APART, sometimes=("perturbed",)),
        Strip("Energy, exact", "J", ("energy",)),
        Strip("Events", "", ("events",)),
    )
    hints = (Hint(("Move",), "aim"), Hint(("Drag",), "pull back"), Hint(("Esc",), "take back"))
    actions = (
        SceneAction("rack", "new rack", "R"),
        SceneAction("demo", "plays itself", "D"),
        SceneAction("left", "turn the cue left", "left"),
        SceneAction("right", "turn the cue right", "right"),
    )
    figure = staticmethod(draw_chaos)
    equations = (
        Equation(
            "Sliding", r"\v{r} = \v{r}_0 + \v{v}_0 t - \frac{1}{2} \mu g t^2 \v{u}", "Leckie, Greenspan 2006"
        ),
        Equation("Next contact of two balls", r"|\v{r}_2(t) - \v{r}_1(t)|^2 = 4 R^2", "a quartic in t"),
        Equation("Cue and ball", r"v = \frac{2 V}{1 + m/M + \frac{5}{2} (a^2 + b^2)}", "Alciatore, TP A-30"),
    )
    try_this = (
        "Draw the tip down and play a straight shot: the lecture's ball stops, the other two come back.",
        "Set the stepped table's step to 0.05 s and break: balls pass through each other.",
        "Choose a perturbation of 1 pm and break: watch the curve climb to a metre.",
    )

    # -- building and stepping ----------------------------------------------------------------------

    def make(self, content: ThreeTablesContent) -> None:
        self.model = ThreeTablesModel(content, self.parameters, self.active)
        self.hand = ThreeTablesHand(self.model, content.plays_itself, self.seed)
        self.said = self.hand.messages

    def parameter_changed(self, name: str) -> None:
        self.model.play()

    def effects_changed(self) -> None:
        self.model.effects = self.active
        self.model.play()

    def advance(self, dt: float) -> None:
        self.hand.advance(dt)
        self.model.advance(dt)
        if not self.model.playing:
            self.hand.play_by_itself()

    def state(self) -> ThreeTablesState:
        return self.model.state(self.hand.cue.data)

    def restore(self, state: ThreeTablesState) -> None:
        Scene.restore(self, state)
        self.model.play()

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [WarmUp("three tables", cls), *table_view.warm_ups()]

    # -- the hand, and what is shown ----------------------------------------------------------------

    def action(self, name: str) -> None:
        if name == "rack":
            plays = self.hand.plays_itself
            self.build(self.level)
            self.hand.plays_itself = plays
        else:
            self.hand.take_action(name)

    def frame(self) -> Frame:
        return view.FRAME

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(canvas, self.model, self.hand, self.previous, alpha)
