"""The fountain itself: particles, stones, nozzles and the air, from the level and the parameters."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.kernels import linear
from game.physics.kernels.limits import LimitError
from game.physics.particles import CALM, Discs, Emitter, ParticleState, ParticleSystem
from game.physics.particles.encounters import STEP
from game.scenes.fountain.level import MOST_STONES, FountainContent, Point, Stone
from game.scenes.fountain.parameters import FountainParameters
from game.stage import Part

HAND_SPEED = 25.0  # m/s, at which a stone follows the hand at most
NEW_RADIUS = 0.25  # m, of an added stone
PATH_STEPS, MOST_PATHS = 2_048, 16  # steps and listed particles of which paths are kept
MOST_MEETINGS = 32_000_000  # of a particle and a solid in a step, each substep again: a second or so at worst
CONTACT_TIME = 1.0 / 60.0  # s for which a particle counts as in contact after an impact
RUNAWAY = (
    "The time step is too long for this drag: it throws particles away. Take a shorter one, or Exponential."
)
OF_EMITTERS = ("rate", "speed", "spread")  # parameters that the emitters take
OF_FLIGHT = ("speed", "gravity", "drag", "wind", "fast_drag", "whirl")  # parameters of a particle's path


BESIDE = ("explicit-euler", "midpoint")  # methods beside the last one
LAST = "verlet"


class SplitState(NamedTuple):
    """A `ParticleState`, and those of the other methods."""

    fields: NDArray[np.float64]
    tags: NDArray[np.int64]
    tallies: NDArray[np.int64]
    clock: NDArray[np.float64]
    emitters: NDArray[np.float64]
    births: NDArray[np.int64]
    solids: NDArray[np.float64]
    impulses: NDArray[np.float64]
    beside: tuple[ParticleState, ...]


class FountainModel(Part):
    """Particles over stones.

    beside: the same by the methods of BESIDE, where three are shown; ``system`` is then by LAST.
    active: the effects that are on. own: restitutions of the stones, None where the parameter's holds. since:
    s, who was born later knows no other law and nozzle than the present ones. full: births were dropped in
    the last step. ran_away: drag has thrown particles away.
    """

    def __init__(
        self, content: FountainContent, parameters: FountainParameters, active: EffectSet, seed: int
    ):
        self.content, self.parameters, self.active = content, parameters, active
        self.emitting = True
        self.own = [stone.restitution for stone in content.stones]
        self.vortex_centre = content.whirl
        self.since = 0.0
        self.full = False
        self.ran_away = False
        self.meetings = 0  # in a step, as far as there may be so many
        self.system = self._new_system(seed)
        self.beside = [self._new_system(seed) for _ in BESIDE] if parameters.split else []
        self.paths = np.zeros(
            (PATH_STEPS if content.paths else 0, MOST_PATHS, 2)
        )  # by step modulo PATH_STEPS
        self._configure()
        self._bound_work()
        self._note_paths()

    def _new_system(self, seed: int) -> ParticleSystem:
        """The level's particles, stones and nozzles at their beginning."""
        content = self.content
        stones = Discs(capacity=MOST_STONES)
        for stone in content.stones:
            stones.add(stone.centre, stone.radius, self._restitution(stone.restitution))
        system = ParticleSystem(
            int(self.parameters.places),
            solids=stones,
            effects=self.active,
            seed=seed,
            floor=content.floor,
            emitters=[self._emitter(i, nozzle.position) for i, nozzle in enumerate(content.nozzles)],
        )
        if content.particles:
            system.add(
                [particle.position for particle in content.particles],
                [particle.velocity for particle in content.particles],
            )
        return system

    @property
    def systems(self) -> list[ParticleSystem]:
        """All of them, in the order of their panes."""
        return [*self.beside, self.system]

    @property
    def methods(self) -> list[str]:
        """The method of each."""
        return [*BESIDE, LAST] if self.beside else [self.parameters.method]

    def _restitution(self, own: float | None) -> float:
        return self.parameters.restitution if own is None else own

    def _emitter(self, index: int, position: Point) -> Emitter:
        """A nozzle of the level with the panel's numbers, at ``position`` m."""
        nozzle, parameters = self.content.nozzles[index], self.parameters
        shares = sum(other.share for other in self.content.nozzles)
        part = nozzle.share / shares if shares > 0.0 else 0.0
        return Emitter(
            position,
            rate=parameters.rate * part if self.emitting else 0.0,
            speed=parameters.speed,
            spread=math.radians(parameters.spread),
            axis=math.radians(nozzle.tilt),
        )

    # -- changes ------------------------------------------------------------------------------------

    def _configure(self) -> None:
        """Hand all parameters to the systems."""
        for system, method in zip(self.systems, self.methods, strict=True):
            self._hand_to(system, method)
        for j, own in enumerate(self.own):
            self.system.solids.rows[j, 5] = self._restitution(own)

    def _hand_to(self, system: ParticleSystem, method: str) -> None:
        parameters = self.parameters
        system.effects = self.active
        system.method = method
        system.contact = parameters.contact
        system.life = parameters.life
        system.substeps = 0 if parameters.smooth else 1
        system.set_ground(self.content.floor, parameters.ground_restitution)
        system.forces = CALM._replace(
            gravity=parameters.gravity,
            drag=parameters.drag,
            quadratic_drag=parameters.fast_drag,
            wind_x=parameters.wind,
            whirl_strength=parameters.whirl,
            whirl_x=self.vortex_centre[0],
            whirl_y=self.vortex_centre[1],
        )

    def _bound_work(self) -> None:
        """LimitError if the parameters ask for more work in a step than before and than there may be."""
        places, solids = int(self.parameters.places), 1 + len(self.own)
        substeps = self.system.substeps_for(self.parameters.step_length)
        meetings = places * substeps * solids * len(self.systems)
        if meetings > max(MOST_MEETINGS, self.meetings):
            most = MOST_MEETINGS // (substeps * solids * len(self.systems))
            raise LimitError(
                f"places: {places} are too many for {substeps} substeps among {solids} "
                f"solids, {most} at most; less drag or a shorter time step takes fewer substeps"
            )
        self.meetings = meetings

    def renew(self) -> None:
        """Give a state that was taken back the present parameters."""
        self._configure()
        self._change_emitters()

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value; LimitError if it asks for too much work."""
        self.ran_away = False
        if name in OF_EMITTERS:
            self._change_emitters()
        else:
            self._configure()
        if name in OF_FLIGHT:
            self.since = self.system.time_s
        self._bound_work()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on; LimitError if they ask for too much work."""
        self.active = active
        self._configure()
        self.since = self.system.time_s
        self._bound_work()

    def switch_emitters(self) -> None:
        """Let the nozzles begin or stop to emit."""
        self.emitting = not self.emitting
        self._change_emitters()

    def _change_emitters(self) -> None:
        """Give the nozzles the panel's numbers, where they are."""
        for index in range(len(self.content.nozzles)):
            x, y = self.nozzle_position(index)
            for system in self.systems:
                system.change_emitter(index, self._emitter(index, (x, y)))

    def nozzle_position(self, index: int) -> Point:
        """Where a nozzle is, m."""
        x, y = self.system.state().emitters[index, :2].tolist()
        return x, y

    def place_nozzle(self, index: int, position: Point) -> None:
        """Put a nozzle somewhere else, m."""
        for system in self.systems:
            system.place_emitter(index, position)
        self.since = self.system.time_s

    def place_vortex(self, position: Point) -> None:
        """Put the vortex somewhere else, m."""
        self.vortex_centre = position
        self._configure()

    def add_stone(self, centre: Point) -> int:
        """Put a stone there, m; its number, or -1 if there are MOST_STONES."""
        if len(self.own) == MOST_STONES:
            return -1
        index = int(self.system.solids.add(centre, NEW_RADIUS, self.parameters.restitution))
        self.own.append(None)
        return index

    def remove_stone(self, index: int) -> None:
        """Take a stone away; those after it move up."""
        self.system.solids.remove(index)
        del self.own[index]

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float, carried: int, target: Point) -> str:
        """One step; the stone ``carried`` (-1: none) goes towards ``target`` m. Gives words to say, or ""."""
        system = self.system
        if (system.forces.whirl_x, system.forces.whirl_y) != self.vortex_centre:
            self._configure()  # the vortex was put back by a step back
        if carried >= 0:
            displacement = np.array(target) - system.solids.centres[carried]
            speed = math.sqrt(float(linear.product(displacement, displacement))) / dt
            system.solids.carry(
                carried, displacement / dt * min(1.0, HAND_SPEED / speed if speed > 0.0 else 1.0)
            )
        dropped, moving = system.dropped, system.has_moving_emitters
        for other in self.beside:  # all have the stones of the hand
            other.solids.restore(system.solids.rows, system.solids.impulses)
            other.step(dt)
        system.step(dt)
        self._note_paths()
        if moving:  # one born meanwhile did not leave the nozzle where it is now
            self.since = system.time_s
        if carried >= 0:
            system.solids.carry(carried, (0.0, 0.0))
        if any(one.runaways for one in self.systems) and not self.ran_away:
            self.ran_away = True
            return RUNAWAY
        was_full, self.full = self.full, system.dropped > dropped
        if self.full and not was_full:
            return f"The pool of {system.capacity} is full: further births are dropped and counted."
        return ""

    def clear(self) -> None:
        """Let all particles die now."""
        for system in self.systems:
            system.clear()

    def state(self) -> ParticleState | SplitState:
        """All that moves."""
        state = self.system.state()
        return SplitState(*state, tuple(one.state() for one in self.beside)) if self.beside else state

    def restore(self, state: ParticleState | SplitState) -> None:
        """Take over a copy of a state."""
        self.system.restore(ParticleState(*state[:8]))
        if isinstance(state, SplitState):
            for system, then in zip(self.beside, state.beside, strict=True):
                system.restore(then)

    def _note_paths(self) -> None:
        """Write where the listed particles are, who have the first places of the pool."""
        if len(self.paths):
            count = min(len(self.content.particles), MOST_PATHS)
            row = int(self.system.tallies[STEP]) % PATH_STEPS
            self.paths[row, :count] = self.system.fields[:2, :count].T

    def paths_so_far(self) -> NDArray[np.float64]:
        """Where the listed particles were (steps, count, 2), m, oldest first; none where none are kept."""
        if not len(self.paths):
            return np.zeros((0, 0, 2))
        last = int(self.system.tallies[STEP])
        steps = np.arange(max(last + 1 - PATH_STEPS, 0), last + 1)
        return self.paths[steps % PATH_STEPS, : min(len(self.content.particles), MOST_PATHS)]

    # -- what is asked of it ------------------------------------------------------------------------

    def first_step_in_contact(self) -> int:
        """Number of the first step whose impacts still count as contact."""
        steps = max(1, round(CONTACT_TIME / self.parameters.step_length))
        return max(int(self.system.tallies[STEP]) + 1 - steps, 1)

    def content_now(self) -> FountainContent:
        """The level as it stands now; living particles are not kept."""
        return FountainContent(
            nozzles=tuple(
                type(nozzle)(position=self.nozzle_position(i), tilt=nozzle.tilt, share=nozzle.share)
                for i, nozzle in enumerate(self.content.nozzles)
            ),
            stones=tuple(
                Stone(centre=(float(row[0]), float(row[1])), radius=float(row[2]), restitution=own)
                for row, own in zip(self.system.solids.rows, self.own, strict=True)
            ),
            floor=self.content.floor,
            whirl=self.vortex_centre,
            expected=self.content.expected,
            repeat=self.content.repeat,
            zoom=self.content.zoom,
            paths=self.content.paths,
            view=self.content.view,
        )
