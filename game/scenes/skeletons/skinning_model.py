"""C02: the figure moves by itself, and its skin follows by both blends, measured against each other."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation import BLENDS, JOINT_LIMITS, SKINNING
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise
from game.scenes.skeletons.model import FigureModel
from game.scenes.skeletons.parameters import SkinningParameters

ROUNDING = 1e-13  # of the farthest coordinate: blends that differ by less agree


class SkinningState(NamedTuple):
    """Angles (n,) rad and shift (2,) m in a row, time (1,) s, and the figure if it is not the level's."""

    pose: Floats
    clock: Floats
    figure: NDArray[np.uint8]


class SkinningModel(FigureModel):
    """skin_areas: by blend, area of the skins over that as bound. apart: the blends' largest distance, m."""

    parameters: SkinningParameters

    def refresh(self) -> None:
        self.skin_areas = dict.fromkeys(BLENDS, 1.0)
        self.apart = 0.0

    def state(self) -> SkinningState:
        return SkinningState(self.rig.now, np.array([self.time]), self.document())

    def restore(self, state: SkinningState) -> None:
        self.restore_document(state.figure)
        self.take_pose(state.pose)
        self.time = float(state.clock[0])

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        if SKINNING not in active:
            for blend in BLENDS:
                self.watch.forget(blend)

    def advance(self, dt: float) -> None:
        """One step: the pose at the new time if it moves by itself, then the skin."""
        self.time += dt
        if self.parameters.motion:
            pose = self.rig.swung(self.time)
            if JOINT_LIMITS in self.active:
                np.clip(pose[:-2], self.rig.skeleton.lower, self.rig.skeleton.upper, out=pose[:-2])
            self.take_pose(pose)
        if SKINNING in self.active:
            self._measure()

    def _measure(self) -> None:
        """Move the skin by both blends, the chosen one last."""
        rig, chosen = self.rig, self.parameters.blend
        if rig.skinner is None:
            return
        whole = float(np.abs(rig.areas).sum())
        last = rig.skinned
        for blend in sorted(BLENDS, key=lambda b: b == chosen):
            with self.watch.time(blend):
                rig.move(blend)
            self.skin_areas[blend] = float(np.abs(rig.areas_now()).sum()) / whole if whole > 0.0 else 1.0
            if blend != chosen:
                last = rig.skinned.copy()
        off = rig.skinned - last
        apart = math.sqrt(float((off * off).sum(axis=1).max(initial=0.0)))
        self.apart = apart if apart > ROUNDING * float(np.abs(last).max(initial=0.0)) else 0.0

    def forward_error(self) -> float:
        """How far (m) the last bone's end is from the sum of its ancestors by angles alone, rounded once."""
        skeleton = self.rig.skeleton
        line, bone = [], skeleton.count - 1
        while bone >= 0:
            line.append(bone)
            bone = int(skeleton.parents[bone])
        chain = np.array(line[::-1])
        turned = np.concatenate(([0.0], np.cumsum(skeleton.angles[chain])))
        c, s = elementwise.cos(turned), elementwise.sin(turned)
        x, y = skeleton.offsets[chain].T
        lengths = np.concatenate((np.zeros(1), skeleton.lengths[chain[-1:]]))
        across = (*(c[:-1] * x - s[:-1] * y), *(lengths * c[[0, -1]]))
        upwards = (*(s[:-1] * x + c[:-1] * y), *(lengths * s[[0, -1]]))
        exact = (math.fsum(across), math.fsum(upwards))
        return elementary.dist(skeleton.ends[chain[-1]].tolist(), exact)

    def largest_bend(self) -> float:
        """Of the joint that is bent most, ° from where it was bound."""
        skeleton = self.rig.skeleton
        bends = np.degrees(skeleton.angles - self.rig.rest)[skeleton.parents >= 0]
        return float(np.abs((bends + 180.0) % 360.0 - 180.0).max(initial=0.0))
