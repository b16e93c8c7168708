"""What the broad-phase scenes share: boxes that move and bounce, come and go, and are moved by hand."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.broadphase import BroadPhase
from game.physics.broadphase.effects import BOUNDARY, BOXES, MOTION
from game.physics.broadphase.motion import move_boxes_kernel
from game.physics.broadphase.workloads import MovingBoxes, make_boxes
from game.scenes.boxes.arrays import LOWER, UPPER, ArraysOfBoxes
from game.scenes.boxes.level import HEIGHT, WIDTH, BoxesContent
from game.scenes.boxes.view import MOST_LINES, grouped
from game.scenes.boxes.warm_up import exercise
from game.scenes.shared.stopwatch import Stopwatch
from game.stage import (
    Choice,
    Frame,
    Hint,
    Param,
    Parameter,
    Pointer,
    SceneAction,
    SetParameter,
    StageEvent,
    Toggle,
    WarmUp,
)
from game.ui.painters.boxes import warm_up as warm_up_painter

Array = NDArray[np.float64]
KINDS = ("equal", "heavy-tail", "power-law", "clustered", "line", "lattice")
KIND_LABELS = ("Equal sizes", "Two sizes", "Heavy-tailed sizes", "Clustered", "On one line", "Lattice")
RATIO, SHARE = 20.0, 0.01  # of large boxes, in scenes without parameters for them
MOST_PAIRS = 500_000  # a frame takes a tenth of a second there
MAKING = ("workload", "fill", "ratio", "share")  # parameters by which random boxes are made
BATCH = 50  # boxes added or removed by one key
MANY = 10_000  # boxes; to make all structures anew takes longer than a frame from here on


class BoxesScene(ArraysOfBoxes):
    """Base of the broad-phase scenes: a subclass makes structures, pairs boxes up and draws its own."""

    effects = MOTION | BOUNDARY
    dt = 1.0 / 60.0
    content_type = BoxesContent

    count = Param(
        500, 1, 100_000, whole=True, log=True, group="Boxes", label="Number",
        help="boxes are added or removed while the others go on; their density stays",
    )  # fmt: skip
    workload = Choice(
        "equal",
        KINDS,
        labels=KIND_LABELS,
        group="Boxes",
        rebuild=True,
        help="how boxes are made",
    )
    fill = Param(
        0.1, 0.01, 2.0, log=True, group="Boxes", label="Density", rebuild=True,
        help="area of equal boxes over that of the world; a box overlaps four times as many",
    )  # fmt: skip
    speed = Param(
        0.6, 0.01, 100.0, log=True, unit="m/s", group="Boxes", help="of every box, in any direction"
    )
    leaps = Param(
        0.0,
        0.0,
        1.0,
        group="Disturbance",
        label="Leaps",
        help="share of the boxes that leap anywhere each step",
    )
    turnover = Param(
        0.0,
        0.0,
        1000.0,
        whole=True,
        group="Disturbance",
        label="Replaced",
        help="boxes that go each step, and come",
    )
    step_length = Param(
        1.0 / 60.0, 1.0 / 960.0, 0.25, log=True, unit="s", group="Step", label="Length of a step",
        help="boxes are tested at its end: what meets and parts within is missed",
    )  # fmt: skip
    swept = Toggle(
        False,
        group="Step",
        label="Swept boxes",
        help="test what a box covers during the step: none is missed",
    )
    lines = Toggle(True, group="Shown", label="Pairs", help="a line between the centres of a pair")

    parts: ClassVar[tuple[tuple[str, Callable[[], BroadPhase]], ...]] = ()  # broad phases to compile, by name
    groups: ClassVar[tuple[str, ...]] = (
        "Boxes",
        "Pairs",
        "Shown",
        "Step",
        "Disturbance",
    )  # as the panel has them

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group: a subclass's own groups come first."""
        order = {group: i for i, group in enumerate(cls.groups, start=1)}
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: order.get(item[1].group, 0))
        )

    hints = (
        Hint(("Point", "Click"), "look into a box"),
        Hint(("Drag",), "move a box, or draw a new one"),
        Hint(("Right click",), "remove"),
        Hint(("↑", "↓"), f"{BATCH} more, fewer"),
    )
    actions = (
        SceneAction("more", f"{BATCH} more boxes", "up"),
        SceneAction("fewer", f"{BATCH} fewer boxes", "down"),
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        content = level.content if level is not None and level.content is not None else BoxesContent()
        self.listed = bool(content.boxes)  # the boxes are those of the level: their sizes are not touched
        self.steps = 0
        self.births = 0  # how often random boxes were asked for
        self.begun = self.ended = 0  # pairs in the last step
        self.empty_hand()
        self.look_at_none()
        self.told: deque[str] = deque(maxlen=8)
        self.watch = Stopwatch()
        if self.listed:
            self.take_listed(content.boxes)
        else:
            made = self._random_boxes(int(self.count))
            self.take(made.lowers, made.uppers, made.velocities, np.zeros(len(made.centers)))
        self.speed_before = self.speed
        self.begin_anew()

    def _random_boxes(self, count: int) -> MovingBoxes:
        self.births += 1
        return make_boxes(
            self.workload, count, np.random.default_rng((self.seed, self.births)), (WIDTH, HEIGHT),
            self.fill, self.speed, self.values.get("ratio", RATIO), self.values.get("share", SHARE),
        )  # fmt: skip

    def begin_anew(self) -> None:
        """Structures anew for the boxes there are; pairs are as if they had always been there."""
        self.pairs = np.empty((0, 2), dtype=np.int64)
        self.note_ids()
        self.size = self.typical_size()
        self.make_structures()
        lowers, uppers = self.covered()
        for phase in self.structures():
            phase.limit_pairs(MOST_PAIRS)
            phase.add_boxes(lowers[self.ids], uppers[self.ids], ids=self.ids)
        self.pair_up()
        self.begun = self.ended = 0

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """The kernels part by part: what a step, a picture and the hand will call."""
        parts = [
            WarmUp("motion of boxes", lambda: cls._warm_motion()),
            WarmUp("picture of boxes", warm_up_painter),
        ]
        parts += [WarmUp(name, partial(exercise, make)) for name, make in cls.parts]
        return [*parts, WarmUp(cls.title, lambda: cls().advance(cls.dt))]

    @staticmethod
    def _warm_motion() -> None:
        corners, flags = np.zeros((1, 2)), np.ones(1, dtype=np.uint8)
        move = move_boxes_kernel(BOXES.mask(MOTION | BOUNDARY))
        move(corners, corners + 1.0, corners, np.zeros(1), flags, LOWER, UPPER, 0.1)

    # -- for subclasses -----------------------------------------------------------------------------

    def make_structures(self) -> None:
        """Make the broad phases and pair managers, empty."""
        raise NotImplementedError

    def structures(self) -> tuple[BroadPhase, ...]:
        """The broad phases, all with the same boxes."""
        raise NotImplementedError

    def pair_up(self) -> None:
        """Find the pairs of the boxes as they are: sets ``pairs``, and ``begun`` and ``ended``."""
        raise NotImplementedError

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        self.steps += 1
        if self.swept:
            before = self.lowers.copy(), self.uppers.copy()
        move = move_boxes_kernel(BOXES.mask(self.active) & BOXES.mask(MOTION | BOUNDARY))
        move(self.lowers, self.uppers, self.velocities, self.growth, self.alive, LOWER, UPPER, dt)
        if self.leaps > 0.0:
            self._leap()
        if self.swept:
            self.swept_lowers, self.swept_uppers = (
                np.minimum(before[0], self.lowers), np.maximum(before[1], self.uppers)
            )  # fmt: skip
        if self.turnover > 0:
            self._replace(int(self.turnover))
        self.pair_up()

    def _leap(self) -> None:
        """A share of the boxes is somewhere else at once."""
        random = np.random.default_rng((self.seed, self.steps, 1))
        count = math.ceil(self.leaps * len(self.ids))
        who = self.ids if count == len(self.ids) else random.choice(self.ids, count, replace=False)
        sizes = self.uppers[who] - self.lowers[who]
        places = random.random((count, 2)) * np.maximum(UPPER - sizes, 0.0)
        movable = np.isfinite(sizes).all(axis=1)
        self.lowers[who[movable]] = places[movable]
        self.uppers[who[movable]] = (places + sizes)[movable]

    def _replace(self, count: int) -> None:
        """Some boxes go, and as many come somewhere else: their ids are used again."""
        random = np.random.default_rng((self.seed, self.steps, 2))
        who = random.choice(self.ids, min(count, len(self.ids)), replace=False)
        who = who[who != self.held]
        sizes = np.minimum(self.uppers[who] - self.lowers[who], min(WIDTH, HEIGHT))
        velocities = self.velocities[who]
        self.remove(who)
        lowers = random.random((len(who), 2)) * (UPPER - sizes)
        self.add(lowers, lowers + sizes, velocities)

    # -- boxes come and go --------------------------------------------------------------------------

    def _set_count(self, count: int) -> None:
        """Add random boxes or remove the last ones; the others shrink or grow, so that the density stays."""
        before = len(self.ids)
        if count == before:
            return
        self.forget_sweep()
        if max(count, before) > 1.2 * min(count, before):
            self.watch.clear()  # times of so many other boxes say nothing of these
        if before and not self.listed:
            factor = math.sqrt(before / count)
            centers, halves = (self.lowers + self.uppers) / 2.0, (self.uppers - self.lowers) / 2.0
            self.lowers, self.uppers = centers - factor * halves, centers + factor * halves
        if count > before:
            made = self._random_boxes(count)
            lowers, uppers = made.lowers[before:], made.uppers[before:]
            if self.listed:
                centers = made.centers[before:]
                lowers, uppers = centers - self.size / 2.0, centers + self.size / 2.0
            self.append(lowers, uppers, made.velocities[before:])
        else:
            gone = self.ids[count:]
            self.alive[gone] = 0
            self.lowers[gone] = self.uppers[gone] = self.velocities[gone] = 0.0
            self.growth[gone] = 0.0
            self.held = -1 if self.held in gone else self.held
            self.chosen = -1 if self.chosen in gone else self.chosen
        self.begin_anew()

    def parameter_changed(self, name: str) -> None:
        if name == "count":
            self._set_count(int(self.count))
        elif name == "speed":
            self.velocities *= self.speed / self.speed_before
            self.speed_before = self.speed
        elif name == "swept":
            self.forget_sweep()
            self.pair_up()

    def action(self, name: str) -> None:
        if name in ("more", "fewer"):
            wanted = len(self.ids) + (BATCH if name == "more" else -BATCH)
            self._set_count(min(max(wanted, 1), self.most))

    def why_idle(self, name: str) -> str:
        if self.listed and name in MAKING:
            return "The level lists its boxes: none is made at random."
        if name == "ratio" and self.workload not in ("heavy-tail", "power-law"):
            return "Boxes of this workload are all alike."
        if name == "share" and self.workload != "heavy-tail":
            return "Only where there are two sizes is there a share of large ones."
        if name == "lines" and len(self.pairs) > MOST_LINES:
            return f"Above {grouped(MOST_LINES)} pairs no lines are drawn."
        return ""

    def takes_long(self, event: StageEvent | None) -> bool:
        """Where there are many boxes, or will be, all that makes the structures anew; and steps back."""
        after = float(event.value) if isinstance(event, SetParameter) and event.name == "count" else 0.0
        return not isinstance(event, Pointer) and max(len(self.ids), after) > MANY

    @property
    def most(self) -> int:
        """The greatest number of boxes."""
        parameter = self.parameter("count")
        assert isinstance(parameter, Param)
        return int(parameter.maximum)

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return Frame(-4.5, -0.1, WIDTH + 0.1, HEIGHT + 0.1)

    def standing(self) -> dict[str, float]:
        """listed: 1 if the boxes are those of the level, whatever the parameters say, else 0."""
        return {"listed": float(self.listed)}

    def overlapping(self) -> int:
        """Number of boxes that overlap another."""
        touched = np.zeros(len(self.alive), dtype=bool)
        touched[self.pairs] = True
        return int(np.count_nonzero(touched))

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told
