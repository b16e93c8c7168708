"""What a level measures of its bodies and joints, each number with a name."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementary
from game.physics.solids import SolidWorld
from game.physics.solids.arrays.layout import BROKEN, JOINT_NAMES, NO_JOINT
from game.physics.solids.arrays.state import DYNAMIC
from game.scenes.solids.level import GaugeEntry
from game.worlds.world import Member

NOTHING = 0  # what a gauge is of whose body is gone: it stays as it is
OF_JOINTS = ("force", "moment")
OF_ALL = ("passed", "fallen", "highest", "broken", "fastest", "gap")
ANGLE, SINCE, PASSES = range(3)  # of a mark: angle (rad) after the last step; s when last passed; how often


class Gauges(Member):
    """values (g,): what they show; marks (g, 3): what those of periods remember; blocks: ids of bodies of
    structures, of which "fallen" counts. ValueError: of nothing.
    """

    kept = ("values", "marks")

    def __init__(
        self,
        world: SolidWorld,
        entries: tuple[GaugeEntry, ...],
        ids: list[int],
        joints: list[int],
        blocks: Sequence[int] = (),
    ):
        self.entries, self.world, self.blocks = entries, world, np.array(blocks, dtype=np.int64)
        self.values: Floats = np.zeros(len(entries))
        self.marks: Floats = np.zeros((len(entries), 3))
        self._of = [_found(entry, entry.of, ids, joints) for entry in entries]
        self._others = [_found(entry, entry.other, ids, joints) for entry in entries]
        self._starts = [_pose(world, of) for of in self._of]
        self._other_starts = [_pose(world, of) for of in self._others]
        self.marks[:, ANGLE] = [angle for _, _, angle in self._starts]
        self.step(0.0)

    def forget(self, body: int) -> None:
        """A body goes: its gauges stay as they are, and it counts no more."""
        self.blocks = self.blocks[self.blocks != body]
        for ids in (self._of, self._others):
            for k, entry in enumerate(self.entries):
                if ids[k] == body and entry.measure not in OF_JOINTS:
                    ids[k] = NOTHING

    def step(self, dt: float) -> None:
        """All of them, as the world is after a step of dt (s)."""
        for k, entry in enumerate(self.entries):
            if entry.until == 0.0 or self.world.time <= entry.until + 0.25 * dt:
                self.values[k] = self._measured(self.world, k, self.world.time, dt)

    def _measured(self, world: SolidWorld, k: int, time: float, dt: float) -> float:
        entry, of, before = self.entries[k], self._of[k], float(self.values[k])
        measure = entry.measure
        if measure == "fallen":
            return _fallen(world, self.blocks, entry.level)
        if measure in OF_ALL:
            return _of_all(world, measure, entry.level, before)
        if measure in OF_JOINTS:
            return _load(world, of, measure == "moment")
        if of == NOTHING or (measure == "between" and self._others[k] == NOTHING):
            return before
        if measure == "period":
            return self._period(k, world, time, dt)
        if measure == "between":
            return self._between(k, world, time)
        x, y, angle = (now - then for now, then in zip(_pose(world, of), self._starts[k], strict=True))
        if measure == "when":
            return time if before == 0.0 and elementary.hypot(x, y) >= entry.level else before
        rows = world.bodies
        return float({
            "right": x, "up": y, "sink": -y, "way": elementary.hypot(x, y), "turn": math.degrees(angle),
            "speed": elementary.length(*rows.velocities[of].tolist()), "spin": float(rows.spins[of]),
        }[measure])  # fmt: skip

    def _between(self, k: int, world: SolidWorld, time: float) -> float:
        """From when the one first had moved so far until the other had."""
        level, mark = self.entries[k].level, self.marks[k]
        if not mark[PASSES] and _way(_pose(world, self._of[k]), self._starts[k]) >= level:
            mark[SINCE], mark[PASSES] = time, 1.0
        if mark[PASSES] == 1.0 and _way(_pose(world, self._others[k]), self._other_starts[k]) >= level:
            mark[PASSES] = 2.0
            return time - float(mark[SINCE])
        return float(self.values[k])

    def _period(self, k: int, world: SolidWorld, time: float, dt: float) -> float:
        """Between the last two times that the angle was passed, each found within its step."""
        angle, mark = float(world.bodies.angles[self._of[k]]), self.marks[k]
        level, before = math.radians(self.entries[k].level), float(mark[ANGLE])
        mark[ANGLE] = angle
        if not before < level <= angle:
            return float(self.values[k])
        now = time - dt * (angle - level) / (angle - before)
        period = now - float(mark[SINCE]) if mark[PASSES] else 0.0
        mark[SINCE], mark[PASSES] = now, mark[PASSES] + 1.0
        return period


def _found(entry: GaugeEntry, number: int, ids: list[int], joints: list[int]) -> int:
    """Id of the body or joint that it is of."""
    if entry.measure in OF_ALL:
        return NOTHING
    things = joints if entry.measure in OF_JOINTS else ids
    if number >= len(things):
        raise ValueError(f"gauges: {entry.name!r} is of {number}; there are {len(things)}")
    return things[number]


def _pose(world: SolidWorld, body: int) -> tuple[float, float, float]:
    rows = world.bodies
    if body >= len(rows.angles):
        return 0.0, 0.0, 0.0
    x, y = rows.positions[body].tolist()
    return x, y, float(rows.angles[body])


def _way(now: tuple[float, float, float], then: tuple[float, float, float]) -> float:
    return elementary.hypot(now[0] - then[0], now[1] - then[1])


def _of_all(world: SolidWorld, measure: str, level: float, before: float) -> float:
    rows, dynamic = world.bodies, world.bodies.flags & DYNAMIC != 0
    places = rows.positions[dynamic]
    if measure == "fastest":
        return max(
            before,
            math.sqrt((rows.velocities[dynamic] * rows.velocities[dynamic]).sum(axis=1).max(initial=0.0)),
        )
    if measure == "gap":
        return max(before, _largest_gap(world))
    if measure == "broken":
        return int(np.count_nonzero((world.joints.kinds != NO_JOINT) & (world.joints.flags & BROKEN != 0)))
    if measure == "passed":
        return int(np.count_nonzero(places[:, 0] > level))
    return float(places[:, 1].max()) if len(places) else 0.0


def _fallen(world: SolidWorld, blocks: NDArray[np.int64], level: float) -> int:
    """How many of these bodies are below a height, m; none that was taken away."""
    rows = world.bodies
    return int(np.count_nonzero((rows.flags[blocks] & DYNAMIC != 0) & (rows.positions[blocks, 1] < level)))


def _largest_gap(world: SolidWorld) -> float:
    """Between the two points of a pin, motor or weld that holds, m."""
    rows = world.joints
    kinds = [JOINT_NAMES.index(name) for name in ("pin", "motor", "weld")]
    holds = np.isin(rows.kinds, kinds) & (rows.flags & BROKEN == 0)
    ends = []
    for end in (0, 1):
        bodies, anchors = rows.bodies[holds, end], rows.anchors[holds, 2 * end : 2 * end + 2]
        c, s = world.bodies.rotations[bodies].T
        x, y = anchors.T
        ends.append(world.bodies.positions[bodies] + np.stack([c * x - s * y, s * x + c * y], axis=1))
    return math.sqrt((elementary.square(ends[0] - ends[1])).sum(axis=1).max(initial=0.0))


def _load(world: SolidWorld, joint: int, moment: bool) -> float:
    """N or N m that a joint carries; 0 for one that is gone or broken."""
    rows = world.joints
    if joint >= len(rows.kinds) or rows.kinds[joint] == NO_JOINT or rows.flags[joint] & BROKEN:
        return 0.0
    return world.joint_load(joint)[1 if moment else 0]
