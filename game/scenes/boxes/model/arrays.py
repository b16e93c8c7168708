"""The boxes of a broad-phase scene as arrays by id: the state, and how rows are filled and emptied."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.broadphase.validation import first_bad_box
from game.scenes.boxes import level
from game.scenes.boxes.level import BoxEntry, BoxesContent

LOWER, UPPER = np.zeros(2), np.array([level.WIDTH, level.HEIGHT])


class BoxesState(NamedTuple):
    """lowers, uppers, velocities (n, 2) m, m/s; growth (n,) m/s; alive (n,), by id.

    swept_lowers, swept_uppers: (n, 2) m, what the boxes covered in the last step, if that is asked for.
    """

    lowers: Floats
    uppers: Floats
    velocities: Floats
    growth: Floats
    alive: NDArray[np.uint8]
    swept_lowers: Floats
    swept_uppers: Floats


class BoxArrays:
    """Boxes by id, with rows of zeros where an id is not in use.

    lowers, uppers, velocities (n, 2) m, m/s; growth (n,) m/s; alive (n,); ids: those in use.
    """

    def __init__(self, lowers: Floats, uppers: Floats, velocities: Floats, growth: Floats):
        self.lowers, self.uppers, self.velocities, self.growth = lowers, uppers, velocities, growth
        self.alive = np.ones(len(lowers), dtype=np.uint8)
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))
        self.note_ids()

    def note_ids(self) -> None:
        """Look up which ids are in use."""
        self.ids = np.flatnonzero(self.alive)

    def __len__(self) -> int:
        """How many boxes there are."""
        return len(self.ids)

    # -- what they are ------------------------------------------------------------------------------

    def typical_size(self) -> float:
        """Median size of the boxes that are not infinite, m; never zero."""
        sizes = (self.uppers - self.lowers)[self.alive == 1].max(axis=1, initial=0.0)
        sizes = sizes[np.isfinite(sizes) & (sizes > 0.0)]
        if not len(sizes):
            return 0.1
        below, above = (len(sizes) - 1) // 2, len(sizes) // 2
        sizes.partition((below, above))
        # halved before they are added, as the sum may be too large; of the least numbers half is zero
        return float(max(0.5 * sizes[below] + 0.5 * sizes[above], sizes[below]))

    def is_finite(self, ids: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Which of some boxes end on all sides."""
        ends = np.concatenate([self.lowers[ids], self.uppers[ids]], axis=1)
        finite: NDArray[np.bool_] = np.all(np.isfinite(ends), axis=1)
        return finite

    def covered(self) -> tuple[Floats, Floats]:
        """What broad phases work on: the boxes as they are, or all that they covered in the last step."""
        if len(self.swept_lowers):
            return self.swept_lowers, self.swept_uppers
        return self.lowers, self.uppers

    def sweep(self, lowers: Floats, uppers: Floats) -> None:
        """Note what the boxes have covered since they had these corners."""
        self.swept_lowers = np.minimum(lowers, self.lowers)
        self.swept_uppers = np.maximum(uppers, self.uppers)

    def forget_sweep(self) -> None:
        """Boxes that are changed by hand are where they are."""
        self.swept_lowers = self.swept_uppers = np.empty((0, 2))

    # -- rows are filled and emptied ----------------------------------------------------------------

    def put(self, ids: NDArray[np.int64], lowers: Floats, uppers: Floats, velocities: Floats) -> None:
        """Boxes with these ids, in rows that are free or yet to be made. `note_ids` is to follow."""
        missing = int(ids.max(initial=-1)) + 1 - len(self.alive)
        if missing > 0:
            for name in ("lowers", "uppers", "velocities", "growth", "alive"):
                array = getattr(self, name)
                more = np.zeros((missing, *array.shape[1:]), dtype=array.dtype)
                setattr(self, name, np.concatenate([array, more]))
        self.lowers[ids], self.uppers[ids], self.velocities[ids] = lowers, uppers, velocities
        self.growth[ids], self.alive[ids] = 0.0, 1

    def next_ids(self, count: int) -> NDArray[np.int64]:
        """Ids for so many more boxes, free ones first."""
        free = np.flatnonzero(self.alive == 0)[:count]
        new = np.arange(len(self.alive), len(self.alive) + count - len(free))
        return np.concatenate([free, new])

    def clear(self, ids: NDArray[np.int64]) -> None:
        """Empty some rows. `note_ids` is to follow."""
        self.alive[ids] = 0
        self.lowers[ids] = self.uppers[ids] = self.velocities[ids] = 0.0
        self.growth[ids] = 0.0

    def scale(self, factor: float) -> None:
        """Make all boxes larger or smaller about their centres."""
        centers, halves = (self.lowers + self.uppers) / 2.0, (self.uppers - self.lowers) / 2.0
        self.lowers, self.uppers = centers - factor * halves, centers + factor * halves

    # -- what is remembered -------------------------------------------------------------------------

    def state(self) -> BoxesState:
        """The arrays as they are, not copied."""
        return BoxesState(
            self.lowers, self.uppers, self.velocities, self.growth, self.alive, self.swept_lowers,
            self.swept_uppers,
        )  # fmt: skip

    def restore(self, state: BoxesState) -> None:
        """Take over copies of a state."""
        self.lowers, self.uppers = np.array(state.lowers), np.array(state.uppers)
        self.velocities, self.growth = np.array(state.velocities), np.array(state.growth)
        self.alive = np.array(state.alive)
        self.swept_lowers, self.swept_uppers = np.array(state.swept_lowers), np.array(state.swept_uppers)
        self.note_ids()

    def to_content(self) -> BoxesContent | None:
        """The boxes as a level lists them; None if they are too many."""
        if len(self.ids) > level.MOST_LISTED:
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


def listed_boxes(boxes: tuple[BoxEntry, ...]) -> BoxArrays:
    """The boxes of a level; ValueError if one of them is none, or too far away to be moved."""
    lowers = np.array([box.lower for box in boxes], dtype=np.float64)
    uppers = np.array([box.upper for box in boxes], dtype=np.float64)
    bad = first_bad_box(lowers, uppers)
    if bad >= 0:
        raise ValueError(f"boxes[{bad}]: lower {boxes[bad].lower} must not be above upper {boxes[bad].upper}")
    for name, given in (("lower", lowers), ("upper", uppers)):
        far = np.flatnonzero((np.isfinite(given) & (np.abs(given) > level.FARTHEST)).any(axis=1))
        if len(far):
            corner = tuple(given[far[0]].tolist())
            raise ValueError(
                f"boxes[{far[0]}]: {name} {corner} must be within {level.FARTHEST:g} m, or infinite"
            )
    return BoxArrays(
        lowers,
        uppers,
        np.array([box.velocity for box in boxes], dtype=np.float64),
        np.array([box.growth for box in boxes], dtype=np.float64),
    )
