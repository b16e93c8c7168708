"""The hand in both skeleton scenes: tools, keys and the pointer on the bench."""

from __future__ import annotations

import msgspec

from game.physics.animation import JOINT_LIMITS
from game.scenes.skeletons import bench as skeleton_bench
from game.scenes.skeletons import editing
from game.scenes.skeletons.cells import cell_at, cells_of, frame_of_cells
from game.scenes.skeletons.editing import FARTHEST
from game.scenes.skeletons.model import FigureModel
from game.scenes.skeletons.parameters import SHOWN
from game.scenes.skeletons.reaching_model import ReachingModel
from game.stage import Pointer
from game.stage.part import Part


class FigureHand(Part):
    """Edits the model's figure by the pointer and by named actions."""

    def __init__(self, model: FigureModel) -> None:
        self.model = model

    def take_tool(self) -> None:
        """Begin with another tool: what is made by hand is made standing still, a skin in the bind pose."""
        model, tool = self.model, self.model.parameters.tool
        model.clear_hand()
        if tool in ("bone", "skin", "chain"):
            model.hold_still()
        if tool == "skin":
            model.stand_as_bound()

    def take(self, event: Pointer) -> None:
        """A pointer event in the figure's own coordinates."""
        model = self.model
        before, limited = model.bench.held, JOINT_LIMITS in model.active
        model.take(editing.take_pointer(model.bench, model.rig, event, model.parameters.tool, limited))
        if model.bench.held and not before:
            model.hold_still()

    def take_action(self, name: str) -> None:
        """One of the named actions, a tool among them."""
        model = self.model
        if name in model.parameters.tools:
            model.parameters.tool = name
            self.take_tool()
        elif name in ("undo", "redo"):
            model.hold_still()
            go = skeleton_bench.undo if name == "undo" else skeleton_bench.redo
            model.take(go(model.bench, model.rig))
        elif name == "move":
            model.parameters.motion = not model.parameters.motion
        elif name == "delete":
            model.take(editing.delete(model.bench, model.rig, model.parameters.tool))
        elif name == "finish":
            model.take(editing.finish(model.bench, model.rig))
        elif name == "rebind":
            model.hold_still()
            model.take(editing.rebind(model.bench, model.rig, model.parameters.blend))
        elif name == "stand":
            model.hold_still()
            model.stand_as_bound()


class ReachingHand(FigureHand):
    """The hand of C03, which also pulls the target, in any of the figures side by side. pulling: whether."""

    model: ReachingModel

    def __init__(self, model: ReachingModel) -> None:
        super().__init__(model)
        self.pulling = False

    def take(self, event: Pointer) -> None:
        """A pointer event in the picture: it is for the figure under it, or for that where a drag began."""
        model, shown = self.model, self.model.parameters
        view = model.bench.figure.view
        k = cell_at(event.x, event.y, frame_of_cells(view)) if shown.compare else shown.master
        if event.kind == "down" and event.button == 1 and shown.compare:
            shown.method = SHOWN[k]
            model.stand_as_chosen()
        elif self.pulling or model.bench.held:
            k = shown.master  # a drag stays in the figure where it began
        x, y = cells_of(view, shown.compare)[k].into(event.x, event.y)
        event = msgspec.structs.replace(event, x=x, y=y)
        if event.kind == "down":
            model.note_target()
        if shown.tool == "pull":
            self._pull(event)
        else:
            super().take(event)

    def _pull(self, event: Pointer) -> None:
        model = self.model
        if event.kind == "down" and event.button == 1:
            model.remember()
            model.hold_still()
            self.pulling = True
        elif event.kind in ("up", "cancel"):
            self.pulling = False
        if self.pulling and event.kind in ("down", "move"):
            model.target[:] = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)

    def take_action(self, name: str) -> None:
        if name == "compare-all":
            self.model.parameters.compare = not self.model.parameters.compare
        else:
            self.model.note_target()
            super().take_action(name)
