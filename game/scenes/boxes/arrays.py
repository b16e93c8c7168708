"""The boxes of a broad-phase scene as arrays by id: the state, and how boxes enter and leave it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase import BroadPhase
from game.physics.broadphase.validation import first_bad_box
from game.scenes.boxes.hand import HandOnBoxes
from game.scenes.boxes.level import FARTHEST, HEIGHT, MOST_LISTED, WIDTH, BoxEntry, BoxesContent

Array = NDArray[np.float64]
LOWER, UPPER = np.zeros(2), np.array([WIDTH, HEIGHT])


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


class ArraysOfBoxes(HandOnBoxes):
    """Boxes by id, with rows of zeros where an id is not in use; every structure has the same boxes."""

    may_be_infinite = frozenset(("lowers", "uppers", "swept_lowers", "swept_uppers"))

    def begin_anew(self) -> None:
        """Structures anew for the boxes there are."""
        raise NotImplementedError

    def take_listed(self, boxes: tuple[BoxEntry, ...]) -> None:
        """Begin with the boxes of a level; ValueError if one of them is none, or too far away to be moved."""
        lowers = np.array([box.lower for box in boxes], dtype=np.float64)
        uppers = np.array([box.upper for box in boxes], dtype=np.float64)
        bad = first_bad_box(lowers, uppers)
        if bad >= 0:
            raise ValueError(
                f"boxes[{bad}]: lower {boxes[bad].lower} must not be above upper {boxes[bad].upper}"
            )
        for name, given in (("lower", lowers), ("upper", uppers)):
            far = np.flatnonzero((np.isfinite(given) & (np.abs(given) > FARTHEST)).any(axis=1))
            if len(far):
                corner = tuple(given[far[0]].tolist())
                raise ValueError(
                    f"boxes[{far[0]}]: {name} {corner} must be within {FARTHEST:g} m, or infinite"
                )
        self.take(
            lowers,
            uppers,
            np.array([box.velocity for box in boxes], dtype=np.float64),
            np.array([box.growth for box in boxes], dtype=np.float64),
        )

    def take(self, lowers: Array, uppers: Array, velocities: Array, growth: Array) -> None:
        """Begin with these boxes, ids in their order."""
        self.lowers, self.uppers, self.velocities, self.growth = lowers, uppers, velocities, growth
        self.alive = np.ones(len(lowers), dtype=np.uint8)
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))

    def note_ids(self) -> None:
        """Ids in use, and their number in the parameter."""
        self.ids = np.flatnonzero(self.alive)
        self.values["count"] = max(len(self.ids), 1)  # the parameter's least value

    def typical_size(self) -> float:
        """Median size of the boxes that are not infinite, m; never nothing."""
        sizes = (self.uppers - self.lowers)[self.alive == 1].max(axis=1, initial=0.0)
        sizes = sizes[np.isfinite(sizes) & (sizes > 0.0)]
        if not len(sizes):
            return 0.1
        below, above = (len(sizes) - 1) // 2, len(sizes) // 2
        sizes.partition((below, above))
        # halved before they are added, as the sum may be too large; of the least numbers half is nothing
        return float(max(0.5 * sizes[below] + 0.5 * sizes[above], sizes[below]))

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
        self.begin_anew()
        self.values["count"] = count

    def covered(self) -> tuple[Array, Array]:
        """What broad phases are told: the boxes as they are, or all that they covered in the last step."""
        if len(self.swept_lowers):
            return self.swept_lowers, self.swept_uppers
        return self.lowers, self.uppers

    def forget_sweep(self) -> None:
        """Boxes that are changed by hand are where they are."""
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))

    def update(self, phase: BroadPhase) -> None:
        """Tell a broad phase where the boxes are now."""
        lowers, uppers = self.covered()
        if len(self.ids) == len(self.alive):
            phase.update_boxes(self.ids, lowers, uppers)
        else:
            phase.update_boxes(self.ids, lowers[self.ids], uppers[self.ids])

    def add(self, lowers: Array, uppers: Array, velocities: Array) -> NDArray[np.int64]:
        """Add boxes to the arrays and to every structure; their ids are the smallest free ones."""
        self.forget_sweep()
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
        self.note_ids()
        return ids

    def remove(self, who: NDArray[np.int64]) -> None:
        """Remove boxes from the arrays and from every structure."""
        self.forget_sweep()
        for phase in self.structures():
            phase.remove_boxes(who)
        self.alive[who] = 0
        self.lowers[who] = self.uppers[who] = self.velocities[who] = 0.0
        self.growth[who] = 0.0
        if self.held in who:
            self.held = -1
        if self.chosen in who:
            self.chosen = -1
        self.note_ids()

    def append(self, lowers: Array, uppers: Array, velocities: Array) -> None:
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
