"""What the broad-phase scenes share: boxes that move and bounce, come and go, and are moved by hand."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.broadphase import BroadPhase, HashedPairs, MatrixPairs
from game.physics.broadphase.boxes import first_bad_box
from game.physics.broadphase.effects import BOUNDARY, MOTION
from game.physics.broadphase.motion import move_boxes_kernel
from game.physics.broadphase.workloads import MovingBoxes, make_boxes
from game.scenes.boxes_level import HEIGHT, MOST_LISTED, WIDTH, BoxEntry, BoxesContent
from game.scenes.stopwatch import Stopwatch
from game.stage import Choice, Frame, Hint, Knob, Param, Pointer, Scene, SceneAction, Toggle, WarmUp
from game.ui.painters.boxes import warm_up as warm_up_painter

Array = NDArray[np.float64]
LOWER, UPPER = np.zeros(2), np.array([WIDTH, HEIGHT])
RATIO, SHARE = 20.0, 0.01  # of the heavy tail, in scenes without knobs for them
BATCH = 50  # boxes added or removed by one key
HAND_BUTTON, REMOVE_BUTTON = 1, 3


class BoxesState(NamedTuple):
    """lowers, uppers, velocities (n, 2) m, m/s; growth (n,) m/s; alive (n,), by id.

    swept_lowers, swept_uppers: (n, 2) m, what the boxes covered in the last step, if that is asked for.
    """

    lowers: Array
    uppers: Array
    velocities: Array
    growth: Array
    alive: NDArray[np.uint8]
    swept_lowers: Array
    swept_uppers: Array


class BoxesScene(Scene):
    """Base of the broad-phase scenes: a subclass makes structures, pairs boxes up and draws its own."""

    effects = MOTION | BOUNDARY
    dt = 1.0 / 60.0
    content_type = BoxesContent
    may_be_infinite = frozenset(("lowers", "uppers", "swept_lowers", "swept_uppers"))
    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    count = Param(
        500, 1, 100_000, whole=True, log=True, group="Boxes", label="Number",
        help="boxes are added or removed while the others go on; their density stays",
    )  # fmt: skip
    workload = Choice(
        "equal",
        ("equal", "heavy-tail", "clustered", "line", "lattice"),
        labels=("Equal sizes", "Heavy-tailed sizes", "Clustered", "On one line", "Lattice"),
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
    def knobs(cls) -> dict[str, Knob[Any]]:
        """Knobs by name, group by group: a subclass's own groups come first."""
        order = {group: i for i, group in enumerate(cls.groups, start=1)}
        return dict(sorted(super().knobs().items(), key=lambda item: order.get(item[1].group, 0)))

    hints = (
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
        self.held = -1  # box in the hand
        self.held_velocity = (0.0, 0.0)
        self.grip = (0.0, 0.0)  # m, from its lower corner to the pointer
        self.anchor: tuple[float, float] | None = None  # where a new box was begun
        self.reach: tuple[float, float] = (0.0, 0.0)  # and where its other corner is
        self.erasing = False
        self.told: deque[str] = deque(maxlen=8)
        self.watch = Stopwatch()
        if self.listed:
            self._take_listed(content.boxes)
        else:
            made = self._random_boxes(int(self.count))
            self._take(made.lowers, made.uppers, made.velocities, np.zeros(len(made.centers)))
        self.speed_before = self.speed
        self._begin_anew()

    def _take_listed(self, boxes: tuple[BoxEntry, ...]) -> None:
        lowers = np.array([box.lower for box in boxes], dtype=np.float64)
        uppers = np.array([box.upper for box in boxes], dtype=np.float64)
        bad = first_bad_box(lowers, uppers)
        if bad >= 0:
            raise ValueError(
                f"boxes[{bad}]: lower {boxes[bad].lower} must not be above upper {boxes[bad].upper}"
            )
        self._take(
            lowers,
            uppers,
            np.array([box.velocity for box in boxes], dtype=np.float64),
            np.array([box.growth for box in boxes], dtype=np.float64),
        )

    def _take(self, lowers: Array, uppers: Array, velocities: Array, growth: Array) -> None:
        self.lowers, self.uppers, self.velocities, self.growth = lowers, uppers, velocities, growth
        self.alive = np.ones(len(lowers), dtype=np.uint8)
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))

    def _random_boxes(self, count: int) -> MovingBoxes:
        self.births += 1
        return make_boxes(
            self.workload, count, np.random.default_rng((self.seed, self.births)), (WIDTH, HEIGHT),
            self.fill, self.speed, self.values.get("ratio", RATIO), self.values.get("share", SHARE),
        )  # fmt: skip

    def _begin_anew(self) -> None:
        """Structures anew for the boxes there are; pairs are as if they had always been there."""
        self.pairs = np.empty((0, 2), dtype=np.int64)
        self._note_ids()
        self.size = self._typical_size()
        self.make_structures()
        lowers, uppers = self.covered()
        for phase in self.structures():
            phase.add_boxes(lowers[self.ids], uppers[self.ids], ids=self.ids)
        self.pair_up()
        self.begun = self.ended = 0

    def _note_ids(self) -> None:
        self.ids = np.flatnonzero(self.alive)
        self.values["count"] = max(len(self.ids), 1)  # the knob's least value

    def _typical_size(self) -> float:
        """Median size of the boxes that are not infinite, m; never nothing."""
        sizes = (self.uppers - self.lowers)[self.alive == 1].max(axis=1, initial=0.0)
        sizes = sizes[np.isfinite(sizes) & (sizes > 0.0)]
        return float(np.median(sizes)) if len(sizes) else 0.1

    def state(self) -> BoxesState:
        return BoxesState(
            self.lowers,
            self.uppers,
            self.velocities,
            self.growth,
            self.alive,
            self.swept_lowers,
            self.swept_uppers,
        )

    def restore(self, state: BoxesState) -> None:
        self.lowers, self.uppers = np.array(state.lowers), np.array(state.uppers)
        self.velocities, self.growth = np.array(state.velocities), np.array(state.growth)
        self.alive = np.array(state.alive)
        self.swept_lowers, self.swept_uppers = np.array(state.swept_lowers), np.array(state.swept_uppers)
        count = self.values["count"]
        self._begin_anew()
        self.values["count"] = count

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
        move = move_boxes_kernel((MOTION | BOUNDARY).mask)
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
        move = move_boxes_kernel(self.active.mask & (MOTION | BOUNDARY).mask)
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

    def covered(self) -> tuple[Array, Array]:
        """What broad phases are told: the boxes as they are, or all that they covered in the last step."""
        if len(self.swept_lowers):
            return self.swept_lowers, self.swept_uppers
        return self.lowers, self.uppers

    def _forget_sweep(self) -> None:
        """Boxes that are changed by hand are where they are."""
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))

    def update(self, phase: BroadPhase) -> None:
        """Tell a broad phase where the boxes are now."""
        lowers, uppers = self.covered()
        if len(self.ids) == len(self.alive):
            phase.update_boxes(self.ids, lowers, uppers)
        else:
            phase.update_boxes(self.ids, lowers[self.ids], uppers[self.ids])

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
        self._remove(who)
        lowers = random.random((len(who), 2)) * (UPPER - sizes)
        self._add(lowers, lowers + sizes, velocities)

    # -- boxes come and go --------------------------------------------------------------------------

    def _add(self, lowers: Array, uppers: Array, velocities: Array) -> NDArray[np.int64]:
        """Add boxes to the arrays and to every structure; their ids are the smallest free ones."""
        self._forget_sweep()
        ids = np.empty(0, dtype=np.int64)
        for phase in self.structures():
            ids = phase.add_boxes(lowers, uppers)
        missing = int(ids.max(initial=-1)) + 1 - len(self.alive)
        if missing > 0:
            for name in ("lowers", "uppers", "velocities", "growth", "alive"):
                array = getattr(self, name)
                more = np.zeros((missing, *array.shape[1:]), dtype=array.dtype)
                setattr(self, name, np.concatenate([array, more]))
        self.lowers[ids], self.uppers[ids], self.velocities[ids] = lowers, uppers, velocities
        self.growth[ids], self.alive[ids] = 0.0, 1
        self._note_ids()
        return ids

    def _remove(self, who: NDArray[np.int64]) -> None:
        """Remove boxes from the arrays and from every structure."""
        self._forget_sweep()
        for phase in self.structures():
            phase.remove_boxes(who)
        self.alive[who] = 0
        self.lowers[who] = self.uppers[who] = self.velocities[who] = 0.0
        self.growth[who] = 0.0
        if self.held in who:
            self.held = -1
        self._note_ids()

    def _set_count(self, count: int) -> None:
        """Add random boxes or remove the last ones; the others shrink or grow, so that the density stays."""
        before = len(self.ids)
        if count == before:
            return
        self._forget_sweep()
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
            self._append(lowers, uppers, made.velocities[before:])
        else:
            gone = self.ids[count:]
            self.alive[gone] = 0
            self.lowers[gone] = self.uppers[gone] = self.velocities[gone] = 0.0
            self.growth[gone] = 0.0
            self.held = -1 if self.held in gone else self.held
        self._begin_anew()

    def _append(self, lowers: Array, uppers: Array, velocities: Array) -> None:
        """Put boxes into the arrays alone, into free rows first."""
        count = len(lowers)
        free = np.flatnonzero(self.alive == 0)[:count]
        missing = count - len(free)
        ids = np.concatenate([free, np.arange(len(self.alive), len(self.alive) + missing)])
        for name in ("lowers", "uppers", "velocities", "growth", "alive"):
            array = getattr(self, name)
            more = np.zeros((missing, *array.shape[1:]), dtype=array.dtype)
            setattr(self, name, np.concatenate([array, more]))
        self.lowers[ids], self.uppers[ids], self.velocities[ids], self.alive[ids] = (
            lowers,
            uppers,
            velocities,
            1,
        )

    def knob_changed(self, name: str) -> None:
        if name == "count":
            self._set_count(int(self.count))
        elif name == "speed":
            self.velocities *= self.speed / self.speed_before
            self.speed_before = self.speed
        elif name == "swept":
            self._forget_sweep()
            self.pair_up()

    # -- the hand -----------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        at = (event.x, event.y)
        if event.kind == "down" and event.button == HAND_BUTTON:
            self._grasp(at)
        elif event.kind == "down" and event.button == REMOVE_BUTTON:
            self.erasing = True
            self._erase(at)
        elif event.kind == "move" and self.erasing:
            self._erase(at)
        elif event.kind == "move" and self.held >= 0:
            self._drag(at)
        elif event.kind == "move" and self.anchor is not None:
            self.reach = at
        elif event.kind == "up":
            if self.anchor is not None:
                self._draw_box(self.anchor, at)
            self._let_go()
        elif event.kind == "cancel":
            self._let_go()

    def action(self, name: str) -> None:
        if name in ("more", "fewer"):
            wanted = len(self.ids) + (BATCH if name == "more" else -BATCH)
            self._set_count(min(max(wanted, 1), self.most))

    @property
    def most(self) -> int:
        """The greatest number of boxes."""
        knob = self.knob("count")
        assert isinstance(knob, Param)
        return int(knob.maximum)

    def box_at(self, at: tuple[float, float]) -> int:
        """The topmost box at a point, -1 if there is none; boxes without end are left alone."""
        found = self.structures()[0].query_point(at)
        found = found[
            np.isfinite(self.lowers[found]).all(axis=1) & np.isfinite(self.uppers[found]).all(axis=1)
        ]
        return int(found[-1]) if len(found) else -1

    def _grasp(self, at: tuple[float, float]) -> None:
        """Take the box at a point, or begin a new one."""
        box = self.box_at(at)
        if box >= 0:
            self.held = box
            self.held_velocity = tuple(self.velocities[box].tolist())
            self.grip = (at[0] - self.lowers[box, 0], at[1] - self.lowers[box, 1])
            self.velocities[box] = 0.0
        elif 0.0 <= at[0] <= WIDTH and 0.0 <= at[1] <= HEIGHT:
            self.anchor = self.reach = at

    def _drag(self, at: tuple[float, float]) -> None:
        self._forget_sweep()
        size = self.uppers[self.held] - self.lowers[self.held]
        lower = np.array([at[0] - self.grip[0], at[1] - self.grip[1]])
        self.lowers[self.held], self.uppers[self.held] = lower, lower + size
        self.pair_up()

    def _let_go(self) -> None:
        if self.held >= 0:
            self.velocities[self.held] = self.held_velocity
        self.held, self.anchor, self.erasing = -1, None, False

    def _erase(self, at: tuple[float, float]) -> None:
        box = self.box_at(at)
        if box >= 0:
            self._remove(np.array([box]))
            self.pair_up()

    def _draw_box(self, anchor: tuple[float, float], at: tuple[float, float]) -> None:
        """A new box between two points; a mere click makes one of the typical size."""
        if len(self.ids) >= self.most:
            self.told.append(f"{self.most} boxes are the most.")
            return
        lower, upper = np.minimum(anchor, at), np.maximum(anchor, at)
        if (upper - lower).max() < 0.25 * self.size:
            lower, upper = lower - self.size / 2.0, upper + self.size / 2.0
        random = np.random.default_rng((self.seed, self.steps, 3, len(self.ids)))
        angle = 2.0 * math.pi * random.random()
        velocity = self.speed * np.array([[math.cos(angle), math.sin(angle)]])
        self._add(lower[None], upper[None], velocity)
        self.pair_up()

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return Frame(-4.5, -0.1, WIDTH + 0.1, HEIGHT + 0.1)

    def overlapping(self) -> int:
        """Number of boxes that overlap another."""
        touched = np.zeros(len(self.alive), dtype=bool)
        touched[self.pairs] = True
        return int(np.count_nonzero(touched))

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told

    def save_content(self) -> BoxesContent | None:
        if len(self.ids) > MOST_LISTED:
            return None
        rows = zip(
            self.lowers[self.ids].tolist(), self.uppers[self.ids].tolist(),
            self.velocities[self.ids].tolist(), self.growth[self.ids].tolist(), strict=True,
        )  # fmt: skip
        return BoxesContent(
            boxes=tuple(
                BoxEntry(lower=tuple(a), upper=tuple(b), velocity=tuple(v), growth=g) for a, b, v, g in rows
            )
        )


def exercise(make: Callable[[], BroadPhase]) -> None:
    """Call all that a broad phase and the pair managers can do on three boxes, so that it is compiled."""
    phase = make()
    corners = np.zeros((3, 2))
    ids = phase.add_boxes(corners, corners + 1.0)
    phase.update_boxes(ids, corners, corners + 2.0)
    phase.query_point((0.5, 0.5))
    phase.update_box(phase.add_box((0.0, 0.0), (1.0, 1.0)), (2.0, 2.0), (3.0, 3.0))
    pairs = phase.pairs()
    phase.remove_box(3)
    phase.remove_boxes(ids[:1])
    for manager in (HashedPairs(), MatrixPairs(4)):
        manager.set_pairs(pairs)
        manager.clear()
        manager.take_events()
