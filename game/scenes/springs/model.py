"""A network of particles and links that is built, moved and edited."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.constraints import PositionBasedDynamics
from game.physics.constraints.areas import AREA
from game.physics.constraints.editing import Topology, assemble, topology_of
from game.physics.constraints.settings import LARGEST
from game.physics.constraints.system import PositionState
from game.physics.effects import EffectSet
from game.physics.kernels.limits import LimitError
from game.scenes.springs.level import BesideEntry, Point, SpringContent
from game.scenes.springs.links import LinkLaw
from game.scenes.springs.network import Network, build_network
from game.scenes.springs.parameters import BUILDING, MassSpringParameters
from game.stage import ParameterError, Part

MOST_PROJECTIONS = 50_000_000  # of links and areas in a step: a second

AS_IN_THE_PANEL = BesideEntry(label="-", to_the_right=0.0)


class SpringState(NamedTuple):
    """What moves (see `PositionState`), and how it is linked if that is not as in the level any more."""

    fields: Floats
    torn: NDArray[np.int64]
    intact: Floats
    hand: Floats
    own: Floats  # (m,) stiffness of a link's own; empty as the following while nothing was edited
    pairs: NDArray[np.int64]
    rest: Floats
    stiffness: Floats
    compliance: Floats
    corners: NDArray[np.int64]
    starts: NDArray[np.int64]
    areas: Floats
    contacts: NDArray[np.int64]
    distances: Floats


class ComparedState(NamedTuple):
    """The same with what moves of the networks that are solved beside it."""

    fields: Floats
    torn: NDArray[np.int64]
    intact: Floats
    hand: Floats
    own: Floats
    pairs: NDArray[np.int64]
    rest: Floats
    stiffness: Floats
    compliance: Floats
    corners: NDArray[np.int64]
    starts: NDArray[np.int64]
    areas: Floats
    contacts: NDArray[np.int64]
    distances: Floats
    beside: tuple[PositionState, ...]


class SpringModel(Part):
    """Particles and links.

    beside: the same network solved in other ways, one for each of the content's entries, until it is edited.
    time: s. sweep_tick: steps since a sweep is shown slowed down. undisturbed: nothing was pulled, and
    gravity is what it was. law: how stiff links are. own: (m,) stiffness of a link's own, or NOT_OWN. edited:
    the network is not the level's any more.
    """

    def __init__(
        self, content: SpringContent, parameters: MassSpringParameters, law: LinkLaw, active: EffectSet
    ):
        self.content, self.parameters, self.law, self.active = content, parameters, law, active
        self.projections = 0  # in a step, as far as there may be so many
        self.time, self.undisturbed, self.sweep_tick = 0.0, True, 0
        self._make_system()
        self._bound_work()

    def _make_system(self) -> None:
        """The level's network, at its beginning."""
        network = build_network(self.content)
        self.own, self.edited = network.own, False
        self.system = self._system_of(network)
        self.beside = [self._system_of(network) for _ in self.content.beside]
        self._configure()

    def _system_of(self, network: Network) -> PositionBasedDynamics:
        shape, links = network.shape, self.law.firmness(network.own)
        system = PositionBasedDynamics(
            *shape[:3],
            links.stiffness,
            rest_lengths=network.rest,
            compliances=links.compliance,
            areas=shape.areas,
            area_stiffness=self.law.area_stiffness,
            area_compliance=self.law.area_compliance,
            velocities=network.velocities,
            contacts=shape.contacts,
            distances=shape.distances,
            order=self.parameters.order,
        )
        system.outlines.rows[AREA] *= network.pressures
        return system

    def _configure(self) -> None:
        """Hand the parameters to the systems; ParameterError if one refuses one."""
        self._hand_to(self.system, None)
        for system, entry in zip(self.beside, self.content.beside, strict=False):
            self._hand_to(system, entry)

    def _hand_to(self, system: PositionBasedDynamics, entry: BesideEntry | None) -> None:
        """Parameters to a system, but for what an entry says otherwise."""
        parameters, other = self.parameters, entry or AS_IN_THE_PANEL
        try:
            system.change(
                effects=self.active,
                model=other.model or self.law.model,
                scheme=parameters.scheme,
                solver=parameters.solver,
                substeps=other.substeps or int(parameters.substeps),
                iterations=other.iterations or int(parameters.iterations),
                gravity=parameters.gravity,
                damping=parameters.damping,
                floor=self.content.floor,
                left=self.walls[0],
                right=self.walls[1],
                body_distance=self.content.body_distance,
                relaxation=parameters.relaxation,
                speed_limit=parameters.speed_limit,
                stretch_limit=parameters.strength,
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def _bound_work(self) -> None:
        """LimitError if the parameters ask for more work in a step than before and than there may be."""
        system, settings = self.system, self.system.settings
        each = len(system.torn) + len(system.outlines.starts) - 1 + len(system.contacts.pairs)
        if settings.body_distance > 0.0:
            each += system.body_pairs
        each *= 1 + len(self.beside)
        projections = each * settings.iterations * settings.substeps
        if projections > max(MOST_PROJECTIONS, self.projections):
            raise LimitError(
                f"iterations, substeps: {settings.iterations} x {settings.substeps} sweeps over {each} "
                f"links, areas and contacts are too many, {MOST_PROJECTIONS // each} at most"
            )
        self.projections = projections

    @property
    def walls(self) -> Point:
        """Where the left and the right wall are, m; far away where the level has none."""
        return self.content.walls or (-LARGEST, LARGEST)

    # -- changes ------------------------------------------------------------------------------------

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value; ParameterError or LimitError if it cannot be."""
        self._configure()
        self.renew_links()
        self.undisturbed = self.undisturbed and name != "gravity"
        if name in ("iterations", "substeps"):
            self._bound_work()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self._configure()

    def renew_links(self) -> None:
        """Give all links the stiffness that they have now."""
        links = self.law.firmness(self.own)
        for system in (self.system, *self.beside):
            system.links = dataclasses.replace(
                system.links, stiffness=links.stiffness, compliance=links.compliance
            )
            system.masses_changed()

    def give_own_stiffness(self, particle: int, stiffness: float) -> None:
        """Give all links of a particle a stiffness of their own, 0 to 1."""
        self.own[np.any(self.system.links.pairs == particle, axis=1)] = stiffness
        self.edited = True
        self.renew_links()

    def inverse_mass(self, particle: int) -> float:
        """1/kg, also while the hand holds it."""
        return float(self.system.own_inverse_masses()[particle])

    def give_inverse_mass(self, particle: int, inverse_mass: float) -> None:
        """Give a particle another mass, 1/kg; with 0 it stands still."""
        self.undisturbed = False
        self.system.give_inverse_mass(particle, inverse_mass)

    def take_system(self, system: PositionBasedDynamics, own: Floats) -> None:
        """Go on with an edited system."""
        self.system, self.own, self.edited = system, own, True
        self.beside = []
        self._configure()

    # -- a step, and what a later one depends on -----------------------------------------------------

    @property
    def at_rest(self) -> bool:
        """Whether it stands still, as somebody builds on an empty sheet."""
        return self.content.sheet and self.parameters.tool in BUILDING

    def advance(self, dt: float) -> bool:
        """One step; True if the first link of all has torn in it."""
        if self.parameters.slow_sweep:
            self.sweep_tick += 1
            return False
        self.sweep_tick = 0
        if self.at_rest:
            return False
        self.time += dt
        self.undisturbed = self.undisturbed and self.system.held < 0
        before = self.system.tears
        self.system.step(dt)
        for system in self.beside:
            system.step(dt)
        return self.system.tears > before == 0

    def state(self) -> SpringState | ComparedState:
        """What moves, and the network once it is edited."""
        moving = self.system.state()
        if self.beside:
            beside = tuple(system.state() for system in self.beside)
            return ComparedState(*SpringState(*moving, *_UNEDITED), beside)
        if not self.edited:
            return SpringState(*moving, *_UNEDITED)
        topology = topology_of(self.system)
        return SpringState(
            *moving, self.own, *(part for name, part in topology._asdict().items() if name != "torn")
        )

    def restore(self, state: SpringState | ComparedState) -> None:
        """Take over a copy of a state."""
        if len(state.starts) > 0:
            topology = Topology(
                state.pairs, state.rest, state.stiffness, state.compliance, state.torn, state.corners,
                state.starts, state.areas, state.contacts, state.distances,
            )  # fmt: skip
            count = state.fields.shape[1] - (self.system.fields.shape[1] - self.system.count)
            self.own = state.own.copy()
            self.system = assemble(self.system, state.fields[:, :count], topology)
            self.edited, self.beside = True, []
        elif self.edited or (isinstance(state, ComparedState) and not self.beside):
            self._make_system()
        self._configure()
        self.renew_links()
        self.system.restore(PositionState(*state[:4]))
        if isinstance(state, ComparedState):
            for system, then in zip(self.beside, state.beside, strict=True):
                system.restore(then)


_NONE, _NO_INDEX = np.zeros(0), np.zeros(0, dtype=np.int64)
_UNEDITED: tuple[Any, ...] = (
    _NONE, _NO_INDEX, _NONE, _NONE, _NONE, _NO_INDEX, _NO_INDEX, _NONE, _NO_INDEX, _NONE,
)  # fmt: skip
