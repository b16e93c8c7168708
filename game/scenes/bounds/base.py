"""What the two scenes of bounding-volume trees share: two outlines, their trees, the query, the hand."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from game.levels import Level
from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.bounds import view, walk
from game.scenes.bounds.hand import Hand
from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.panes import Panes
from game.scenes.bounds.parameters import TREE_PARAMETERS, BoundsParameters
from game.scenes.bounds.readouts import readouts_of
from game.scenes.bounds.state import BoundsState
from game.scenes.bounds.view import BoundsView
from game.scenes.bounds.walk import Walk
from game.scenes.shared.outlines.level import CoastEntry, OutlinesContent
from game.stage import Frame, Hint, Pointer, Readout, Scene, SceneAction, WarmUp
from game.worlds.expectations import captions_of, draw_captions


class BoundsScene(Scene):
    """Base of C08 and C09."""

    effects = SHAPE_MOTION | COHERENCE | EXACT_ANSWER
    dt = 1.0 / 60.0
    content_type = OutlinesContent
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

    def build(self, level: Level | None) -> None:
        content = self.content_of(level)
        self.model = BoundsModel(self.parameters, self.active, content, self.second_kind)
        self.walk = Walk(self.model)
        panes = self.make_panes()
        self.hand = Hand(self.model, self.walk, panes)
        self.view = BoundsView(self.model, self.walk, panes)
        captions_of(content.expected, self.readouts())  # refuses an unknown readout

    def make_panes(self) -> Panes:
        """What gives the parts of the picture."""
        return Panes(self.model)

    def state(self) -> BoundsState:
        return self.model.state()

    def restore(self, state: BoundsState) -> None:
        self.model.restore(state)

    def save_content(self) -> OutlinesContent:
        return self.model.to_content()

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.parameters.walked != "off":
            self.walk.play(dt)
        else:
            self.model.drift(dt)
        self.model.ask(self.model.coherent)

    def pointer(self, event: Pointer) -> None:
        self.hand.take_pointer(event)

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

    def effects_changed(self) -> None:
        self.model.active = self.active
        self.model.ask(coherent=False)

    def messages(self) -> Sequence[str]:
        return self.model.messages.take()

    # -- what is shown ------------------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return readouts_of(self.model, self.walk.under_way)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend()

    def frame(self) -> Frame:
        seen = self.model.content.view
        return Frame(seen.left, seen.bottom, seen.right, seen.top)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)
        content = self.model.content
        if content.expected and self.parameters.walked == "off":
            top = (0.5 * (content.view.left + content.view.right), content.view.top)
            draw_captions(canvas, top, captions_of(content.expected, self.readouts()))

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("bounding volumes", lambda: walk.warm_up("build")),
            WarmUp("two trees", lambda: walk.warm_up("query")),
            WarmUp("distance", lambda: walk.warm_up("nearest")),
            WarmUp("picture", view.warm_up),
        ]
