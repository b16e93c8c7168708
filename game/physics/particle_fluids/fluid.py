"""A fluid of particles in a vessel: one search for neighbours, and the laws that can be chosen."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats, Longs
from game.physics.fields import GRAVITY
from game.physics.particle_fluids.effects import DRAGGING, SPRINGS, TENSION, WARMTH
from game.physics.particle_fluids.forces import act, steadied
from game.physics.particle_fluids.laws import follow_law
from game.physics.particle_fluids.scratch import Scratch
from game.physics.particle_fluids.search import SEARCHES, NeighbourSearch
from game.physics.particle_fluids.settings import CLAVET, DFSPH, MUELLER
from game.physics.particle_fluids.store import FluidStore
from game.physics.particle_fluids.sums import spread_heat
from game.physics.particle_fluids.walls import MARGIN, PARTICLES, hold_inside

MOST_SUBSTEPS = 200  # of one `advance`
LONGEST = 0.02  # s of a substep
FALLING = 0.1  # of the time in which a particle falls a spacing or so: longer steps heave liquid at rest
PRESSED = (
    0.5  # spacings that pressure over density, as the square of a speed, goes in a step: rows zigzag else
)
SOUND = 0.25  # supports that sound goes in a step of a law that squeezes


class ParticleFluid(FluidStore):
    """Particles ``spacing`` (m) apart at rest, of some kinds of liquid, in a vessel of closed loops."""

    _scratch: Scratch | None = None

    def longest_step(self) -> float:
        """s: the fastest particle goes a share of the spacing, sound of soft laws a share of the support.

        A particle between others is held in its place by pressure as by springs, of a frequency of about
        √(p/ρ) over the spacing. Pressures are found for the places that a step begins with, so a step must be
        shorter than such a swing. What is light under what is heavy, or deep, needs the shortest.
        """
        fastest = math.sqrt(float(np.max(np.sum(np.square(self.velocity), axis=1), initial=0.0)))
        weight = self.settings.gravity if GRAVITY in self.active else 0.0
        step = LONGEST
        if fastest > 0.0:
            step = min(step, self.settings.courant * self.spacing / fastest)
        if weight > 0.0:
            step = min(step, FALLING * math.sqrt(self.spacing / weight))
        if self.settings.law == MUELLER:
            step = min(step, SOUND * self.support / self.settings.softness)
            if DRAGGING in self.active:
                stiff = float(np.max(steadied(self) / self.densities))
                step = min(step, 0.02 * self.support * self.support / max(stiff, 1e-12))
        elif self.settings.law == CLAVET:
            step = min(step, SOUND * self.support / self.settings.softness)
        elif self.settings.law == DFSPH:
            highest = float(np.max(self.pressure[1] / self.densities[self.kind], initial=0.0))
            if highest > 0.0:
                step = min(step, PRESSED * self.spacing / math.sqrt(highest))
        tension = max((a.tension / a.density for a in self.liquids), default=0.0)
        if TENSION in self.active and tension > 0.0:
            step = min(step, 0.4 * math.sqrt(self.spacing * self.spacing * self.spacing / tension))
        return min(step, LONGEST)

    def advance(self, duration: float) -> int:
        """Go on by a duration (s) in substeps no longer than `longest_step`; how many were made.

        ValueError for a duration that is none, or a place that is not finite. RuntimeError for more substeps
        than ``MOST_SUBSTEPS``.
        """
        if not 0.0 <= duration < math.inf:
            raise ValueError(f"duration = {duration!r}: expected a time, at least 0 s")
        left, made = duration, 0
        while left > 0.0:
            parts = max(1.0, math.ceil(left / self.longest_step() - 1e-9))
            if made + parts > MOST_SUBSTEPS:
                raise RuntimeError(f"fluid: more than {MOST_SUBSTEPS} substeps in {duration:g} s")
            self._step(left / parts)
            left, made = left - left / parts if parts > 1.0 else 0.0, made + 1
        return made

    def scratch(self) -> Scratch:
        """Sorted copies and the pairs, of the size that is needed now."""
        walls = self.rows if self.settings.walls == PARTICLES else self.rows[:0]
        method = SEARCHES[self.settings.search]
        known = self._scratch
        if known is None or not known.fits(len(self.place), len(walls), method):
            known = self._scratch = Scratch(
                len(self.place), walls, self.spacing, NeighbourSearch(self.support, method)
            )
        return known

    def _step(self, dt: float) -> None:
        if not len(self.place):
            self.clock[:2] += dt, 1.0
            return
        work = self.scratch()
        if SPRINGS in self.active and bool(self.springy.any()) and len(self.partner) != len(self.place):
            self._make_springs(len(self.place))
        work.gather(self)
        excess = np.maximum(work.work.density - 1.0, 0.0)[work.body.light > 0.0]
        self.error, self.worst = float(np.mean(excess)), float(np.max(excess))
        act(self, work, dt)
        self.iterations = follow_law(self, work, dt)
        work.scatter(self)
        moving = np.ones(len(self.place))
        if len(self.edges):
            self.clock[2] += hold_inside(self.place, self.velocity, moving, self.edges, MARGIN * self.spacing)
        if WARMTH in self.active:
            self._warm(work, dt)
        self.clock[:2] += dt, 1.0

    def _warm(self, work: Scratch, dt: float) -> None:
        """Conduct heat, and let what is hot enough boil, what is cold enough condense."""
        if float(np.ptp(self.heat)) > 0.0:
            temperature, heat = work.sorted_rows(self.temperature()), work.sorted_rows(self.heat)
            most = 0.05 * self.support * self.support
            spread = min(self.settings.diffusivity * dt, most)
            spread_heat(work.pairs, work.felt, work.body, (temperature, heat), spread)
            work.unsort_rows(heat, self.heat)
        for number, one in enumerate(self.liquids):
            if one.vapour >= 0:
                boiling = (self.kind == number) & (self.heat >= one.boils + one.latent)
                condensing = (self.kind == one.vapour) & (self.heat <= one.boils)
                self.kind[boiling], self.kind[condensing] = one.vapour, number

    def density(self) -> Floats:
        """(n,) relative to rest, as the chosen kernel and walls have it now."""
        found = np.zeros(len(self.place))
        if len(self.place):
            work = self.scratch()
            work.gather(self)
            work.unsort_rows(work.work.density, found)
        return found

    def ranks(self) -> Longs:
        """(n,) where each particle stands in memory as the search sorts them."""
        found = np.zeros(len(self.place), dtype=np.int64)
        if len(self.place):
            work = self.scratch()
            work.gather(self)
            found[work.order[work.order < len(found)]] = np.arange(len(found))
        return found
