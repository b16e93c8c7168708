"""What the V-Clip and GJK scenes share: two convex polygons that are drawn, moved, turned and measured."""

from __future__ import annotations

from collections.abc import Sequence
from operator import methodcaller
from typing import Any, ClassVar

from game.physics.narrowphase import ConvexPolygon
from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.convex.hand import Hand
from game.scenes.convex.level import PairContent, ShapeEntry
from game.scenes.convex.model.pair import PairModel
from game.scenes.convex.parameters import PairParameters
from game.scenes.convex.readouts import PairReadouts
from game.stage import Hint, Readout, SceneAction, Strip, WarmUp
from game.worlds.expectations import Caption, draw_captions
from game.worlds.scene import ModelScene, Told


class ConvexPairScene(ModelScene):
    """Base of C10 and C11. A subclass names its model and draws."""

    effects = SHAPE_MOTION | COHERENCE | EXACT_ANSWER
    dt = 1.0 / 60.0
    content_type = PairContent
    at_once = True
    told = Told(saved=methodcaller("to_content"))
    takes: ClassVar[frozenset[str]] = frozenset()
    parameters_type = PairParameters
    parameters: PairParameters
    model_type: ClassVar[type[PairModel]]
    model: PairModel
    readouts_type: ClassVar[type[PairReadouts]] = PairReadouts

    hints = (
        Hint(("Drag",), "move"),
        Hint(("Shift", "Drag"), "turn"),
        Hint(("←", "→"), "walk through the query"),
        Hint(("H",), "take the hull"),
    )
    actions = (
        SceneAction("earlier", "step of the query before", "left"),
        SceneAction("later", "next step of the query", "right"),
        SceneAction("all", "all steps of the query", "up"),
        SceneAction("start", "begin at the next features", "s"),
        SceneAction("hull", "take the hull", "h"),
        SceneAction("move", "move", "1"),
        SceneAction("draw", "draw", "2"),
        SceneAction("points", "corners", "3"),
        SceneAction("turn-left", "turn left", "q"),
        SceneAction("turn-right", "turn right", "e"),
        SceneAction("close", "close the line", "return"),
        SceneAction("delete", "delete", "delete"),
        SceneAction("undo", "take back", "ctrl+z"),
        SceneAction("redo", "do again", "ctrl+y"),
    )
    strips = (
        Strip("Steps", "per query", ("steps",)),
        Strip("Distance", "m", ("distance",)),
        Strip("Query", "s", ("query",)),
    )
    default_content: ClassVar[PairContent] = PairContent(
        a=ShapeEntry(corners=7, radius=1.4, flat=0.75, position=(-1.8, 0.0), spin=9.0),
        b=ShapeEntry(corners=5, radius=1.2, position=(1.9, 0.1), spin=-24.0),
    )

    def make(self, content: PairContent) -> None:
        self.model = self.model_type(self.parameters, self.active, content)
        self.said = self.model.messages
        self.hand = Hand(self.model)
        self._readouts = self.readouts_type(self.model)

    # -- a step, and what comes in ------------------------------------------------------------------

    def action(self, name: str) -> None:
        self.hand.act(name)

    def parameter_changed(self, name: str) -> None:
        if name == "tool":
            self.hand.act("cancel")
        else:
            self.model.query(fresh=name in ("start_a", "start_b"))

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        return self._readouts.rows()

    def standing(self) -> dict[str, float]:
        return self.model.standing(self.dt)

    def slider_range(self, name: str) -> tuple[float, float] | None:
        """Features that there are: 2 n of a polygon of n corners."""
        if name not in ("start_a", "start_b"):
            return None
        index, outlines = "ab".index(name[-1]), self.model.board.outlines
        if index >= len(outlines):
            return None
        return 0.0, float(max(2 * len(outlines[index].points) - 1, 1))

    def captions(self) -> Sequence[Caption]:
        """None before there are two polygons."""
        return super().captions() if self.model.ready else ()

    def draw_expected(self, canvas: Any) -> None:
        """Above the polygons, whatever else the frame shows."""
        shown = self.shown()
        draw_captions(canvas, (0.5 * (shown.left + shown.right), shown.top), self.captions())

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        corners = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
        return (
            WarmUp("outlines", lambda: ConvexPolygon(corners)),
            WarmUp("query", lambda: cls().advance(cls.dt)),
            WarmUp("many queries", lambda: cls().readouts()),
        )
