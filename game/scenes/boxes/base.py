"""What the broad-phase scenes share: boxes that move and bounce, come and go, and are moved by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, ClassVar

import numpy as np

from game.physics.broadphase import BroadPhase
from game.physics.broadphase.effects import BOUNDARY, BOXES, MOTION
from game.physics.broadphase.motion import move_boxes_kernel
from game.scenes.boxes.hand import Hand
from game.scenes.boxes.level import HEIGHT, WIDTH, BoxesContent
from game.scenes.boxes.model.arrays import LOWER, UPPER
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.parameters import MAKING, BoxesParameters
from game.scenes.boxes.view.outside import draw_outside
from game.scenes.boxes.view.world import MOST_LINES, BoxesView
from game.scenes.boxes.warm_up import exercise
from game.stage import Frame, Hint, Parameter, Pointer, SceneAction, SetParameter, StageEvent, WarmUp
from game.ui.painters.boxes import warm_up as warm_up_painter
from game.worlds.expectations import draw_captions
from game.worlds.scene import ModelScene, Told

BATCH = 50  # boxes added or removed by one key
MANY = 10_000  # boxes; to make all structures again takes longer than a frame from here on


class BoxesScene(ModelScene):
    """Base of the broad-phase scenes: a subclass names its parameters, model and view."""

    effects = MOTION | BOUNDARY
    content_type = BoxesContent
    at_once = True
    told = Told(saved=lambda model: model.boxes.to_content())
    default_content: ClassVar[BoxesContent] = BoxesContent()
    takes: ClassVar[frozenset[str]] = frozenset(("right",))
    may_be_infinite = frozenset(("lowers", "uppers", "swept_lowers", "swept_uppers"))
    parameters_type = BoxesParameters
    parameters: BoxesParameters
    model_type: ClassVar[type[BoxesModel]]
    model: BoxesModel
    hand_type: ClassVar[type[Hand]] = Hand
    view_type: ClassVar[type[BoxesView]]

    phases: ClassVar[tuple[tuple[str, Callable[[], BroadPhase]], ...]] = ()  # to compile, by name
    groups: ClassVar[tuple[str, ...]] = ("Boxes", "Pairs", "Shown", "Step", "Disturbance")  # in the panel

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group: a subclass's own groups come first."""
        order = {group: i for i, group in enumerate(cls.groups, start=1)}
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: order.get(item[1].group, 0))
        )

    hints: ClassVar[tuple[Hint, ...]] = (
        Hint(("Point", "Click"), "look into a box"),
        Hint(("Drag",), "move a box, or draw a new one"),
        Hint(("Right click",), "remove"),
        Hint(("↑", "↓"), f"{BATCH} more, fewer"),
    )
    actions: ClassVar[tuple[SceneAction, ...]] = (
        SceneAction("more", f"{BATCH} more boxes", "up"),
        SceneAction("fewer", f"{BATCH} fewer boxes", "down"),
    )

    def make(self, content: BoxesContent) -> None:
        self.model = self.model_type(self.parameters, self.active, self.seed)
        self.said = self.model.messages
        self.model.begin(content)
        self.hand = self.hand_type(self.model)
        self.view = self.view_type(self.model, self.hand)

    # -- a step, and what comes in ------------------------------------------------------------------

    def action(self, name: str) -> None:
        self.model.set_count(len(self.model.boxes) + (BATCH if name == "more" else -BATCH))

    def takes_long(self, event: StageEvent | None) -> bool:
        """Where there are many boxes, or will be, all that makes the structures again; and steps back."""
        after = float(event.value) if isinstance(event, SetParameter) and event.name == "count" else 0.0
        return not isinstance(event, Pointer) and max(len(self.model.boxes), after) > MANY

    # -- what is shown ------------------------------------------------------------------------------

    def why_idle(self, name: str) -> str:
        workload = self.parameters.workload
        if self.model.listed and name in MAKING:
            return "The level lists its boxes: none is made at random."
        if name == "ratio" and workload not in ("heavy-tail", "power-law"):
            return "Boxes of this workload are all alike."
        if name == "share" and workload != "heavy-tail":
            return "Only where there are two sizes is there a share of large ones."
        if name == "lines" and len(self.model.pairs) > MOST_LINES:
            return f"Above {grouped(MOST_LINES)} pairs no lines are drawn."
        return ""

    def standing(self) -> dict[str, float]:
        """listed: 1 if the boxes are those of the level, whatever the parameters say, else 0."""
        return {"listed": float(self.model.listed)}

    def frame(self) -> Frame:
        return self.view.frame()

    def draw_expected(self, canvas: Any) -> None:
        draw_outside(canvas, self.model)
        draw_captions(canvas, (0.5 * WIDTH, HEIGHT), self.captions())

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """The kernels part by part: what a step, a picture and the hand will call."""
        parts = [
            WarmUp("motion of boxes", lambda: cls._warm_motion()),
            WarmUp("picture of boxes", warm_up_painter),
        ]
        parts += [WarmUp(name, partial(exercise, make)) for name, make in cls.phases]
        return [*parts, WarmUp(cls.title, lambda: cls().advance(cls.dt))]

    @staticmethod
    def _warm_motion() -> None:
        corners, flags = np.zeros((1, 2)), np.ones(1, dtype=np.uint8)
        move = move_boxes_kernel(BOXES.mask(MOTION | BOUNDARY))
        move(corners, corners + 1.0, corners, np.zeros(1), flags, LOWER, UPPER, 0.1)
