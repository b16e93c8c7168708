"""What the two scenes of bounding-volume trees share: two outlines, their trees, the query, the hand."""

from __future__ import annotations

from collections.abc import Sequence
from operator import methodcaller
from typing import ClassVar

from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.bounds import view, walk
from game.scenes.bounds.hand import Hand
from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.panes import Panes
from game.scenes.bounds.parameters import TREE_PARAMETERS, BoundsParameters
from game.scenes.bounds.readouts import readouts_of
from game.scenes.bounds.view import BoundsView
from game.scenes.bounds.walk import Walk
from game.scenes.shared.outlines.level import CoastEntry, OutlinesContent
from game.stage import Hint, Readout, SceneAction, WarmUp
from game.worlds.expectations import Caption
from game.worlds.scene import ModelScene, Told


class BoundsScene(ModelScene):
    """Base of C08 and C09."""

    effects = SHAPE_MOTION | COHERENCE | EXACT_ANSWER
    dt = 1.0 / 60.0
    content_type = OutlinesContent
    at_once = True
    told = Told(saved=methodcaller("to_content"))
    second_kind: ClassVar[str] = "aabb"  # of the trees that are counted beside

    parameters_type = BoundsParameters
    parameters: BoundsParameters

    hints = (
        Hint(("Drag",), "move"),
        Hint(("Shift", "Drag"), "turn"),
        Hint(("2",), "draw a line"),
        Hint(("W",), "walk"),
        Hint(("←", "→"), "walk back, on"),
        Hint(("G",), "play the walk"),
        Hint(("B",), "from its start"),
        Hint(("↑", "↓"), "level up, down"),
        Hint(("H",), "hierarchy"),
    )
    actions = (
        SceneAction("move", "move outlines", "1"),
        SceneAction("draw", "draw an outline", "2"),
        SceneAction("points", "move corners", "3"),
        SceneAction("close", "close what is drawn", "c"),
        SceneAction("finish", "end what is drawn, open", "return"),
        SceneAction("delete", "delete", "delete"),
        SceneAction("undo", "undo", "ctrl+z"),
        SceneAction("redo", "do again", "ctrl+y"),
        SceneAction("hierarchy", "hierarchy in grey", "h"),
        SceneAction("level-up", "level up", "up"),
        SceneAction("level-down", "level down", "down"),
        SceneAction("walk", "walk through fit, build, query", "w"),
        SceneAction("walk-on", "walk on", "right"),
        SceneAction("walk-back", "walk back", "left"),
        SceneAction("walk-play", "play the walk, or stop it", "g"),
        SceneAction("walk-start", "walk from the start", "b"),
    )
    default_content: ClassVar[OutlinesContent] = OutlinesContent(
        outlines=(
            CoastEntry(seed=5, segments=120, position=(-2.0, 0.0)),
            CoastEntry(seed=8, segments=128, position=(2.0, 0.0)),
        )
    )

    def make(self, content: OutlinesContent) -> None:
        self.model = BoundsModel(self.parameters, self.active, content, self.second_kind)
        self.said = self.model.messages
        self.walk = Walk(self.model)
        panes = self.make_panes()
        self.hand = Hand(self.model, self.walk, panes)
        self.view = BoundsView(self.model, self.walk, panes)

    def make_panes(self) -> Panes:
        """What gives the parts of the picture."""
        return Panes(self.model)

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.parameters.walked != "off":
            self.walk.play(dt)
        else:
            self.model.drift(dt)
        self.model.ask(self.model.coherent)

    def action(self, name: str) -> None:
        self.hand.act(name)

    def parameter_changed(self, name: str) -> None:
        if name in TREE_PARAMETERS:
            self.model.build_trees()
            self.walk.stay_within()
        elif name in ("walked", "node"):
            self.walk.begin()
        elif name == "playing":
            self.walk.start_if_ended()
        elif name == "tool":
            self.hand.act("cancel")
        elif name == "compare":
            self.model.compare_trees()

    # -- what is shown ------------------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return readouts_of(self.model, self.walk.under_way)

    def captions(self) -> Sequence[Caption]:
        """None in a walk, which has words of its own."""
        return super().captions() if self.parameters.walked == "off" else ()

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("bounding volumes", lambda: walk.warm_up("build")),
            WarmUp("two trees", lambda: walk.warm_up("query")),
            WarmUp("distance", lambda: walk.warm_up("nearest")),
            WarmUp("picture", view.warm_up),
        ]
