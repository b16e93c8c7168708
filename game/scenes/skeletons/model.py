"""A figure that is posed, moved and edited: what both skeleton scenes compute and remember."""

from __future__ import annotations

from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation.skeleton_editing import NOWHERE
from game.physics.effects import EffectSet
from game.scenes.skeletons import bench as skeleton_bench
from game.scenes.skeletons.level import FigureContent
from game.scenes.skeletons.parameters import FigureParameters
from game.scenes.skeletons.rig import Rig, WeightRules
from game.stage.messages import Messages
from game.stage.part import Part
from game.worlds.stopwatch import Stopwatch

UNCHANGED: NDArray[np.uint8] = np.zeros(0, dtype=np.uint8)


class FigureModel(Part):
    """The rig in its present pose, the bench on which its figure is edited, and the time (s).

    content: the figure of the level. active: the effects that are on. watch: how long the parts of a step
    take.
    """

    def __init__(self, parameters: FigureParameters, active: EffectSet, content: FigureContent) -> None:
        self.parameters, self.active = parameters, active
        self.content = content
        self.bench = skeleton_bench.Bench(content)
        self.time = 0.0
        self.watch = Stopwatch()
        self.messages = Messages()
        self._written: tuple[FigureContent, NDArray[np.uint8]] = (content, UNCHANGED)
        self.make_rig(content)
        self.take_pose(self.rig.start)

    def rules(self) -> WeightRules:
        """How skins are bound, as the parameters say."""
        shown = self.parameters
        return WeightRules(shown.threshold, shown.falloff, int(shown.influences), shown.smooth)

    def make_rig(self, figure: FigureContent) -> None:
        """Skeleton and skins of a figure; ValueError if it cannot be."""
        self.rig = Rig(figure, self.rules())
        self.refresh()

    def refresh(self) -> None:
        """What a subclass makes of a new rig."""

    def take_pose(self, pose: Floats) -> None:
        """Let the figure stand so (n + 2,)."""
        self.rig.pose(pose)

    def advance(self, dt: float) -> None:
        """One step."""
        raise NotImplementedError

    def take(self, turn: skeleton_bench.Turn) -> None:
        """Go on with what came of an event."""
        bench, pose = turn
        if bench.figure is not self.bench.figure:
            self.make_rig(bench.figure)
            self.figure_changed()
        self.bench = bench
        if pose is not None:
            self.take_pose(pose)
        if bench.message:
            self.messages.say(bench.message)

    def figure_changed(self) -> None:
        """What a subclass does after an edit."""

    def bind_again(self) -> None:
        """Bind the skins by the present rules, in the same pose."""
        now = self.poses()
        self.make_rig(self.bench.figure)
        self.take_poses(now)

    def change_effects(self, active: EffectSet) -> None:
        """Other effects are on."""
        self.active = active

    def hold_still(self) -> None:
        """The figure no longer moves by itself."""
        self.parameters.motion = False

    def remember(self) -> None:
        """What comes now can be undone up to here."""
        self.bench = skeleton_bench.remembered(self.bench, self.rig.now)

    def stand_as_bound(self) -> None:
        """Take the bind pose, as an edit."""
        self.remember()
        self.take_pose(self.rig.bound)

    def clear_hand(self) -> None:
        """What was being drawn, picked or held is given up."""
        self.bench = msgspec.structs.replace(self.bench, drawn=(), picked=NOWHERE, held="")

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> NamedTuple:
        """The arrays that later steps depend on."""
        raise NotImplementedError

    def restore(self, state: Any) -> None:
        """Take over a state."""
        raise NotImplementedError

    def poses(self) -> Floats:
        """The pose or poses of the state."""
        return self.rig.now

    def take_poses(self, poses: Floats) -> None:
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
