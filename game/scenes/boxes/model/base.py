"""Boxes that move and bounce, come and go; broad phases round them, and the pairs that these find."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.broadphase import BroadPhase
from game.physics.broadphase.effects import BOUNDARY, BOXES, MOTION
from game.physics.broadphase.motion import move_boxes_kernel
from game.physics.broadphase.workloads import MovingBoxes, make_boxes
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.scenes.boxes.level import HEIGHT, WIDTH, BoxesContent
from game.scenes.boxes.model.arrays import LOWER, UPPER, BoxArrays, BoxesState, listed_boxes
from game.scenes.boxes.parameters import BoxesParameters
from game.stage import Param, Part
from game.stage.messages import Messages
from game.worlds.stopwatch import Stopwatch

MOST_PAIRS = 500_000  # a frame takes a tenth of a second there
NO_BOX = -1
# Workloads whose boxes turn back in every step, and on which axes: else a line would be none after a second.
TREMBLING = {"line": (1,), "lattice": (0, 1)}


class BoxesModel(Part):
    """Base of the models: a subclass makes structures and pairs boxes up.

    pairs: (m, 2) ids; begun, ended: pairs in the last step. held: the box that a hand holds, which stays
    where it is; chosen: the one that is looked into; or NO_BOX. Both forget a box that goes.
    """

    shaping: ClassVar[tuple[str, ...]] = ()  # parameters that the structures are made by

    def __init__(self, parameters: BoxesParameters, active: EffectSet, seed: int):
        self.parameters, self.active, self.seed = parameters, active, seed
        self.steps = 0
        self.births = 0  # how often random boxes were asked for
        self.begun = self.ended = 0
        self.held = self.chosen = NO_BOX
        self.held_velocity: tuple[float, ...] = (0.0, 0.0)
        self.messages = Messages()
        self.watch = Stopwatch()

    def begin(self, content: BoxesContent) -> None:
        """Begin with the boxes of a level, or random ones. ValueError if the level's are none."""
        self.content = content
        self.listed = bool(content.boxes)  # the boxes are those of the level: their sizes are not changed
        if self.listed:
            self.boxes = listed_boxes(content.boxes)
        else:
            made = self._random_boxes(int(self.parameters.count))
            self.boxes = BoxArrays(made.lowers, made.uppers, made.velocities, np.zeros(len(made.centers)))
        self.speed_before = self.parameters.speed
        self.begin_again()

    def _random_boxes(self, count: int) -> MovingBoxes:
        self.births += 1
        parameters = self.parameters
        return make_boxes(
            parameters.workload, count, np.random.default_rng((self.seed, self.births)), (WIDTH, HEIGHT),
            parameters.fill, parameters.speed, *parameters.large(),
        )  # fmt: skip

    def begin_again(self) -> None:
        """New structures for the boxes there are; pairs are as if they had always been there."""
        boxes = self.boxes
        self.pairs = np.empty((0, 2), dtype=np.int64)
        self._note_ids()
        self.size = boxes.typical_size()
        self.make_structures()
        lowers, uppers = boxes.covered()
        for phase in self.structures():
            phase.limit_pairs(MOST_PAIRS)
            phase.add_boxes(lowers[boxes.ids], uppers[boxes.ids], ids=boxes.ids)
        self.pair_up()
        self.begun = self.ended = 0

    def _note_ids(self) -> None:
        """Look up which ids are in use; the parameter says how many."""
        self.boxes.note_ids()
        self.parameters.values["count"] = max(len(self.boxes), 1)  # the parameter's least value

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

    def update(self, phase: BroadPhase) -> None:
        """Move a broad phase's boxes to where they are now."""
        ids, (lowers, uppers) = self.boxes.ids, self.boxes.covered()
        if len(ids) == len(self.boxes.alive):
            phase.update_boxes(ids, lowers, uppers)
        else:
            phase.update_boxes(ids, lowers[ids], uppers[ids])

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Boxes move, some leap or are replaced, and are paired up."""
        self.steps += 1
        boxes, parameters = self.boxes, self.parameters
        if parameters.swept:
            before = boxes.lowers.copy(), boxes.uppers.copy()
        move = move_boxes_kernel(BOXES.mask(self.active) & BOXES.mask(MOTION | BOUNDARY))
        trembling = () if self.listed else TREMBLING.get(parameters.workload, ())
        came_with = [boxes.velocities[:, axis].copy() for axis in trembling]
        move(boxes.lowers, boxes.uppers, boxes.velocities, boxes.growth, boxes.alive, LOWER, UPPER, dt)
        for axis, velocity in zip(trembling, came_with, strict=True):
            boxes.velocities[:, axis] = -velocity  # whether or not the boundary has turned it back
        if parameters.leaps > 0.0:
            self._leap()
        if parameters.swept:
            boxes.sweep(*before)
        if parameters.turnover > 0:
            self._replace(int(parameters.turnover))
        self.pair_up()

    def _leap(self) -> None:
        """A share of the boxes is somewhere else at once."""
        boxes = self.boxes
        random = np.random.default_rng((self.seed, self.steps, 1))
        count = math.ceil(self.parameters.leaps * len(boxes))
        who = boxes.ids if count == len(boxes) else random.choice(boxes.ids, count, replace=False)
        sizes = boxes.uppers[who] - boxes.lowers[who]
        places = random.random((count, 2)) * np.maximum(UPPER - sizes, 0.0)
        movable = np.isfinite(sizes).all(axis=1)
        boxes.lowers[who[movable]] = places[movable]
        boxes.uppers[who[movable]] = (places + sizes)[movable]

    def _replace(self, count: int) -> None:
        """Some boxes go, and as many come somewhere else: their ids are used again."""
        boxes = self.boxes
        random = np.random.default_rng((self.seed, self.steps, 2))
        who = random.choice(boxes.ids, min(count, len(boxes)), replace=False)
        who = who[who != self.held]
        sizes = np.minimum(boxes.uppers[who] - boxes.lowers[who], min(WIDTH, HEIGHT))
        velocities = boxes.velocities[who]
        self.remove(who)
        lowers = random.random((len(who), 2)) * (UPPER - sizes)
        self.add(lowers, lowers + sizes, velocities)

    # -- boxes come and go --------------------------------------------------------------------------

    def add(self, lowers: Floats, uppers: Floats, velocities: Floats) -> NDArray[np.int64]:
        """Add boxes to the arrays and to every structure; their ids are the smallest free ones."""
        self.boxes.forget_sweep()
        ids = np.empty(0, dtype=np.int64)
        for phase in self.structures():
            ids = phase.add_boxes(lowers, uppers)
        self.boxes.put(ids, lowers, uppers, velocities)
        self._note_ids()
        return ids

    def remove(self, who: NDArray[np.int64]) -> None:
        """Remove boxes from the arrays and from every structure."""
        self.boxes.forget_sweep()
        for phase in self.structures():
            phase.remove_boxes(who)
        self._clear(who)
        self._note_ids()

    def _clear(self, who: NDArray[np.int64]) -> None:
        """Empty the rows of some boxes; hand and look let go of them."""
        self.boxes.clear(who)
        self.held = NO_BOX if self.held in who else self.held
        self.chosen = NO_BOX if self.chosen in who else self.chosen

    @property
    def most(self) -> int:
        """The greatest number of boxes."""
        count = type(self.parameters).count
        assert isinstance(count, Param)
        return int(count.maximum)

    def set_count(self, count: int) -> None:
        """Add random boxes or remove the last ones; the others shrink or grow, so that the density stays."""
        boxes = self.boxes
        count = min(max(count, 1), self.most)
        before = len(boxes)
        if count == before:
            return
        boxes.forget_sweep()
        if max(count, before) > 1.2 * min(count, before):
            self.watch.clear()  # times of so many other boxes say nothing of these
        if before and not self.listed:
            boxes.scale(math.sqrt(before / count))
        if count > before:
            made = self._random_boxes(count)
            lowers, uppers = made.lowers[before:], made.uppers[before:]
            if self.listed:
                centers = made.centers[before:]
                lowers, uppers = centers - self.size / 2.0, centers + self.size / 2.0
            boxes.put(boxes.next_ids(count - before), lowers, uppers, made.velocities[before:])
        else:
            self._clear(boxes.ids[count:])
        self.begin_again()

    def change_parameter(self, name: str) -> None:
        """A parameter has a new value."""
        if name == "count":
            self.set_count(int(self.parameters.count))
        elif name == "speed":
            self.boxes.velocities *= self.parameters.speed / self.speed_before
            self.speed_before = self.parameters.speed
        elif name == "swept":
            self.boxes.forget_sweep()
            self.pair_up()
        elif name in self.shaping:
            counts = self.begun, self.ended
            self.begin_again()
            self.begun, self.ended = counts

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active

    # -- what a hand does ---------------------------------------------------------------------------

    def box_at(self, at: tuple[float, float]) -> int:
        """The topmost box at a point, or NO_BOX; boxes without end are left alone."""
        found = self.structures()[0].query_point(at)
        found = found[self.boxes.is_finite(found)]
        return int(found[-1]) if len(found) else NO_BOX

    def hold(self, box: int) -> None:
        """Take a box: it stands still."""
        self.held = box
        self.held_velocity = tuple(self.boxes.velocities[box].tolist())
        self.boxes.velocities[box] = 0.0

    def release(self) -> None:
        """Let go of the box that is held, if there is one: it goes on as before."""
        if self.held >= 0:
            self.boxes.velocities[self.held] = self.held_velocity
        self.held = NO_BOX

    def move_held(self, lower: tuple[float, float]) -> None:
        """Put the box that is held somewhere, m."""
        boxes = self.boxes
        boxes.forget_sweep()
        size = boxes.uppers[self.held] - boxes.lowers[self.held]
        boxes.lowers[self.held], boxes.uppers[self.held] = lower, np.array(lower) + size
        self.pair_up()

    def remove_one(self, box: int) -> None:
        """Remove a box, and pair the others up."""
        self.remove(np.array([box]))
        self.pair_up()

    def add_one(self, lower: Floats, upper: Floats) -> None:
        """Add a box that goes in a random direction, and pair it up; a message if there are too many."""
        if len(self.boxes) >= self.most:
            self.messages.say(f"{self.most} boxes are the most.")
            return
        random = np.random.default_rng((self.seed, self.steps, 3, len(self.boxes)))
        angle = 2.0 * math.pi * random.random()
        velocity = self.parameters.speed * np.array([[elementary.cos(angle), elementary.sin(angle)]])
        self.add(lower[None], upper[None], velocity)
        self.pair_up()

    # -- what is remembered -------------------------------------------------------------------------

    def state(self) -> BoxesState:
        """The arrays of the boxes."""
        return self.boxes.state()

    def restore(self, state: BoxesState) -> None:
        """Take over an earlier state."""
        self.boxes.restore(state)
        count = self.parameters.values["count"]
        self.begin_again()
        self.parameters.values["count"] = count

    def missed_pairs(self) -> int:
        """How many pairs are found but do not overlap, or overlap but are not found, by testing all."""
        ids, (lowers, uppers) = self.boxes.ids, self.boxes.covered()
        low, high = lowers[ids], uppers[ids]
        overlap = np.all((low[:, None] <= high[None]) & (low[None] <= high[:, None]), axis=2)
        first, second = np.nonzero(np.triu(overlap, 1))
        truth = set(zip(ids[first].tolist(), ids[second].tolist(), strict=True))
        return len(truth.symmetric_difference(map(tuple, self.pairs.tolist())))

    def overlapping(self) -> int:
        """Number of boxes that overlap another."""
        overlaps = np.zeros(len(self.boxes.alive), dtype=bool)
        overlaps[self.pairs] = True
        return int(np.count_nonzero(overlaps))
