"""What the two skeleton scenes share: a figure that is made by hand, moves by itself, and is saved."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Any, ClassVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.animation import BLENDS, JOINT_LIMITS, SKINNING, chain_skeleton
from game.scenes.shared.polygons import warm_up_painter
from game.scenes.shared.stopwatch import Stopwatch
from game.scenes.skeletons import bench as skeleton_bench
from game.scenes.skeletons import hand as editor
from game.scenes.skeletons.level import BoneEntry, FigureContent, SkinEntry, View
from game.scenes.skeletons.rig import Rig, WeightRules
from game.scenes.skeletons.skin_painter import SkinPainter
from game.stage import Choice, Frame, Param, Parameter, Pointer, Scene, SceneAction, Toggle, WarmUp

Array = NDArray[np.float64]
UNCHANGED: NDArray[np.uint8] = np.zeros(0, dtype=np.uint8)
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
    SceneAction("undo", "take back", "ctrl+z"),
    SceneAction("redo", "do again", "ctrl+y"),
    SceneAction("stand", "pose of binding", "b"),
    SceneAction("rebind", "bind in this pose", "r"),
    SceneAction("move", "motion", "m"),
)  # what both scenes can do besides their tools


class FigureScene(Scene):
    """Base of C02 and C03. A subclass says what the poses are and what a step makes of them."""

    effects = SKINNING | JOINT_LIMITS
    dt = 1.0 / 60.0
    content_type = FigureContent
    tools: ClassVar[tuple[str, ...]] = ("pose", "bone", "skin")

    tool = Choice(
        "pose", ("pose", "bone", "skin"), labels=("Turn", "New bone", "Skin"), group="Hand",
        help="what the left button does",
    )  # fmt: skip
    motion = Toggle(True, group="Hand", label="Moves by itself", help="until you take a bone")
    blend = Choice(
        "linear", ("linear", "rotor"), labels=("Matrices", "Rotors"), group="Skin",
        help="what is blended between bones: matrices lose area at a bend, rotors bulge",
    )  # fmt: skip
    threshold = Param(
        0.3, 0.005, 5.0, unit="m", log=True, group="Skin", help="bones farther off than this do not count"
    )
    falloff = Param(3.0, 0.5, 16.0, log=True, group="Skin", help="how fast a weight falls with distance")
    influences = Param(4, 1, 8, whole=True, group="Skin", help="the most bones that a point follows")
    smooth = Toggle(True, group="Skin", label="Rounded", help="outlines are rounded between their points")
    bones = Toggle(True, group="Shown", label="Bones")
    skins = Toggle(True, group="Shown", label="Skins")
    weights = Toggle(False, group="Shown", label="Weights", help="as colours: of all bones, or of the chosen")

    default_content: ClassVar[FigureContent] = PLAIN
    groups: ClassVar[tuple[str, ...]] = ("Hand", "Solver", "Skin", "Shown")  # as the panel has them

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group."""
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: cls.groups.index(item[1].group))
        )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.content: FigureContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.bench = skeleton_bench.Bench(self.content)
        self.time = 0.0
        self.told: deque[str] = deque(maxlen=8)
        self.watch = Stopwatch()
        self.painter = SkinPainter()
        self._written: tuple[FigureContent, NDArray[np.uint8]] = (self.content, UNCHANGED)
        self.make_rig(self.content)
        self.begin_pose()

    def rules(self) -> WeightRules:
        """How skins are bound, as the parameters say."""
        return WeightRules(self.threshold, self.falloff, int(self.influences), self.smooth)

    def make_rig(self, figure: FigureContent) -> None:
        """Skeleton and skins of a figure; ValueError if it cannot be."""
        self.rig = Rig(figure, self.rules())
        self.refresh()

    def refresh(self) -> None:
        """What a subclass makes of a new rig."""

    def begin_pose(self) -> None:
        """Stand as at the beginning."""
        self.take_pose(self.rig.start)

    def take_pose(self, pose: Array) -> None:
        """Let the figure stand so (n + 2,)."""
        self.rig.pose(pose)

    def take(self, turn: skeleton_bench.Turn) -> None:
        """Go on with what came of an event."""
        bench, pose = turn
        if bench.figure is not self.bench.figure:
            self.make_rig(bench.figure)
            self.figure_changed()
        self.bench = bench
        if pose is not None:
            self.take_pose(pose)
        if bench.told:
            self.told.append(bench.told)

    def figure_changed(self) -> None:
        """What a subclass does after an edit."""

    def parameter_changed(self, name: str) -> None:
        if name in ("threshold", "falloff", "influences", "smooth"):
            now = self.poses()
            self.make_rig(self.bench.figure)
            self.take_poses(now)
        elif name == "tool":
            self.take_tool()

    def take_tool(self) -> None:
        """Begin with another tool: what is made by hand is made standing still, a skin as it is bound."""
        self.bench = msgspec.structs.replace(self.bench, drawn=(), picked=editor.NOWHERE, held="")
        if self.tool in ("bone", "skin", "chain"):
            self.values["motion"] = False
        if self.tool == "skin":
            self.bench = skeleton_bench.remembered(self.bench, self.rig.now)
            self.take_pose(self.rig.bound)

    # -- remembering --------------------------------------------------------------------------------

    def poses(self) -> Array:
        """The pose or poses of the state."""
        return self.rig.now

    def take_poses(self, poses: Array) -> None:
        """Take over what `poses` gave."""
        self.take_pose(poses)

    def document(self) -> NDArray[np.uint8]:
        """The figure as bytes, or none while it is that of the level."""
        figure = self.bench.figure
        if figure is self.content:
            return UNCHANGED
        if self._written[0] is not figure:
            self._written = (figure, np.frombuffer(msgspec.msgpack.encode(figure), np.uint8).copy())
        return self._written[1]

    def restore_document(self, document: NDArray[np.uint8]) -> None:
        """Take over the figure that `document` gave."""
        figure = self.content
        if len(document):
            figure = msgspec.msgpack.decode(document.tobytes(), type=FigureContent)
        if figure != self.rig.figure or self.rig.rules != self.rules():
            self.make_rig(figure)
        self.bench = msgspec.structs.replace(self.bench, figure=figure)

    def save_content(self) -> FigureContent:
        """The figure in its present pose."""
        pose, rig = self.rig.now, self.rig
        turns = np.degrees(pose[:-2] - rig.rest).tolist()
        bones = tuple(
            msgspec.structs.replace(bone, turn=turn)
            for bone, turn in zip(self.bench.figure.bones, turns, strict=True)
        )
        shift = (float(pose[-2]), float(pose[-1]))
        return msgspec.structs.replace(self.bench.figure, bones=bones, shift=shift)

    # -- events -------------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        before = self.bench.held
        self.take(editor.take_pointer(self.bench, self.rig, event, self.tool, JOINT_LIMITS in self.active))
        if self.bench.held and not before:
            self.values["motion"] = False

    def action(self, name: str) -> None:
        if name in self.tools:
            self.values["tool"] = name
            self.take_tool()
        elif name in ("undo", "redo"):
            self.values["motion"] = False
            go = skeleton_bench.undo if name == "undo" else skeleton_bench.redo
            self.take(go(self.bench, self.rig))
        elif name == "move":
            self.values["motion"] = not self.motion
        elif name == "delete":
            self.take(editor.delete(self.bench, self.rig, self.tool))
        elif name == "finish":
            self.take(editor.finish(self.bench, self.rig))
        elif name == "rebind":
            self.values["motion"] = False
            self.take(editor.rebind(self.bench, self.rig, self.blend))
        elif name == "stand":
            self.values["motion"] = False
            self.bench = skeleton_bench.remembered(self.bench, self.rig.now)
            self.take_pose(self.rig.bound)

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    def frame(self) -> Frame:
        view = self.bench.figure.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def effects_changed(self) -> None:
        if SKINNING not in self.active:
            self.watch.forget("skin")

    @property
    def drawing(self) -> tuple[Any, ...]:
        """Points of the skin being drawn."""
        return self.bench.drawn


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
