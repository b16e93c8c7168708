"""Spheres that collide: candidates from any broad phase, impulses, positions, and a ledger of it all."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.broadphase import BroadPhase
from game.physics.spheres import steps
from game.physics.spheres.candidates import Candidates
from game.physics.spheres.contact_buffers import ContactBuffers
from game.physics.spheres.effects import COLLISIONS, IMPACT_TIMES, PUSHES, SPHERES, STRINGS
from game.physics.spheres.ledger import (
    LEDGER_COLUMNS,
    LEDGER_ROWS,
    Ledger,
    Totals,
    deepest_overlap,
    sum_totals,
)
from game.physics.spheres.planar_impulses import FLAT_COLUMNS, lies_in_plane
from game.physics.spheres.planar_steps import move_flat, planar_part
from game.physics.spheres.settings import (
    CollisionSettings,
    Numbers,
    Surroundings,
    Tables,
    World,
    material_tables,
    surroundings_of,
)
from game.physics.spheres.spheres import (
    WORK_COLUMNS,
    MotionState,
    SphereBodies,
    gather_velocities,
    place_spheres,
)
from game.physics.spheres.state import CollisionState, entries_in_order
from game.physics.spheres.steps import BodyMotion, general_part, move_by_velocity
from game.physics.spheres.time_of_impact import divide_at_impacts, first_impact

PLANAR_FROM = 200  # spheres; fewer are solved in space and weighed collision by collision


class CollidingSpheres:
    """Bodies of spheres that hit, carry and rub each other, and walls.

    bodies: a `SphereBodies`. surroundings: of `surroundings_of`. tables: of `material_tables`. broad_phase:
    any of game.physics.broadphase, empty; None tests every sphere against every other. settings: fields of
    `CollisionSettings`. ValueError, naming what is wrong, for nonsense.
    """

    def __init__(
        self,
        bodies: SphereBodies,
        surroundings: Surroundings | None = None,
        tables: Tables | None = None,
        broad_phase: BroadPhase | None = None,
        **settings: Any,
    ):
        self.settings = CollisionSettings(**settings)
        self.bodies = bodies
        self.surroundings = surroundings if surroundings is not None else surroundings_of()
        self.tables = tables if tables is not None else material_tables(0.5, 0.3)
        s, n = len(bodies.composition.radii), bodies.count
        if int(bodies.composition.kinds.max(initial=0)) > len(self.tables.restitution) - 2:
            raise ValueError(f"kinds: there are {len(self.tables.restitution) - 1} materials")
        if self.surroundings.hung.size and not (self.surroundings.hung.min() >= 0) & (
            self.surroundings.hung.max() < s
        ):
            raise ValueError(f"strings: spheres 0 to {s - 1} can hang")
        self.smallest = float(bodies.composition.radii.min())
        self.pulls = np.zeros((n, 6))
        self.ring = np.zeros((LEDGER_ROWS, LEDGER_COLUMNS))
        self.counters = np.zeros(steps.COUNTERS)
        self._work = np.zeros((n + 1, WORK_COLUMNS))
        self._flat = np.zeros((n + 1, FLAT_COLUMNS))
        self._shifts = np.zeros((n + 1, 4))
        self._log = Ledger(self.ring, self.counters, np.zeros((2, 7)))
        self._places = bodies.places()
        self._candidates = Candidates(bodies.composition, broad_phase)
        self._buffers = ContactBuffers(max(64, 4 * s))
        self.parts = 0  # of the last step
        self._asked: tuple[CollisionSettings, float, float, float] | None = None
        self._numbers: Numbers

    def change(self, **settings: Any) -> None:
        """Other settings from now on; ValueError, and nothing changed, if one of them makes no sense."""
        self.settings = dataclasses.replace(self.settings, **settings)

    @property
    def tests(self) -> int:
        """Pairs that were tested in the last step; boxes where there is a broad phase."""
        return self._candidates.tests

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        settings = self.settings
        nominal = dt / settings.substeps
        self.parts = self._candidates.tests = 0
        if PUSHES not in settings.effects:
            self.pulls[:] = 0.0
        for _ in range(settings.substeps):
            for h in self._divided(nominal):
                self._part(h, nominal)
                self.parts += 1
        self.pulls[:] = 0.0

    def _divided(self, nominal: float) -> Iterable[float]:
        """Lengths of the parts of a substep (s): one, or as its impacts come."""
        if IMPACT_TIMES not in self.settings.effects:
            return (nominal,)
        spheres, pause = len(self.bodies.composition.radii), self.settings.scheme != "explicit-euler"
        return divide_at_impacts(nominal, spheres, pause, lambda left: self._time_to_impact(left, nominal))

    def _time_to_impact(self, left: float, nominal: float) -> float:
        """Seconds until the first impact that bounces, at most those left of a substep of nominal length."""
        bodies, _settings = self.bodies, self.settings
        gather_velocities(bodies.state, bodies.composition, self._work)
        self._place()
        pairs = self._candidates.that_could_meet(self._places, self._work, left)
        numbers = self._numbers_of(left, nominal)
        first: float = first_impact(self._places, self._world(), self._work, pairs, numbers)
        return first

    def _numbers_of(self, h: float, nominal: float) -> Numbers:
        """For kernels, a part of h (s) of a substep of nominal length: mostly those of the part before."""
        asked = (self.settings, h, nominal, float(self.counters[steps.LAST_H]))
        if asked != self._asked:
            self._asked, self._numbers = asked, self.settings.numbers(*asked[1:], self.smallest)
        return self._numbers

    def _world(self) -> World:
        """What a step meets and leaves as it is."""
        return World(self.bodies.composition, self.surroundings, self.tables, self.pulls)

    def planar(self) -> bool:
        """True if the next step will be that of single spheres in a plane."""
        bodies, settings = self.bodies, self.settings
        if settings.path == "general" or settings.law == "at-once" or not bodies.alike:
            return False
        many = bodies.count >= PLANAR_FROM or settings.path == "planar"
        if not many or (STRINGS in settings.effects and self.surroundings.hung.size):
            return False
        state = bodies.state
        flat: bool = lies_in_plane(state.positions, state.momenta, state.spins)
        return flat and not self.pulls[:, 2:5].any()

    def _part(self, h: float, nominal: float) -> None:
        bodies, settings = self.bodies, self.settings
        numbers = self._numbers_of(h, nominal)
        planar = self.planar()
        if settings.scheme == "explicit-euler":
            move, work = (move_flat, self._flat) if planar else (move_by_velocity, self._work)
            move(bodies.state, bodies.composition, work, numbers)
        self._find_contacts(numbers.mask)
        buffers = self._buffers
        contacts, count, past = buffers.contacts, buffers.count, buffers.past
        if planar:
            rows = buffers.planar_rows()
            planar_part(
                bodies.state, self._world(), numbers, self._flat, contacts, count, past, rows, self._log
            )
        else:
            rows, motion = buffers.general_rows(), BodyMotion(self._places, self._work, self._shifts)
            general_part(bodies.state, self._world(), numbers, motion, contacts, count, past, rows, self._log)
        buffers.turn_over()

    def _find_contacts(self, mask: int) -> None:
        """Bring places, candidates and contacts up to date."""
        self._place()
        self._find_candidates()
        margin = self.settings.slop * self.smallest
        pairs = self._candidates.pairs
        self._buffers.find(self._places, self.bodies.composition, pairs, self.surroundings, mask, margin)

    def _find_candidates(self) -> None:
        """Bring the pairs that may be in contact up to date, if spheres collide at all."""
        if COLLISIONS in self.settings.effects:
            self._candidates.find(self._places)

    def _place(self) -> None:
        """Bring the places of spheres up to date."""
        if self.bodies.single:
            self._places = self.bodies.state.positions
        else:
            place_spheres(self.bodies.state, self.bodies.composition, self._places)

    # -- the hand -----------------------------------------------------------------------------------

    def apply_force(self, body: int, force: ArrayLike, point: ArrayLike) -> None:
        """A force (3,) N at a point (3,) m of the world, during the next step; it also turns the body.

        ValueError for a body that there is not, or numbers that are not finite.
        """
        if not 0 <= body < self.bodies.count:
            raise ValueError(f"body {body}: there are 0 to {self.bodies.count - 1}")
        pull, place = np.array(force, dtype=np.float64), np.array(point, dtype=np.float64)
        if pull.shape != (3,) or place.shape != (3,) or not np.isfinite([*pull, *place]).all():
            raise ValueError("force, point: expected three finite numbers each")
        self.pulls[body, :3] += pull
        self.pulls[body, 3:] += np.cross(place - self.bodies.state.positions[body], pull)

    # -- what there is ------------------------------------------------------------------------------

    def totals(self) -> Totals:
        """Momentum, angular momentum and energies."""
        bodies = self.bodies
        gather_velocities(bodies.state, bodies.composition, self._work)
        gravity = self.settings.gravity if "gravity" in self.settings.effects.names else 0.0
        sums = sum_totals(bodies.state, bodies.composition, self._work, float(gravity))
        return Totals(tuple(sums[:3]), tuple(sums[3:6]), *sums[6:])

    def overlap(self) -> float:
        """Deepest overlap now, m."""
        bodies = self.bodies
        self._place()
        self._find_candidates()
        buffers = ContactBuffers(max(64, 4 * len(self._places), self._buffers.capacity))
        mask = SPHERES.mask(self.settings.effects)
        count = buffers.find(
            self._places, bodies.composition, self._candidates.pairs, self.surroundings, mask, 0.0
        )
        return float(deepest_overlap(buffers.contacts, count))

    @property
    def contacts(self) -> tuple[Floats, NDArray[np.int32], Floats]:
        """Of the last step: normals and gaps (m, 4), spheres (m, 2), contact impulses (m, 4)."""
        found, impulses = self._buffers.contacts, self._buffers.past.impulses
        m = len(impulses)
        return found.normals[:m], found.spheres[:m], impulses

    @property
    def time(self) -> float:
        """s since the start."""
        return float(self.counters[steps.CLOCK])

    @property
    def collisions(self) -> int:
        """Collisions so far."""
        return int(self.counters[steps.MADE])

    @property
    def rounds(self) -> int:
        """Rounds of collisions in the last part of the last step."""
        return int(self.counters[steps.ROUNDS])

    @property
    def bounces(self) -> int:
        """Collisions in the last part of the last step."""
        return int(self.counters[steps.BOUNCES])

    def ledger(self) -> Floats:
        """Last collisions (k, LEDGER_COLUMNS), oldest first; see ledger.py for the columns."""
        return entries_in_order(self.ring, self.collisions)

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> CollisionState:
        """The state as arrays that the world goes on using."""
        found, past = self._candidates, self._buffers.past
        return CollisionState(
            *self.bodies.state, found.pairs, found.found_at, *past, self.pulls, self.ring, self.counters
        )

    def restore(self, state: CollisionState) -> None:
        """Take over a copy of a state of a world of the same bodies."""
        for mine, theirs in zip(self.bodies.state, MotionState(*state[:4]), strict=True):
            np.copyto(mine, theirs)
        self._candidates.take(state.pairs, state.found_at)
        self._buffers.take(state.keys, state.held)
        np.copyto(self.pulls, state.pulls)
        np.copyto(self.ring, state.ring)
        np.copyto(self.counters, state.counters)

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        self.bodies.check()
        keys, impulses = self._buffers.past
        assert np.all(np.diff(keys) > 0), "contacts by ascending key, each once"
        assert (impulses[:, 0] >= 0.0).all(), "impulses only push"
