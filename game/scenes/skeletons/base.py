"""What the two skeleton scenes share: a figure that is made by hand, moves by itself, and is saved."""

from __future__ import annotations

from collections.abc import Sequence
from operator import methodcaller
from typing import Any, ClassVar

from game.physics.animation import BLENDS, JOINT_LIMITS, SKINNING, chain_skeleton
from game.scenes.skeletons.guide import steps_of
from game.scenes.skeletons.hand import FigureHand
from game.scenes.skeletons.level import BoneEntry, FigureContent, SkinEntry, View
from game.scenes.skeletons.model import FigureModel
from game.scenes.skeletons.parameters import BINDING, FigureParameters
from game.scenes.skeletons.rig import Rig, WeightRules
from game.stage import Frame, Hint, Parameter, SceneAction, WarmUp
from game.worlds.expectations import Caption, with_headroom
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import ModelScene, Told

PLAIN = FigureContent(
    bones=(
        BoneEntry(name="first", length=0.8, angle=60.0),
        BoneEntry(name="second", parent="first", length=0.6, angle=-50.0),
        BoneEntry(name="third", parent="second", length=0.4, angle=40.0),
    ),
    skins=(SkinEntry(points=((-0.1, 0.0), (0.1, 0.0), (1.4, 1.0), (0.4, 1.0))),),
    view=View(left=-1.2, bottom=-0.3, right=2.0, top=1.8),
)


EDITING = (
    SceneAction("finish", "close the skin", "return"),
    SceneAction("delete", "delete", "delete"),
    SceneAction("undo", "undo", "ctrl+z"),
    SceneAction("redo", "redo", "ctrl+y"),
    SceneAction("stand", "bind pose", "b"),
    SceneAction("rebind", "bind in this pose", "r"),
    SceneAction("move", "motion", "m"),
)  # what both scenes can do besides their tools


MAKING = {
    "bone": (
        Hint(("Click",), "parent bone, then the new end"),
        Hint(("Shift", "Click"), "where on the parent it begins"),
        Hint(("Delete",), "delete the chosen bone"),
    ),
    "skin": (
        Hint(("Click",), "corners around the bones"),
        Hint(("Enter",), "close the skin"),
        Hint(("Delete",), "delete the last corner"),
    ),
    "chain": (Hint(("Click",), "first and last bone of the chain"),),
    "pose": (Hint(("Drag",), "turn a bone"),),
}  # hints by the tool in the hand, where they are not those of the scene


class FigureScene(ModelScene):
    """Base of C02 and C03. A subclass says what the poses are and what a step makes of them."""

    effects = SKINNING | JOINT_LIMITS
    dt = 1.0 / 60.0
    content_type = FigureContent
    told = Told(saved=methodcaller("save_content"))

    parameters: FigureParameters
    model: FigureModel
    hand: FigureHand
    default_content: ClassVar[FigureContent] = PLAIN
    groups: ClassVar[tuple[str, ...]] = ("Hand", "Solver", "Skin", "Shown")  # as the panel has them

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group."""
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: cls.groups.index(item[1].group))
        )

    def parameter_changed(self, name: str) -> None:
        if name in BINDING:
            self.model.bind_again()
        elif name == "tool":
            self.hand.take_tool()

    def action(self, name: str) -> None:
        self.hand.take_action(name)

    def hints_now(self) -> Sequence[Hint]:
        tool = self.parameters.tool
        if tool == type(self.parameters).tool.default:
            return self.hints
        return (*MAKING[tool], *self.hints[1:])

    def frame(self) -> Frame:
        view = self.model.bench.figure.view
        return self.with_captions(Frame(view.left, view.bottom, view.right, view.top))

    def with_captions(self, frame: Frame) -> Frame:
        """A frame with space for what is expected."""
        return with_headroom(frame, len(self.model.content.expected) + len(self.guide()))

    def captions(self) -> Sequence[Caption]:
        return [*super().captions(), *self.guide()]

    def guide(self) -> list[Caption]:
        """The steps of making a figure, and which of them are done; none but in a level made for it."""
        model = self.model
        return steps_of(model.bench.figure, model.rig.now - model.rig.bound) if model.content.guide else []


def warm_ups_of_figures() -> tuple[WarmUp, ...]:
    """The kernels that both scenes need, part by part."""

    def follow() -> None:
        rig = Rig(PLAIN, WeightRules())
        for blend in BLENDS:
            rig.move(blend)
        rig.areas_now()

    return (
        WarmUp("bones", lambda: chain_skeleton([1.0]).update()),
        WarmUp("skin", follow),
        WarmUp("picture of skins", warm_up_painter),
    )
